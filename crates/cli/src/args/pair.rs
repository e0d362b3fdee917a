use clap::Args;
use oaktwin::depth::imager;

use super::sensor::assignment;
use crate::context::Result;

/// How the pair that stereo-matching matches is taken.
#[derive(Args, Debug)]
#[command(next_help_heading = "The pair of stereo-matching")]
pub(crate) struct PairArgs {
    /// The power of a Pro's dot projector, 0 to 1; off by default
    #[arg(long, value_name = "POWER", allow_negative_numbers = true)]
    pub(crate) projector: Option<f64>,

    /// The factor of the scene's own light: 1 by default, 0 is a dark room
    #[arg(long, value_name = "FACTOR", allow_negative_numbers = true)]
    pub(crate) ambient: Option<f64>,

    /// Set a parameter of the image sensors, listed by `oaktwin params imager`; repeatable
    #[arg(long, value_name = "NAME=VALUE", value_parser = assignment)]
    pub(crate) imager: Vec<(String, String)>,

    #[arg(
        long,
        help = "What the two cameras record too, for `oaktwin stereo`: left, right, rectified_left, rectified_right PNG"
    )]
    pub(crate) pair: bool,
}

impl PairArgs {
    /// The first option that was given.
    pub(crate) fn given(&self) -> Option<&'static str> {
        [
            (self.projector.is_some(), "--projector"),
            (self.ambient.is_some(), "--ambient"),
            (!self.imager.is_empty(), "--imager"),
            (self.pair, "--pair"),
        ]
        .into_iter()
        .find_map(|(is_given, name)| is_given.then_some(name))
    }

    /// The image sensors.
    pub(crate) fn imager(&self) -> Result<imager::Parameters> {
        let mut parameters = imager::Parameters::default();
        for (name, value) in &self.imager {
            parameters
                .set(name, value)
                .map_err(|error| format!("--imager: {error}"))?;
        }
        Ok(parameters)
    }
}

use clap::Args;
use oaktwin::depth::imager;
use oaktwin::pair::PairOptions;
use oaktwin::sensor::assignment;
use oaktwin::usd::asset::LensChoice;

use crate::context::Result;

/// The stereo pair of stereo-matching.
#[derive(Args, Debug)]
#[command(next_help_heading = "Stereo pair")]
pub(crate) struct PairArgs {
    /// The intensity of a Pro model's infrared dot projector, 0 to 1 [default: 0; coverage: 1]
    #[arg(long, value_name = "POWER")]
    pub(crate) projector: Option<f64>,

    /// The factor on ambient light; 0 is a dark room [default: 1]
    #[arg(long, value_name = "FACTOR")]
    pub(crate) ambient: Option<f64>,

    /// Set a parameter of the image sensors, listed by `oaktwin params imager`; repeatable
    #[arg(long, value_name = "NAME=VALUE", value_parser = assigned)]
    pub(crate) imager: Vec<(String, String)>,
}

impl PairArgs {
    /// The first option that was given.
    pub(crate) fn given(&self) -> Option<&'static str> {
        [
            (self.projector.is_some(), "--projector"),
            (self.ambient.is_some(), "--ambient"),
            (!self.imager.is_empty(), "--imager"),
        ]
        .into_iter()
        .find_map(|(is_given, name)| is_given.then_some(name))
    }

    /// The options for recording pairs with this lens.
    pub(crate) fn options(&self, lens: LensChoice) -> Result<PairOptions> {
        let default = PairOptions::default();
        let mut imager = imager::Parameters::default();
        for (name, value) in &self.imager {
            imager
                .set(name, value)
                .map_err(|error| format!("--imager: {error}"))?;
        }
        Ok(PairOptions {
            imager,
            projector: self.projector.unwrap_or(default.projector),
            ambient: self.ambient.unwrap_or(default.ambient),
            lens,
            ..default
        })
    }
}

/// `on` or `NAME=VALUE`
pub(super) fn switched(text: &str) -> std::result::Result<Option<(String, String)>, String> {
    match text {
        "on" => Ok(None),
        _ => assigned(text)
            .map(Some)
            .map_err(|remedy| format!("{remedy}, or on")),
    }
}

/// `NAME=VALUE`
fn assigned(text: &str) -> std::result::Result<(String, String), String> {
    match assignment(text) {
        Ok((name, value)) => Ok((name.to_owned(), value.to_owned())),
        Err(error) => Err(error.remedy),
    }
}

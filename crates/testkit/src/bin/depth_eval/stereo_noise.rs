use std::error::Error;
use std::path::PathBuf;

use oaktwin_camera::StereoGeometry;
use oaktwin_depth::Shot;
use oaktwin_depth::random::Stream;
use oaktwin_depth::stereo_noise::{Parameters, StereoNoise};
use serde::Deserialize;
use serde_json::{Value, json};

use crate::files;

#[derive(Deserialize)]
pub(crate) struct Request {
    depth: PathBuf,
    /// Where the disparities go.
    disparity: PathBuf,
    seed: u64,
    camera: String,
    frame: u64,
    /// Of the matcher.
    focal_length_px: f64,
    baseline_m: f64,
    width_px: u32,
}

impl Request {
    pub(crate) fn answer(&self) -> Result<Value, Box<dyn Error>> {
        let depth = files::read_depth(&self.depth)?;
        let stereo = StereoGeometry {
            focal_length_px: self.focal_length_px,
            baseline_m: self.baseline_m,
        };
        let sensor = StereoNoise::new(Parameters::new(stereo, self.width_px))?;
        let mut shot = Shot::new((&depth).into());
        shot.frame = self.frame;
        let disparity = sensor.disparity(&shot, &Stream::new(self.seed, &self.camera));
        files::write(&self.disparity, &disparity)?;
        Ok(json!({}))
    }
}

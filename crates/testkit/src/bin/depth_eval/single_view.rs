use std::error::Error;
use std::path::PathBuf;

use oaktwin_depth::Shot;
use oaktwin_depth::random::Stream;
use oaktwin_depth::single_view::{Assumptions, Parameters, SingleView, Wanted};
use serde::Deserialize;
use serde_json::{Value, json};

use crate::files;

#[derive(Deserialize)]
pub(crate) struct Request {
    depth: PathBuf,
    /// Where the result goes.
    distance: PathBuf,
    seed: u64,
    camera: String,
    frame: u64,
}

impl Request {
    pub(crate) fn answer(&self) -> Result<Value, Box<dyn Error>> {
        let depth = files::read_depth(&self.depth)?;
        let sensor = SingleView::new(Parameters::ISAAC_5_1, Assumptions::default())?;
        let mut shot = Shot::new((&depth).into());
        shot.frame = self.frame;
        let output = sensor.sense(&shot, &Stream::new(self.seed, &self.camera), Wanted::default());
        files::write(&self.distance, &output.distance.0)?;
        Ok(json!({}))
    }
}

use std::path::PathBuf;

use clap::{Args, ValueHint};
use oaktwin::accuracy::MeasuredOptics;
use oaktwin::usd::asset::LensChoice;

use super::choice::parser;

/// The calibration and lens of one unit.
#[derive(Args, Debug)]
pub(crate) struct UnitArgs {
    /// The DepthAI calibration (JSON) of one unit
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub(crate) calibration: Option<PathBuf>,

    /// Ignore calibration errors
    #[arg(long, requires = "calibration")]
    pub(crate) force: bool,

    /// The lens of the left and right cameras of wide models
    #[arg(long, value_parser = parser::<LensChoice>(), default_value_t)]
    pub(crate) lens: LensChoice,
}

/// The optics of one unit whose errors are measured.
#[derive(Args, Debug)]
pub(crate) struct MeasuredUnitArgs {
    /// The DepthAI calibration (JSON) of the unit
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub(crate) calibration: Option<PathBuf>,

    /// Ignore calibration errors
    #[arg(long, requires = "calibration")]
    pub(crate) force: bool,

    /// The focal length of the unit, in pixels at --stereo-width
    #[arg(long, value_name = "F")]
    pub(crate) focal_px: Option<f64>,

    /// The width of the unit's images: 1280 at 800P, 640 at 480P and 400P
    #[arg(long, value_name = "W")]
    pub(crate) stereo_width: Option<u32>,
}

impl MeasuredUnitArgs {
    /// Returns the unit with pinhole lenses, since depth images are rectified.
    pub(crate) fn unit(&self) -> UnitArgs {
        UnitArgs {
            calibration: self.calibration.clone(),
            force: self.force,
            lens: LensChoice::Pinhole,
        }
    }

    pub(crate) fn optics(&self) -> MeasuredOptics {
        MeasuredOptics {
            focal_length_px: self.focal_px,
            width_px: self.stereo_width,
        }
    }
}

use std::path::PathBuf;

use clap::{Args, ValueEnum, ValueHint};
use oaktwin::accuracy::MeasuredOptics;
use oaktwin::usd::asset;

/// The calibration and lens of one unit.
#[derive(Args, Debug)]
pub(crate) struct UnitArgs {
    /// DepthAI calibration (JSON) of one unit
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub(crate) calibration: Option<PathBuf>,

    /// Ignore calibration errors
    #[arg(long, requires = "calibration")]
    pub(crate) force: bool,

    /// Lens of the left and right cameras of wide models
    #[arg(long, value_enum, default_value_t = Lens::Pinhole)]
    pub(crate) lens: Lens,
}

/// The optics of one unit whose errors are measured.
#[derive(Args, Debug)]
pub(crate) struct MeasuredUnitArgs {
    /// DepthAI calibration (JSON) of one unit, which provides its optics
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub(crate) calibration: Option<PathBuf>,

    /// Ignore calibration errors
    #[arg(long, requires = "calibration")]
    pub(crate) force: bool,

    /// Focal length of the unit, in pixels at --stereo-width
    #[arg(long, value_name = "F", allow_negative_numbers = true)]
    pub(crate) focal_px: Option<f64>,

    /// Image width of the unit: 1280 at 800P, 640 at 480P and 400P
    #[arg(long, value_name = "W")]
    pub(crate) stereo_width: Option<u32>,
}

impl MeasuredUnitArgs {
    /// Returns the unit with pinhole lenses, since depth images are rectified.
    pub(crate) fn unit(&self) -> UnitArgs {
        UnitArgs {
            calibration: self.calibration.clone(),
            force: self.force,
            lens: Lens::Pinhole,
        }
    }

    pub(crate) fn optics(&self) -> MeasuredOptics {
        MeasuredOptics {
            focal_length_px: self.focal_px,
            width_px: self.stereo_width,
        }
    }
}

#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Lens {
    Pinhole,
    Fisheye,
}

impl From<Lens> for asset::LensChoice {
    fn from(lens: Lens) -> Self {
        match lens {
            Lens::Pinhole => Self::Pinhole,
            Lens::Fisheye => Self::Fisheye,
        }
    }
}

use std::path::PathBuf;

use clap::{Args, ValueEnum, ValueHint};
use oaktwin::accuracy::MeasuredOptics;
use oaktwin::usd::asset;

/// A model, and the calibration that makes it one unit's twin.
#[derive(Args, Debug)]
pub(crate) struct UnitArgs {
    /// The DepthAI calibration (JSON) of one unit
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub(crate) calibration: Option<PathBuf>,

    /// Use a calibration in spite of the errors found in it
    #[arg(long, requires = "calibration")]
    pub(crate) force: bool,

    /// The lens of the left and right cameras of the wide models
    #[arg(long, value_enum, default_value_t = Lens::Pinhole)]
    pub(crate) lens: Lens,
}

/// What is known of one unit whose errors are measured.
#[derive(Args, Debug)]
pub(crate) struct MeasuredUnitArgs {
    /// The DepthAI calibration (JSON) of one unit: its optics
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub(crate) calibration: Option<PathBuf>,

    /// Use a calibration in spite of the errors found in it
    #[arg(long, requires = "calibration")]
    pub(crate) force: bool,

    /// Its focal length, pixels of the width below
    #[arg(long, value_name = "F", allow_negative_numbers = true)]
    pub(crate) focal_px: Option<f64>,

    /// The width of its images: 1280 at 800P, 640 at 480P and 400P
    #[arg(long, value_name = "W")]
    pub(crate) stereo_width: Option<u32>,
}

impl MeasuredUnitArgs {
    /// Its depth images are rectified, whatever its lenses.
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

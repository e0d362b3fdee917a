//! Filters of depth and disparity images, bit-identical to `DepthAI`'s host implementation. 0 is invalid.
//!
//! [`Median`], [`Spatial`], [`Temporal`] and [`Speckle`] reproduce `DepthAI`'s `ImageFilters`, including its quirks.
//! [`Decimation`], [`Threshold`] and [`Brightness`] exist on devices only and follow `DepthAI`'s description of their
//! settings. The device's hole filling, adaptive median and bilateral filter have no public definition and are missing.
//!
//! A filter can be written as text: `spatial:alpha=0.5,delta=20` ([`parse`]).

mod brightness;
mod chain;
mod confidence;
mod decimation;
mod kernels;
mod median;
mod pixel;
mod spatial;
mod speckle;
mod temporal;
mod text;
mod threshold;

pub use brightness::Brightness;
pub use chain::Chain;
pub use confidence::DepthConfidence;
pub use decimation::{Decimation, DecimationMode, Sample};
pub use median::{Median, MedianSettings};
pub(crate) use median::{Network, Networks};
pub use pixel::Pixel;
pub use spatial::Spatial;
pub use speckle::Speckle;
pub use temporal::{PersistencyMode, Temporal};
pub use text::{NAMES, parse};
pub use threshold::Threshold;

use oaktwin_base::parameter::Platform;

#[cfg(test)]
mod tests;

/// One filter and its settings, under `DepthAI`'s names.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Filter {
    /// `median`
    Median(Median),
    /// `spatialFilter`
    Spatial(Spatial),
    /// `temporalFilter`
    Temporal(Temporal),
    /// `speckleFilter`
    Speckle(Speckle),
    /// `decimationFilter`
    Decimation(Decimation),
    /// `thresholdFilter`
    Threshold(Threshold),
    /// `brightnessFilter`
    Brightness(Brightness),
}

impl Filter {
    /// The name in text, one of [`NAMES`].
    #[must_use]
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Median(_) => "median",
            Self::Spatial(_) => "spatial",
            Self::Temporal(_) => "temporal",
            Self::Speckle(_) => "speckle",
            Self::Decimation(_) => "decimation",
            Self::Threshold(_) => "threshold",
            Self::Brightness(_) => "brightness",
        }
    }

    /// Whether the settings are in millimetres, so that the filter applies to depth only.
    #[must_use]
    pub const fn is_of_depth(&self) -> bool {
        matches!(self, Self::Threshold(_))
    }

    /// Whether the filter needs a colour image.
    #[must_use]
    pub const fn needs_rgb(&self) -> bool {
        matches!(self, Self::Brightness(_))
    }
}

macro_rules! default_of_depthai {
    ($($Filter:ident),+) => {$(
        impl Default for $Filter {
            fn default() -> Self {
                Self::defaults(Platform::default())
            }
        }
    )+};
}
default_of_depthai!(Spatial, Temporal, Speckle, Decimation, Threshold, Brightness);

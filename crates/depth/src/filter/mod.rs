//! Filters of depth and disparity images, bit for bit as `DepthAI` runs them on a host. 0 is no value.
//!
//! [`Median`], [`Spatial`], [`Temporal`] and [`Speckle`] do what `DepthAI`'s `ImageFilters` does, its oddities included.
//! [`Decimation`], [`Threshold`] and [`Brightness`] exist on devices only and follow `DepthAI`'s description of their
//! settings. The device's hole filling, adaptive median and bilateral filter have no public definition and are not here.
//!
//! A filter reads as text too: `spatial:alpha=0.5,delta=20` ([`parse`]); what is not said has `DepthAI`'s default.

mod brightness;
mod chain;
mod confidence;
mod decimation;
mod median;
mod pixel;
mod simd;
mod spatial;
mod speckle;
mod temporal;
mod text;
mod threshold;

pub use brightness::Brightness;
pub use chain::Chain;
pub use confidence::DepthConfidence;
pub use decimation::{Decimation, DecimationMode};
pub use median::Median;
pub(crate) use median::{Network, Networks};
pub use pixel::Pixel;
pub use spatial::Spatial;
pub use speckle::Speckle;
pub use temporal::{PersistencyMode, Temporal};
pub use text::{NAMES, parse};
pub use threshold::Threshold;

use crate::ParameterError;

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
    /// Its name in text, one of [`NAMES`].
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

    /// Whether its settings are in millimetres, so that it has no meaning on disparity.
    #[must_use]
    pub const fn is_of_depth(&self) -> bool {
        matches!(self, Self::Threshold(_))
    }

    /// Whether it needs the picture that the camera took.
    #[must_use]
    pub const fn needs_rgb(&self) -> bool {
        matches!(self, Self::Brightness(_))
    }

    /// Whether its settings can be.
    ///
    /// # Errors
    /// A setting out of its range.
    pub fn check(&self) -> Result<(), ParameterError> {
        match self {
            Self::Spatial(Spatial { alpha, .. }) | Self::Temporal(Temporal { alpha, .. })
                if !(0.0..=1.0).contains(alpha) =>
            {
                Err(self.error("alpha", alpha, "give a number from 0 to 1"))
            }
            Self::Spatial(spatial) if spatial.num_iterations > Spatial::MAX_ITERATIONS => {
                let most = format!("give up to {}", Spatial::MAX_ITERATIONS);
                Err(self.error("iterations", spatial.num_iterations, &most))
            }
            Self::Decimation(Decimation { factor, .. }) if !(1..=4).contains(factor) => {
                Err(self.error("factor", factor, "give 1, 2, 3 or 4"))
            }
            Self::Threshold(threshold) if threshold.min_range > threshold.max_range => {
                let most = format!("give up to max, {}", threshold.max_range);
                Err(self.error("min", threshold.min_range, &most))
            }
            Self::Brightness(brightness) if !(-1..=255).contains(&brightness.min_brightness) => {
                Err(self.error("min", brightness.min_brightness, "give -1 to 255"))
            }
            Self::Brightness(brightness) if !(0..=256).contains(&brightness.max_brightness) => {
                Err(self.error("max", brightness.max_brightness, "give 0 to 256"))
            }
            _ => Ok(()),
        }
    }

    fn error(&self, setting: &str, value: impl std::fmt::Display, remedy: &str) -> ParameterError {
        ParameterError::new(
            format!("{} filter: {setting}", self.name()),
            format!("{value} is out of range"),
            remedy,
        )
    }
}

use super::{PresetError, is_named};
use crate::filter::{Filter, Median, PersistencyMode, Spatial, Speckle, Temporal};
use crate::time_of_flight::Parameters;

/// The presets of time-of-flight sensors: for 0.2 to 2 m, 0.2 to 5 m, 1 to 6 m.
pub const TIME_OF_FLIGHT_PRESETS: [&str; 3] = ["TOF_LOW_RANGE", "TOF_MID_RANGE", "TOF_HIGH_RANGE"];

/// The configuration of a time-of-flight preset: `DepthAI`'s `ToFConfig`, `ToFDepthConfidenceFilterConfig` and
/// `ImageFiltersConfig`.
#[derive(Clone, Debug, PartialEq)]
pub struct TimeOfFlightConfig {
    /// `phaseUnwrapErrorThreshold`.
    pub phase_unwrap_error_threshold: u16,
    /// `confidenceThreshold`.
    pub confidence_threshold: f32,
    /// The filters, in their order, for depth in millimetres.
    pub filters: Vec<Filter>,
}

impl TimeOfFlightConfig {
    /// Returns the configuration of a preset, one of [`TIME_OF_FLIGHT_PRESETS`].
    ///
    /// # Errors
    /// Returns an error if there is no preset of this name.
    pub fn preset(name: &str) -> Result<Self, PresetError> {
        let filters = time_of_flight_filters(name)?;
        let number = number(name).unwrap_or_default();
        Ok(Self {
            phase_unwrap_error_threshold: [50, 75, 130][number],
            confidence_threshold: [0.1, 0.2, 0.3][number],
            filters,
        })
    }

    /// Configures a sensor; the filters are separate.
    pub fn apply_to(&self, parameters: &mut Parameters) {
        parameters.phase_unwrap_error_threshold = self.phase_unwrap_error_threshold;
        parameters.confidence_threshold = self.confidence_threshold;
    }
}

/// The index in [`TIME_OF_FLIGHT_PRESETS`].
fn number(name: &str) -> Option<usize> {
    TIME_OF_FLIGHT_PRESETS
        .iter()
        .position(|known| is_named(name, known) || is_named(name, known.trim_start_matches("TOF_")))
}

/// The filters of a preset, in their order, for depth in millimetres.
///
/// # Errors
/// Returns an error if there is no preset of this name.
pub fn time_of_flight_filters(name: &str) -> Result<Vec<Filter>, PresetError> {
    let number = number(name);
    let temporal = |alpha, delta, persistency_mode| {
        Filter::Temporal(Temporal {
            alpha,
            delta,
            persistency_mode,
        })
    };
    let speckle = |speckle_range, difference_threshold| {
        Filter::Speckle(Speckle {
            speckle_range,
            difference_threshold,
        })
    };
    let spatial = |delta, hole_filling_radius, num_iterations| {
        Filter::Spatial(Spatial {
            alpha: 0.5,
            delta,
            hole_filling_radius,
            num_iterations,
        })
    };
    Ok(match number {
        Some(0) => vec![
            temporal(0.2, 60, PersistencyMode::Valid1InLast8),
            speckle(14, 11),
            spatial(20, 0, 2),
        ],
        Some(1) => vec![
            temporal(0.1, 40, PersistencyMode::Valid1InLast5),
            speckle(6, 130),
            spatial(20, 2, 1),
        ],
        Some(_) => vec![
            temporal(0.2, 60, PersistencyMode::Indefinitely),
            speckle(4, 130),
            spatial(50, 0, 2),
            Filter::Median(Median::Kernel5x5),
        ],
        None => {
            return Err(PresetError::unknown(
                name,
                "a time-of-flight sensor",
                &TIME_OF_FLIGHT_PRESETS,
            ));
        }
    })
}

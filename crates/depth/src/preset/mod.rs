//! `DepthAI`'s presets: what they configure, by their names.

mod stereo;
mod time_of_flight;

pub use oaktwin_parameter::Platform;
pub use stereo::{FilterStage, Preset, StereoConfig};
pub use time_of_flight::{TIME_OF_FLIGHT_PRESETS, TimeOfFlightConfig, time_of_flight_filters};

use oaktwin_diagnostic::{fold_name, nearest};

/// A name that is no preset there: `preset: what is wrong; what to do`.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("preset: {what}; {remedy}")]
pub struct PresetError {
    /// What is wrong.
    pub what: String,
    /// What to do.
    pub remedy: String,
}

impl PresetError {
    fn unknown(name: &str, place: &str, names: &[&str]) -> Self {
        let near = nearest(name, names.iter().copied());
        Self {
            what: format!("{place} has no {name:?}"),
            remedy: if near.is_empty() {
                format!("use one of {}", names.join(", "))
            } else {
                format!("did you mean {}?", near.join(" or "))
            },
        }
    }
}

#[cfg(test)]
mod tests;

fn is_named(name: &str, known: &str) -> bool {
    fold_name(name) == fold_name(known)
}

//! `DepthAI`'s presets by name.

mod stereo;
mod time_of_flight;

pub use oaktwin_base::parameter::Platform;
pub use stereo::{FilterStage, Preset, StereoConfig};
pub use time_of_flight::{TIME_OF_FLIGHT_PRESETS, TimeOfFlightConfig, time_of_flight_filters};

use oaktwin_base::diagnostic::{fold_name, suggest};

/// An unknown preset: `preset: what is wrong; what to do`.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("preset: {what}; {remedy}")]
pub struct PresetError {
    /// What is wrong.
    pub what: String,
    /// How to fix it.
    pub remedy: String,
}

impl PresetError {
    fn unknown(name: &str, place: &str, names: &[&str]) -> Self {
        Self {
            what: format!("unknown preset '{name}' of {place}"),
            remedy: suggest(name, names.iter().copied()),
        }
    }
}

#[cfg(test)]
mod tests;

fn is_named(name: &str, known: &str) -> bool {
    fold_name(name) == fold_name(known)
}

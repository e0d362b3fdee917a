//! The registry of engines.
//!
//! A new engine needs its own module, an adapter here that implements [`Engine`], and a line in [`ENGINES`]. Engines of other crates need
//! neither: their [`EngineKind`] is passed wherever one is chosen.

mod filters;
mod measured;
mod single_view;
mod stereo_matching;
mod stereo_noise;
mod time_of_flight;

use std::ptr;
use std::sync::Arc;

use oaktwin_base::diagnostic::{fold_name, suggest};

use crate::{Engine, EngineKind, ParameterError, Setup, Technology};

pub use single_view::SINGLE_VIEW;
pub use stereo_matching::{STEREO_MATCHING, calibration_error_px, is_calibration_error};
pub use stereo_noise::STEREO_NOISE;
pub use time_of_flight::TIME_OF_FLIGHT;

#[cfg(test)]
pub(crate) use filters::spread;

/// The engines of this crate.
pub static ENGINES: &[&EngineKind] = &[&SINGLE_VIEW, &STEREO_NOISE, &STEREO_MATCHING, &TIME_OF_FLIGHT];

impl EngineKind {
    /// Returns the engine of a name; case, hyphens and underscores are ignored.
    ///
    /// # Errors
    /// Returns an error if there is no such engine, with the nearest names.
    pub fn parse(name: &str) -> Result<&'static Self, ParameterError> {
        let found = ENGINES
            .iter()
            .find(|kind| fold_name(&kind.name) == fold_name(name));
        found.copied().ok_or_else(|| {
            let remedy = suggest(name, ENGINES.iter().map(|kind| &*kind.name));
            ParameterError::new("engine", format!("unknown engine '{name}'"), remedy)
        })
    }

    /// Returns the default engine for depth cameras of a technology.
    #[must_use]
    pub fn default_for(technology: Technology) -> &'static Self {
        let mut all = ENGINES.iter().filter(|kind| kind.is_default);
        all.find(|kind| kind.models == Some(technology))
            .unwrap_or(&ENGINES[0])
    }

    /// Creates the engine.
    ///
    /// # Errors
    /// Returns an error if a parameter is unknown, has an invalid value, or is out of range, or if the kind has the name of one of
    /// [`ENGINES`] and is another.
    pub fn create(&self, setup: &Setup) -> Result<Arc<dyn Engine>, ParameterError> {
        let mut others = ENGINES.iter().filter(|other| !ptr::eq(**other, self));
        if others.any(|other| fold_name(&other.name) == fold_name(&self.name)) {
            let what = format!("there is already an engine named {self}");
            return Err(ParameterError::new("engine", what, "give it another name"));
        }
        let mut setup = setup.clone();
        for (name, _) in &mut setup.parameters {
            self.resolve(name)?.clone_into(name);
        }
        self.factory.create(&setup)
    }

    fn find(&self, name: &str) -> Option<&'static str> {
        let mut names = (self.parameters)().into_iter();
        names.find(|own| fold_name(own) == fold_name(name))
    }

    /// Returns the exact name of a parameter.
    fn resolve(&self, given: &str) -> Result<&'static str, ParameterError> {
        if let Some(name) = self.find(given) {
            return Ok(name);
        }
        let mut others = ENGINES.iter();
        let (what, remedy) = match others.find_map(|other| Some((other, other.find(given)?))) {
            Some((other, _)) => (
                format!("a parameter of {other}, not of {self}"),
                format!("remove it, or choose the engine {other}"),
            ),
            None => {
                let what = format!("unknown parameter of {self}");
                (what, suggest(given, (self.parameters)()))
            }
        };
        Err(ParameterError::new(given, what, remedy))
    }
}

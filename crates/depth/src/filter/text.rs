use std::fmt;
use std::str::FromStr;

use oaktwin_base::diagnostic::{fold_name, suggest};
use oaktwin_base::parameter::{Platform, Table};

use super::{Brightness, Decimation, Filter, MedianSettings, Spatial, Speckle, Temporal, Threshold};
use crate::ParameterError;

/// The names of the filters in text.
pub const NAMES: [&str; 7] = [
    "median",
    "spatial",
    "temporal",
    "speckle",
    "decimation",
    "threshold",
    "brightness",
];

/// Reads a filter from text: `NAME` or `NAME:SETTING=VALUE,…`, with `DepthAI`'s defaults for all other settings.
///
/// # Errors
/// Returns an error that suggests the nearest names if there is no such filter or setting, and one that names the valid
/// values if a value is invalid.
pub fn parse(text: &str) -> Result<Filter, ParameterError> {
    let (name, settings) = text.split_once(':').unwrap_or((text, ""));
    let defaults = Platform::default();
    let folded = fold_name(name);
    let known = NAMES.iter().copied().find(|known| fold_name(known) == folded);
    let mut filter = match known {
        Some("median") => Filter::Median(MedianSettings::defaults(defaults).kernel),
        Some("spatial") => Filter::Spatial(Spatial::defaults(defaults)),
        Some("temporal") => Filter::Temporal(Temporal::defaults(defaults)),
        Some("speckle") => Filter::Speckle(Speckle::defaults(defaults)),
        Some("decimation") => Filter::Decimation(Decimation::defaults(defaults)),
        Some("threshold") => Filter::Threshold(Threshold::defaults(defaults)),
        Some(_) => Filter::Brightness(Brightness::defaults(defaults)),
        None => {
            return Err(ParameterError::new(
                text,
                format!("unknown filter '{name}'"),
                suggest(name, NAMES),
            ));
        }
    };
    for setting in oaktwin_base::parameter::settings(settings) {
        let (key, value) = setting.map_err(|setting| {
            let what = format!("setting '{setting}' has no value");
            ParameterError::new(text, what, format!("write {setting}=VALUE"))
        })?;
        filter.set(key, value).map_err(|error| {
            ParameterError::new(text, format!("{}: {}", error.name, error.what), error.remedy)
        })?;
    }
    filter.check()?;
    Ok(filter)
}

impl FromStr for Filter {
    type Err = ParameterError;

    fn from_str(text: &str) -> Result<Self, ParameterError> {
        parse(text)
    }
}

impl Filter {
    /// Changes a setting by its name.
    fn set(&mut self, name: &str, value: &str) -> Result<(), ParameterError> {
        match self {
            Self::Median(median) => {
                let mut settings = MedianSettings { kernel: *median };
                settings.set(name, value)?;
                *median = settings.kernel;
                Ok(())
            }
            Self::Spatial(spatial) => spatial.set(name, value),
            Self::Temporal(temporal) => temporal.set(name, value),
            Self::Speckle(speckle) => speckle.set(name, value),
            Self::Decimation(decimation) => decimation.set(name, value),
            Self::Threshold(threshold) => threshold.set(name, value),
            Self::Brightness(brightness) => brightness.set(name, value),
        }
    }

    /// Checks the settings.
    ///
    /// # Errors
    /// Returns an error for the first setting that is out of range.
    pub fn check(&self) -> Result<(), ParameterError> {
        match self {
            Self::Median(_) => Ok(()),
            Self::Spatial(spatial) => checked(spatial),
            Self::Temporal(temporal) => checked(temporal),
            Self::Speckle(speckle) => checked(speckle),
            Self::Decimation(decimation) => checked(decimation),
            Self::Threshold(threshold) => checked(threshold),
            Self::Brightness(brightness) => checked(brightness),
        }
    }
}

fn checked<T: Table>(settings: &T) -> Result<(), ParameterError> {
    settings.check_all().map_err(|error| {
        ParameterError::new(format!("{}: {}", T::GROUP, error.name), error.what, error.remedy)
    })
}

fn settings<T: Table>(settings: &T) -> String {
    let all: Vec<String> = T::rows()
        .map(|row| format!("{}={}", row.about.name, (row.get)(settings)))
        .collect();
    all.join(",")
}

/// The text that [`parse`] reads, with all settings.
impl fmt::Display for Filter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let settings = match self {
            Self::Median(median) => settings(&MedianSettings { kernel: *median }),
            Self::Spatial(spatial) => settings(spatial),
            Self::Temporal(temporal) => settings(temporal),
            Self::Speckle(speckle) => settings(speckle),
            Self::Decimation(decimation) => settings(decimation),
            Self::Threshold(threshold) => settings(threshold),
            Self::Brightness(brightness) => settings(brightness),
        };
        write!(f, "{}:{settings}", self.name())
    }
}

//! Parameters of an engine in a file, as a fit writes them.
//!
//! ```toml
//! engine = "stereo-noise"
//!
//! [parameters]
//! bias = -0.22
//! pixelLocking = 0.13
//! ```
//!
//! A table `[fit]` documents their origin; it is not read.

use std::path::Path;

use oaktwin_depth::{EngineKind, ParameterError, Setup};
use toml::Value;

use super::SensorOptions;
use oaktwin_base::diagnostic::nearest;
use oaktwin_base::parameter::Scalar;
use oaktwin_files::{self as files, FileError};

/// The maximum size of a file of parameters.
const MAX_BYTES: u64 = 1 << 20;

const TABLES: [&str; 3] = ["engine", "parameters", "fit"];

/// An engine and values for some of its parameters.
#[derive(Clone, Debug, PartialEq)]
pub struct ParameterFile {
    /// The engine.
    pub engine: &'static EngineKind,
    /// The names and values of parameters, in the file's order.
    pub parameters: Vec<(String, Scalar)>,
}

impl ParameterFile {
    /// Reads a file and checks each name and value.
    ///
    /// # Errors
    /// Returns an error if the file cannot be read, is not TOML, or names a parameter that the engine does not have.
    pub fn read(path: &Path) -> Result<Self, FileError> {
        let bytes = files::read(path, MAX_BYTES, "a file of parameters")?;
        let text = std::str::from_utf8(&bytes)
            .map_err(|_| FileError::new(path, "is not text", "give a TOML file in UTF-8"))?;
        Self::parse(text).map_err(|(what, remedy)| FileError::new(path, what, remedy))
    }

    /// Reads the text of a file.
    ///
    /// # Errors
    /// Returns what is wrong and what to do.
    pub fn parse(text: &str) -> Result<Self, (String, String)> {
        let document: toml::Table = text.parse().map_err(|error: toml::de::Error| {
            let line = error.span().map_or(1, |span| {
                text[..span.start.min(text.len())].matches('\n').count() + 1
            });
            let what = error.message().lines().collect::<Vec<_>>().join(" ");
            (
                format!("line {line}: {what}"),
                "write engine = \"stereo-noise\" and a table [parameters]".to_owned(),
            )
        })?;
        for name in document.keys() {
            if !TABLES.contains(&name.as_str()) {
                let near = nearest(name, TABLES);
                let hint = if near.is_empty() {
                    "parameters of the engine belong below [parameters]".to_owned()
                } else {
                    format!("did you mean {}?", near.join(" or "))
                };
                return Err((format!("{name}: unknown key"), hint));
            }
        }
        let engine = match document.get("engine").and_then(Value::as_str) {
            Some(name) => {
                EngineKind::parse(name).map_err(|error| (format!("engine: {}", error.what), error.remedy))?
            }
            None => {
                return Err((
                    "engine: missing".to_owned(),
                    "begin the file with the engine, such as engine = \"stereo-noise\"".to_owned(),
                ));
            }
        };
        let Some(table) = document.get("parameters").and_then(Value::as_table) else {
            return Err((
                "parameters: there is no such table".to_owned(),
                "write [parameters], and below it NAME = VALUE".to_owned(),
            ));
        };
        let mut parameters = Vec::new();
        for (name, value) in table {
            let value = match value {
                Value::String(text) => text.into(),
                Value::Integer(number) => (*number).into(),
                Value::Float(number) => (*number).into(),
                Value::Boolean(flag) => (*flag).into(),
                _ => {
                    return Err((
                        format!("parameters.{name}: is neither a number, nor true or false, nor text"),
                        "give one value".to_owned(),
                    ));
                }
            };
            parameters.push((name.clone(), value));
        }
        let file = Self { engine, parameters };
        file.check()
            .map_err(|error| (format!("parameters.{}: {}", error.name, error.what), error.remedy))?;
        Ok(file)
    }

    /// Sets the options of a sensor to the file's values, except for parameters that the options already set. Their device seed
    /// draws what the file does not determine.
    ///
    /// # Errors
    /// The options ask for another engine.
    pub fn apply(&self, options: &mut SensorOptions) -> Result<(), ParameterError> {
        match &options.engine {
            Some(engine) if **engine != *self.engine => Err(ParameterError {
                name: "engine".to_owned(),
                what: format!(
                    "the parameter file is for {}, but {engine} is chosen",
                    self.engine
                ),
                remedy: "remove one of the two".to_owned(),
            }),
            _ => {
                options.engine = Some(self.engine.into());
                let named = std::mem::replace(&mut options.parameters, self.parameters.clone());
                options.parameters.extend(named);
                Ok(())
            }
        }
    }

    /// Checks the values on a reference camera, so that errors name the file.
    fn check(&self) -> Result<(), ParameterError> {
        let setup = Setup {
            parameters: self.parameters.clone(),
            ..Setup::new(800.0, 1280, 0.075)
        };
        self.engine.create(&setup).map(|_| ())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sensor::{SINGLE_VIEW, STEREO_NOISE};

    #[test]
    fn a_file_is_read_and_named_values_count_more() {
        let file = ParameterFile::parse(
            "engine = 'stereo-noise'\n[parameters]\nbias = -0.22\nwindow = 9\ndepth-rounding = 'truncate'\n\
             subpixel = true\n[fit]\nmodel = 'x'\n",
        )
        .unwrap();
        let mut options = SensorOptions {
            parameters: vec![("bias".to_owned(), "0.1".into())],
            ..SensorOptions::default()
        };
        file.apply(&mut options).unwrap();
        assert_eq!(options.engine, Some((&STEREO_NOISE).into()));
        let last = options
            .parameters
            .iter()
            .rfind(|(name, _)| name == "bias")
            .unwrap();
        assert_eq!(last.1, "0.1".into());
        assert_eq!(options.parameters.len(), 5);
        options.engine = Some((&SINGLE_VIEW).into());
        assert!(
            file.apply(&mut options)
                .unwrap_err()
                .what
                .contains("stereo-noise")
        );
    }

    #[test]
    fn rejects_invalid_files() {
        for (text, expected) in [
            ("", "engine: missing"),
            (
                "engine = 'stereo-nose'\n[parameters]\n",
                "did you mean 'stereo-noise'",
            ),
            ("engine = 'stereo-noise'\n", "no such table"),
            (
                "engine = 'stereo-noise'\nbias = 1\n[parameters]\n",
                "bias: unknown key",
            ),
            (
                "engine = 'stereo-noise'\n[parameter]\n",
                "did you mean parameters?",
            ),
            (
                "engine = 'stereo-noise'\n[parameters]\njiter = 1\n",
                "parameters.jiter: unknown parameter of stereo-noise; did you mean 'jitter'?",
            ),
            (
                "engine = 'stereo-noise'\n[parameters]\njitter = -1.0\n",
                "parameters.jitter: -1 is out of range",
            ),
            (
                "engine = 'stereo-noise'\n[parameters]\njitter = nan\n",
                "parameters.jitter",
            ),
            (
                "engine = 'stereo-noise'\n[parameters]\njitter = [1]\n",
                "parameters.jitter: is neither",
            ),
            ("engine = 'stereo-noise'\n\n[parameters\n", "line 3"),
            (
                "engine = 'single-view'\n[parameters]\njitter = 1\n",
                "a parameter of stereo-noise",
            ),
        ] {
            let (what, remedy) = ParameterFile::parse(text).unwrap_err();
            let error = format!("{what}; {remedy}");
            assert!(error.contains(expected), "{text:?}: {error}");
        }
    }
}

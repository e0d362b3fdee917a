//! Parameters by name.

use oaktwin_diagnostic::fold_name;

use super::parameters::{Bits, Parameters};
use crate::ParameterError;
use crate::choice::unknown;

/// The names of all parameters.
pub const NAMES: [&str; 11] = [
    "autoExposure",
    "exposureTarget",
    "exposure",
    "maxExposureTime",
    "maxGain",
    "fullWell",
    "readNoise",
    "noise",
    "lensBlur",
    "vignetting",
    "bits",
];

/// A parameter to change.
enum Field<'a> {
    Number(&'a mut f64),
    Flag(&'a mut bool),
    Bits(&'a mut Bits),
}

impl Parameters {
    /// Changes one of [`NAMES`]; case, hyphens and underscores in the name do not matter.
    ///
    /// # Errors
    /// No such name, a value that is none of its kind, or out of its range. Then nothing is changed.
    pub fn set(&mut self, name: &str, value: &str) -> Result<(), ParameterError> {
        let name = known(name)?;
        let mut changed = *self;
        changed.field(name)?.put(value.trim()).map_err(|values| {
            ParameterError::new(name, format!("`{value}` is none of its values"), values)
        })?;
        // What was wrong before is not this value's fault.
        match changed.check() {
            Err(error) if error.name == name => Err(error),
            _ => {
                *self = changed;
                Ok(())
            }
        }
    }

    /// One of [`NAMES`], as [`Parameters::set`] takes it.
    ///
    /// # Errors
    /// No such name.
    pub fn get(&self, name: &str) -> Result<String, ParameterError> {
        let mut own = *self;
        Ok(match own.field(known(name)?)? {
            Field::Number(value) => value.to_string(),
            Field::Flag(value) => value.to_string(),
            Field::Bits(value) => value.count().to_string(),
        })
    }

    fn field(&mut self, name: &str) -> Result<Field<'_>, ParameterError> {
        Ok(match name {
            "autoExposure" => Field::Flag(&mut self.auto_exposure),
            "exposureTarget" => Field::Number(&mut self.exposure_target),
            "exposure" => Field::Number(&mut self.exposure),
            "maxExposureTime" => Field::Number(&mut self.max_exposure_time),
            "maxGain" => Field::Number(&mut self.max_gain),
            "fullWell" => Field::Number(&mut self.full_well_e),
            "readNoise" => Field::Number(&mut self.read_noise_e),
            "noise" => Field::Flag(&mut self.noise),
            "lensBlur" => Field::Number(&mut self.lens_blur_px),
            "vignetting" => Field::Number(&mut self.vignetting),
            "bits" => Field::Bits(&mut self.bits),
            _ => return Err(unknown(name, "parameter of an imager", &NAMES)),
        })
    }
}

impl Field<'_> {
    /// Or what its values are.
    fn put(self, value: &str) -> Result<(), &'static str> {
        match self {
            Self::Number(field) => *field = value.parse().map_err(|_| "give a number")?,
            Self::Flag(field) => {
                *field = match value {
                    "true" | "1" => true,
                    "false" | "0" => false,
                    _ => return Err("give true or false"),
                }
            }
            Self::Bits(field) => {
                *field = match value {
                    "8" => Bits::Eight,
                    "10" => Bits::Ten,
                    _ => return Err("give 8 or 10"),
                }
            }
        }
        Ok(())
    }
}

fn known(name: &str) -> Result<&'static str, ParameterError> {
    let folded = fold_name(name);
    (NAMES.into_iter())
        .find(|known| fold_name(known) == folded)
        .ok_or_else(|| unknown(name, "parameter of an imager", &NAMES))
}

use std::fmt;

use crate::diagnostic::{fold_name, suggest};

use crate::parameter::{About, ParameterError, Platform, Scalar};

/// A parameter of `P`: its description and the access to its value.
pub struct ParameterRow<P: 'static> {
    /// The description.
    pub about: About,
    /// The value as text.
    pub get: fn(&P) -> String,
    /// Reads a value; `None`, and no change, if the text is invalid.
    pub set: fn(&mut P, &str) -> Option<()>,
    /// The numbers that the range applies to.
    pub numbers: fn(&P) -> Vec<f64>,
}

impl<P> fmt::Debug for ParameterRow<P> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Row").field(&self.about).finish()
    }
}

impl<P> ParameterRow<P> {
    fn check(&self, parameters: &P) -> Result<(), ParameterError> {
        let numbers = (self.numbers)(parameters);
        let Some(number) = numbers.into_iter().find(|&number| !self.about.accepts(number)) else {
            return Ok(());
        };
        let what = match number {
            number if number.is_nan() => "must not be NaN".to_owned(),
            number if (self.about.min..=self.about.max).contains(&number) => {
                format!("invalid value '{number}'")
            }
            number => format!("{number} is out of range"),
        };
        Err(ParameterError::new(
            self.about.name,
            what,
            self.about.expectation(),
        ))
    }

    fn is_named(&self, folded: &str) -> bool {
        let about = &self.about;
        fold_name(about.name) == folded || !about.alias.is_empty() && fold_name(about.alias) == folded
    }
}

/// Splits settings, `NAME=VALUE,…`, into names and values without the blanks around them. An error is a setting without a value.
pub fn settings(text: &str) -> impl Iterator<Item = Result<(&str, &str), &str>> {
    let settings = text.split(',').map(str::trim);
    settings.filter(|setting| !setting.is_empty()).map(|setting| {
        let (name, value) = setting.split_once('=').ok_or(setting)?;
        Ok((name.trim(), value.trim()))
    })
}

/// A struct of parameters that [`parameters!`](crate::parameters!) declared.
pub trait Table: Clone + 'static {
    /// The name of the group in errors: `stereo-noise`.
    const GROUP: &'static str;
    /// The parameters, in slices in their order.
    const ROWS: &'static [&'static [ParameterRow<Self>]];

    /// The defaults on a platform.
    fn defaults(platform: Platform) -> Self;

    /// Checks what no range can express.
    ///
    /// # Errors
    /// Returns an error if two parameters contradict each other.
    fn check_relations(&self) -> Result<(), ParameterError> {
        Ok(())
    }

    /// The parameters in their order.
    #[must_use]
    fn rows() -> impl Iterator<Item = &'static ParameterRow<Self>> {
        Self::ROWS.iter().copied().flatten()
    }

    /// The parameter of this name; case, hyphens and underscores do not matter.
    ///
    /// # Errors
    /// Returns an error that suggests the nearest names if there is no such parameter.
    fn row(name: &str) -> Result<&'static ParameterRow<Self>, ParameterError> {
        let folded = fold_name(name);
        Self::rows().find(|row| row.is_named(&folded)).ok_or_else(|| {
            let remedy = suggest(name, Self::rows().map(|row| row.about.name));
            ParameterError::new(name, format!("unknown parameter of {}", Self::GROUP), remedy)
        })
    }

    /// Changes a parameter to a value in its range.
    ///
    /// # Errors
    /// Returns an error, and changes nothing, if there is no such parameter or the value is invalid or out of range.
    fn set_by_name(&mut self, name: &str, value: impl Into<Scalar>) -> Result<(), ParameterError> {
        let row = Self::row(name)?;
        let mut changed = self.clone();
        let value = value.into().to_string();
        (row.set)(&mut changed, value.trim()).ok_or_else(|| {
            let what = format!("invalid value '{value}'");
            ParameterError::new(row.about.name, what, row.about.expectation())
        })?;
        row.check(&changed)?;
        *self = changed;
        Ok(())
    }

    /// Checks all ranges and relations.
    ///
    /// # Errors
    /// Returns an error for the first parameter that is out of range.
    fn check_all(&self) -> Result<(), ParameterError> {
        Self::rows().try_for_each(|row| row.check(self))?;
        self.check_relations()
    }
}

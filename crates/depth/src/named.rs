//! Parameters by name, for command lines and presets: what engines' tables are made of.

use std::fmt::Display;
use std::str::FromStr;

use oaktwin_diagnostic::{fold_name, nearest};

use oaktwin_parameter::{Choice, ParameterError};

/// One parameter of `P`: its name, how to read and to change it, and what it may be.
pub(crate) struct Named<P: 'static> {
    pub(crate) name: &'static str,
    pub(crate) get: fn(&P) -> String,
    pub(crate) set: fn(&mut P, &str) -> Option<()>,
    pub(crate) values: &'static str,
}

/// A parameter that is a field of a type that reads as text.
macro_rules! field {
    ($name:literal, $($field:ident).+, $values:literal) => {
        $crate::named::Named {
            name: $name,
            get: |p| $crate::named::text(&p.$($field).+),
            set: |p, value| $crate::named::put(&mut p.$($field).+, value),
            values: $values,
        }
    };
}
pub(crate) use field;

/// What a switch may be.
pub(crate) const FLAG: &str = "give true or false";

/// A switch.
macro_rules! flag {
    ($name:literal, $($field:ident).+) => {
        $crate::named::Named {
            name: $name,
            get: |p| $crate::named::text(&p.$($field).+),
            set: |p, value| $crate::named::switch(value).map(|value| p.$($field).+ = value),
            values: $crate::named::FLAG,
        }
    };
}
pub(crate) use flag;

/// One of a few named values.
macro_rules! one_of {
    ($name:literal, $($field:ident).+, $values:literal) => {
        $crate::named::Named {
            name: $name,
            get: |p| p.$($field).+.name().to_owned(),
            set: |p, value| $crate::named::pick(value).map(|value| p.$($field).+ = value),
            values: $values,
        }
    };
}
pub(crate) use one_of;

/// Whether disparities have a fraction.
macro_rules! subpixel {
    ($name:literal, $($field:ident).+) => {
        $crate::named::Named {
            name: $name,
            get: |p| <$crate::disparity::SubpixelSwitch as oaktwin_parameter::View<_>>::get(&p.$($field).+),
            set: |p, value| <$crate::disparity::SubpixelSwitch as oaktwin_parameter::View<_>>::set(&mut p.$($field).+, value),
            values: $crate::named::FLAG,
        }
    };
}
pub(crate) use subpixel;

/// Of how many bits it is.
macro_rules! subpixel_bits {
    ($name:literal, $($field:ident).+) => {
        $crate::named::Named {
            name: $name,
            get: |p| <$crate::disparity::FractionalBits as oaktwin_parameter::View<_>>::get(&p.$($field).+),
            set: |p, value| <$crate::disparity::FractionalBits as oaktwin_parameter::View<_>>::set(&mut p.$($field).+, value),
            values: "give 0, 3, 4 or 5",
        }
    };
}
pub(crate) use subpixel_bits;

/// `NAMES` of a table, and of its parameters `set`, `get` and `by_name`. A name that is none has the error that `$unknown`
/// makes of it.
macro_rules! by_name {
    ($parameters:ty, $table:ident, $unknown:expr) => {
        /// The names of all parameters: `DepthAI`'s where it has one.
        pub const NAMES: [&str; $table.len()] = $crate::named::names(&$table);

        impl $parameters {
            /// Changes one of [`NAMES`]; case, hyphens and underscores in the name do not matter.
            ///
            /// # Errors
            /// No such name, a value that is none of its kind, or out of its range. Then nothing is changed.
            pub fn set(&mut self, name: &str, value: &str) -> Result<(), $crate::ParameterError> {
                $crate::named::find(&$table, name, $unknown)?.change(self, value, Self::check)
            }

            /// One of [`NAMES`], as [`set`](Self::set) takes it.
            ///
            /// # Errors
            /// No such name.
            pub fn get(&self, name: &str) -> Result<String, $crate::ParameterError> {
                let named = $crate::named::find(&$table, name, $unknown)?;
                Ok((named.get)(self))
            }

            /// All of [`NAMES`], as [`set`](Self::set) takes them.
            pub fn by_name(&self) -> impl Iterator<Item = (&'static str, String)> {
                $table.iter().map(|named| (named.name, (named.get)(self)))
            }
        }
    };
}
pub(crate) use by_name;

/// The names of a table.
pub(crate) const fn names<P, const N: usize>(table: &[Named<P>; N]) -> [&'static str; N] {
    let mut names = [""; N];
    let mut at = 0;
    while at < N {
        names[at] = table[at].name;
        at += 1;
    }
    names
}

/// The one of this name; case, hyphens and underscores do not matter.
pub(crate) fn find<P>(
    table: &'static [Named<P>],
    name: &str,
    unknown: impl FnOnce(&str) -> ParameterError,
) -> Result<&'static Named<P>, ParameterError> {
    let folded = fold_name(name);
    let found = table.iter().find(|named| fold_name(named.name) == folded);
    found.ok_or_else(|| unknown(name))
}

/// The error for a name that is none of an engine's.
pub(crate) fn unknown(engine: &str, name: &str, names: &[&'static str]) -> ParameterError {
    let near = nearest(name, names.iter().copied());
    let remedy = if near.is_empty() {
        format!("use one of {}", names.join(", "))
    } else {
        format!("did you mean {}?", near.join(", "))
    };
    ParameterError::new(name, format!("{engine} has no such parameter"), remedy)
}

impl<P: Copy> Named<P> {
    /// Changes it, unless the value is none of its kind or, by `check`, out of its range.
    pub(crate) fn change(
        &self,
        parameters: &mut P,
        value: &str,
        check: impl FnOnce(&P) -> Result<(), ParameterError>,
    ) -> Result<(), ParameterError> {
        let mut changed = *parameters;
        (self.set)(&mut changed, value.trim()).ok_or_else(|| {
            ParameterError::new(self.name, format!("`{value}` is none of its values"), self.values)
        })?;
        // What was wrong before is not this value's fault.
        match check(&changed) {
            Err(error) if error.name == self.name => Err(error),
            _ => {
                *parameters = changed;
                Ok(())
            }
        }
    }
}

pub(crate) fn text(value: &impl Display) -> String {
    value.to_string()
}

pub(crate) fn put<T: FromStr>(field: &mut T, value: &str) -> Option<()> {
    *field = value.parse().ok()?;
    Some(())
}

pub(crate) fn pick<C: Choice>(value: &str) -> Option<C> {
    C::find(value)
}

pub(crate) fn switch(value: &str) -> Option<bool> {
    match value {
        "true" | "1" => Some(true),
        "false" | "0" => Some(false),
        _ => None,
    }
}

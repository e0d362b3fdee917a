//! Values of options by name.

use oaktwin_parameter::Choice;

use crate::ParameterError;

/// The value of an option by its name.
pub(crate) fn parse<C: Choice>(option: &str, value: &str) -> Result<C, ParameterError> {
    let found = C::find(value);
    found.ok_or_else(|| {
        let names = C::NAMES;
        ParameterError::new(
            option,
            format!("'{value}' is none of its values"),
            format!("give one of {}", names.join(", ")),
        )
    })
}

/// A number by what it is written as.
pub(crate) fn number(option: &str, value: &str) -> Result<f64, ParameterError> {
    value.trim().parse().map_err(|_| {
        ParameterError::new(
            option,
            format!("'{value}' is no number"),
            "give a number, 0.25 for one",
        )
    })
}

/// The error for a name that is none of `names`, which are of `what`.
pub(crate) fn unknown(name: &str, what: &str, names: &[&str]) -> ParameterError {
    let near = oaktwin_diagnostic::nearest(name, names.iter().copied());
    let remedy = match near.first() {
        Some(near) => format!("did you mean {near}?"),
        None => format!("give one of {}", names.join(", ")),
    };
    ParameterError::new(name, format!("no such {what}"), remedy)
}

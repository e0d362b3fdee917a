use oaktwin::depth::parameters::Choice;
use oaktwin::diagnostic::fold_name;
use pyo3::PyResult;

use crate::error::{error, wrong};

/// The value that a name of an option stands for; case, hyphens and underscores do not matter.
pub(crate) fn choose<T: Copy>(option: &str, name: &str, all: &[(&str, T)]) -> PyResult<T> {
    let found = all.iter().find(|(known, _)| fold_name(known) == fold_name(name));
    found.map(|(_, value)| *value).ok_or_else(|| {
        let names: Vec<&str> = all.iter().map(|(name, _)| *name).collect();
        let remedy = match oaktwin::diagnostic::nearest(name, names.iter().copied())[..] {
            [] => format!("give one of {}", names.join(", ")),
            [near, ..] => format!("did you mean {near}?"),
        };
        wrong(option, format_args!("there is no `{name}`"), remedy)
    })
}

/// The variant of this name of any enumeration; case, hyphens and underscores do not matter.
pub(crate) fn named<C: Choice>(option: &str, name: &str) -> PyResult<C> {
    oaktwin::depth::parameters::choose(option, name).map_err(error)
}

use oaktwin::depth::parameters::{self, Choice};
use oaktwin::diagnostic::{fold_name, suggest};
use pyo3::PyResult;

use crate::error::{error, wrong};

/// Returns the value for a name of an option, ignoring case, hyphens and underscores.
pub(crate) fn choose<T: Copy>(option: &str, name: &str, all: &[(&str, T)]) -> PyResult<T> {
    let found = all.iter().find(|(known, _)| fold_name(known) == fold_name(name));
    found.map(|(_, value)| *value).ok_or_else(|| {
        let remedy = suggest(name, all.iter().map(|(name, _)| *name));
        wrong(option, format_args!("invalid value '{name}'"), remedy)
    })
}

/// Returns the variant of an enumeration with a name, ignoring case, hyphens and underscores.
pub(crate) fn named<C: Choice>(option: &str, name: &str) -> PyResult<C> {
    parameters::choose(option, name).map_err(error)
}

/// Returns the variant of an enumeration with a name, if there is a name.
pub(crate) fn maybe_named<C: Choice>(option: &str, name: Option<&str>) -> PyResult<Option<C>> {
    name.map(|name| named(option, name)).transpose()
}

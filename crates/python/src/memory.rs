use oaktwin::memory;
use pyo3::prelude::*;

use crate::error::wrong;

/// Limits the memory that this process uses: what a call needs is compared with it before the call begins.
///
/// limit: such as "4G" or a number of bytes; None for as much as the system allows.
///
/// A call that needs more raises oaktwin.Error. Up to 64 MiB are never checked. Raises oaktwin.Error for what is not a size.
#[pyfunction]
#[pyo3(signature = (limit))]
pub(crate) fn set_memory_limit(limit: Option<Bound<'_, PyAny>>) -> PyResult<()> {
    let bytes = match limit {
        None => None,
        Some(limit) => {
            let text = limit.str()?.to_string();
            let parsed = memory::parse_size(&text);
            Some(parsed.map_err(|is| wrong("limit", is, "pass a string such as \"4G\", or bytes"))?)
        }
    };
    memory::set_limit(bytes);
    Ok(())
}

/// Returns an error if less memory is free than needed, bytes. `less` is the way to need less.
pub(crate) fn check_free(name: &str, needed: u64, less: &str) -> PyResult<()> {
    memory::check(needed).map_err(|shortage| wrong(name, shortage.what(), shortage.remedy_or(less)))
}

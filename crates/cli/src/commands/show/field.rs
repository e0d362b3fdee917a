//! Lines with a label, and the sources of values.

use std::fmt::Write;

use oaktwin::catalog::{Source, Sourced, Sources};

pub(super) fn field(out: &mut String, label: &str, value: &str) {
    let _ = writeln!(out, "  {label:<26}{}", value.trim_end());
}

/// Marks estimates, also without `--provenance`.
pub(super) fn mark(table: &impl Sourced, key: &str) -> &'static str {
    mark_source(table.source_of(key))
}

/// Marks estimates of a table whose sources are known.
pub(super) fn mark_key(source: Source, others: &Sources, key: &str) -> &'static str {
    mark_source(others.get(key).copied().unwrap_or(source))
}

pub(super) fn mark_source(source: Source) -> &'static str {
    match source {
        Source::Estimate => " (estimate)",
        _ => "",
    }
}

pub(super) fn sources(out: &mut String, source: Source, others: &Sources) {
    let mut text = source.as_str().to_owned();
    for (key, source) in others {
        let _ = write!(text, "; {key}: {}", source.as_str());
    }
    field(out, "source", &text);
}

pub(super) fn triple([x, y, z]: [f64; 3]) -> String {
    // Adding 0 changes −0 to 0.
    format!("({:.2}, {:.2}, {:.2})", x + 0.0, y + 0.0, z + 0.0)
}

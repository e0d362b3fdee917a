//! Why a pixel has no value.

use oaktwin::image::Image;
use oaktwin::measure::Region;
use serde::Serialize;

use crate::station::Measurement;

#[derive(Debug, Serialize)]
pub(crate) struct Reason {
    code: u8,
    name: &'static str,
    documentation: &'static str,
}

const REASONS: [(&str, &str); 2] = [
    ("measured", "The pixel has a value."),
    ("not_measured", "The sensor reports no value."),
];

/// Returns all reasons by code.
pub(crate) fn all() -> Vec<Reason> {
    (0..)
        .zip(REASONS)
        .map(|(code, (name, documentation))| Reason {
            code,
            name,
            documentation,
        })
        .collect()
}

/// Returns the reason of each pixel of a measured image.
pub(crate) fn image(measurement: &Measurement) -> Image<u8> {
    measurement
        .capture
        .distance
        .0
        .map(|metres| u8::from(*metres <= 0.0))
}

/// Counts the pixels of each reason in a region.
pub(crate) fn count(reasons: &Image<u8>, region: &Region) -> Vec<u64> {
    let mut counts = vec![0; all().len()];
    let columns = region.columns.start as usize..region.columns.end as usize;
    let rows = reasons
        .rows()
        .skip(region.rows.start as usize)
        .take(region.rows.len());
    for code in rows.filter_map(|row| row.get(columns.clone())).flatten() {
        if let Some(count) = counts.get_mut(usize::from(*code)) {
            *count += 1;
        }
    }
    counts
}

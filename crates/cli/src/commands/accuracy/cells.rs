//! The cells of the tables of `accuracy`.

use oaktwin::accuracy::{AccuracyRow, Band, Reading};

use crate::number::{fixed, signed};

pub(super) fn distance(row: &AccuracyRow) -> String {
    let text = format!("{:.3}", row.distance_m);
    let whole = text.trim_end_matches('0');
    let digits = whole.len().max(text.len() - 1);
    text[..digits].to_owned()
}

/// Formats an error. The error of several devices is absolute and has no sign.
pub(super) fn error(reading: &Reading, many: bool) -> String {
    if many {
        fixed(reading.error_percent, 2)
    } else {
        signed(reading.error_percent, 2)
    }
}

pub(super) fn quartiles(reading: &Reading) -> String {
    reading
        .error_5_to_95_percent
        .or(reading.error_quartiles_percent)
        .map_or_else(|| "-".to_owned(), |[low, high]| format!("{low:.2}-{high:.2}"))
}

pub(super) fn band(row: &AccuracyRow) -> String {
    if row.bands.is_empty() {
        return "-".to_owned();
    }
    let one = |band: &Band| {
        let text = format!("{:.2}", band.error_percent);
        format!("<{}", text.trim_end_matches('0').trim_end_matches('.'))
    };
    row.bands.iter().map(one).collect::<Vec<_>>().join(" ")
}

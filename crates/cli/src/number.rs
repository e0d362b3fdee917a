//! Numbers in tables.

/// Formats a number with so many digits behind the point; a missing one is a hyphen.
pub(crate) fn fixed(value: Option<f64>, digits: usize) -> String {
    value.map_or_else(|| "-".to_owned(), |value| format!("{value:.digits$}"))
}

/// Formats a number with its sign; a missing one is a hyphen.
pub(crate) fn signed(value: Option<f64>, digits: usize) -> String {
    value.map_or_else(
        || "-".to_owned(),
        |value| {
            let text = format!("{value:+.digits$}");
            // Zero has no sign.
            if text.trim_start_matches(['+', '-', '0', '.']).is_empty() {
                text.replacen(['+', '-'], "", 1)
            } else {
                text
            }
        },
    )
}

/// Formats a share.
pub(crate) fn percent(share: f64) -> String {
    format!("{:.1} %", share * 100.0)
}

/// Formats millimetres; a missing number is a hyphen.
pub(crate) fn millimetres(value: Option<f64>) -> String {
    value.map_or_else(|| "-".to_owned(), |value| format!("{value:.1} mm"))
}

//! How the sheet prints numbers.

/// `value` with as many decimals as `like` has.
pub(crate) fn printed(value: f64, like: &str) -> String {
    let decimals = like.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    format!("{value:.decimals$}")
}

/// Our value, rounded to the digits printed, is what is printed.
#[track_caller]
pub(crate) fn assert_printed(value: f64, expected: &str, what: &str) {
    assert_eq!(printed(value, expected), expected, "{what}: {value}");
}

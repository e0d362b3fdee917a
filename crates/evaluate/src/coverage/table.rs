//! The results as a table.

use std::collections::BTreeSet;

use super::{CandidateCoverage, Coverage, Shares, reasons};

const COLUMNS: [&str; 17] = [
    "rank",
    "model",
    "engine",
    "name",
    "x_m",
    "y_m",
    "z_m",
    "qx",
    "qy",
    "qz",
    "qw",
    "height_m",
    "tilt_deg",
    "seen",
    "measured",
    "median_absolute_error_mm",
    "p95_absolute_error_mm",
];

impl Coverage {
    /// Returns the candidates as a table in CSV, best first, with a column for the share that is lost for each
    /// reason that occurs.
    #[must_use]
    pub fn to_csv(&self) -> String {
        table(&[], &[(&[], self)])
    }
}

/// Returns a table in CSV of the candidates of each coverage, best first, after columns that are the same for all of its rows.
pub(super) fn table(common: &[&str], parts: &[(&[String], &Coverage)]) -> String {
    let candidates = parts.iter().flat_map(|(_, coverage)| &coverage.candidates);
    let reasons = lost_columns(candidates.map(|candidate| &candidate.shares));
    let mut table = csv::Writer::from_writer(Vec::new());
    // Writing to memory does not fail.
    let _ = table.write_record(common.iter().chain(&COLUMNS).chain(&reasons));
    for (values, coverage) in parts {
        for (rank, &index) in (1..).zip(&coverage.ranking) {
            let row = row(rank, &coverage.candidates[index], &reasons);
            let _ = table.write_record(values.iter().chain(&row));
        }
    }
    let bytes = table.into_inner().unwrap_or_default();
    String::from_utf8_lossy(&bytes).into_owned()
}

/// Returns the names of the reasons for which something is lost.
pub(super) fn lost_columns<'a>(shares: impl Iterator<Item = &'a Shares>) -> Vec<&'static str> {
    let lost: BTreeSet<&str> = shares.flat_map(|shares| shares.lost.keys().copied()).collect();
    let reasons = reasons().iter().map(|reason| reason.name.as_str());
    reasons.filter(|name| lost.contains(name)).collect()
}

fn row(rank: usize, candidate: &CandidateCoverage, reasons: &[&str]) -> Vec<String> {
    let shares = &candidate.shares;
    let number = |value: f64| value.to_string();
    let maybe = |value: Option<f64>| value.map(number).unwrap_or_default();
    let texts = [&candidate.model, &candidate.engine, &candidate.name].map(String::clone);
    let mut row = vec![rank.to_string()];
    row.extend(texts);
    row.extend(candidate.position_m.map(number));
    row.extend(candidate.orientation.map(number));
    row.extend(
        [
            candidate.height_m,
            candidate.tilt_deg,
            shares.seen,
            shares.measured,
        ]
        .map(number),
    );
    row.extend([shares.median_absolute_error_mm, shares.p95_absolute_error_mm].map(maybe));
    let share = |reason: &&str| number(shares.lost.get(*reason).copied().unwrap_or(0.0));
    row.extend(reasons.iter().map(share));
    row
}

//! The distances to measure.

use super::AccuracyError;
use crate::list::{self, InvalidItem, tidy};
use crate::table::{CsvRow, TableProblem, wrong};

/// The minimum distance of a depth image in whole millimetres.
const NEAREST_M: f64 = 0.001;

/// The maximum distance of a depth image in whole millimetres.
pub const FARTHEST_M: f64 = 65.535;

/// The maximum number of default distances, so that the report fits on a page.
const MAX_DEFAULTS: u32 = 24;

/// Parses a comma-separated list of distances in metres and ranges `FROM:TO:STEP`.
///
/// # Errors
/// Returns an error if an item is not a distance or there are more than 10 000 distances.
pub fn parse(text: &str) -> Result<Vec<f64>, AccuracyError> {
    list::parse(text, "a distance", check)
        .map_err(|InvalidItem { text, what }| AccuracyError::Distances { text, what })
}

/// Returns an error if a distance cannot be measured.
pub(super) fn check(distance_m: f64) -> Result<f64, &'static str> {
    match distance_m {
        z if !z.is_finite() => Err("is not a finite number"),
        z if z <= 0.0 => Err("is not above 0"),
        z if z < NEAREST_M => Err("is nearer than 0.001 m, where a depth image in millimetres begins"),
        z if z > FARTHEST_M => Err("is farther than 65.535 m, where a depth image in millimetres ends"),
        z => Ok(z),
    }
}

/// Parses the distance in a row of a table.
pub(crate) fn in_row<const N: usize>(row: &CsvRow<N>, at: usize) -> Result<f64, TableProblem> {
    let distance_m = row.number(at)?;
    check(distance_m).map_err(|what| {
        wrong(
            format!("line {}: distance_m: {} {what}", row.line, row.fields[at]),
            "give metres",
        )
    })
}

/// Returns round distances between two limits, and the limits; the first one is rounded up to 0.1 m.
///
/// # Errors
/// Returns an error if a limit is not finite, or everything is too far for a depth image.
pub(super) fn between(nearest_m: f64, farthest_m: f64) -> Result<Vec<f64>, AccuracyError> {
    let from = (nearest_m * 10.0 - 1e-6).ceil().max(1.0) / 10.0;
    let problem = match nearest_m.is_finite() && farthest_m.is_finite() {
        false => Some("is not finite"),
        true if from > FARTHEST_M => Some("begins beyond 65.535 m, where a depth image in millimetres ends"),
        true => None,
    };
    if let Some(what) = problem {
        return Err(AccuracyError::Range {
            nearest_m,
            farthest_m,
            what,
        });
    }
    let to = farthest_m.clamp(from, FARTHEST_M);
    let steps = [0.1, 0.25, 0.5, 1.0, 2.5, 5.0];
    let step = steps
        .into_iter()
        .find(|step| (to - from) / step < f64::from(MAX_DEFAULTS - 1))
        .unwrap_or(5.0);
    let mut distances = vec![from];
    let first = (from / step + 1e-9).floor() + 1.0;
    let inner = (0..MAX_DEFAULTS).map(|i| tidy((first + f64::from(i)) * step));
    distances.extend(inner.take_while(|z| *z < to - 1e-9));
    if to > from {
        distances.push(to);
    }
    Ok(distances)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parses_lists_and_ranges() {
        assert_eq!(parse("2, 1,0.5,2").unwrap(), [0.5, 1.0, 2.0]);
        assert_eq!(parse("0.1:0.4:0.1,9").unwrap(), [0.1, 0.2, 0.3, 0.4, 9.0]);
        assert_eq!(parse("1:1:0.5").unwrap(), [1.0]);
    }

    #[test]
    fn rejects_invalid_distances() {
        for text in [
            "",
            "0",
            "-1",
            "1e-300",
            "0.0009",
            "nan",
            "inf",
            "1,,2",
            "x",
            "1:2",
            "2:1:1",
            "1:2:0",
            "1:2:-1",
            "1:2:nan",
            "1:60:1e-6",
            "66",
            "1:1e9:1e8",
            "1;2",
            "1:2:3:4",
        ] {
            assert!(parse(text).is_err(), "{text}");
        }
    }

    #[test]
    fn default_distances_are_round() {
        let between = |nearest, farthest| between(nearest, farthest).unwrap();
        let stereo = between(0.636, 10.5);
        assert_eq!(
            (stereo.first(), stereo.get(1), stereo.last()),
            (Some(&0.7), Some(&1.0), Some(&10.5))
        );
        assert_eq!(stereo.len(), 21);
        assert_eq!(between(0.2, 5.0)[..3], [0.2, 0.25, 0.5]);
        assert_eq!(between(2.0, 2.0), [2.0]);
        assert_eq!(between(3.0, 2.0), [3.0]);
        assert!(between(0.0, 1e9).len() <= MAX_DEFAULTS as usize);
        assert_eq!(between(-1e300, -1e300), [0.1]);
    }

    #[test]
    fn ranges_without_a_measurable_distance_are_errors() {
        for (nearest, farthest) in [
            (1e300, 10.0),
            (66.0, 1e9),
            (f64::INFINITY, 10.0),
            (f64::NAN, 10.0),
            (1.0, f64::NAN),
            (1.0, f64::INFINITY),
        ] {
            let error = between(nearest, farthest).unwrap_err().to_string();
            assert!(
                error.starts_with("distances: ") && error.contains("; "),
                "{error}"
            );
        }
    }
}

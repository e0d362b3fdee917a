//! Measured curves of a camera's error over distance.

use std::path::Path;

use super::{AccuracyError, distances};
use crate::table::{self, CsvRow, TableProblem, wrong};

const DISTANCE: &str = "distance_m";
const ERROR: &str = "depth_error_percent";
const MAX_PERCENT: f64 = 1e6;

/// A measured error; see [`MeasuredCurve`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// The true distance in metres.
    pub distance_m: f64,
    /// The error in percent of the true distance.
    pub error_percent: f64,
}

/// A measured curve of errors over distance.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredCurve {
    /// The points in the order of the file.
    pub points: Vec<Point>,
    /// Whether the errors are absolute: none is negative.
    pub is_absolute: bool,
}

/// Reads a CSV file with the columns `distance_m` and `depth_error_percent` among others.
///
/// # Errors
/// Returns an error if the file cannot be read, a column is missing, a number is invalid, or there are no rows.
pub fn read(path: &Path) -> Result<MeasuredCurve, AccuracyError> {
    of_text(path, &table::text(path, "a measured curve")?)
}

/// Reads the content of such a file; `path` is its name in errors.
///
/// # Errors
/// Returns an error if a column is missing, a number is invalid, or there are no rows.
pub fn of_text(path: &Path, text: &str) -> Result<MeasuredCurve, AccuracyError> {
    let points = parse(text).map_err(|wrong| wrong.of(path))?;
    let is_absolute = points.iter().all(|point| point.error_percent >= 0.0);
    Ok(MeasuredCurve { points, is_absolute })
}

fn parse(text: &str) -> Result<Vec<Point>, TableProblem> {
    let rows = table::rows(text, [DISTANCE, ERROR])?;
    let points = rows.iter().map(|row| {
        Ok(Point {
            distance_m: distances::in_row(row, 0)?,
            error_percent: error_in_row(row)?,
        })
    });
    points.collect()
}

/// Parses an error: of −100 %, nothing is in front of the camera.
fn error_in_row(row: &CsvRow<2>) -> Result<f64, TableProblem> {
    let error_percent = row.number(1)?;
    match error_percent > -100.0 && error_percent <= MAX_PERCENT {
        true => Ok(error_percent),
        false => Err(wrong(
            format!("line {}: {ERROR}: {} is out of range", row.line, row.fields[1]),
            format!("give percent of the distance, above -100 and up to {MAX_PERCENT}"),
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn accepts_columns_in_any_order() {
        let text = "\u{feff}unit,\"depth_error_percent\", distance_m\r\nA, 1.5 ,2\r\n\r\nB,-0.25,3.5\r\n";
        let points = parse(text).ok().unwrap();
        let expected = [(2.0, 1.5), (3.5, -0.25)].map(|(distance_m, error_percent)| Point {
            distance_m,
            error_percent,
        });
        assert_eq!(points, expected);
    }

    #[test]
    fn reports_the_line_of_an_error() {
        for (text, expected) in [
            ("", "is empty"),
            ("distance_m,depth_error_percent\n", "no row"),
            (
                "distance_m,error\n1,2\n",
                "line 1: there is no column depth_error_percent",
            ),
            ("distance_m;depth_error_percent\n1;2\n", "separated by ';'"),
            (
                "distance_m,depth_error_percent\n1,2\n2,nan\n",
                "line 3: depth_error_percent: \"nan\"",
            ),
            (
                "distance_m,depth_error_percent\n1,2\n2\n",
                "line 3: depth_error_percent: \"\"",
            ),
            (
                "distance_m,depth_error_percent\n\n0,2\n",
                "line 3: distance_m: 0 is not above 0",
            ),
            ("distance_m,depth_error_percent\n1e3,2\n", "farther than 65.535 m"),
            (
                "distance_m,depth_error_percent\n1,2\n1e-200,2\n",
                "line 3: distance_m: 1e-200 is nearer than 0.001 m",
            ),
            ("distance_m,depth_error_percent\n1,-100\n", "-100 is out of range"),
            ("distance_m,depth_error_percent\n1,1e300\n", "is out of range"),
        ] {
            let what = parse(text).err().map(|wrong| wrong.what).unwrap_or_default();
            assert!(what.contains(expected), "{text:?}: {what}");
        }
    }
}

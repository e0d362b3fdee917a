//! Somebody's measurements of a camera's error over distance.

use std::path::Path;

use super::{AccuracyError, distances};
use crate::files::{self, FileError};

const DISTANCE: &str = "distance_m";
const ERROR: &str = "depth_error_percent";

/// Far more than anybody measures.
const MOST_POINTS: usize = 10_000;

/// A measured error, percent of the distance: [`Curve`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// True distance, m.
    pub distance_m: f64,
    /// Percent of it.
    pub error_percent: f64,
}

/// A measured curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// In the file's order.
    pub points: Vec<Point>,
    /// Whether the errors have lost their sign: none is below 0.
    pub is_absolute: bool,
}

/// Reads a CSV file with the columns `distance_m` and `depth_error_percent` among others.
///
/// # Errors
/// It cannot be read; a column is missing; a number is none, or not finite; there is no row.
pub fn read(path: &Path) -> Result<Curve, AccuracyError> {
    let bytes = files::read(path, 1 << 20, "a measured curve")?;
    let text = std::str::from_utf8(&bytes)
        .map_err(|_| FileError::new(path, "is no text", "give a CSV file in UTF-8"))?;
    let points = parse(text).map_err(|wrong| FileError::new(path, wrong.what, wrong.remedy))?;
    let is_absolute = points.iter().all(|point| point.error_percent >= 0.0);
    Ok(Curve { points, is_absolute })
}

struct Wrong {
    what: String,
    remedy: String,
}

fn wrong(what: impl Into<String>, remedy: impl Into<String>) -> Wrong {
    Wrong {
        what: what.into(),
        remedy: remedy.into(),
    }
}

fn parse(text: &str) -> Result<Vec<Point>, Wrong> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut lines = (1..)
        .zip(text.lines())
        .filter(|(_, line)| !line.trim().is_empty());
    let Some((_, header)) = lines.next() else {
        return Err(wrong("is empty", format!("give the columns {DISTANCE},{ERROR}")));
    };
    let names: Vec<&str> = fields(header).collect();
    let place = |name: &str| {
        names.iter().position(|field| *field == name).ok_or_else(|| {
            let separator = [';', '\t'].into_iter().find(|c| header.contains(*c));
            match separator {
                Some(c) => wrong(
                    format!("line 1: there is no column {name}: they are apart by {c:?}"),
                    "separate them by commas, with points in the numbers",
                ),
                None => wrong(
                    format!("line 1: there is no column {name}"),
                    format!("name the columns {DISTANCE},{ERROR} in the first line"),
                ),
            }
        })
    };
    let (distance_at, error_at) = (place(DISTANCE)?, place(ERROR)?);
    let mut points = Vec::new();
    for (number, line) in lines {
        let fields: Vec<&str> = fields(line).collect();
        let value = |at: usize, name: &str| {
            let field = fields.get(at).copied().unwrap_or_default();
            let value = field.parse::<f64>().ok().filter(|value| value.is_finite());
            value.ok_or_else(|| {
                let what = format!("line {number}: {name}: {field:?} is no finite number");
                wrong(what, "correct it, or leave the line out")
            })
        };
        let distance_m = value(distance_at, DISTANCE)?;
        distances::check(distance_m).map_err(|what| {
            wrong(
                format!("line {number}: {DISTANCE}: {distance_m} {what}"),
                "give metres",
            )
        })?;
        points.push(Point {
            distance_m,
            error_percent: value(error_at, ERROR)?,
        });
        if points.len() > MOST_POINTS {
            return Err(wrong(
                format!("has more than {MOST_POINTS} rows"),
                "check that it is the right file",
            ));
        }
    }
    if points.is_empty() {
        return Err(wrong("has no row below its header", "give at least one"));
    }
    Ok(points)
}

fn fields(line: &str) -> impl Iterator<Item = &str> {
    line.split(',').map(|field| field.trim().trim_matches('"').trim())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_in_any_order() {
        let text = "\u{feff}unit,\"depth_error_percent\", distance_m\r\nA, 1.5 ,2\r\n\r\nB,-0.25,3.5\r\n";
        let points = parse(text).ok().unwrap();
        let expected = [(2.0, 1.5), (3.5, -0.25)].map(|(distance_m, error_percent)| Point {
            distance_m,
            error_percent,
        });
        assert_eq!(points, expected);
    }

    #[test]
    fn what_is_wrong_is_told_with_its_line() {
        for (text, expected) in [
            ("", "is empty"),
            ("distance_m,depth_error_percent\n", "no row"),
            (
                "distance_m,error\n1,2\n",
                "line 1: there is no column depth_error_percent",
            ),
            ("distance_m;depth_error_percent\n1;2\n", "apart by ';'"),
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
        ] {
            let what = parse(text).err().map(|wrong| wrong.what).unwrap_or_default();
            assert!(what.contains(expected), "{text:?}: {what}");
        }
        let long = format!(
            "distance_m,depth_error_percent\n{}",
            "1,1\n".repeat(MOST_POINTS + 1)
        );
        assert!(parse(&long).is_err());
    }
}

//! Findings about a fit, and the reasons why parameters cannot be fitted.

use super::super::point::Point;
use super::errors::{Errors, Systematic};
use oaktwin_base::diagnostic::{Finding, Level, Message, message, opt};

/// The vendor's published accuracy is within 0.35 px.
const MAX_BIAS_PX: f64 = 1.0;

/// The correlation above which bias and amplitude cannot be separated.
const MAX_CORRELATION: f64 = 0.98;

/// The share of the squares below which another focal length is significantly better.
const MUCH_BETTER: f64 = 0.5;
/// The required number of points for that.
const MIN_POINTS_FOR_FOCAL: usize = 10;

/// The required excess of points over parameters for a curve without known errors.
const MIN_EXCESS_POINTS: usize = 3;

/// Returns the reason why bias and locking, `wanted` parameters, cannot be fitted, and the remedy.
pub(super) fn not_identifiable(
    points: &[Point],
    found: Option<&Systematic>,
    wanted: usize,
    is_known: bool,
) -> Option<(String, Message)> {
    let mut distances: Vec<f64> = points.iter().map(|point| point.depth_m).collect();
    distances.sort_by(f64::total_cmp);
    distances.dedup_by(|a, b| (*a - *b).abs() <= 1e-6 * b.abs());
    let more = Message::from("record more distances, at all phases of a pixel of disparity");
    match distances.len() {
        0 => {
            return Some((
                "there is no true distance".to_owned(),
                message![
                    "give a distances.csv with columns file,distance_m, or an earlier ",
                    opt("from")
                ],
            ));
        }
        1 => {
            return Some((
                "bias and pixel locking cannot be separated with one distance".to_owned(),
                more,
            ));
        }
        _ => {}
    }
    let required = wanted + if is_known { 1 } else { MIN_EXCESS_POINTS };
    if distances.len() < required {
        let why = format!(
            "{} distances are too few; {required} are required",
            distances.len()
        );
        return Some((why, more));
    }
    let found = found?;
    match found.solution.correlation() {
        Some(correlation) if correlation.abs() <= MAX_CORRELATION => {}
        _ => {
            return Some((
                "all distances are at nearly the same phase of a pixel of disparity".to_owned(),
                more,
            ));
        }
    }
    let rival = found.rival.as_ref()?;
    Some((
        format!(
            "a bias of {:.3} px with a locking of {:.3} px fits as well as {:.3} px with {:.3} px",
            found.solution.parameters[0], found.solution.parameters[1], rival[0], rival[1]
        ),
        more,
    ))
}

/// Reports suspicious distances, optics and images.
pub(super) fn implausible(errors: &Errors<'_>, found: &Systematic, is_focal_free: bool) -> Vec<Finding> {
    let mut findings = Vec::new();
    let mut add = |code, place, message: String, remedy: Message| {
        findings.push(Finding::new(code, Level::Warning, place, message, remedy));
    };
    let bias = found.solution.parameters[0];
    let share = scale(errors);
    if let Some(share) = share {
        add(
            "wrong-scale",
            "focalLength",
            format!(
                "depth has an error of {:+.1} % at every distance, which a bias of disparity cannot cause",
                100.0 * share
            ),
            "check the distances, and the focal length and baseline with which the device computed depth"
                .into(),
        );
    }
    if bias.abs() > MAX_BIAS_PX && share.is_none() {
        add(
            "implausible-bias",
            "bias",
            format!("{bias:.2} px exceeds the error of any calibration"),
            message!["check the distances, the model and ", opt("focal-px")],
        );
    }
    if !is_focal_free
        && errors.points.len() >= MIN_POINTS_FOR_FOCAL
        && let Some(other) = errors.fit(true)
        && let Some(focal) = other.solution.parameters.get(2)
        && other.solution.squares < MUCH_BETTER * found.solution.squares
        && other.rival.is_none()
        && (focal - 1.0).abs() > 3.0 * other.solution.error(2).unwrap_or(f64::INFINITY)
        && (!found.is_known || found.solution.squares > 2.0 * found.solution.freedom as f64)
    {
        add(
            "other-focal-length",
            "focalLength",
            format!(
                "a change of {:+.2} % would reduce the squared residuals to {:.0} %",
                100.0 * (focal - 1.0),
                100.0 * other.solution.squares / found.solution.squares
            ),
            message![
                "set the unit's own ",
                opt("focal-px"),
                " or ",
                opt("calibration"),
                ", or fit it with ",
                opt("fit").with("focal")
            ],
        );
    }
    findings
}

/// Returns the share by which depth is wrong at every distance, if it is significant and above 1 %: the slope of the error of
/// disparity over disparity.
fn scale(errors: &Errors<'_>) -> Option<f64> {
    const MIN_SCALE: f64 = 0.01;
    if errors.is_absolute || errors.points.len() < 5 {
        return None;
    }
    let pairs: Vec<[f64; 2]> = errors
        .points
        .iter()
        .map(|point| {
            [
                errors.px_m / point.depth_m,
                errors.in_px(point.error, point.depth_m),
            ]
        })
        .collect();
    let count = pairs.len() as f64;
    let mean = [0, 1].map(|at| pairs.iter().map(|pair| pair[at]).sum::<f64>() / count);
    let sum = |of: &dyn Fn(f64, f64) -> f64| {
        pairs
            .iter()
            .map(|[x, y]| of(x - mean[0], y - mean[1]))
            .sum::<f64>()
    };
    let xx = sum(&|x, _| x * x);
    let slope = sum(&|x, y| x * y) / xx;
    let rest = sum(&|x, y| (y - slope * x).powi(2)) / (count - 2.0);
    let error = (rest / xx).sqrt();
    // A disparity that is too small by a share is a depth that is too large by it.
    (slope.abs() > MIN_SCALE && slope.abs() > 6.0 * error).then(|| -slope / (1.0 + slope))
}

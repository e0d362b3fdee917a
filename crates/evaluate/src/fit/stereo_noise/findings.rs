//! What cannot be found, and what is odd in what was.

use super::super::points::Point;
use super::errors::{Errors, Systematic};
use oaktwin_diagnostic::{Finding, Level, Message, message, opt};

/// The vendor's published accuracy is within 0.35 px.
const MOST_BIAS_PX: f64 = 1.0;

/// Bias and amplitude that stand for one another more than this are not told apart.
const MOST_CORRELATION: f64 = 0.98;

/// A focal length that leaves less than this of the squares is the better one.
const MUCH_BETTER: f64 = 0.5;
/// Not with fewer points.
const FEWEST_FOR_FOCAL: usize = 10;

/// Of a curve without known errors so many points more than parameters.
const FEWEST_MORE: usize = 3;

/// Why bias and locking, `wanted` parameters, cannot be found, and what to do.
pub(super) fn not_identifiable(
    points: &[Point],
    found: Option<&Systematic>,
    wanted: usize,
    is_known: bool,
) -> Option<(String, Message)> {
    let mut distances: Vec<f64> = points.iter().map(|point| point.depth_m).collect();
    distances.sort_by(f64::total_cmp);
    distances.dedup_by(|a, b| (*a - *b).abs() <= 1e-6 * b.abs());
    let more = Message::from("record more distances, on all phases of a pixel of disparity");
    match distances.len() {
        0 => {
            return Some((
                "no true distance is known".to_owned(),
                message![
                    "give a distances.csv with columns file,distance_m, or an earlier ",
                    opt("from")
                ],
            ));
        }
        1 => {
            return Some((
                "one distance does not tell bias and pixel locking apart".to_owned(),
                more,
            ));
        }
        _ => {}
    }
    let least = wanted + if is_known { 1 } else { FEWEST_MORE };
    if distances.len() < least {
        let why = format!("{} distances are too few, {least} are needed", distances.len());
        return Some((why, more));
    }
    let found = found?;
    match found.solution.correlation() {
        Some(correlation) if correlation.abs() <= MOST_CORRELATION => {}
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
            "a bias of {:.3} px with a locking of {:.3} px fits, and so do {:.3} px and {:.3} px",
            found.solution.parameters[0], found.solution.parameters[1], rival[0], rival[1]
        ),
        more,
    ))
}

/// Doubts about the distances, the optics or the images.
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
                "depth is {:+.1} % off at every distance, which no bias of disparity makes",
                100.0 * share
            ),
            "check the distances, and the focal length and baseline that the device computed depth with"
                .into(),
        );
    }
    if bias.abs() > MOST_BIAS_PX && share.is_none() {
        add(
            "implausible-bias",
            "bias",
            format!("{bias:.2} px is more than any calibration is off"),
            message!["check the distances, the model and ", opt("focal-px")],
        );
    }
    if !is_focal_free
        && errors.points.len() >= FEWEST_FOR_FOCAL
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
                "{:+.2} % of it would leave {:.0} % of the squared deviations",
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

/// By which share depth is off at every distance, where that is more than a hundredth and sure: the slope of the error in
/// disparity over disparity.
fn scale(errors: &Errors<'_>) -> Option<f64> {
    const LEAST: f64 = 0.01;
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
    // Disparity too small by a share is depth too large by it.
    (slope.abs() > LEAST && slope.abs() > 6.0 * error).then(|| -slope / (1.0 + slope))
}

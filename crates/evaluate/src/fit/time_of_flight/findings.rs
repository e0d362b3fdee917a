//! Findings about a fit, and the reasons why parameters cannot be fitted.

use super::super::point::Point;
use super::errors::WigglingFit;
use super::light::Light;
use oaktwin_base::diagnostic::{Finding, Level, Message, message, opt};

/// The correlation above which bias and amplitude cannot be separated.
const MAX_CORRELATION: f64 = 0.98;

/// The vendor publishes 1 % from 0.2 m.
const MAX_BIAS_M: f64 = 0.1;

/// The deviation of noise from the curve, in standard errors, above which the model does not fit.
const MAX_SCATTER: f64 = 4.0;

/// The required excess of points over parameters if errors are unknown.
const MIN_EXCESS_POINTS: usize = 3;

/// Returns the reason why bias and wiggling cannot be fitted, and the remedy.
pub(super) fn not_identifiable(points: &[Point], found: Option<&WigglingFit>) -> Option<(String, Message)> {
    let mut distances: Vec<f64> = points.iter().map(|point| point.depth_m).collect();
    distances.sort_by(f64::total_cmp);
    distances.dedup_by(|a, b| (*a - *b).abs() <= 1e-6 * b.abs());
    let more = Message::from(
        "record more distances, including some a few centimetres apart: the error repeats about every 0.4 m",
    );
    let required = match points.iter().all(|point| point.sigma.is_some()) {
        true => 3,
        false => 2 + MIN_EXCESS_POINTS,
    };
    match distances.len() {
        0 => {
            return Some((
                "there is no true distance within range".to_owned(),
                message![
                    "give a distances.csv with columns file,distance_m, or an earlier ",
                    opt("from")
                ],
            ));
        }
        1 => {
            return Some((
                "bias and wiggling cannot be separated with one distance".to_owned(),
                more,
            ));
        }
        count if count < required => {
            return Some((
                format!("{count} distances are too few; {required} are required"),
                more,
            ));
        }
        _ => {}
    }
    let found = found?;
    let correlation = found.solution.correlation();
    if correlation.is_none_or(|c| c.is_nan() || c.abs() > MAX_CORRELATION) {
        return Some(("all distances are at nearly the same phase".to_owned(), more));
    }
    let rival = found.rival.as_ref()?;
    let [a, b] = [&found.solution.parameters, rival].map(|p| 1e3 * p[0]);
    Some((
        format!("for absolute errors, biases of {a:.2} mm and {b:.2} mm fit equally well"),
        "give signed errors".into(),
    ))
}

/// Reports suspicious distances and devices.
pub(super) fn implausible(found: &WigglingFit, wiggling: &'static str) -> Vec<Finding> {
    let mut findings = Vec::new();
    let bias_m = found.solution.parameters[0];
    if bias_m.abs() > MAX_BIAS_M {
        findings.push(Finding::new(
            "implausible-bias",
            Level::Warning,
            "bias",
            format!("{bias_m:.3} m exceeds the error of any camera"),
            "check the distances and the point from which they were measured",
        ));
    }
    if let Some([_, high]) = found.solution.interval(1, 1.0, found.is_known)
        && high < 0.0
    {
        findings.push(Finding::new(
            "other-phase",
            Level::Warning,
            wiggling,
            "the periodic error has the opposite sign of the engine's; 0 is the closest value".to_owned(),
            "check the modulation frequencies, and whether the correction was enabled",
        ));
    }
    findings
}

/// Reports suspicious noise.
pub(super) fn of_light(light: &Light) -> Option<Finding> {
    let scatter = light.scatter.filter(|scatter| *scatter > MAX_SCATTER)?;
    Some(Finding::new(
        "other-noise",
        Level::Warning,
        "signal",
        format!("noise over distance differs from the model of light by {scatter:.1} standard errors"),
        "does the target have a uniform albedo? was the illumination the same at all distances? were filters enabled?",
    ))
}

/// Reports frames that share measurements in another way than the engine's parameters state.
pub(super) fn other_sharing(shared: f64) -> Finding {
    let message = if shared > 0.0 {
        "consecutive frames share half of their noise, as without burst mode; the fit assumes this"
    } else {
        "consecutive frames share no noise, as in burst mode; the fit assumes this"
    };
    Finding::new(
        "shared-noise",
        Level::Note,
        "enableBurstMode",
        message.to_owned(),
        "",
    )
}

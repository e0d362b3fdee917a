//! What cannot be found, and what is odd in what was.

use super::super::points::Point;
use super::errors::Found;
use super::light::Light;
use oaktwin_diagnostic::{Finding, Level, Message, message, opt};

/// Bias and amplitude that stand for one another more than this are not told apart.
const MOST_CORRELATION: f64 = 0.98;

/// The vendor publishes 1 % of 0.2 m and more.
const MOST_BIAS_M: f64 = 0.1;

/// Noise that is off the curve by so many standard errors is of something else.
const MOST_SCATTER: f64 = 4.0;

/// Of points without known errors so many more than parameters.
const FEWEST_MORE: usize = 3;

/// Why bias and wiggling cannot be found, and what to do.
pub(super) fn not_identifiable(points: &[Point], found: Option<&Found>) -> Option<(String, Message)> {
    let mut distances: Vec<f64> = points.iter().map(|point| point.depth_m).collect();
    distances.sort_by(f64::total_cmp);
    distances.dedup_by(|a, b| (*a - *b).abs() <= 1e-6 * b.abs());
    let more = Message::from(
        "record more distances, a few centimetres apart too: the error repeats every 0.4 m or so",
    );
    let least = match points.iter().all(|point| point.sigma.is_some()) {
        true => 3,
        false => 2 + FEWEST_MORE,
    };
    match distances.len() {
        0 => {
            return Some((
                "no true distance within range is known".to_owned(),
                message![
                    "give a distances.csv with columns file,distance_m, or an earlier ",
                    opt("from")
                ],
            ));
        }
        1 => {
            return Some((
                "one distance does not tell bias and wiggling apart".to_owned(),
                more,
            ));
        }
        count if count < least => {
            return Some((format!("{count} distances are too few, {least} are needed"), more));
        }
        _ => {}
    }
    let found = found?;
    let correlation = found.solution.correlation();
    if correlation.is_none_or(|c| c.is_nan() || c.abs() > MOST_CORRELATION) {
        return Some(("all distances are at nearly the same phase".to_owned(), more));
    }
    let rival = found.rival.as_ref()?;
    let [a, b] = [&found.solution.parameters, rival].map(|p| 1e3 * p[0]);
    Some((
        format!("without signs of the errors a bias of {a:.2} mm fits, and so does {b:.2} mm"),
        "give errors with their signs".into(),
    ))
}

/// Doubts about distances and device.
pub(super) fn implausible(found: &Found, wiggling: &'static str) -> Vec<Finding> {
    let mut findings = Vec::new();
    let bias_m = found.solution.parameters[0];
    if bias_m.abs() > MOST_BIAS_M {
        findings.push(Finding::new(
            "implausible-bias",
            Level::Warning,
            "bias",
            format!("{bias_m:.3} m is more than any camera is off"),
            "check the distances, and from where they were measured",
        ));
    }
    if let Some([_, high]) = found.solution.interval(1, 1.0, found.is_known)
        && high < 0.0
    {
        findings.push(Finding::new(
            "other-phase",
            Level::Warning,
            wiggling,
            "the error that repeats has the opposite sign of the engine's: 0 is as near as it comes"
                .to_owned(),
            "check the modulation frequencies, and whether the correction was on",
        ));
    }
    findings
}

/// Doubts about the noise.
pub(super) fn of_light(light: &Light) -> Option<Finding> {
    let scatter = light.scatter.filter(|scatter| *scatter > MOST_SCATTER)?;
    Some(Finding::new(
        "other-noise",
        Level::Warning,
        "signal",
        format!("noise over distance is {scatter:.1} standard errors off what light makes it"),
        "is the target of one albedo, and the lamp's light alike at all distances? were filters on?",
    ))
}

/// Frames that share other measurements than the engine's parameters say.
pub(super) fn other_sharing(shared: f64) -> Finding {
    let message = if shared > 0.0 {
        "half of a frame's noise is the next one's too, as without burst mode: it is taken so"
    } else {
        "frames one after the other share no noise, as in burst mode: it is taken so"
    };
    Finding::new(
        "shared-noise",
        Level::Note,
        "enableBurstMode",
        message.to_owned(),
        "",
    )
}

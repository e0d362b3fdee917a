//! Findings about a recording.

use super::error_domain::ErrorDomain;
use super::target::Observation;
use oaktwin_base::diagnostic::{Finding, Level};

/// The share of valid pixels below which a target is reported.
const MIN_FILL_RATE: f64 = 0.5;

/// The share of mismatches above which a target is reported.
const MAX_MISMATCH_RATE: f64 = 0.05;

pub(super) fn of_targets(
    observations: &[Observation],
    error_domain: ErrorDomain,
    findings: &mut Vec<Finding>,
) {
    let [brighter, filled] = match error_domain {
        ErrorDomain::Disparity { .. } => [
            "give the target more texture, or the region another size",
            "does the target fill the region?",
        ],
        ErrorDomain::Depth => [
            "give a brighter target, or the region another size",
            "does the target fill the region? in low light, phases are unwrapped to wrong periods",
        ],
    };
    for one in observations {
        let mut add = |code, message: String, remedy| {
            findings.push(Finding::new(code, Level::Warning, &one.name, message, remedy));
        };
        let percent = |share: f64| 100.0 * share;
        if one.values() == 0 {
            add(
                "nothing-measured",
                format!(
                    "no pixel of the region is valid in any of {} frames: ignored",
                    one.frames
                ),
                "is it nearer than the minimum distance of the sensor?",
            );
        } else if one.fill_rate < MIN_FILL_RATE {
            add(
                "few-pixels",
                format!(
                    "only {:.0} % of the region's pixels are valid",
                    percent(one.fill_rate)
                ),
                brighter,
            );
        }
        if one.mismatch_rate > MAX_MISMATCH_RATE {
            add(
                "mismatches",
                format!(
                    "{:.1} % of the region's pixels differ greatly from the others",
                    percent(one.mismatch_rate)
                ),
                filled,
            );
        }
    }
}

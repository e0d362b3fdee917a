//! What is odd in a recording.

use super::counting::Counting;
use super::target::Seen;
use oaktwin_diagnostic::{Finding, Level};

/// Less of a region than this is a poor target.
const LEAST_FILL: f64 = 0.5;

/// More mismatches than this are no exception.
const MOST_MISMATCHES: f64 = 0.05;

pub(super) fn of_targets(seen: &[Seen], counting: Counting, findings: &mut Vec<Finding>) {
    let [brighter, filled] = match counting {
        Counting::Disparity { .. } => [
            "give the target more texture, or the region another size",
            "does the target fill the region?",
        ],
        Counting::Depth => [
            "give a brighter target, or the region another size",
            "does the target fill the region? of little light wrong periods are found",
        ],
    };
    for one in seen {
        let mut add = |code, message: String, remedy| {
            findings.push(Finding::new(code, Level::Warning, &one.name, message, remedy));
        };
        let percent = |share: f64| 100.0 * share;
        if one.values() == 0 {
            add(
                "nothing-measured",
                format!(
                    "no pixel of the region has a value in any of {} frames: left out",
                    one.frames
                ),
                "is it nearer than the sensor measures?",
            );
        } else if one.fill_rate < LEAST_FILL {
            add(
                "few-pixels",
                format!(
                    "only {:.0} % of the region's pixels have a value",
                    percent(one.fill_rate)
                ),
                brighter,
            );
        }
        if one.mismatch_rate > MOST_MISMATCHES {
            add(
                "mismatches",
                format!(
                    "{:.1} % of the region's pixels are far from the others",
                    percent(one.mismatch_rate)
                ),
                filled,
            );
        }
    }
}

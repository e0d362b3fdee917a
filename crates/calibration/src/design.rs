//! The baseline with which the device converts disparity to depth: the one of the board's design, unless the file says otherwise.
//! `DepthAI` reads `stereoUseSpecTranslation`, whose default is true.

use oaktwin_base::diagnostic::{Finding, Level};
use oaktwin_catalog::Twin;

use crate::Calibration;
use crate::against::{pair_of, socket_of};

/// The relative difference of the baselines that is worth a note.
const NOTABLE: f64 = 3e-3;
/// The relative difference that causes a warning: half the best accuracy that the vendor states.
const SUSPICIOUS: f64 = 1e-2;

/// Sets the baselines of a calibrated twin with which its processor converts disparity to depth.
pub(crate) fn apply(calibration: &Calibration, twin: &mut Twin, findings: &mut Vec<Finding>) {
    if !calibration.use_spec_translation {
        return;
    }
    let socket = |role| socket_of(twin.camera(role)?);
    let design = |(left, right)| {
        let baseline_m = calibration.baseline(socket(left)?, socket(right)?, true).ok()?;
        (baseline_m > 0.0).then_some(baseline_m)
    };
    let pairs = twin.baselines_m().into_keys();
    twin.design_baselines_m = pairs.filter_map(|pair| Some((pair, design(pair)?))).collect();
    findings.extend(finding(calibration, twin));
}

/// Reports the error of depth that the design's baseline causes.
fn finding(calibration: &Calibration, twin: &Twin) -> Option<Finding> {
    let (left, right) = pair_of(twin)?;
    let calibrated = calibration.baseline(left, right, false).ok()?;
    let place = "stereoUseSpecTranslation";
    let design = calibration.baseline(left, right, true).ok()?;
    let error = design / calibrated - 1.0;
    if error.abs() < NOTABLE {
        return None;
    }
    let message = format!(
        "as on the device, depth is computed with the baseline of the board's design, {:.2} mm, not with the calibrated {:.2} mm, \
         so it is {:.1} % too {}",
        design * 1e3,
        calibrated * 1e3,
        error.abs() * 100.0,
        if error > 0.0 { "large" } else { "small" }
    );
    let (level, remedy) = if error.abs() < SUSPICIOUS {
        (Level::Note, "")
    } else {
        let remedy = "set stereoUseSpecTranslation to false, in the device's calibration as well, to use the calibrated baseline";
        (Level::Warning, remedy)
    };
    Some(Finding::new("design-baseline", level, place, message, remedy))
}

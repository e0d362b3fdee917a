//! Errors at known distances.

use std::collections::BTreeMap;

use super::FitError;
use super::error_domain::ErrorDomain;
use super::method::Method;
use super::point::{OfTarget, Point};
use super::recording::TargetRecording;
use super::report::TargetReport;
use super::target::{Observation, Sum};
use crate::accuracy::measured::MeasuredCurve;
use oaktwin_base::diagnostic::{Finding, Level, message, opt};
use oaktwin_files::FileError;

/// The rotation above which a target does not measure a distance.
const MAX_TILT_DEG: f64 = 5.0;

/// The rotation, in degrees and in standard errors, below which it is ignored.
const MIN_TILT_DEG: f64 = 0.3;
const MIN_TILT_ERRORS: f64 = 4.0;

/// Returns the errors of a measured curve.
pub(super) fn of_curve(curve: &MeasuredCurve) -> Vec<OfTarget> {
    let points = curve.points.iter().map(|point| OfTarget {
        target: None,
        point: Point {
            depth_m: point.distance_m,
            error: point.error_percent / 100.0,
            sigma: None,
        },
    });
    points.collect()
}

/// Returns an error if the images differ in size.
pub(super) fn of_one_size(
    observations: &[Observation],
    recordings: &[TargetRecording],
) -> Result<(), FitError> {
    let mut both = observations.iter().zip(recordings);
    let Some((first, _)) = both.next() else {
        return Ok(());
    };
    match both.find(|(one, _)| one.size != first.size) {
        Some((other, recording)) => {
            let path = recording
                .files
                .first()
                .map(|files| files.sensed.clone())
                .unwrap_or_default();
            let message = format!("it is {}, but {} is {}", other.size, first.name, first.size);
            Err(FileError::new(&path, message, "give images of one camera in one mode").into())
        }
        None => Ok(()),
    }
}

/// The rotation of targets: the relative change of inverse depth to the right and down per unit at depth 1.
pub(super) struct Tilts {
    /// The rotation of each target with its standard error and the scatter of its plane.
    own: BTreeMap<String, TargetTilt>,
    /// The rotation to apply to the true distances.
    common: Option<[f64; 2]>,
}

#[derive(Clone, Copy)]
struct TargetTilt {
    slope: [f64; 2],
    error: [f64; 2],
    rms: f64,
}

impl Tilts {
    pub(super) fn common_deg(&self) -> Option<f64> {
        self.common.map(degrees)
    }
}

fn degrees([right, down]: [f64; 2]) -> f64 {
    right.hypot(down).atan().to_degrees()
}

/// Estimates the rotation of targets without ground truth images. A periodic error bends the plane through a target that
/// spans less than a period, so all targets are combined.
pub(super) fn tilts(
    observations: &[Observation],
    method: &dyn Method,
    findings: &mut Vec<Finding>,
) -> Result<Tilts, FitError> {
    let mut own = BTreeMap::new();
    for one in observations.iter().filter(|one| !one.cells.is_empty()) {
        let Some(([middle, right, down], rms)) = one.plane() else {
            continue;
        };
        let variance = match method.variance_of_mean(one, one.values()) {
            Some(variance) => variance.max(1e-8),
            // Neighbours are assumed to be correlated over a window of 7.
            None => rms * rms * 49.0 / one.values() as f64 + 1e-8,
        };
        let sign = method.error_domain().per_inverse_depth();
        let of = TargetTilt {
            slope: [sign * right / middle, sign * down / middle],
            error: one.extent().map(|squares| (variance / squares).sqrt() / middle),
            rms,
        };
        own.insert(one.name.clone(), of);
    }
    let mean = |axis: usize| {
        let (mut sum, mut weight) = (0.0, 0.0);
        for one in own.values() {
            let w = one.error[axis].powi(-2);
            sum += w * one.slope[axis];
            weight += w;
        }
        (sum / weight, weight.powf(-0.5))
    };
    let ([right, down], [right_error, down_error]) = {
        let (right, down) = (mean(0), mean(1));
        ([right.0, down.0], [right.1, down.1])
    };
    let common = [right, down];
    let angle = degrees(common);
    let is_sure = right.abs() > MIN_TILT_ERRORS * right_error || down.abs() > MIN_TILT_ERRORS * down_error;
    let is_turned = own.values().next().is_some() && angle > MIN_TILT_DEG && is_sure;
    if is_turned && angle > MAX_TILT_DEG {
        let (name, _) = own
            .iter()
            .max_by(|a, b| degrees(a.1.slope).total_cmp(&degrees(b.1.slope)))
            .map_or((String::new(), 0.0), |(name, own)| {
                (name.clone(), degrees(own.slope))
            });
        return Err(FitError::Option(message![
            format!(
                "{name}: the target is tilted by {angle:.1}°, more than the {MAX_TILT_DEG}° that can be corrected; \
                 record it perpendicular to the camera, or decrease "
            ),
            opt("region")
        ]));
    }
    if is_turned {
        findings.push(Finding::new(
            "turned",
            Level::Note,
            "target",
            format!("is rotated by {angle:.2}°; the true distances are corrected for this"),
            "",
        ));
    }
    Ok(Tilts {
        own,
        common: is_turned.then_some(common),
    })
}

/// Reports problems of a target.
pub(super) fn target(one: &Observation, tilts: &Tilts, method: &dyn Method) -> TargetReport {
    let own = tilts.own.get(&one.name);
    let variance = method.variance(one);
    let step = method.step();
    let fixed = own
        .zip(variance)
        .filter(|_| one.square == 1)
        .map(|(own, variance)| {
            let by_time = variance.max(step * step / 12.0) / one.frames as f64;
            (own.rms.powi(2) - by_time).max(0.0).sqrt()
        });
    TargetReport {
        name: one.name.clone(),
        distance_m: one.distance_m,
        frames: one.frames,
        fill_rate: one.fill_rate,
        mismatch_rate: one.mismatch_rate,
        tilt_deg: own.map(|own| degrees(own.slope)),
        temporal_noise: variance.map(f64::sqrt),
        fixed_pattern: fixed,
    }
}

/// Returns the errors of targets with a known true distance.
pub(super) fn of_targets(observations: &[Observation], tilts: &Tilts, method: &dyn Method) -> Vec<OfTarget> {
    let error_domain = method.error_domain();
    let mut points = Vec::new();
    for (target, one) in observations.iter().enumerate() {
        let sums = match one.distance_m {
            _ if !one.by_truth.is_empty() => one.by_truth.clone(),
            Some(distance_m) => by_truth(one, error_domain, distance_m, tilts.common),
            None => continue,
        };
        for sum in sums.into_iter().filter(|sum| sum.values > 0) {
            // The stated distance, if there is one.
            let depth_m = match one
                .distance_m
                .filter(|_| one.by_truth.is_empty() && tilts.common.is_none())
            {
                Some(distance_m) => distance_m,
                None => error_domain.depth_m(sum.mean_truth()),
            };
            let [truth, measured] =
                [sum.mean_truth(), sum.mean_measured()].map(|value| error_domain.depth_m(value));
            let variance = method
                .variance_of_mean(one, sum.values)
                .map(|noise| noise + method.variance_of_rounding(one));
            points.push(OfTarget {
                target: Some(target),
                point: Point {
                    depth_m,
                    error: measured / truth - 1.0,
                    sigma: variance.map(f64::sqrt),
                },
            });
        }
    }
    points
}

/// Groups the cells of a target by their true value; `distance_m` is the centre's.
#[expect(clippy::cast_possible_truncation, reason = "values are below 2⁶³ bins")]
fn by_truth(
    one: &Observation,
    error_domain: ErrorDomain,
    distance_m: f64,
    tilt: Option<[f64; 2]>,
) -> Vec<Sum> {
    let middle = error_domain.of_depth(distance_m);
    let mut sums: BTreeMap<i64, Sum> = BTreeMap::new();
    for cell in &one.cells {
        let [right, down] = tilt.unwrap_or_default();
        let turned = distance_m / (1.0 + right * cell.at[0] + down * cell.at[1]);
        let truth = error_domain.of_depth(turned);
        let bin = ((truth - middle) / error_domain.turned_bin()).round() as i64;
        let sum = sums.entry(bin).or_default();
        sum.truth += truth * cell.sum.values as f64;
        sum.measured += cell.sum.measured;
        sum.values += cell.sum.values;
    }
    sums.into_values().collect()
}

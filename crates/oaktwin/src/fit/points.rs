//! From what was seen to errors at known distances.

use std::collections::BTreeMap;

use super::FitError;
use super::noise::Noise;
use super::recording::Stand;
use super::report::Target;
use super::stereo_noise::Point;
use super::target::{Look, Seen, Sum};
use crate::accuracy::measured::Curve;
use crate::diagnostic::{Finding, Level};
use crate::files::FileError;

/// A target that is turned farther is no measurement of a distance.
const MOST_TILT_DEG: f64 = 5.0;

/// A turn that is less than this, or than so many standard errors, is none.
const LEAST_TILT_DEG: f64 = 0.3;
const LEAST_ERRORS: f64 = 4.0;

/// Truths of a turned target are put together within this, px.
const BIN_PX: f64 = 1.0 / 32.0;

/// Jitter, in units of what is rounded to, above which rounding is as good as random.
const FEWEST_ALIKE: f64 = 3.54;

/// An error of one target.
#[derive(Clone, Copy, Debug)]
pub(super) struct OfTarget {
    /// Which.
    pub(super) target: Option<usize>,
    pub(super) point: Point,
}

/// The errors of a measured curve.
pub(super) fn of_curve(curve: &Curve) -> Vec<OfTarget> {
    let points = curve.points.iter().map(|point| OfTarget {
        target: None,
        point: Point {
            depth_m: point.distance_m,
            error: point.error_percent / 100.0,
            sigma_px: None,
        },
    });
    points.collect()
}

/// Refuses images of several sizes.
pub(super) fn of_one_size(seen: &[Seen], stands: &[Stand]) -> Result<(), FitError> {
    let mut both = seen.iter().zip(stands);
    let Some((first, _)) = both.next() else {
        return Ok(());
    };
    match both.find(|(one, _)| one.size != first.size) {
        Some((other, stand)) => {
            let path = stand
                .files
                .first()
                .map(|files| files.sensed.clone())
                .unwrap_or_default();
            let message = format!("is {}, and {} is {}", other.size, first.name, first.size);
            Err(FileError::new(&path, message, "give images of one camera in one mode").into())
        }
        None => Ok(()),
    }
}

/// How targets are turned: of each how much inverse depth grows to the right and down, as a share of it, to a unit at
/// depth 1.
pub(super) struct Tilts {
    /// Of each target by itself, with the standard error, and the plane's scatter; in their order.
    own: BTreeMap<String, Own>,
    /// What is put into the truth.
    common: Option<[f64; 2]>,
}

#[derive(Clone, Copy)]
struct Own {
    slope: [f64; 2],
    error: [f64; 2],
    rms_px: f64,
}

impl Tilts {
    pub(super) fn common_deg(&self) -> Option<f64> {
        self.common.map(degrees)
    }
}

fn degrees([right, down]: [f64; 2]) -> f64 {
    right.hypot(down).atan().to_degrees()
}

/// Of targets without images of the truth. Pixel locking bends the plane through one target, which spans less than a
/// pixel: all together tell.
pub(super) fn tilts(
    seen: &[Seen],
    noise: Option<&Noise>,
    findings: &mut Vec<Finding>,
) -> Result<Tilts, FitError> {
    let mut own = BTreeMap::new();
    for one in seen.iter().filter(|one| !one.places.is_empty()) {
        let Some(([middle, right, down], rms_px)) = one.plane() else {
            continue;
        };
        let variance = match noise {
            Some(noise) => noise.of_mean(one.values()).max(1e-8),
            // As if neighbours were alike over a window of 7.
            None => rms_px * rms_px * 49.0 / one.values() as f64 + 1e-8,
        };
        let of = Own {
            slope: [right / middle, down / middle],
            error: one.extent().map(|squares| (variance / squares).sqrt() / middle),
            rms_px,
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
    let is_sure = right.abs() > LEAST_ERRORS * right_error || down.abs() > LEAST_ERRORS * down_error;
    let is_turned = own.values().next().is_some() && angle > LEAST_TILT_DEG && is_sure;
    if is_turned && angle > MOST_TILT_DEG {
        let (name, _) = own
            .iter()
            .max_by(|a, b| degrees(a.1.slope).total_cmp(&degrees(b.1.slope)))
            .map_or((String::new(), 0.0), |(name, own)| {
                (name.clone(), degrees(own.slope))
            });
        return Err(FitError::Option(format!(
            "{name}: the target is turned by {angle:.1}°, more than the {MOST_TILT_DEG}° that can be corrected; \
             record it perpendicular to the camera, or give a smaller --region"
        )));
    }
    if is_turned {
        findings.push(Finding::new(
            "turned",
            Level::Note,
            "target",
            format!("is turned by {angle:.2}°: that is put into the truth"),
            "",
        ));
    }
    Ok(Tilts {
        own,
        common: is_turned.then_some(common),
    })
}

/// What there is to say about a target.
pub(super) fn target(one: &Seen, tilts: &Tilts, step_px: f64) -> Target {
    let own = tilts.own.get(&one.name);
    let variance = one.variance();
    let fixed = own
        .zip(variance)
        .filter(|_| one.square == 1)
        .map(|(own, variance)| {
            let by_time = variance.max(step_px * step_px / 12.0) / one.frames as f64;
            (own.rms_px.powi(2) - by_time).max(0.0).sqrt()
        });
    Target {
        name: one.name.clone(),
        distance_m: one.distance_m,
        frames: one.frames,
        fill_rate: one.fill_rate,
        mismatch_rate: one.mismatch_rate,
        tilt_deg: own.map(|own| degrees(own.slope)),
        temporal_noise_px: variance.map(f64::sqrt),
        fixed_pattern_px: fixed,
    }
}

/// The errors of targets whose truth is known.
pub(super) fn of_targets(seen: &[Seen], tilts: &Tilts, noise: Option<&Noise>, look: &Look) -> Vec<OfTarget> {
    let mut points = Vec::new();
    for (target, one) in seen.iter().enumerate() {
        let sums = match one.distance_m {
            _ if !one.by_truth.is_empty() => one.by_truth.clone(),
            Some(distance_m) => by_truth(one, look.px_m / distance_m, tilts.common),
            None => continue,
        };
        for sum in sums.into_iter().filter(|sum| sum.values > 0) {
            // As it was given, where it is one.
            let depth_m = match one
                .distance_m
                .filter(|_| one.by_truth.is_empty() && tilts.common.is_none())
            {
                Some(distance_m) => distance_m,
                None => look.px_m / sum.truth(),
            };
            let sigma = |noise: &Noise| {
                let variance =
                    noise.of_mean(sum.values) + rounding(noise.sigma_px, look.step_px, one.unit_px);
                variance.sqrt()
            };
            points.push(OfTarget {
                target: Some(target),
                point: Point {
                    depth_m,
                    error: sum.truth() / sum.measured() - 1.0,
                    sigma_px: noise.map(sigma),
                },
            });
        }
    }
    points
}

/// The places of a target put together by their truth, of which `truth_px` is that in the middle.
#[expect(clippy::cast_possible_truncation, reason = "disparities are below 2⁶³ bins")]
fn by_truth(one: &Seen, truth_px: f64, tilt: Option<[f64; 2]>) -> Vec<Sum> {
    let mut sums: BTreeMap<i64, Sum> = BTreeMap::new();
    for place in &one.places {
        let [right, down] = tilt.unwrap_or_default();
        let truth = truth_px * (1.0 + right * place.at[0] + down * place.at[1]);
        let bin = ((truth - truth_px) / BIN_PX).round() as i64;
        let sum = sums.entry(bin).or_default();
        sum.truth_px += truth * place.sum.values as f64;
        sum.measured_px += place.sum.measured_px;
        sum.values += place.sum.values;
    }
    sums.into_values().collect()
}

/// What is left of rounding in a mean, px²: noise evens steps out, millimetres as far as they fall on several steps.
fn rounding(sigma_px: f64, step_px: f64, unit_px: f64) -> f64 {
    let left = |of: f64| {
        let turns = std::f64::consts::TAU * sigma_px / of;
        of * of / 12.0 * (-turns * turns).exp()
    };
    let steps = left(step_px);
    if unit_px <= 0.0 {
        return steps;
    }
    let alike = (step_px / (FEWEST_ALIKE * sigma_px)).min(1.0) * unit_px * unit_px / 12.0;
    steps + left(unit_px).max(alike)
}

/// The odd side in matcher pixels of a window so wide in an image, `image_px` pixels of which are a matcher pixel.
pub(super) fn matcher_window(side: usize, image_px: f64) -> f64 {
    let sides = (0..32u32).map(|i| f64::from(2 * i + 1));
    let width = side as f64;
    let exact = |matcher: f64| (matcher * image_px).round().max(1.0) - width;
    sides
        .min_by(|a, b| {
            let off = |matcher: f64| (exact(matcher).abs(), (matcher * image_px - width).abs());
            let ((a0, a1), (b0, b1)) = (off(*a), off(*b));
            a0.total_cmp(&b0).then(a1.total_cmp(&b1))
        })
        .unwrap_or(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn windows_in_matcher_pixels() {
        assert_eq!(matcher_window(7, 1.0), 7.0);
        assert_eq!(matcher_window(4, 0.5), 7.0);
        assert_eq!(matcher_window(1, 0.1), 9.0);
        assert_eq!(matcher_window(6, 1.0), 5.0);
        assert_eq!(matcher_window(500, 1.0), 63.0);
    }

    #[test]
    fn noise_evens_rounding_out() {
        assert!((rounding(0.0, 0.25, 0.0) - 0.0625 / 12.0).abs() < 1e-12);
        assert!(rounding(0.25, 0.25, 0.0) < 1e-15);
        let coarse = rounding(0.05, 1.0 / 32.0, 0.06);
        assert!(coarse > 0.0 && coarse < 0.06f64.powi(2) / 12.0);
    }
}

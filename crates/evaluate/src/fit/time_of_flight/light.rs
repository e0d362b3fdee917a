//! The light that explains the increase of noise with distance.

use oaktwin_depth::time_of_flight::Parameters;

use super::super::least_squares::{Problem, Solution, solve};
use super::rays::mean;

/// The correlation above which signal and ambient light cannot be separated.
const MAX_CORRELATION: f64 = 0.98;

/// The uncertainty of ambient light, as a share of the light at the farthest target, above which it is unknown.
const MAX_AMBIENT_ERROR: f64 = 0.5;

/// The unit of ambient light in electrons, which makes the numbers of the fit close to 1.
const AMBIENT_UNIT_E: f64 = 100.0;

/// The noise of one target.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Noise {
    pub(super) depth_m: f64,
    /// The variance of depth without rounding, m².
    pub(super) variance_m2: f64,
    /// The relative standard error of the variance.
    pub(super) error: f64,
}

/// Returns the variance of a pixel's depth in m², averaged over the region.
pub(super) fn variance_m2(p: &Parameters, rays: &[f64], depth_m: f64) -> f64 {
    mean(rays, |ray| {
        p.range_variance_m2(depth_m * ray, 1.0 / ray) / (ray * ray)
    })
}

/// The fitted light.
#[derive(Clone, Debug)]
pub(super) struct Light {
    pub(super) signal_e: f64,
    pub(super) signal_interval_e: Option<[f64; 2]>,
    /// The ambient light; `None` if it cannot be separated from the signal.
    pub(super) ambient: Option<(f64, Option<[f64; 2]>)>,
    /// The root mean square of the deviations in standard errors.
    pub(super) scatter: Option<f64>,
}

/// Fits the signal and, if it is significant, the ambient light; `None` without noise.
pub(super) fn fit(p: &Parameters, rays: &[f64], noise: &[Noise]) -> Option<Light> {
    if noise.is_empty() {
        return None;
    }
    let problem = Variances { p, rays, noise };
    let both = (noise.len() >= 3)
        .then(|| solve(&problem, &[1.0, p.ambient_e / AMBIENT_UNIT_E], true))
        .filter(|both| {
            let farthest_m = noise.iter().map(|one| one.depth_m).fold(0.0, f64::max);
            let light = p.signal_e * both.parameters[0] / (farthest_m * farthest_m);
            let is_apart = both.correlation().is_some_and(|c| c.abs() <= MAX_CORRELATION);
            let half = both
                .error(1)
                .map(|error| both.factor(true) * error * AMBIENT_UNIT_E);
            is_apart && half.is_some_and(|half| half <= MAX_AMBIENT_ERROR * light) && both.parameters[0] > 0.0
        });
    let solution = match &both {
        Some(both) => both.clone(),
        None => solve(&problem, &[1.0], true),
    };
    let not_below = |ends: [f64; 2]| ends.map(|end| end.max(0.0));
    let scatter = |solution: &Solution| {
        (solution.freedom > 0).then(|| (solution.squares / solution.freedom as f64).sqrt())
    };
    (solution.parameters[0] > 0.0 && solution.squares.is_finite()).then(|| Light {
        signal_e: solution.parameters[0] * p.signal_e,
        signal_interval_e: solution.interval(0, p.signal_e, true).map(not_below),
        ambient: both.as_ref().map(|both| {
            let ends = both.interval(1, AMBIENT_UNIT_E, true).map(not_below);
            ((both.parameters[1] * AMBIENT_UNIT_E).max(0.0), ends)
        }),
        scatter: scatter(&solution),
    })
}

struct Variances<'a> {
    p: &'a Parameters,
    rays: &'a [f64],
    noise: &'a [Noise],
}

impl Problem for Variances<'_> {
    fn points(&self) -> usize {
        self.noise.len()
    }

    /// The deviation of the logarithm: noise spans orders of magnitude.
    fn deviation(&self, parameters: &[f64], i: usize) -> f64 {
        let one = &self.noise[i];
        let p = Parameters {
            signal_e: (parameters[0] * self.p.signal_e).max(1e-6),
            ambient_e: parameters
                .get(1)
                .map_or(self.p.ambient_e, |ambient| ambient * AMBIENT_UNIT_E),
            ..*self.p
        };
        let variance = variance_m2(&p, self.rays, one.depth_m).max(1e-15);
        (variance / one.variance_m2).ln() / one.error
    }
}

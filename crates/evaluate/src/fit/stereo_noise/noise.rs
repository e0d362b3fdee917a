//! The noise of a pixel over time and its correlation with neighbours.

use crate::measure::Autocovariance;
use oaktwin_depth::random::philox4x32_10;

use super::super::least_squares::NORMAL_95;
use super::super::target::Observation;

/// The number of bootstrap samples of pairs of frames from which the window is estimated.
const RESAMPLED: u32 = 200;

/// The key of the random numbers.
const KEY: [u32; 2] = [0x6669_7421, 0x7769_6e64];

/// The minimum number of pairs of frames for a confidence interval.
const MIN_PAIRS: usize = 4;

/// The jitter, in steps, below which disparities rarely change from step to step.
pub(super) const MIN_JITTER_STEPS: f64 = 0.3;

/// The noise of all targets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Noise {
    /// The standard deviation over time without rounding in pixels.
    pub(super) sigma_px: f64,
    /// The 95 % interval.
    pub(super) sigma_interval_px: [f64; 2],
    /// The side of the square window of the correlation in pixels of the image.
    pub(super) window: usize,
    /// The 95 % interval, if there are enough pairs of frames.
    pub(super) window_interval: Option<[usize; 2]>,
}

impl Noise {
    /// The number of values that correspond to an independent one.
    pub(super) fn together(&self) -> f64 {
        (self.window * self.window) as f64
    }

    /// Returns the variance of the mean of a number of values, px².
    pub(super) fn of_mean(&self, values: u64) -> f64 {
        self.sigma_px * self.sigma_px * self.together() / (values as f64).max(self.together())
    }
}

/// Estimates the noise of targets in images of one size; `None` if no pixel is valid in two frames.
pub(super) fn noise(observations: &[Observation], step_px: f64) -> Option<Noise> {
    // Coarse whole millimetres hide the noise.
    let is_fine = |one: &&Observation| {
        let unit = one.unit * one.unit / 12.0;
        one.variance().is_some_and(|variance| unit <= 0.25 * variance)
    };
    let any = || observations.iter().filter(|one| one.variance().is_some());
    let used: Vec<&Observation> = if any().any(|one| is_fine(&one)) {
        any().filter(is_fine).collect()
    } else {
        any().collect()
    };
    let all: Vec<(Autocovariance, f64)> = used
        .iter()
        .filter_map(|one| Some((one.noise()?, one.rounding(step_px))))
        .collect();
    let count = |one: &(Autocovariance, f64)| one.0.values() as f64;
    let weight = all.iter().map(count).sum::<f64>();
    let variances: Vec<(f64, f64)> = all
        .iter()
        .filter_map(|one| Some((count(one), one.0.at(0)? - one.1)))
        .collect();
    if variances.is_empty() || weight <= 0.0 {
        return None;
    }
    let variance = variances.iter().map(|(w, v)| w * v).sum::<f64>() / weight;
    let total = variances.iter().map(|(w, v)| w * v).sum::<f64>() / weight
        + all.iter().map(|one| count(one) * one.1).sum::<f64>() / weight;

    // The variance of each pair without rounding.
    let pairs: Vec<(&Autocovariance, f64)> = used
        .iter()
        .flat_map(|one| one.pairs.iter().map(|pair| (pair, one.rounding(step_px))))
        .collect();
    let window = window(&covariances(pairs.iter().copied()));
    let mut windows: Vec<usize> = Vec::new();
    if pairs.len() >= MIN_PAIRS {
        for i in 0..RESAMPLED {
            let drawn = (0..pairs.len()).map(|at| pairs[draw(i, at, pairs.len())]);
            windows.push(self::window(&covariances(drawn)));
        }
        windows.sort_unstable();
    }
    let window_interval = (!windows.is_empty()).then(|| {
        let dropped = windows.len() / 40;
        [windows[dropped], windows[windows.len() - 1 - dropped]]
    });

    // The degrees of freedom: each difference has two frames, and neighbours share a window.
    let side = window as f64;
    let alike = ((2.0 * side * side + 1.0) / (3.0 * side)).powi(2);
    let overlap = if used.iter().all(|one| one.pairs.len() < 2) {
        1.0
    } else {
        1.5
    };
    let by_counts = total * (2.0 * overlap * alike / weight).sqrt();
    // Other effects of the device appear as differences between distances.
    let number = variances.len() as f64;
    let scatter = variances
        .iter()
        .map(|(w, v)| w * (v - variance).powi(2))
        .sum::<f64>()
        / weight;
    let by_distances = if variances.len() >= 5 {
        (scatter / (number - 1.0)).sqrt()
    } else {
        0.0
    };
    let half = NORMAL_95 * by_counts.max(by_distances);
    Some(Noise {
        sigma_px: variance.max(0.0).sqrt(),
        sigma_interval_px: [variance - half, variance + half].map(|v| v.max(0.0).sqrt()),
        window,
        window_interval,
    })
}

/// Returns a pseudorandom number below `of` that depends only on the arguments.
fn draw(i: u32, at: usize, of: usize) -> usize {
    #[expect(clippy::cast_possible_truncation, reason = "fewer pairs than 2³²")]
    let [word, ..] = philox4x32_10([i, at as u32, 0, 0], KEY);
    ((u64::from(word) * of as u64) >> 32) as usize
}

/// Returns the covariance by lag in pixels, without the rounding of each pixel.
fn covariances<'a>(pairs: impl Iterator<Item = (&'a Autocovariance, f64)>) -> Vec<f64> {
    let mut all: Option<Autocovariance> = None;
    let mut rounding = 0.0;
    for (pair, own) in pairs {
        rounding += own * pair.values() as f64;
        match &mut all {
            Some(all) => all.merge(pair),
            None => all = Some(pair.clone()),
        }
    }
    let Some(all) = all else { return Vec::new() };
    let mut covariances: Vec<f64> = (0..all.lags()).map_while(|lag| all.at(lag)).collect();
    if let Some(own) = covariances.first_mut() {
        *own -= rounding / (all.values() as f64).max(1.0);
    }
    covariances
}

/// Returns the side of the square window with the best least-squares fit to covariances, which decrease linearly to 0 at that
/// lag.
fn window(covariances: &[f64]) -> usize {
    let fit = |side: usize| {
        let line = |lag: usize| (1.0 - lag as f64 / side as f64).max(0.0);
        let (mut both, mut own) = (0.0, 0.0);
        for (lag, c) in covariances.iter().enumerate() {
            both += line(lag) * c;
            own += line(lag).powi(2);
        }
        let height = both / own;
        let squares = covariances
            .iter()
            .enumerate()
            .map(|(lag, c)| (c - height * line(lag)).powi(2));
        squares.sum::<f64>()
    };
    let sides = 1..=covariances.len().max(1);
    sides.min_by(|&a, &b| fit(a).total_cmp(&fit(b))).unwrap_or(1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn window_sizes_are_recovered() {
        for side in [1usize, 2, 7, 13] {
            let covariances: Vec<f64> = (0..24usize)
                .map(|lag| {
                    0.0025 * (1.0 - lag as f64 / side as f64).max(0.0) + 1e-5 * (lag as f64 * 0.7).sin()
                })
                .collect();
            assert_eq!(window(&covariances), side);
        }
        assert_eq!(window(&[]), 1);
    }

    #[test]
    fn draws_are_in_range() {
        let drawn: Vec<usize> = (0..1000).map(|i| draw(i, 3, 7)).collect();
        assert!((0..7).all(|n| drawn.contains(&n)) && drawn.iter().all(|n| *n < 7));
    }
}

//! The systematic error of `stereo_noise`: d + β − a·sin(2π(d + β)), and on request the focal length, which converts distances
//! to disparities.
//!
//! The fit minimizes the error of depth times disparity, to first order the error of disparity in pixels of the nominal focal
//! length, so that no focal length reduces it by itself. A grid search precedes least squares, because the error is periodic in
//! disparity.

use std::f64::consts::TAU;

use super::super::error_domain::ErrorDomain;
use super::super::least_squares::{Problem, Solution, solve};
use super::super::point::Point;

/// The data of a fit.
#[derive(Clone, Copy, Debug)]
pub(super) struct Errors<'a> {
    pub(super) points: &'a [Point],
    /// Nominal disparity times depth, px·m.
    pub(super) px_m: f64,
    /// Whether the errors are absolute.
    pub(super) is_absolute: bool,
}

/// The solution: bias and amplitude of pixel locking in pixels, and the focal length as a share of the nominal one if it was
/// free.
#[derive(Clone, Debug)]
pub(super) struct Systematic {
    pub(super) solution: Solution,
    /// Whether the standard errors of the points were known.
    pub(super) is_known: bool,
    /// The parameters of an equally good solution.
    pub(super) rival: Option<Vec<f64>>,
}

/// The tolerance of a focal length.
const FOCAL_RANGE: f64 = 0.12;

/// The grid of bias and amplitude in pixels.
const GRID_PX: f64 = 0.025;
const AMPLITUDES: u32 = 17;
/// The deviation in pixels from which the grid search treats all points alike.
const WILD_PX: f64 = 0.6;

/// The number of points of the grid from which least squares start.
const STARTS: usize = 8;

/// A point of the grid: its cost, and the parameters.
type Start = (f64, Vec<f64>);

/// An observation of the grid search.
struct Observed {
    depth_m: f64,
    error_px: f64,
    weight: f64,
}

impl Errors<'_> {
    /// Returns the error as a share of depth for a set of parameters.
    pub(super) fn error(&self, parameters: &[f64], depth_m: f64) -> f64 {
        let [bias, locking] = [parameters[0], parameters[1]];
        let disparity = self.disparity(parameters, depth_m);
        let measured = disparity + bias - locking * (TAU * (disparity + bias)).sin();
        // A disparity close to 0 px is infinitely far.
        let error = disparity / measured.max(1e-3 * disparity) - 1.0;
        if self.is_absolute { error.abs() } else { error }
    }

    /// Returns the disparity of a true depth in pixels.
    fn disparity(&self, parameters: &[f64], depth_m: f64) -> f64 {
        self.px_m * parameters.get(2).copied().unwrap_or(1.0) / depth_m
    }

    /// Converts an error of depth to pixels of disparity, negative if too far.
    pub(super) fn in_px(&self, error: f64, depth_m: f64) -> f64 {
        let px = ErrorDomain::Disparity { px_m: self.px_m }.of_error(error, depth_m);
        if self.is_absolute { px.abs() } else { px }
    }

    /// Returns half of the 95 % interval of the curve at a depth as a share of depth; `None` without a covariance.
    pub(super) fn half_width(&self, found: &Systematic, depth_m: f64) -> Option<f64> {
        found
            .solution
            .half_width(|p| self.error(p, depth_m), found.is_known)
    }

    /// Fits bias and locking, and the focal length if it `is_free`; `None` without points.
    pub(super) fn fit(&self, is_free: bool) -> Option<Systematic> {
        let starts = self.starts(is_free);
        let is_known = self.points.iter().all(|point| point.sigma.is_some());
        let mut solutions: Vec<Solution> = starts.iter().map(|start| solve(self, start, is_known)).collect();
        solutions.retain(|solution| {
            solution.squares.is_finite() && solution.parameters.iter().all(|p| p.is_finite())
        });
        solutions.sort_by(|a, b| a.squares.total_cmp(&b.squares));
        let mut solutions = solutions.into_iter();
        let best = solutions.next()?;
        let scatter = best.squares / (best.freedom as f64).max(1.0);
        let allowance = 4.0 * if is_known { scatter.max(1.0) } else { scatter };
        let rival = solutions
            .find(|other| {
                let is_elsewhere = (other.parameters[0] - best.parameters[0]).abs() > 0.05
                    || (other.parameters[1].abs() - best.parameters[1].abs()).abs() > 0.05;
                is_elsewhere && other.squares <= best.squares + allowance
            })
            .map(|other| other.parameters);
        Some(Systematic {
            solution: best,
            is_known,
            rival,
        })
    }

    /// Returns the best points of the grid, best first, no two of them adjacent.
    fn starts(&self, is_free: bool) -> Vec<Vec<f64>> {
        let farthest_px = self
            .points
            .iter()
            .map(|point| self.px_m / point.depth_m)
            .fold(0.0, f64::max);
        // A step changes the phase of the nearest point by a fifth of a period.
        let focal_step = 0.2 / farthest_px.max(1.0);
        #[expect(clippy::cast_possible_truncation, reason = "a few hundred")]
        let focal_steps = if is_free {
            (FOCAL_RANGE / focal_step).min(400.0) as i32
        } else {
            0
        };
        let observed: Vec<Observed> = self.points.iter().map(|point| self.observed(point)).collect();
        let weight = observed.iter().map(|one| one.weight).sum::<f64>();
        let mean = observed.iter().map(|one| one.error_px * one.weight).sum::<f64>() / weight;
        let [low, high] = if self.is_absolute {
            [-mean - 0.4, mean + 0.4]
        } else {
            [mean - 0.5, mean + 0.5]
        };
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "limited")]
        let biases = ((high - low) / GRID_PX).clamp(1.0, 400.0) as u32;
        let mut grid: Vec<Start> = Vec::new();
        for i in -focal_steps..=focal_steps {
            let focal = 1.0 + f64::from(i) * focal_step;
            let all = (0..=biases).map(|step| low + (high - low) * f64::from(step) / f64::from(biases));
            let mut best = self.costs(&observed, focal, all);
            if is_free {
                best.iter_mut().for_each(|(_, start)| start.push(focal));
            }
            grid.extend(not_adjacent(best, if is_free { 2 } else { STARTS }));
        }
        grid.sort_by(|a, b| a.0.total_cmp(&b.0));
        grid.truncate(STARTS);
        grid.into_iter().map(|(_, start)| start).collect()
    }

    fn observed(&self, point: &Point) -> Observed {
        Observed {
            depth_m: point.depth_m,
            error_px: self.in_px(point.error, point.depth_m),
            weight: point.sigma.map_or(1.0, |sigma| 1.0 / (sigma * sigma)),
        }
    }

    /// Returns the costs of the points of the grid with these biases and a focal length, as a share of the nominal one.
    fn costs(&self, observed: &[Observed], focal: f64, biases: impl Iterator<Item = f64>) -> Vec<Start> {
        let phases: Vec<(f64, f64)> = observed
            .iter()
            .map(|one| (TAU * self.px_m * focal / one.depth_m).sin_cos())
            .collect();
        let mut costs = Vec::new();
        for bias in biases {
            let (turned_sine, turned_cosine) = (TAU * bias).sin_cos();
            for amplitude in 0..AMPLITUDES {
                let amplitude = f64::from(amplitude) * GRID_PX;
                let mut cost = 0.0;
                for (&(sine, cosine), one) in phases.iter().zip(observed) {
                    let locked = bias - amplitude * (sine * turned_cosine + cosine * turned_sine);
                    let expected = if self.is_absolute { locked.abs() } else { locked };
                    let off = (expected - one.error_px).abs().min(WILD_PX);
                    cost += one.weight * off * off;
                }
                costs.push((cost, vec![bias, amplitude]));
            }
        }
        costs
    }
}

/// Returns the best points of the grid, no two of them adjacent.
fn not_adjacent(mut grid: Vec<Start>, count: usize) -> Vec<Start> {
    grid.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut apart: Vec<Start> = Vec::new();
    for one in grid {
        let is_near = |other: &Start| {
            (other.1[0] - one.1[0]).abs() < 4.5 * GRID_PX && (other.1[1] - one.1[1]).abs() < 4.5 * GRID_PX
        };
        if !apart.iter().any(is_near) {
            apart.push(one);
        }
        if apart.len() == count {
            break;
        }
    }
    apart
}

impl Problem for Errors<'_> {
    fn points(&self) -> usize {
        self.points.len()
    }

    fn deviation(&self, parameters: &[f64], i: usize) -> f64 {
        let point = &self.points[i];
        let own = if self.is_absolute {
            point.error.abs()
        } else {
            point.error
        };
        let px = self.px_m / point.depth_m * (self.error(parameters, point.depth_m) - own);
        px / point.sigma.unwrap_or(1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PX_M: f64 = 60.0;

    fn points(bias: f64, locking: f64, focal: f64, distances: &[f64]) -> Vec<Point> {
        let errors = Errors {
            points: &[],
            px_m: PX_M,
            is_absolute: false,
        };
        let point = |&depth_m: &f64| Point {
            depth_m,
            error: errors.error(&[bias, locking, focal], depth_m),
            sigma: None,
        };
        distances.iter().map(point).collect()
    }

    fn distances() -> Vec<f64> {
        (0..40).map(|i| 1.0 + 0.21 * f64::from(i)).collect()
    }

    #[test]
    fn known_parameters_are_recovered_with_and_without_a_sign() {
        for (bias, locking) in [(-0.22, 0.13), (0.0, 0.2), (0.31, 0.05), (-0.7, 0.1)] {
            for (is_absolute, focal) in [(false, 1.0), (true, 1.0), (false, 1.013), (true, 0.987)] {
                let mut points = points(bias, locking, focal, &distances());
                for point in &mut points {
                    point.error = if is_absolute {
                        point.error.abs()
                    } else {
                        point.error
                    };
                }
                let errors = Errors {
                    points: &points,
                    px_m: PX_M,
                    is_absolute,
                };
                let found = errors.fit(focal != 1.0).unwrap();
                let p = &found.solution.parameters;
                assert!(
                    (p[0] - bias).abs() < 1e-3,
                    "{bias} {locking} {is_absolute} {focal}: {p:?}"
                );
                assert!((p[1] - locking).abs() < 1e-3, "{p:?}");
                assert!((p.get(2).copied().unwrap_or(1.0) - focal).abs() < 1e-4, "{p:?}");
            }
        }
    }

    #[test]
    fn one_distance_does_not_separate_the_parameters() {
        let points = points(-0.2, 0.1, 1.0, &[2.0, 2.0, 2.0]);
        let errors = Errors {
            points: &points,
            px_m: PX_M,
            is_absolute: false,
        };
        let found = errors.fit(false).unwrap();
        assert!(
            found.solution.correlation().is_none_or(|c| c.abs() > 0.99) || found.rival.is_some(),
            "{found:?}"
        );
        let none = Errors {
            points: &[],
            ..errors
        };
        assert!(none.fit(false).is_none());
    }
}

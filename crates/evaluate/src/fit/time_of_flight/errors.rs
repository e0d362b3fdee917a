//! The systematic error: a constant and four waves per period along the rays, averaged over the region.

use oaktwin_depth::time_of_flight::Parameters;

use super::super::error_domain::ErrorDomain;
use super::super::least_squares::{Problem, Solution, solve};
use super::super::method::Fitted;
use super::super::point::Point;
use super::super::report::{FitReport, number};
use super::rays::mean;

/// The number of points of the curve per wave, and its maximum.
const A_WAVE: f64 = 24.0;
const MAX: f64 = 4000.0;

/// The parameters of the sensor that affect its systematic error.
#[derive(Clone, Debug)]
pub(super) struct ErrorModel {
    pub(super) p: Parameters,
    pub(super) rays: Vec<f64>,
    pub(super) is_absolute: bool,
}

impl ErrorModel {
    /// Returns the error as a share of depth for a bias in metres and an amplitude of wiggling.
    pub(super) fn error(&self, parameters: &[f64], depth_m: f64) -> f64 {
        let [bias_m, wiggling] = [parameters[0], parameters[1]];
        let error = mean(&self.rays, |ray| {
            let range_m = depth_m * ray + bias_m;
            (bias_m + self.p.wiggle_m(range_m, wiggling)) / ray
        });
        if self.is_absolute {
            error.abs() / depth_m
        } else {
            error / depth_m
        }
    }

    /// Fits bias and wiggling; `None` without points.
    pub(super) fn fit(&self, points: &[Point]) -> Option<WigglingFit> {
        let is_known = points.iter().all(|point| point.sigma.is_some());
        let problem = Errors { shape: self, points };
        let mut sizes: Vec<f64> = points.iter().map(|point| point.error * point.depth_m).collect();
        sizes.sort_by(f64::total_cmp);
        let middle = *sizes.get(sizes.len() / 2)?;
        // A signed error is nearly linear in both parameters; for absolute errors the bias may have either sign.
        let mut starts = vec![[middle, self.p.wiggling_left().max(1e-4)]];
        if self.is_absolute {
            starts.push([-middle, starts[0][1]]);
            starts.extend([0.01, 0.05, 0.1].map(|wiggling| [0.0, wiggling]));
        }
        let mut solutions: Vec<Solution> = starts
            .iter()
            .map(|start| solve(&problem, start, is_known))
            .filter(|solution| {
                solution.squares.is_finite() && solution.parameters.iter().all(|p| p.is_finite())
            })
            .collect();
        if self.is_absolute {
            // Inverting both signs gives the same absolute errors.
            for solution in &mut solutions {
                if solution.parameters[1] < 0.0 {
                    solution.parameters.iter_mut().for_each(|p| *p = -*p);
                }
            }
        }
        solutions.sort_by(|a, b| a.squares.total_cmp(&b.squares));
        let mut solutions = solutions.into_iter();
        let solution = solutions.next()?;
        let scatter = solution.squares / (solution.freedom as f64).max(1.0);
        let bias = solution.parameters[0];
        let rival = solutions
            .find(|other| {
                let apart = (other.parameters[0] - bias).abs();
                apart > 0.1 * bias.abs().max(1e-4) && other.squares <= solution.squares + 4.0 * scatter
            })
            .map(|other| other.parameters);
        Some(WigglingFit {
            shape: self.clone(),
            solution,
            is_known,
            rival,
        })
    }
}

struct Errors<'a> {
    shape: &'a ErrorModel,
    points: &'a [Point],
}

impl Problem for Errors<'_> {
    fn points(&self) -> usize {
        self.points.len()
    }

    fn deviation(&self, parameters: &[f64], i: usize) -> f64 {
        let point = &self.points[i];
        let error = self.shape.error(parameters, point.depth_m) - point.error;
        error * point.depth_m / point.sigma.unwrap_or(1.0)
    }
}

/// The solution: bias in metres, and the amplitude of wiggling.
#[derive(Clone, Debug)]
pub(super) struct WigglingFit {
    shape: ErrorModel,
    pub(super) solution: Solution,
    pub(super) is_known: bool,
    /// The parameters of an equally good solution.
    pub(super) rival: Option<Vec<f64>>,
}

impl Fitted for WigglingFit {
    fn error_domain(&self) -> ErrorDomain {
        ErrorDomain::Depth
    }

    fn error(&self, depth_m: f64) -> f64 {
        self.shape.error(&self.solution.parameters, depth_m)
    }

    fn half_width(&self, depth_m: f64) -> Option<f64> {
        self.solution
            .half_width(|p| self.shape.error(p, depth_m), self.is_known)
    }

    fn places(&self, near_m: f64, far_m: f64) -> Vec<f64> {
        let waves = 4.0 * (far_m - near_m) / self.shape.p.period_m();
        let count = (A_WAVE * waves).clamp(2.0, MAX).round();
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "limited")]
        let steps = 0..=count as u32;
        steps
            .map(|i| near_m + (far_m - near_m) * f64::from(i) / count)
            .collect()
    }

    fn name(&self, _report: &FitReport) -> String {
        let [bias_m, wiggling] = [self.solution.parameters[0], self.solution.parameters[1]];
        format!("bias {:.2} mm, wiggling {:.4}", 1e3 * bias_m, wiggling.max(0.0))
    }

    fn noise(&self, report: &FitReport) -> String {
        report.parameter("signal").map_or(String::new(), |signal| {
            format!(", signal {} electrons at 1 m", number(signal.value))
        })
    }

    fn solution(&self) -> (&Solution, bool) {
        (&self.solution, self.is_known)
    }
}

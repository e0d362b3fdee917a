//! `stereo_noise`: errors of disparity.

mod errors;
mod findings;
mod noise;
#[cfg(test)]
mod tests;
mod window;

use oaktwin_depth::stereo_noise::{DepthRounding, Parameters};

use super::error_domain::{ErrorDomain, left_of_rounding};
use super::least_squares::Solution;
use super::method::{Fitted, Method};
use super::point::Point;
use super::report::{FitReport, Parameter, number};
use super::state::FitState;
use super::target::Observation;
use errors::{Errors, Systematic};
use noise::Noise;
use oaktwin_base::diagnostic::{Finding, Level};
use window::matcher_window;

/// The number of points of the curve per pixel of disparity, and its maximum.
const POINTS_PER_PX: f64 = 40.0;
const MAX_POINTS: f64 = 8000.0;

/// The jitter, in units of the rounding, above which rounding is effectively random.
const MIN_RANDOM_JITTER: f64 = 3.54;

/// A matcher to fit.
pub(super) struct Stereo {
    p: Parameters,
    px_m: f64,
    noise: Option<Noise>,
}

impl Stereo {
    /// Creates the method from the known parameters.
    pub(super) fn new(p: Parameters) -> Self {
        Self {
            p,
            px_m: p.stereo.disparity(1.0),
            noise: None,
        }
    }

    fn errors<'a>(&self, points: &'a [Point], is_absolute: bool) -> Errors<'a> {
        Errors {
            points,
            px_m: self.px_m,
            is_absolute,
        }
    }
}

impl Method for Stereo {
    fn error_domain(&self) -> ErrorDomain {
        ErrorDomain::Disparity { px_m: self.px_m }
    }

    fn step(&self) -> f64 {
        self.p.subpixel.step_px()
    }

    fn focal_length_px(&self) -> (f64, u32) {
        (self.p.stereo.focal_length_px, self.p.width_px)
    }

    fn is_truncated(&self) -> bool {
        self.p.depth_rounding == DepthRounding::Truncate
    }

    fn noise_names(&self) -> &'static [&'static str] {
        &["jitter", "window"]
    }

    fn noise(&mut self, observations: &[Observation], state: &mut FitState<'_>) {
        let p = &self.p;
        self.noise = noise::noise(observations, self.step());
        let Some(noise) = self.noise else {
            let why = "no pixel is valid in two frames of one target";
            for name in self.noise_names() {
                state.not_found(name, why, "give several frames of each distance");
            }
            return;
        };
        let is_hidden = noise.sigma_px < noise::MIN_JITTER_STEPS * p.subpixel.step_px();
        state.report.parameters.push(Parameter {
            name: "jitter",
            value: noise.sigma_px,
            interval_95: Some(noise.sigma_interval_px),
            unit: "px",
            what: "the standard deviation of a pixel over time",
            is_fitted: true,
        });
        if is_hidden {
            state.findings.push(Finding::new(
                "jitter-below-steps",
                Level::Warning,
                "jitter",
                format!(
                    "is less than {:.3} px, too small to be measured with steps of {} px",
                    noise::MIN_JITTER_STEPS * p.subpixel.step_px(),
                    p.subpixel.step_px()
                ),
                "record with more subpixel bits",
            ));
            state.not_found(
                "window",
                "jitter is hidden by the steps of disparity",
                "record with more subpixel bits",
            );
            return;
        }
        let width = observations.first().map_or(p.width_px, |one| one.size.width);
        let side = |image_px: usize| matcher_window(image_px, f64::from(width) / f64::from(p.width_px));
        state.report.parameters.push(Parameter {
            name: "window",
            value: side(noise.window),
            interval_95: noise.window_interval.map(|ends| ends.map(side)),
            unit: "px",
            what: "the side of the square over which it is correlated",
            is_fitted: true,
        });
    }

    fn variance(&self, one: &Observation) -> Option<f64> {
        one.variance()
    }

    fn variance_of_mean(&self, _one: &Observation, values: u64) -> Option<f64> {
        self.noise.map(|noise| noise.of_mean(values))
    }

    fn variance_of_rounding(&self, one: &Observation) -> f64 {
        self.noise
            .map_or(0.0, |noise| rounding(noise.sigma_px, self.step(), one.unit))
    }

    fn systematic(&self, used: &[Point], state: &mut FitState<'_>) -> Option<Box<dyn Fitted>> {
        let errors = self.errors(used, state.report.is_absolute);
        let is_free = state.options.fits_focal_length;
        let wanted = if is_free { 3 } else { 2 };
        let is_known = used.iter().all(|point| point.sigma.is_some());
        let found = errors.fit(is_free);
        if let Some((why, remedy)) = findings::not_identifiable(used, found.as_ref(), wanted, is_known) {
            state.not_found("bias", &why, &remedy);
            state.not_found("pixelLocking", &why, &remedy);
            if is_free {
                state.not_found("focalLength", &why, &remedy);
            }
            return None;
        }
        let found = found?;
        let parameters = parameters_of(&found, &mut state.report);
        state.put_first(parameters);
        state
            .findings
            .extend(findings::implausible(&errors, &found, is_free));
        Some(Box::new(LockingFit {
            px_m: self.px_m,
            is_absolute: state.report.is_absolute,
            found,
        }))
    }

    fn given(&self, state: &mut FitState<'_>) {
        let p = &self.p;
        let optics = &state.options.optics;
        if optics.focal_length_px.is_some() && state.report.parameter("focalLength").is_none() {
            state.report.parameters.push(Parameter {
                name: "focalLength",
                value: p.stereo.focal_length_px,
                interval_95: None,
                unit: "px",
                what: "the focal length that converts distances to disparities",
                is_fitted: false,
            });
        }
        if optics.width_px.is_some() {
            state.report.parameters.push(Parameter {
                name: "width",
                value: f64::from(p.width_px),
                interval_95: None,
                unit: "px",
                what: "the width of the matcher's images",
                is_fitted: false,
            });
        }
    }
}

fn parameters_of(found: &Systematic, report: &mut FitReport) -> Vec<Parameter> {
    let solution = &found.solution;
    let interval = |at: usize, scale: f64| solution.interval(at, scale, found.is_known);
    // An amplitude is not negative.
    let locking = interval(1, 1.0).map(|ends| ends.map(|end| end.max(0.0)));
    let nominal = report.focal_length_px;
    let mut parameters = vec![
        Parameter {
            name: "bias",
            value: solution.parameters[0],
            interval_95: interval(0, 1.0),
            unit: "px",
            what: "the calibration error, negative if too far",
            is_fitted: true,
        },
        Parameter {
            name: "pixelLocking",
            value: solution.parameters[1].max(0.0),
            interval_95: locking,
            unit: "px",
            what: "the amplitude of the error that repeats every pixel",
            is_fitted: true,
        },
    ];
    if let Some(share) = solution.parameters.get(2) {
        report.focal_length_px = nominal * share;
        parameters.push(Parameter {
            name: "focalLength",
            value: nominal * share,
            interval_95: interval(2, nominal),
            unit: "px",
            what: "the focal length that converts distances to disparities",
            is_fitted: true,
        });
    }
    parameters
}

/// The fitted curve.
#[derive(Debug)]
struct LockingFit {
    px_m: f64,
    is_absolute: bool,
    found: Systematic,
}

impl LockingFit {
    fn errors(&self) -> Errors<'static> {
        Errors {
            points: &[],
            px_m: self.px_m,
            is_absolute: self.is_absolute,
        }
    }
}

impl Fitted for LockingFit {
    fn error_domain(&self) -> ErrorDomain {
        ErrorDomain::Disparity { px_m: self.px_m }
    }

    fn error(&self, depth_m: f64) -> f64 {
        self.errors().error(&self.found.solution.parameters, depth_m)
    }

    fn half_width(&self, depth_m: f64) -> Option<f64> {
        self.errors().half_width(&self.found, depth_m)
    }

    /// Returns the curve in equal steps of disparity, in which the error is periodic.
    fn places(&self, near_m: f64, far_m: f64) -> Vec<f64> {
        let [near_px, far_px] = [near_m, far_m].map(|z| self.px_m / z);
        let count = (POINTS_PER_PX * (near_px - far_px))
            .clamp(2.0, MAX_POINTS)
            .round();
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "limited")]
        let steps = 0..=count as u32;
        steps
            .map(|i| self.px_m / (near_px + (far_px - near_px) * f64::from(i) / count))
            .collect()
    }

    fn name(&self, report: &FitReport) -> String {
        let value = |name: &str| report.parameter(name).map_or(0.0, |parameter| parameter.value);
        format!(
            "bias {} px, pixel locking {} px",
            number(value("bias")),
            number(value("pixelLocking"))
        )
    }

    fn noise(&self, report: &FitReport) -> String {
        report.parameter("jitter").map_or(String::new(), |jitter| {
            let window = report
                .parameter("window")
                .map_or(String::new(), |window| format!(" over {0}x{0} px", window.value));
            format!(", jitter {} px{window}", number(jitter.value))
        })
    }

    fn solution(&self) -> (&Solution, bool) {
        (&self.found.solution, self.found.is_known)
    }
}

/// Returns the variance due to rounding in a mean, px²: noise averages steps, and millimetres if they cover several steps.
fn rounding(sigma_px: f64, step_px: f64, unit_px: f64) -> f64 {
    let steps = left_of_rounding(sigma_px, step_px);
    if unit_px <= 0.0 {
        return steps;
    }
    let alike = (step_px / (MIN_RANDOM_JITTER * sigma_px)).min(1.0) * unit_px * unit_px / 12.0;
    steps + left_of_rounding(sigma_px, unit_px).max(alike)
}

//! `time_of_flight`: errors of depth.

mod errors;
mod findings;
mod light;
mod rays;
#[cfg(test)]
mod tests;

use crate::measure::median;
use oaktwin_depth::time_of_flight::{Parameters, TimeOfFlight};

use super::error_domain::{ErrorDomain, left_of_rounding};
use super::method::{Fitted, Method};
use super::point::{OfTarget, Point};
use super::report::Parameter;
use super::state::FitState;
use super::target::Observation;
use super::{FitError, FitOptions};
use errors::{ErrorModel, WigglingFit};
use light::Noise;
use oaktwin_base::diagnostic::{Finding, Level, message, opt};

/// The distance from the median, in steps of millimetres, below which a value does not have a wrong period.
const STEP_M: f64 = 0.001;

/// The noise, in units, below which rounding hides it.
const MIN_NOISE_UNITS: f64 = 0.5;

/// The noise, as a share of a period, above which it is not small.
const MAX_SHARE_OF_PERIOD: f64 = 0.03;

/// The share of valid pixels below which noise selects them.
const MIN_FILL_RATE: f64 = 0.8;

/// The tolerance, as a share of a period, for errors of whole periods.
const NEAR_PERIOD: f64 = 0.1;

/// A camera to fit.
pub(super) struct Tof {
    p: Parameters,
    rays: Vec<f64>,
    range_m: f64,
    /// The share of a frame's noise that the next frame shares.
    shared: f64,
}

impl Tof {
    /// Creates the method from the known parameters.
    pub(super) fn new(engine: &TimeOfFlight, options: &FitOptions) -> Result<Self, FitError> {
        let p = *engine.parameters();
        let refused = |text: &str| Err(FitError::Option(text.into()));
        if options.fits_focal_length {
            return Err(FitError::Option(message![
                "fit: time-of-flight distances do not depend on the focal length; remove ",
                opt("fit").with("focal")
            ]));
        }
        if !p.enable_optical_correction {
            return refused(
                "enableOpticalCorrection: without it distances are along the rays; record depth along the axis",
            );
        }
        if !(p.signal_e > 0.0 && p.albedo > 0.0 && p.contrast > 0.0) {
            return refused(
                "signal: without light there is nothing to fit; give signal, albedo and contrast above 0",
            );
        }
        Ok(Self {
            rays: rays::rays(&p, options.region),
            range_m: engine.range_m(),
            shared: p.shared_noise(),
            p,
        })
    }

    fn wiggling(&self) -> (&'static str, &'static str) {
        if self.p.enable_wiggle_correction {
            (
                "wigglingResidual",
                "the residual of the corrected error, which repeats four times per period",
            )
        } else {
            (
                "wiggling",
                "the amplitude of the error that repeats four times per period",
            )
        }
    }

    /// Returns the variance of a pixel over time without rounding, m².
    fn noise_m2(&self, one: &Observation) -> Option<f64> {
        Some((one.variance()? - one.rounding(0.0)).max(0.0) / (1.0 - self.shared))
    }

    /// Returns the share of a frame's noise that the next frame shares: half if measurements are shared, because every second
    /// frame then differs by twice as much, otherwise none.
    fn shared_by(&self, observations: &[Observation]) -> Option<f64> {
        let ratios: Vec<f64> = observations
            .iter()
            .filter_map(|one| {
                let rounding = one.rounding(0.0);
                let [next, apart] = [one.variance()? - rounding, one.apart.at(0)? - rounding];
                (apart > rounding).then_some(next / apart)
            })
            .collect();
        let ratio = median(&ratios)?;
        Some(if ratio < 0.75 { 0.5 } else { 0.0 })
    }

    /// Returns the factor by which the mean square of consecutive differences varies more than for independent ones: each
    /// shares a frame with the next, and its noise with the one after that.
    fn overlap(&self, pairs: usize) -> f64 {
        let shared = self.shared;
        let own = 2.0 - 2.0 * shared;
        let correlations = [(2.0 * shared - 1.0) / own, -shared / own];
        let with = |(apart, correlation): (f64, f64)| {
            let share = (1.0 - apart / pairs.max(1) as f64).max(0.0);
            2.0 * share * correlation * correlation
        };
        1.0 + [1.0, 2.0].into_iter().zip(correlations).map(with).sum::<f64>()
    }

    /// Returns the targets that can be compared with the engine.
    fn noise_of(&self, one: &Observation) -> Option<Noise> {
        let variance_m2 = self.noise_m2(one)?;
        let sigma_m = variance_m2.sqrt();
        let is_seen = sigma_m >= MIN_NOISE_UNITS * one.unit && sigma_m > 0.0;
        let is_small = sigma_m <= MAX_SHARE_OF_PERIOD * self.p.period_m();
        if !is_seen || !is_small || one.fill_rate < MIN_FILL_RATE {
            return None;
        }
        let values = one.noise()?.values() as f64;
        let raw = one.variance()?;
        Some(Noise {
            depth_m: one.depth_m,
            variance_m2,
            error: (2.0 * self.overlap(one.pairs.len()) / values).sqrt() * raw / (raw - one.rounding(0.0)),
        })
    }
}

impl Method for Tof {
    fn error_domain(&self) -> ErrorDomain {
        ErrorDomain::Depth
    }

    fn step(&self) -> f64 {
        STEP_M
    }

    fn focal_length_px(&self) -> (f64, u32) {
        (self.p.focal_length_px, self.p.width_px)
    }

    fn noise_names(&self) -> &'static [&'static str] {
        &["signal", "ambient"]
    }

    fn noise(&mut self, observations: &[Observation], state: &mut FitState<'_>) {
        if let Some(shared) = self.shared_by(observations)
            && shared != self.shared
        {
            self.shared = shared;
            state.findings.push(findings::other_sharing(shared));
        }
        let noise: Vec<Noise> = observations.iter().filter_map(|one| self.noise_of(one)).collect();
        let Some(light) = light::fit(&self.p, &self.rays, &noise) else {
            let (why, remedy) = if observations.iter().all(|one| one.variance().is_none()) {
                (
                    "no pixel is valid in two frames of one target",
                    "give several frames of each distance",
                )
            } else {
                (
                    "the noise of every target is hidden by rounding to millimetres, or too large relative to a period",
                    "record farther or nearer targets",
                )
            };
            for name in self.noise_names() {
                state.not_found(name, why, remedy);
            }
            return;
        };
        state.report.parameters.push(Parameter {
            name: "signal",
            value: light.signal_e,
            interval_95: light.signal_interval_e,
            unit: "electrons",
            what: "the light of a white surface at 1 m, with the model's contrast, albedo and read noise",
            is_fitted: true,
        });
        match light.ambient {
            Some((ambient_e, interval_95)) => state.report.parameters.push(Parameter {
                name: "ambient",
                value: ambient_e,
                interval_95,
                unit: "electrons",
                what: "other light on a white surface",
                is_fitted: true,
            }),
            None => {
                let why = format!(
                    "these distances do not separate it from the signal; the fit assumes {} electrons of it",
                    self.p.ambient_e
                );
                state.not_found(
                    "ambient",
                    &why,
                    message![
                        "record near and far targets, or set ",
                        opt("param").with("ambient=VALUE")
                    ],
                );
            }
        }
        state.findings.extend(findings::of_light(&light));
    }

    fn variance(&self, one: &Observation) -> Option<f64> {
        Some(self.noise_m2(one)? + one.rounding(0.0))
    }

    fn variance_of_mean(&self, one: &Observation, values: u64) -> Option<f64> {
        // The covariance of a frame with itself, and with the previous and the next one.
        let by_time = self.noise_m2(one)? * (1.0 + 2.0 * self.shared) / (values as f64).max(1.0);
        // This includes the constant differences between pixels.
        let cells = one.cells.iter().filter(|cell| cell.sum.values > 0).count() as f64;
        let by_place = one.plane().map_or(0.0, |(_, rms)| rms * rms / cells);
        Some(by_time.max(by_place * one.values() as f64 / (values as f64).max(1.0)))
    }

    fn variance_of_rounding(&self, one: &Observation) -> f64 {
        let sigma = self.noise_m2(one).unwrap_or_default().sqrt();
        left_of_rounding(sigma, one.unit)
    }

    fn is_used(&self, point: &OfTarget, state: &mut FitState<'_>) -> bool {
        let depth_m = point.point.depth_m;
        let error_m = point.point.error * depth_m;
        let name = |state: &FitState<'_>| {
            let target = point.target.and_then(|number| state.report.targets.get(number));
            target.map_or_else(|| format!("{depth_m} m"), |target| target.name.clone())
        };
        if depth_m > self.range_m {
            state.findings.push(Finding::new(
                "beyond-range",
                Level::Warning,
                name(state),
                format!(
                    "{depth_m:.3} m is beyond the range of {:.3} m: ignored",
                    self.range_m
                ),
                message![
                    "set the recording's ",
                    opt("param").with("phaseUnwrappingLevel=N"),
                    ", or use nearer targets"
                ],
            ));
            return false;
        }
        let periods = error_m / self.p.period_m();
        let is_wrong = periods.abs() > 0.5 && (periods - periods.round()).abs() < NEAR_PERIOD;
        if is_wrong {
            state.findings.push(Finding::new(
                "wrong-period",
                Level::Warning,
                name(state),
                format!(
                    "the error of {error_m:+.3} m is {:+.0} periods of {:.3} m: ignored",
                    periods.round(),
                    self.p.period_m()
                ),
                "check the distance; a brighter target is unwrapped more reliably",
            ));
        }
        !is_wrong
    }

    fn systematic(&self, used: &[Point], state: &mut FitState<'_>) -> Option<Box<dyn Fitted>> {
        let shape = ErrorModel {
            p: self.p,
            rays: self.rays.clone(),
            is_absolute: state.report.is_absolute,
        };
        let found = shape.fit(used);
        let (wiggling, what) = self.wiggling();
        if let Some((why, remedy)) = findings::not_identifiable(used, found.as_ref()) {
            state.not_found("bias", &why, &remedy);
            state.not_found(wiggling, &why, &remedy);
            return None;
        }
        let found: WigglingFit = found?;
        let interval = |at| found.solution.interval(at, 1.0, found.is_known);
        // An amplitude is not negative.
        let not_below = |ends: [f64; 2]| ends.map(|end| end.max(0.0));
        state.put_first(vec![
            Parameter {
                name: "bias",
                value: found.solution.parameters[0],
                interval_95: interval(0),
                unit: "m",
                what: "the constant error, positive if too far",
                is_fitted: true,
            },
            Parameter {
                name: wiggling,
                value: found.solution.parameters[1].max(0.0),
                interval_95: interval(1).map(not_below),
                unit: "of the amplitude",
                what,
                is_fitted: true,
            },
        ]);
        state.findings.extend(findings::implausible(&found, wiggling));
        Some(Box::new(found))
    }
}

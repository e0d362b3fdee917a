//! The parameters of an engine from what a real device reported of a flat target.
//!
//! A recording is a folder of depth images of a flat target, perpendicular to the camera, and a table
//! ([`TABLE`], `file,distance_m`) of its true distances; or a folder in Replicator's layout that holds ground truth beside
//! what a sensor reported; or, for the systematic error alone, a curve of errors as vendors publish them
//! ([`measured`](crate::accuracy::measured)). Images without true distances tell the noise alone.
//!
//! # `stereo_noise`
//! * σ (`jitter`): half of the variance of the differences of frames one after the other, less what whole steps of
//!   disparity and whole millimetres add (step²/12), over distances where millimetres are not coarser than the noise.
//! * The window of its correlation (`window`): how the covariance of those differences falls with the distance in pixels;
//!   under a square window in a straight line. Its interval is that of 200 draws among the pairs of frames.
//! * β (`bias`) and a (`pixelLocking`): the mean over time and region at each distance, mismatches dropped, against the
//!   truth, by robust least squares; where it is asked for the focal length too. Points weigh by what noise and rounding
//!   leave uncertain in them. Intervals are those of the linear approximation, wider where the points scatter more than
//!   their noise explains.
//!
//! A target's turn is that of the planes through its images, all distances together; up to a few degrees it is put into
//! the truth, pixel by pixel. The given distances are those at the region's middle.

mod findings;
mod least_squares;
mod noise;
mod plot;
mod points;
mod recording;
mod report;
mod stereo_noise;
mod target;
#[cfg(test)]
mod tests;

use std::ops::ControlFlow;
use std::path::PathBuf;
use std::sync::atomic::{AtomicU64, Ordering};

use oaktwin_depth::measure::r_squared;
use oaktwin_depth::stereo_noise::{DepthRounding, Parameters};
use rayon::prelude::*;

pub use recording::TABLE;
pub use report::{Curve, FittedPoint, NotFound, Parameter, Report, Target};

use crate::accuracy::{self, AccuracyError, MeasuredOptics, REGION, Watch};
use crate::catalog::{DepthKind, Twin};
use crate::dataset::figure::Figure;
use crate::diagnostic::{Finding, Level};
use crate::files::FileError;
use crate::sensor::{Engine, EngineKind, ParameterError, SensorOptions, sensor};
use noise::Noise;
use recording::Recording;
use stereo_noise::{Errors, Systematic};
use target::{Look, Seen};

/// How to fit.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// The depth sensor by prim or kind; by default the device's stereo pair.
    pub sensor: Option<String>,
    /// The engine, and what of it is known: its subpixel bits, say.
    pub engine: SensorOptions,
    /// The unit's optics, where they are not the model's.
    pub optics: MeasuredOptics,
    /// The side of the measured region as a share (0 to 1) of the image's.
    pub region: f64,
    /// Metres to a unit of whole numbers.
    pub depth_scale: f64,
    /// Errors nearer than this do not count, m.
    pub from_m: f64,
    /// Whether the focal length is fitted too.
    pub fits_focal_length: bool,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            sensor: None,
            engine: SensorOptions::default(),
            optics: MeasuredOptics::default(),
            region: REGION,
            depth_scale: 0.001,
            from_m: 0.0,
            fits_focal_length: false,
        }
    }
}

/// Why nothing was fitted.
#[derive(Debug, thiserror::Error)]
pub enum FitError {
    /// A file that cannot be read or understood.
    #[error(transparent)]
    File(#[from] FileError),
    /// A parameter of the sensor.
    #[error(transparent)]
    Parameter(#[from] ParameterError),
    /// A sensor or optics that cannot be.
    #[error(transparent)]
    Accuracy(#[from] AccuracyError),
    /// An option or recording that cannot be: `WHAT: what is wrong; what to do`.
    #[error("{0}")]
    Option(String),
    /// Whoever watched wanted no more.
    #[error("interrupted; nothing was fitted")]
    Interrupted,
}

/// A fit, and the means to draw it.
#[derive(Debug)]
pub struct Fit {
    report: Report,
    px_m: f64,
    found: Option<Systematic>,
}

impl Fit {
    /// The numbers.
    #[must_use]
    pub fn report(&self) -> &Report {
        &self.report
    }

    /// The error over distance with the fitted curve, and what it leaves.
    #[must_use]
    pub fn figures(&self) -> Vec<Figure> {
        let errors = Errors {
            points: &[],
            px_m: self.px_m,
            is_absolute: self.report.is_absolute,
        };
        plot::figures(&self.report, &errors, self.found.as_ref())
    }
}

/// Fits the parameters of a twin's depth sensor to recordings; the findings are what is odd in them.
///
/// # Errors
/// A recording that cannot be read, holds nothing, or is not of a flat target that stands straight; options that cannot
/// be; [`FitError::Interrupted`].
pub fn fit(
    twin: &Twin,
    recordings: &[PathBuf],
    options: &Options,
    watch: Watch<'_>,
) -> Result<(Fit, Vec<Finding>), FitError> {
    check(options)?;
    let mut twin = twin.clone();
    let name = options.sensor.as_deref().unwrap_or(DepthKind::Stereo.as_str());
    let depth = accuracy::depth_sensor(&twin, Some(name))?.clone();
    let depth = options.optics.apply(&mut twin, &depth)?;
    let kind = options
        .engine
        .engine
        .unwrap_or_else(|| EngineKind::default_for(depth.spec.kind));
    let settings = SensorOptions {
        engine: Some(kind),
        ..options.engine.clone()
    };
    let (sensor, mut findings) = sensor(&twin, &depth, &settings)?;
    let Engine::StereoNoise(engine) = sensor.engine() else {
        return Err(FitError::Option(format!(
            "engine: there is nothing to fit in {}, whose errors are not measured; choose stereo-noise",
            kind.as_str()
        )));
    };
    let p = engine.parameters();
    let recording = recording::open(recordings, &depth.spec.prim)?;
    let report = Report {
        model: twin.device.name.clone(),
        sensor: depth.spec.prim.clone(),
        engine: kind.as_str(),
        parameters: Vec::new(),
        not_found: Vec::new(),
        focal_length_px: p.stereo.focal_length_px,
        width_px: p.width_px,
        baseline_m: p.stereo.baseline_m,
        step_px: p.subpixel.step_px(),
        is_absolute: false,
        from_m: options.from_m,
        curve: None,
        tilt_deg: None,
        sources: recordings.iter().map(|path| path.display().to_string()).collect(),
        targets: Vec::new(),
        points: Vec::new(),
        is_good: true,
    };
    let mut work = Work {
        report,
        px_m: p.stereo.disparity(1.0),
        options,
        noise: None,
        findings: Vec::new(),
    };
    let points = match recording {
        Recording::Curve(path, curve) => {
            work.report.is_absolute = curve.is_absolute;
            work.without_images(&path);
            points::of_curve(&curve)
        }
        Recording::Stands(stands) => work.look(&stands, p, watch)?,
    };
    let found = work.systematic(&points);
    work.given(p);
    findings.append(&mut work.findings);
    work.report.is_good = !findings.iter().any(|finding| finding.level != Level::Note);
    let fit = Fit {
        report: work.report,
        px_m: work.px_m,
        found,
    };
    Ok((fit, findings))
}

fn check(options: &Options) -> Result<(), FitError> {
    let wrong = |text: String| Err(FitError::Option(text));
    if !(options.region > 0.0 && options.region <= 1.0) {
        return wrong(format!(
            "region: {} is no share of an image; give a share above 0, up to 1",
            options.region
        ));
    }
    if !(options.depth_scale > 0.0 && options.depth_scale.is_finite()) {
        return wrong(format!(
            "depth scale: {} is no scale; give metres a unit, above 0",
            options.depth_scale
        ));
    }
    if !(options.from_m >= 0.0 && options.from_m.is_finite()) {
        return wrong(format!("from: {} is no distance; give metres", options.from_m));
    }
    Ok(())
}

/// What is being made.
struct Work<'a> {
    report: Report,
    px_m: f64,
    options: &'a Options,
    noise: Option<Noise>,
    findings: Vec<Finding>,
}

impl Work<'_> {
    /// Looks at all images: the noise, the targets, and the errors where the truth is known.
    fn look(
        &mut self,
        stands: &[recording::Stand],
        p: &Parameters,
        watch: Watch<'_>,
    ) -> Result<Vec<points::OfTarget>, FitError> {
        let look = Look {
            px_m: self.px_m,
            step_px: p.subpixel.step_px(),
            focal_of_width: p.stereo.focal_length_px / f64::from(p.width_px),
            region: self.options.region,
            unit_m: self.options.depth_scale,
            is_truncated: p.depth_rounding == DepthRounding::Truncate,
        };
        let (done, of) = (AtomicU64::new(0), stands.len() as u64);
        let look_at = |stand| {
            let seen = target::look(stand, &look)?;
            match watch(done.fetch_add(1, Ordering::Relaxed) + 1, of) {
                ControlFlow::Continue(()) => Ok(seen),
                ControlFlow::Break(()) => Err(FitError::Interrupted),
            }
        };
        let seen: Vec<Seen> = stands.par_iter().map(look_at).collect::<Result<_, FitError>>()?;
        points::of_one_size(&seen, stands)?;
        findings::of_targets(&seen, &mut self.findings);
        if seen.iter().all(|one| one.values() == 0) {
            return Err(FitError::Option(format!(
                "{}: nothing was measured in the middle of any image; record again, or give a larger --region",
                self.report.sources.join(", ")
            )));
        }
        self.noise = noise::noise(&seen, look.step_px);
        self.noise_parameters(&seen, p);
        let tilts = points::tilts(&seen, self.noise.as_ref(), &mut self.findings)?;
        self.report.tilt_deg = tilts.common_deg();
        self.report.targets = seen
            .iter()
            .map(|one| points::target(one, &tilts, look.step_px))
            .collect();
        Ok(points::of_targets(&seen, &tilts, self.noise.as_ref(), &look))
    }

    fn noise_parameters(&mut self, seen: &[Seen], p: &Parameters) {
        let Some(noise) = self.noise else {
            let why = "no pixel was seen in two frames of one target";
            for name in ["jitter", "window"] {
                self.not_found(name, why, "give several frames of each distance");
            }
            return;
        };
        let is_hidden = noise.sigma_px < noise::FEWEST_STEPS * p.subpixel.step_px();
        self.report.parameters.push(Parameter {
            name: "jitter",
            value: noise.sigma_px,
            interval_95: Some(noise.sigma_interval_px),
            unit: "px",
            what: "a pixel's standard deviation over time",
            is_fitted: true,
        });
        if is_hidden {
            self.findings.push(Finding::new(
                "jitter-below-steps",
                Level::Warning,
                "jitter",
                format!(
                    "is less than {:.3} px: too little for steps of {} px to show how much",
                    noise::FEWEST_STEPS * p.subpixel.step_px(),
                    p.subpixel.step_px()
                ),
                "record with more subpixel bits",
            ));
            self.not_found(
                "window",
                "jitter is hidden by the steps of disparity",
                "record with more subpixel bits",
            );
            return;
        }
        let width = seen.first().map_or(p.width_px, |one| one.size.width);
        let side =
            |image_px: usize| points::matcher_window(image_px, f64::from(width) / f64::from(p.width_px));
        self.report.parameters.push(Parameter {
            name: "window",
            value: side(noise.window),
            interval_95: noise.window_interval.map(|ends| ends.map(side)),
            unit: "px",
            what: "the side of the square over which it is correlated",
            is_fitted: true,
        });
    }

    fn without_images(&mut self, path: &std::path::Path) {
        for name in ["jitter", "window"] {
            self.report.not_found.push(NotFound {
                name,
                why: format!("{} has errors and no images", path.display()),
            });
        }
    }

    fn not_found(&mut self, name: &'static str, why: &str, remedy: &str) {
        self.report.not_found.push(NotFound {
            name,
            why: why.to_owned(),
        });
        self.findings.push(Finding::new(
            "not-identifiable",
            Level::Warning,
            name,
            format!("cannot be found: {why}"),
            remedy,
        ));
    }

    /// Fits the systematic error.
    fn systematic(&mut self, points: &[points::OfTarget]) -> Option<Systematic> {
        let is_used = |one: &points::OfTarget| one.point.depth_m >= self.options.from_m;
        let used: Vec<stereo_noise::Point> = points
            .iter()
            .filter(|one| is_used(one))
            .map(|one| one.point)
            .collect();
        let errors = Errors {
            points: &used,
            px_m: self.px_m,
            is_absolute: self.report.is_absolute,
        };
        let is_free = self.options.fits_focal_length;
        let wanted = if is_free { 3 } else { 2 };
        let is_known = used.iter().all(|point| point.sigma_px.is_some());
        let found = errors.fit(is_free);
        let trouble = findings::not_identifiable(&used, found.as_ref(), wanted, is_known);
        let found = match trouble {
            Some((why, remedy)) => {
                self.not_found("bias", &why, remedy);
                self.not_found("pixelLocking", &why, remedy);
                if is_free {
                    self.not_found("focalLength", &why, remedy);
                }
                None
            }
            None => found,
        };
        if let Some(found) = &found {
            self.parameters_of(found);
            self.findings
                .extend(findings::implausible(&errors, found, is_free));
        }
        let parameters = found.as_ref().map(|found| found.solution.parameters.as_slice());
        self.report.points = points
            .iter()
            .map(|one| {
                let point = &one.point;
                let fitted = parameters.map(|p| errors.error(p, point.depth_m));
                FittedPoint {
                    target: one.target,
                    distance_m: point.depth_m,
                    error_percent: 100.0 * point.error,
                    error_px: errors.in_px(point.error, point.depth_m),
                    sigma_px: point.sigma_px,
                    fitted_percent: fitted.map(|error| 100.0 * error),
                    fitted_px: fitted.map(|error| errors.in_px(error, point.depth_m)),
                    is_used: is_used(one),
                }
            })
            .collect();
        self.report.curve = found.as_ref().map(|found| self.goodness(found));
        found
    }

    fn parameters_of(&mut self, found: &Systematic) {
        let solution = &found.solution;
        let interval = |at: usize, scale: f64| {
            let half = solution.factor(found.is_known) * solution.error(at)?;
            let value = solution.parameters[at];
            Some([(value - half) * scale, (value + half) * scale])
        };
        // An amplitude is not below 0.
        let locking = interval(1, 1.0).map(|ends| ends.map(|end| end.max(0.0)));
        let nominal = self.report.focal_length_px;
        let mut parameters = vec![
            Parameter {
                name: "bias",
                value: solution.parameters[0],
                interval_95: interval(0, 1.0),
                unit: "px",
                what: "the error of the calibration; below 0 it reports too far",
                is_fitted: true,
            },
            Parameter {
                name: "pixelLocking",
                value: solution.parameters[1].max(0.0),
                interval_95: locking,
                unit: "px",
                what: "the amplitude of the error that repeats with every pixel",
                is_fitted: true,
            },
        ];
        if let Some(share) = solution.parameters.get(2) {
            self.report.focal_length_px = nominal * share;
            parameters.push(Parameter {
                name: "focalLength",
                value: nominal * share,
                interval_95: interval(2, nominal),
                unit: "px",
                what: "by which distances became disparities",
                is_fitted: true,
            });
        }
        parameters.append(&mut self.report.parameters);
        self.report.parameters = parameters;
    }

    /// Optics that were given belong to the unit as much as what was fitted.
    fn given(&mut self, p: &Parameters) {
        let optics = &self.options.optics;
        if optics.focal_length_px.is_some() && self.report.parameter("focalLength").is_none() {
            self.report.parameters.push(Parameter {
                name: "focalLength",
                value: p.stereo.focal_length_px,
                interval_95: None,
                unit: "px",
                what: "by which distances became disparities",
                is_fitted: false,
            });
        }
        if optics.width_px.is_some() {
            self.report.parameters.push(Parameter {
                name: "width",
                value: f64::from(p.width_px),
                interval_95: None,
                unit: "px",
                what: "of the matcher's images",
                is_fitted: false,
            });
        }
    }

    fn goodness(&self, found: &Systematic) -> Curve {
        let used: Vec<&FittedPoint> = self.report.points.iter().filter(|point| point.is_used).collect();
        let rms = |of: &dyn Fn(&FittedPoint) -> f64| {
            (used.iter().map(|point| of(point).powi(2)).sum::<f64>() / used.len() as f64).sqrt()
        };
        let pairs: Vec<[f64; 2]> = used
            .iter()
            .filter_map(|point| Some([point.error_percent, point.fitted_percent?]))
            .collect();
        Curve {
            points: used.len(),
            rms_px: rms(&|point| point.error_px - point.fitted_px.unwrap_or(f64::NAN)),
            rms_percent: rms(&|point| point.error_percent - point.fitted_percent.unwrap_or(f64::NAN)),
            r_squared: r_squared(&pairs),
            scatter: (found.is_known && found.solution.freedom > 0)
                .then(|| (found.solution.squares / found.solution.freedom as f64).sqrt()),
        }
    }
}

//! Estimates the parameters of an engine from a real device's recordings of a flat target.
//!
//! A recording is a folder of depth images of a flat target, perpendicular to the camera, and a table
//! ([`TABLE`], `file,distance_m`) of its true distances; or a folder in Replicator's layout with ground truth beside the
//! sensor's images; or, for the systematic error alone, a curve of errors over distance
//! ([`measured`](crate::accuracy::measured)). Images without true distances determine only the noise.
//!
//! # `stereo_noise`
//! * σ (`jitter`): half of the variance of the differences of consecutive frames, minus the variance of rounding to whole
//!   steps of disparity and whole millimetres (step²/12), over distances at which a millimetre is not coarser than the noise.
//! * The window of its correlation (`window`): the covariance of those differences decreases linearly with the distance in
//!   pixels under a square window. Its interval follows from 200 bootstrap samples of the pairs of frames.
//! * β (`bias`), a (`pixelLocking`) and, on request, the focal length: robust least squares of the mean over time and region
//!   at each distance, without mismatches, against the true distance. Points are weighted by their uncertainty due to noise
//!   and rounding. Intervals follow from the linear approximation, and are wider if the points scatter more than their noise
//!   explains.
//!
//! # `time_of_flight`
//! * σ at each distance: half of the variance of such differences, corrected for the noise that consecutive frames share
//!   (half of it or none, as the differences of every second frame show), minus the variance of whole millimetres (unit²/12).
//! * Light (`signal`, `ambient`): robust least squares of the logarithm of σ over distance. Noise determines only
//!   contrast²·albedo·signal, where the light itself dominates, and (ambient·albedo + read noise²) over
//!   (contrast·albedo·signal)², where it does not. Contrast, albedo and read noise are the engine's parameters, and so
//!   is ambient light if the distances are too few or too similar to separate it from the signal.
//! * Bias (`bias`) and wiggling (`wigglingResidual`, or `wiggling` if its correction is off): the mean over time and region
//!   against the true distance, as above. Targets beyond the range, or off by whole periods, are ignored.
//!
//! The rotation of a target is computed from the planes through its images, over all distances; up to a few degrees it is applied
//! to the true distances, pixel by pixel. The stated distances are those at the centre of the region.

mod error_domain;
mod evaluation;
mod findings;
#[cfg(test)]
mod fixture;
mod least_squares;
mod method;
mod plot;
mod point;
mod points;
mod recording;
mod report;
mod state;
mod stereo_noise;
mod target;
mod time_of_flight;

pub use recording::TABLE;
pub use report::{FitQuality, FitReport, FittedPoint, NotFound, Parameter, TargetReport};

use crate::accuracy::{AccuracyError, MeasuredOptics, REGION};
use crate::figure::Figure;
use method::{Fitted, Method};
use oaktwin_base::diagnostic::{Finding, Level, Message, message, opt};
use oaktwin_catalog::{DepthKind, Twin};
use oaktwin_depth::stereo_noise::StereoNoise;
use oaktwin_depth::time_of_flight::TimeOfFlight;
use oaktwin_files::FileError;
use oaktwin_pipeline::input::check_depth_scale;
use oaktwin_pipeline::progress::Watch;
use oaktwin_pipeline::sensor::{ParameterError, SensorOptions, Technology, depth_sensor, sensor};
use recording::Recording;
pub use recording::{Recordings, TargetImages};
use state::FitState;
use stereo_noise::Stereo;
use time_of_flight::Tof;

/// The settings of a fit.
#[derive(Clone, Debug, PartialEq)]
pub struct FitOptions {
    /// The depth sensor by prim or kind; by default the engine's, or the device's own.
    pub sensor: Option<String>,
    /// The engine and its known parameters, such as its subpixel bits.
    pub engine: SensorOptions,
    /// The unit's optics, if they differ from the model's.
    pub optics: MeasuredOptics,
    /// The side of the measured region as a share (0 to 1) of the image's side.
    pub region: f64,
    /// Metres per unit of integer images.
    pub depth_scale: f64,
    /// The distance in metres below which errors are ignored.
    pub from_m: f64,
    /// Whether to fit the focal length as well.
    pub fits_focal_length: bool,
}

impl Default for FitOptions {
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

/// The reason why nothing was fitted.
#[derive(Debug, thiserror::Error)]
pub enum FitError {
    /// A file cannot be read or understood.
    #[error(transparent)]
    File(#[from] FileError),
    /// A parameter of the sensor is invalid.
    #[error(transparent)]
    Parameter(#[from] ParameterError),
    /// The sensor or the optics are invalid.
    #[error(transparent)]
    Accuracy(#[from] AccuracyError),
    /// An option or recording is invalid: `WHAT: what is wrong; what to do`.
    #[error("{0}")]
    Option(Message),
    /// The fit was interrupted.
    #[error("interrupted; nothing was fitted")]
    Interrupted,
}

/// A fit, from which a figure can be drawn.
#[derive(Debug)]
pub struct Fit {
    report: FitReport,
    found: Option<Box<dyn Fitted>>,
}

impl Fit {
    /// Returns the results.
    #[must_use]
    pub fn report(&self) -> &FitReport {
        &self.report
    }

    /// Draws the error over distance with the fitted curve, and the residuals.
    #[must_use]
    pub fn figures(&self) -> Vec<Figure> {
        plot::figures(&self.report, self.found.as_deref())
    }
}

/// Fits the parameters of a twin's depth sensor to recordings. The findings are about the recordings.
///
/// # Errors
/// Returns an error if a recording cannot be read, is empty, or does not show a flat, perpendicular target; if an option is
/// invalid; or if `watch` interrupts.
pub fn fit<'a>(
    twin: &Twin,
    recordings: impl Into<Recordings<'a>>,
    options: &FitOptions,
    watch: &Watch<'_>,
) -> Result<(Fit, Vec<Finding>), FitError> {
    check(options)?;
    let recordings = recordings.into();
    let mut twin = twin.clone();
    let of_engine = options.engine.engine.as_ref().and_then(|kind| kind.models);
    let of_engine = of_engine.map(|models| match models {
        Technology::Stereo => DepthKind::Stereo.as_str(),
        Technology::TimeOfFlight => DepthKind::Tof.as_str(),
    });
    let depth = depth_sensor(&twin, options.sensor.as_deref().or(of_engine))?.clone();
    let depth = options.optics.apply(&mut twin, &depth)?;
    let kind = options.engine.engine_for(depth.spec.kind);
    let settings = SensorOptions {
        engine: Some(kind.clone()),
        ..options.engine.clone()
    };
    let (sensor, mut findings) = sensor(&twin, &depth, &settings)?;
    let stereo = sensor.engine().downcast_ref::<StereoNoise>();
    let stereo = stereo.map(StereoNoise::parameters);
    let mut method: Box<dyn Method> = match (stereo, sensor.engine().downcast_ref::<TimeOfFlight>()) {
        (Some(parameters), _) => Box::new(Stereo::new(*parameters)),
        (_, Some(engine)) => Box::new(Tof::new(engine, options)?),
        _ => {
            return Err(FitError::Option(message![format!(
                "engine: there is nothing to fit in {}, whose errors are not measured; choose stereo-noise or \
                 time-of-flight",
                kind.name
            )]));
        }
    };
    let recording = recordings.open(&depth.spec.prim)?;
    let (focal_length_px, width_px) = method.focal_length_px();
    let report = FitReport {
        model: twin.device.name.clone(),
        sensor: depth.spec.prim.clone(),
        engine: kind.name.to_string(),
        unit: method.error_domain().unit(),
        parameters: Vec::new(),
        not_found: Vec::new(),
        focal_length_px,
        width_px,
        baseline_m: stereo.map(|p| p.stereo.baseline_m),
        step_px: stereo.map(|p| p.subpixel.step_px()),
        is_absolute: false,
        from_m: options.from_m,
        curve: None,
        tilt_deg: None,
        sources: recordings.names(),
        targets: Vec::new(),
        points: Vec::new(),
        passed: true,
    };
    let mut state = FitState {
        report,
        options,
        findings: Vec::new(),
    };
    let points = match recording {
        Recording::Curve(path, curve) => {
            state.report.is_absolute = curve.is_absolute;
            state.without_images(&path, method.noise_names());
            points::of_curve(&curve)
        }
        Recording::Targets(recordings) => state.evaluate(&recordings, method.as_mut(), watch)?,
    };
    let found = state.systematic(&points, method.as_ref());
    method.given(&mut state);
    findings.append(&mut state.findings);
    state.report.passed = !findings.iter().any(|finding| finding.level != Level::Note);
    let fit = Fit {
        report: state.report,
        found,
    };
    Ok((fit, findings))
}

fn check(options: &FitOptions) -> Result<(), FitError> {
    let wrong = |name: &'static str, is: String| Err(FitError::Option(message![opt(name), is]));
    if !(options.region > 0.0 && options.region <= 1.0) {
        let is = format!(
            ": {} is out of range; give a share above 0, up to 1",
            options.region
        );
        return wrong("region", is);
    }
    if !(options.from_m >= 0.0 && options.from_m.is_finite()) {
        let is = format!(": {} is out of range; give a distance in metres", options.from_m);
        return wrong("from", is);
    }
    check_depth_scale(options.depth_scale).map_err(FitError::Option)
}

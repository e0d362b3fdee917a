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
//! # `time_of_flight`
//! * σ at each distance: half of the variance of such differences, by what frames share with the next (half of their
//!   noise or none, as frames two apart tell), less whole millimetres (unit²/12).
//! * Light (`signal`, `ambient`): σ over distance by robust least squares of its logarithm. Noise tells but
//!   contrast²·albedo·signal, from where the light itself is most of it, and (ambient·albedo + read noise²) over
//!   (contrast·albedo·signal)², from where it is not: contrast, albedo and read noise are those of the engine's parameters,
//!   and ambient light too where one distance, or distances too alike, do not tell it from the signal.
//! * Bias (`bias`) and wiggling (`wigglingResidual`, or `wiggling` where its correction is off): the mean over time and
//!   region against the truth, as above. Of targets beyond the range, or off by whole periods, nothing is made.
//!
//! A target's turn is that of the planes through its images, all distances together; up to a few degrees it is put into
//! the truth, pixel by pixel. The given distances are those at the region's middle.

mod counting;
mod findings;
#[cfg(test)]
mod fixture;
mod least_squares;
mod method;
mod plot;
mod points;
mod recording;
mod report;
mod stereo_noise;
mod target;
mod time_of_flight;
mod work;

use std::path::PathBuf;

pub use recording::TABLE;
pub use report::{Curve, FittedPoint, NotFound, Parameter, Report, Target};

use crate::accuracy::{AccuracyError, MeasuredOptics, REGION};
use crate::figure::Figure;
use method::{Fitted, Method};
use oaktwin_catalog::{DepthKind, Twin};
use oaktwin_depth::stereo_noise::StereoNoise;
use oaktwin_depth::time_of_flight::TimeOfFlight;
use oaktwin_diagnostic::{Finding, Level, Message, message};
use oaktwin_files::FileError;
use oaktwin_pipeline::progress::Watch;
use oaktwin_pipeline::sensor::{
    ParameterError, SensorOptions, Technology, default_engine, depth_sensor, sensor,
};
use recording::Recording;
use stereo_noise::Stereo;
use time_of_flight::Tof;
use work::Work;

/// How to fit.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// The depth sensor by prim or kind; by default that of the engine, or the device's own.
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
    Option(Message),
    /// Whoever watched wanted no more.
    #[error("interrupted; nothing was fitted")]
    Interrupted,
}

/// A fit, and the means to draw it.
#[derive(Debug)]
pub struct Fit {
    report: Report,
    found: Option<Box<dyn Fitted>>,
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
        plot::figures(&self.report, self.found.as_deref())
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
    watch: &Watch<'_>,
) -> Result<(Fit, Vec<Finding>), FitError> {
    check(options)?;
    let mut twin = twin.clone();
    let of_engine = options.engine.engine.and_then(|kind| kind.models);
    let of_engine = of_engine.map(|models| match models {
        Technology::Stereo => DepthKind::Stereo.as_str(),
        Technology::TimeOfFlight => DepthKind::Tof.as_str(),
    });
    let depth = depth_sensor(&twin, options.sensor.as_deref().or(of_engine))?.clone();
    let depth = options.optics.apply(&mut twin, &depth)?;
    let kind = options
        .engine
        .engine
        .unwrap_or_else(|| default_engine(depth.spec.kind));
    let settings = SensorOptions {
        engine: Some(kind),
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
    let recording = recording::open(recordings, &depth.spec.prim)?;
    let (focal_length_px, width_px) = method.focal_length_px();
    let report = Report {
        model: twin.device.name.clone(),
        sensor: depth.spec.prim.clone(),
        engine: kind.name,
        unit: method.counting().unit(),
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
        sources: recordings.iter().map(|path| path.display().to_string()).collect(),
        targets: Vec::new(),
        points: Vec::new(),
        passed: true,
    };
    let mut work = Work {
        report,
        options,
        findings: Vec::new(),
    };
    let points = match recording {
        Recording::Curve(path, curve) => {
            work.report.is_absolute = curve.is_absolute;
            work.without_images(&path, method.noise_names());
            points::of_curve(&curve)
        }
        Recording::Stands(stands) => work.look(&stands, method.as_mut(), watch)?,
    };
    let found = work.systematic(&points, method.as_ref());
    method.given(&mut work);
    findings.append(&mut work.findings);
    work.report.passed = !findings.iter().any(|finding| finding.level != Level::Note);
    let fit = Fit {
        report: work.report,
        found,
    };
    Ok((fit, findings))
}

fn check(options: &Options) -> Result<(), FitError> {
    let wrong = |text: String| Err(FitError::Option(text.into()));
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

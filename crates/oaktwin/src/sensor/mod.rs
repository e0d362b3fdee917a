//! The sensor of a twin: from its catalog entry or calibration to a [`Sensor`] that turns ground truth into what the
//! device would report.

use oaktwin_depth::filter::Chain;
use oaktwin_depth::random::Stream;
use oaktwin_depth::single_view::{Assumptions, SingleView};
use oaktwin_depth::stereo_noise::{self, StereoNoise};
pub use oaktwin_depth::{Capture, Engine, ParameterError, Sensor, Shot, single_view};

use crate::camera::{Intrinsics, StereoGeometry};
use crate::catalog::{DepthKind, Role, Twin, TwinDepthSensor};

/// Which model of the errors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EngineKind {
    /// Isaac Sim's `DepthSensorDistance`.
    SingleView,
    /// The errors of an OAK's stereo.
    StereoNoise,
}

impl EngineKind {
    /// The one that is nearest to the device: an OAK's stereo errors; Isaac Sim's for what is no stereo.
    #[must_use]
    pub fn default_for(kind: DepthKind) -> Self {
        match kind {
            DepthKind::Stereo => Self::StereoNoise,
            DepthKind::Tof => Self::SingleView,
        }
    }
}

/// How the sensor of a twin is to be.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SensorOptions {
    /// By default [`EngineKind::default_for`] the sensor's kind.
    pub engine: Option<EngineKind>,
    /// The intrinsics of the depth images where they are not the twin's: the focal length at their width is used.
    pub image: Option<Intrinsics>,
    /// Of the noise.
    pub seed: u64,
    /// Of the device's calibration bias; none has none.
    pub device_seed: Option<u64>,
}

/// The parameters that a render product of this sensor has.
#[must_use]
pub fn single_view_parameters(sensor: &TwinDepthSensor) -> single_view::Parameters {
    let spec = &sensor.spec;
    single_view::Parameters {
        baseline_mm: spec.baseline_mm,
        confidence_threshold: spec.confidence_threshold,
        focal_length_px: sensor.focal_length_px,
        max_disparity_px: spec.max_disparity_px,
        min_distance_m: spec.min_distance_m,
        max_distance_m: spec.max_distance_m,
        noise_mean_px: spec.noise_mean_px,
        noise_sigma_px: spec.noise_sigma_px,
        noise_downscale_factor_px: spec.noise_downscale_factor_px,
        outlier_removal_range_px: spec.outlier_removal_range_px,
        sensor_size_px: spec.sensor_size_px,
        ..single_view::Parameters::ISAAC_5_1
    }
}

/// The parameters of the stereo pair of a twin, in the mode of its cameras' used resolution; `None` where it has no
/// pair.
#[must_use]
pub fn stereo_noise_parameters(twin: &Twin) -> Option<stereo_noise::Parameters> {
    let (left, right) = (twin.camera(Role::Left)?, twin.camera(Role::Right)?);
    let baseline = left.body_from_camera.translation - right.body_from_camera.translation;
    let stereo = StereoGeometry {
        focal_length_px: left.intrinsics.fx,
        baseline_m: baseline.length(),
    };
    Some(stereo_noise::Parameters::new(stereo, left.intrinsics.size.width))
}

/// The sensor of a twin.
///
/// # Errors
/// An engine that the sensor cannot have; a parameter out of its range.
pub fn sensor(
    twin: &Twin,
    sensor: &TwinDepthSensor,
    options: &SensorOptions,
) -> Result<Sensor, ParameterError> {
    let kind = options
        .engine
        .unwrap_or_else(|| EngineKind::default_for(sensor.spec.kind));
    let random = Stream::new(options.seed, &sensor.spec.prim);
    let engine = match kind {
        EngineKind::SingleView => {
            let mut parameters = single_view_parameters(sensor);
            if let Some(image) = options.image {
                let scale = parameters.sensor_size_px / f64::from(image.size.width);
                parameters.focal_length_px = image.fx * scale;
            }
            Engine::SingleView(SingleView::new(parameters, Assumptions::default())?)
        }
        EngineKind::StereoNoise => {
            let parameters = stereo_noise_parameters(twin)
                .filter(|_| sensor.spec.kind == DepthKind::Stereo)
                .ok_or_else(|| ParameterError {
                    name: "engine".to_owned(),
                    what: format!("{} is no stereo sensor", sensor.spec.prim),
                    remedy: "use single-view, or the stereo sensor".to_owned(),
                })?;
            let mut parameters = match options.device_seed {
                Some(seed) => parameters.of_device(seed),
                None => parameters,
            };
            if let Some(image) = options.image {
                let scale = f64::from(parameters.width_px) / f64::from(image.size.width);
                parameters.stereo.focal_length_px = image.fx * scale;
            }
            Engine::StereoNoise(StereoNoise::new(parameters)?)
        }
    };
    Ok(Sensor::new(engine, Chain::default(), random))
}

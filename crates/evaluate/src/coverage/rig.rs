use oaktwin_base::diagnostic::Finding;
use oaktwin_camera::{ImageSize, RigidTransform};
use oaktwin_catalog::Twin;
use oaktwin_pipeline::pair::{PairCameras, PairOptions, default_projector, dot_contrast};
use oaktwin_pipeline::render::{
    DepthSensorOptions, OakOptions, PlacedCamera, depth_sensors, oak_cameras, put_pair,
};
use oaktwin_pipeline::sensor::{EngineInput, Sensor, SensorOptions, default_engine, depth_sensor};

use super::{CoverageError, Placement};

/// The depth sensor of an OAK with its camera, which can be placed anywhere.
#[derive(Clone, Debug)]
pub struct Rig {
    pub(super) model: String,
    pub(super) camera: PlacedCamera,
    pub(super) sensor: Sensor,
    /// The stereo pair, for an engine that matches one.
    pub(super) pair: Option<PairCameras>,
}

/// The settings of a depth sensor.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RigOptions {
    /// The depth sensor by prim or kind (`stereo`, `tof`); by default the device's own.
    pub sensor: Option<String>,
    /// The engine and its settings; by default the engine that models the sensor.
    pub engine: SensorOptions,
    /// The image size, resized by `DepthAI`'s rule; by default the sensor's own.
    pub size: Option<ImageSize>,
    /// The intensity of the dot projector, 0 (off) to 1; by default full on the models that have one.
    pub projector: Option<f64>,
    /// The recording of pairs, for an engine that matches them. The size, projector, seed and bias are set by the other options.
    pub pair: PairOptions,
}

impl Rig {
    /// Creates the depth sensor of a twin. The findings report where it deviates from the twin.
    ///
    /// # Errors
    /// Returns an error if the device has no such depth sensor or an option is invalid.
    pub fn new(twin: &Twin, options: &RigOptions) -> Result<(Self, Vec<Finding>), CoverageError> {
        let own = depth_sensor(twin, options.sensor.as_deref())?;
        let engine = options
            .engine
            .engine
            .unwrap_or_else(|| default_engine(own.spec.kind));
        let oak = OakOptions {
            cameras: std::slice::from_ref(&own.spec.prim),
            size: options.size,
            lens: options.pair.lens,
        };
        let (mut cameras, mut findings) = oak_cameras(twin, &RigidTransform::IDENTITY, &oak)?;
        let projector = options.projector.unwrap_or_else(|| default_projector(twin));
        let dots = dot_contrast(twin, projector, options.pair.ambient)?;
        let pair = if engine.input == EngineInput::Pair {
            let pair = PairOptions {
                size: options.size,
                projector,
                ..options.pair.of_sensor(&options.engine)?
            };
            let (pair, more) = put_pair(twin, &mut cameras, &pair)?;
            findings.extend(more);
            Some(pair)
        } else {
            None
        };
        let sensor = SensorOptions {
            engine: Some(engine),
            ..options.engine.clone()
        };
        let sensor = sensor.with_dots(dots);
        let sensor = DepthSensorOptions {
            twin: Some(twin),
            sensor: &sensor,
        };
        let (mut sensors, more) = depth_sensors(&cameras, &sensor)?;
        findings.extend(more);
        match (cameras.pop(), sensors.pop().flatten()) {
            (Some(camera), Some(sensor)) => Ok((
                Self {
                    model: twin.device.name.clone(),
                    camera,
                    sensor,
                    pair,
                },
                findings,
            )),
            _ => Err(CoverageError::Option(
                format!(
                    "{}: the depth sensor {} has no camera; choose another one",
                    twin.device.name, own.spec.prim
                )
                .into(),
            )),
        }
    }

    /// Creates the depth sensors of those cameras of a stage that have one, by default with Isaac Sim's engine.
    ///
    /// # Errors
    /// Returns an error if an option is invalid.
    pub fn of_stage(
        cameras: &[PlacedCamera],
        options: &SensorOptions,
    ) -> Result<(Vec<Self>, Vec<Finding>), CoverageError> {
        let sensors = DepthSensorOptions {
            twin: None,
            sensor: options,
        };
        let (sensors, findings) = depth_sensors(cameras, &sensors)?;
        let rigs = cameras.iter().zip(sensors).filter_map(|(camera, sensor)| {
            Some(Self {
                model: camera.path.clone(),
                camera: camera.clone(),
                sensor: sensor?,
                pair: None,
            })
        });
        Ok((rigs.collect(), findings))
    }

    /// The name of the model, or the path of a stage's camera.
    #[must_use]
    pub fn model(&self) -> &str {
        &self.model
    }

    /// The camera of the depth sensor; its mount is the body of an OAK, or the camera of a stage.
    #[must_use]
    pub fn camera(&self) -> &PlacedCamera {
        &self.camera
    }

    /// The depth sensor.
    #[must_use]
    pub fn sensor(&self) -> &Sensor {
        &self.sensor
    }
}

/// An OAK at a pose.
#[derive(Clone, Debug)]
pub struct Candidate<'a> {
    /// The OAK.
    pub rig: &'a Rig,
    /// A name for reports.
    pub name: String,
    /// The pose of the body (x forward, y left, z up), or of a stage's camera, in the world, in metres.
    pub world_from_body: RigidTransform,
}

impl<'a> Candidate<'a> {
    /// Creates a candidate from its parts.
    #[must_use]
    pub fn new(rig: &'a Rig, name: impl Into<String>, world_from_body: RigidTransform) -> Self {
        Self {
            rig,
            name: name.into(),
            world_from_body,
        }
    }
}

/// Returns every rig at every placement as a candidate, beginning with the first rig.
#[must_use]
pub fn candidates<'a>(rigs: &'a [Rig], placements: &[Placement]) -> Vec<Candidate<'a>> {
    let placed = |rig: &'a Rig| {
        let at = move |place: &Placement| Candidate::new(rig, &place.name, place.world_from_body);
        placements.iter().map(at)
    };
    rigs.iter().flat_map(placed).collect()
}

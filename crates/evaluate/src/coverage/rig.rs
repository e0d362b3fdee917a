use oaktwin_base::diagnostic::{Finding, message, opt};
use oaktwin_camera::RigidTransform;
use oaktwin_catalog::Twin;
use oaktwin_image::annotation::Annotator;
use oaktwin_pipeline::pair::{PairOptions, default_projector};
use oaktwin_pipeline::render::{PlacedCamera, Rig, RigError, RigSpec, SceneFile};
use oaktwin_pipeline::sensor::{Sensor, depth_sensor};

use super::{CoverageError, Placement};

/// What is made of each view; some engines lack the reasons.
const MADE: [Annotator; 3] = [
    Annotator::DistanceToImagePlane,
    Annotator::DepthSensorDistance,
    Annotator::DepthSensorReason,
];

/// A rig with one depth sensor, whose coverage is measured wherever it is placed.
#[derive(Clone, Debug)]
pub struct MeasuringRig {
    pub(super) rig: Rig,
    pub(super) camera: PlacedCamera,
    pub(super) sensor: Sensor,
}

impl MeasuringRig {
    /// Creates the rig of a twin's depth sensor, which is named by its prim or kind (`stereo`, `tof`) and by default the device's own. The
    /// intensity of the dot projector is by default full on the models that have one. Of the specification, the cameras, the annotators
    /// and the projector are set by the other arguments. The findings report where the sensor deviates from the twin.
    ///
    /// # Errors
    /// Returns an error if the device has no such depth sensor or an option is invalid.
    pub fn new(
        twin: &Twin,
        sensor: Option<&str>,
        projector: Option<f64>,
        spec: &RigSpec,
    ) -> Result<(Self, Vec<Finding>), CoverageError> {
        let own = depth_sensor(twin, sensor)?;
        let spec = RigSpec {
            cameras: vec![own.spec.prim.clone()],
            annotators: MADE.to_vec(),
            are_outputs_optional: true,
            pair: PairOptions {
                projector: projector.unwrap_or_else(|| default_projector(twin)),
                ..spec.pair
            },
            ..spec.clone()
        };
        let (rig, findings) = Rig::new(twin, &spec)?;
        Ok((Self::of(rig)?, findings))
    }

    /// Creates a rig for each depth sensor of a stage, by default with Isaac Sim's engine; none if the stage has no depth sensor.
    ///
    /// # Errors
    /// Returns an error if an option is invalid.
    pub fn of_stage(stage: &SceneFile, spec: &RigSpec) -> Result<(Vec<Self>, Vec<Finding>), CoverageError> {
        let spec = RigSpec {
            annotators: MADE.to_vec(),
            are_outputs_optional: true,
            is_sensor_optional: true,
            ..spec.clone()
        };
        let (rig, findings) = Rig::of_stage(stage, &spec)?;
        let rigs = rig.split().into_iter().map(Self::of);
        Ok((rigs.collect::<Result<_, _>>()?, findings))
    }

    fn of(rig: Rig) -> Result<Self, CoverageError> {
        let Some((camera, sensor)) = rig.depth_sensor() else {
            let what = format!(
                ": the depth sensor of {} has no camera; choose another one",
                rig.name()
            );
            return Err(message![opt("sensor"), what].into());
        };
        Ok(Self {
            camera: camera.clone(),
            sensor: sensor.clone(),
            rig,
        })
    }

    /// The name of the model, or the path of a stage's camera.
    #[must_use]
    pub fn name(&self) -> &str {
        self.rig.name()
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

    /// Rejects images that need more memory than is available, if that is known.
    ///
    /// # Errors
    /// Returns an error that names the camera.
    pub fn check_memory(&self) -> Result<(), RigError> {
        self.rig.check_memory(false)
    }
}

/// An OAK at a pose.
#[derive(Clone, Debug)]
pub struct Candidate<'a> {
    /// The OAK.
    pub rig: &'a MeasuringRig,
    /// A name for reports.
    pub name: String,
    /// The pose of the body (x forward, y left, z up), or of a stage's camera, in the world, in metres.
    pub world_from_body: RigidTransform,
}

impl<'a> Candidate<'a> {
    /// Creates a candidate from its parts.
    #[must_use]
    pub fn new(rig: &'a MeasuringRig, name: impl Into<String>, world_from_body: RigidTransform) -> Self {
        Self {
            rig,
            name: name.into(),
            world_from_body,
        }
    }
}

/// Returns every rig at every placement as a candidate, beginning with the first rig.
#[must_use]
pub fn candidates<'a>(rigs: &'a [MeasuringRig], placements: &[Placement]) -> Vec<Candidate<'a>> {
    let placed = |rig: &'a MeasuringRig| {
        let at = move |place: &Placement| Candidate::new(rig, &place.name, place.world_from_body);
        placements.iter().map(at)
    };
    rigs.iter().flat_map(placed).collect()
}

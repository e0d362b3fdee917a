use std::collections::BTreeMap;

use oaktwin_base::diagnostic::{message, opt};
use oaktwin_base::parameter::{by_name, choice};
use oaktwin_camera::ImageSize;
use oaktwin_catalog::{Twin, TwinDepthSensor};
use oaktwin_depth::imager::ColorParameters;
use oaktwin_image::annotation::Annotator;
use oaktwin_render::{Backend, Transparent};
use oaktwin_usd::optics::Projection;
use serde::{Deserialize, Serialize};

use super::RigError;
use crate::pair::PairOptions;
use crate::render::annotators::annotator_names;
use crate::render::shutter::Shutter;
use crate::render::sweep::Sweep;
use crate::render::{DepthSensorSource, PlacedCamera};
use crate::sensor::{EngineRef, SensorOptions};

/// What a [`Rig`](super::Rig) has and what its shots contain. The default is a device's depth sensors, which render nothing yet.
///
/// In JSON and TOML, a rig is a table with the names of the fields; what is left out has its default:
///
/// ```
/// # use oaktwin_pipeline::render::RigSpec;
/// let spec: RigSpec = serde_json::from_str(
///     r#"{"annotators": ["rgb", "depth_sensor_distance"], "size": {"width": 640, "height": 400},
///         "sensor": {"engine": "stereo-matching", "preset": "robotics", "parameters": {"subpixel": true}},
///         "pair": {"projector": 0.5, "ambient": 0.1, "imager": {"readNoise": 4}}}"#,
/// )?;
/// assert_eq!(spec.pair.imager.read_noise_e, 4.0);
/// let error = serde_json::from_str::<RigSpec>(r#"{"sensor": {"engin": "stereo-noise"}}"#).unwrap_err();
/// assert!(error.to_string().starts_with("unknown option 'engin'; did you mean 'engine'?"));
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct RigSpec {
    /// The names of the cameras. If there are none, the camera of every depth sensor is chosen, or every camera if there is no depth sensor.
    /// Cameras of an OAK are named as in [`OakOptions`](crate::render::OakOptions), cameras of a stage by their paths or unique names.
    pub cameras: Vec<String>,
    /// The image size; by default each camera's own. Images of an OAK are resized by `DepthAI`'s rule.
    pub size: Option<ImageSize>,
    /// How the apertures of a stage's cameras are interpreted.
    pub projection: Projection,
    /// The annotators of each shot. Depth sensors are created if one of them, or a sweep, requires them.
    #[serde(with = "annotator_names")]
    pub annotators: Vec<Annotator>,
    /// Whether the outputs of depth sensors are left out where there is none; otherwise a rig without any is an error.
    pub is_sensor_optional: bool,
    /// Whether outputs that an engine cannot make are left out without a warning.
    pub are_outputs_optional: bool,
    /// The engine of the depth sensors and its settings. An OAK's sensor has the engine of its technology by default, a stage's has
    /// Isaac Sim's.
    pub sensor: SensorOptions,
    /// How the pair is recorded, with the light of the scene and of the dot projector for every engine, and the lens. The cameras, the
    /// size, the bias, the drift and the seed are set by the other fields.
    pub pair: PairOptions,
    /// What the pair is for.
    pub pair_use: PairUse,
    /// The sweep of a parameter, which adds a sheet to each shot of a depth sensor.
    pub sweep: Option<Sweep>,
    /// The image sensor of the cameras, which records the annotator `rgb` with the blur, the exposure and the noise of a colour camera; by
    /// default colours are exact. Depth sensors do not depend on it.
    #[serde(with = "by_name::optional", skip_serializing_if = "Option::is_none")]
    pub rgb_imager: Option<ColorParameters>,
    /// The visibility backend.
    pub backend: Backend,
    /// What the ground truth of transparent surfaces is. Neither colours nor the models of depth cameras depend on it.
    pub transparent: Transparent,
    /// How long a frame takes; by default no time. It has an effect on frames of what moves: along a trajectory, of an animated scene, or
    /// with a velocity ([`Rig::expose`](super::Rig::expose)).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub shutter: Option<Shutter>,
    /// How long after the time of a frame each camera takes it, ms, by the camera's name; 0 of others. Shots have the times, poses and scenes
    /// of their cameras.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub camera_offsets_ms: BTreeMap<String, f64>,
}

choice! {
    /// What the stereo pair of a rig is for.
    PairUse {
        /// Rendered for engines that match pairs, and not for others.
        Matched = "matched",
        /// For engines that match it, and as PNG in each shot: `left`, `right`, `rectified_left`, `rectified_right`.
        Written = "written",
        /// For engines that match it, and as the description of the pair in each shot, for the formats that have one.
        Described = "described",
        /// For engines that match it, and for the caller, if the device has a pair.
        Beside = "beside",
    }
}

impl RigSpec {
    /// Whether depth sensors are required.
    pub(super) fn senses(&self) -> bool {
        self.sweep.is_some() || self.annotators.iter().any(|one| one.is_depth_sensor())
    }

    /// The sensor options, followed by those of a sweep's cells.
    pub(super) fn all_sensors(&self) -> Result<Vec<SensorOptions>, RigError> {
        let swept = self.sweep.as_ref().map(|sweep| sweep.options(&self.sensor));
        let swept = swept.transpose().map_err(|error| {
            let error = format!(": {error}");
            RigError::Option(message![opt("sweep"), error])
        })?;
        let mut all = vec![self.sensor.clone()];
        all.extend(swept.into_iter().flatten());
        Ok(all)
    }
}

/// Returns the depth sensor that measures with a camera of a twin; `None` for a camera without one.
#[must_use]
pub fn depth_sensor_of<'a>(twin: &'a Twin, camera: &PlacedCamera) -> Option<&'a TwinDepthSensor> {
    let DepthSensorSource::Twin(prim) = camera.depth_sensor.as_ref()? else {
        return None;
    };
    twin.depth_sensors.iter().find(|sensor| sensor.spec.prim == *prim)
}

/// The engine of a camera's depth sensor; `None` for a camera without one.
pub(super) fn engine_of(twin: &Twin, camera: &PlacedCamera, options: &SensorOptions) -> Option<EngineRef> {
    let sensor = depth_sensor_of(twin, camera)?;
    Some(options.engine_for(sensor.spec.kind))
}

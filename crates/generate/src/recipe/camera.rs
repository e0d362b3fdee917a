use std::collections::BTreeMap;

use oaktwin_camera::ImageSize;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{ImuRule, MotionRule, ParameterValue, Quantity, Texts};

/// The camera and its place: on a sphere, in a box or along a trajectory. By default it is on a sphere around the objects.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct CameraRule {
    /// The model. With several, each arrangement uses one of them.
    pub model: Texts,
    /// The cameras of the model to render: `depth`, `rgb`, `left`, `right` or the name of a prim. By default its depth sensors.
    pub cameras: Texts,
    /// The width and height of the images; by default the sensor's.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub resolution: Option<[u32; 2]>,
    /// Whether `rgb` has the blur, the exposure and the noise of a colour camera: `true`, `false`, or its parameters by name, as listed by
    /// `oaktwin params color-imager`, as values or distributions.
    #[serde(skip_serializing_if = "is_default")]
    pub rgb_imager: RgbImagerRule,
    /// The place on a sphere around the target.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sphere: Option<SpherePlacement>,
    /// The place in a box.
    #[serde(rename = "box", skip_serializing_if = "Option::is_none")]
    pub inside: Option<BoxPlacement>,
    /// A trajectory of the camera's body: a TUM or JSON file, relative to the recipe. The first frame of an arrangement has the first
    /// pose; after the last pose the trajectory begins again.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub trajectory: Option<String>,
    /// The inertial sensor, for the format `euroc` with a trajectory. Its samples have the times of the frames.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub imu: Option<ImuRule>,
    /// The motion during a frame; by default frames are moments.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub motion: Option<MotionRule>,
    /// The target of the camera: `objects`, `scene`, the path of a prim or a point [x, y, z]. `objects` is one of the objects, and
    /// the centre of the base scene if there are none.
    pub look_at: Target,
    /// The standard deviation of the target around its place, metres.
    pub look_jitter_m: f64,
    /// The rotation about the viewing direction, degrees.
    pub roll_deg: Quantity,
    /// The minimum distance from every surface, metres. Poses inside objects are rejected, too.
    pub clearance_m: f64,
    /// The minimum share of the image that sees a surface within 20 m.
    pub min_coverage: f64,
    /// The minimum number of objects whose centre is in the image and not behind another surface; at most the number placed.
    pub min_objects: u32,
    /// The maximum number of attempts to find a pose.
    pub attempts: u32,
}

impl Default for CameraRule {
    fn default() -> Self {
        Self {
            model: Texts(vec!["OAK-D Pro PoE".to_owned()]),
            cameras: Texts::default(),
            resolution: None,
            rgb_imager: RgbImagerRule::default(),
            sphere: None,
            inside: None,
            trajectory: None,
            imu: None,
            motion: None,
            look_at: Target::default(),
            look_jitter_m: 0.05,
            roll_deg: Quantity::Normal {
                mean: 0.0,
                deviation: 3.0,
            },
            clearance_m: 0.1,
            min_coverage: 0.3,
            min_objects: 1,
            attempts: 200,
        }
    }
}

impl CameraRule {
    /// Returns the size of the images, if the recipe states it.
    #[must_use]
    pub fn size(&self) -> Option<ImageSize> {
        self.resolution
            .map(|[width, height]| ImageSize::new(width, height))
    }
}

/// The image sensor of colours.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(untagged, expecting = "expected true, false or a table of parameters")]
pub enum RgbImagerRule {
    /// Whether there is one.
    Switch(bool),
    /// Its parameters by name.
    Parameters(BTreeMap<String, ParameterValue>),
}

impl Default for RgbImagerRule {
    fn default() -> Self {
        Self::Switch(true)
    }
}

fn is_default(rule: &RgbImagerRule) -> bool {
    *rule == RgbImagerRule::default()
}

/// A place on a sphere around the target.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct SpherePlacement {
    /// The distance from the target, metres. By default beyond the near limit of a stereo OAK, 0.7 m.
    pub distance_m: Quantity,
    /// The elevation above the target, degrees.
    pub elevation_deg: Quantity,
    /// The azimuth, degrees from the x axis counter-clockwise seen from above.
    pub azimuth_deg: Quantity,
}

impl Default for SpherePlacement {
    fn default() -> Self {
        Self {
            distance_m: Quantity::Uniform([0.9, 1.6]),
            elevation_deg: Quantity::Uniform([20.0, 70.0]),
            azimuth_deg: Quantity::Uniform([0.0, 360.0]),
        }
    }
}

/// A place in a box, with a direction.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BoxPlacement {
    /// The minimum corner of the region of the camera, metres.
    pub min: [f64; 3],
    /// The maximum corner.
    pub max: [f64; 3],
    /// The heading, degrees from the x axis counter-clockwise seen from above; without it the camera looks at the target.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub heading_deg: Option<Quantity>,
    /// The elevation of the viewing direction with a heading, degrees.
    #[serde(default = "level")]
    pub tilt_deg: Quantity,
}

fn level() -> Quantity {
    0.0.into()
}

/// The target of a camera.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(
    untagged,
    expecting = "expected objects, scene, the path of a prim or a point [x, y, z]"
)]
pub enum Target {
    /// `objects`, `scene` or the path of a prim.
    Name(String),
    /// A point in the world, metres.
    Point([f64; 3]),
}

impl Default for Target {
    fn default() -> Self {
        Self::Name("objects".to_owned())
    }
}

use std::collections::BTreeMap;
use std::num::NonZeroU64;

use oaktwin_catalog::Role;
use oaktwin_dataset::SHARD_FRAMES;
use oaktwin_pipeline::render::Transparent;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{Quantity, Texts};

/// The depth sensor.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct SensorRule {
    /// The engine: `stereo-noise`, `stereo-matching`, `time-of-flight` or `single-view`; by default the one for the kind of sensor.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub engine: Option<String>,
    /// The DepthAI preset. Its temporal filter is not allowed, because a frame does not depend on the frames before it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub preset: Option<String>,
    /// Filters, first to last, as in `oaktwin sense --filter`.
    pub filters: Texts,
    /// Parameters of the engine by name: numbers, distributions, names or true and false.
    pub parameters: BTreeMap<String, ParameterValue>,
    /// Whether the extended disparity range is enabled.
    pub extended_disparity: bool,
    /// The camera that measured depth is aligned to, such as `rgb`: the usual RGB-D images of an OAK. Its frames have the depth that the
    /// device's own sensor measures, as the device aligns it. If `camera.cameras` is not given, it is the only camera.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Option<String>", extend("enum" = ["rgb", "left", "right", "tof"]))]
    pub align: Option<Role>,
}

/// The value of a parameter.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(
    untagged,
    expecting = "expected a number, a distribution, a name, true or false"
)]
pub enum ParameterValue {
    /// `true` or `false`.
    Flag(bool),
    /// A name.
    Text(String),
    /// A number or a distribution.
    Number(Quantity),
}

/// The annotations and the formats to write.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct OutputRule {
    /// The annotators, as in `oaktwin render --annotators`.
    pub annotators: Texts,
    /// The formats. With several, each has its own folder.
    pub formats: Texts,
    /// The ground truth of transparent surfaces: `surface`, or `through` for what lies behind the clear ones.
    #[serde(skip_serializing_if = "is_default")]
    #[schemars(with = "String", extend("enum" = ["surface", "through"]))]
    pub transparent: Transparent,
    /// The time between the frames of an arrangement, seconds, in formats with times. By default the times of the trajectory's file, or
    /// 1/30 s if it has none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub interval_s: Option<f64>,
    /// Whether each arrangement is written as a USD scene, `scenes/NUMBER.usda`, with its images.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub scenes: bool,
    /// The number of consecutive frames in a shard of the format `webdataset`.
    pub shard_frames: NonZeroU64,
}

fn is_default(transparent: &Transparent) -> bool {
    *transparent == Transparent::default()
}

impl Default for OutputRule {
    fn default() -> Self {
        Self {
            annotators: Texts(
                [
                    "rgb",
                    "distance_to_image_plane",
                    "depth_sensor_distance",
                    "instance_id_segmentation",
                    "semantic_segmentation",
                    "camera_params",
                ]
                .map(str::to_owned)
                .into(),
            ),
            formats: Texts(vec!["basic".to_owned()]),
            transparent: Transparent::default(),
            interval_s: None,
            scenes: false,
            shard_frames: SHARD_FRAMES,
        }
    }
}

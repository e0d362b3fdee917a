//! Recipes: what a data set contains, as TOML.

mod camera;
mod imu;
mod light;
mod motion;
mod objects;
mod output;
mod page;
mod quantity;
mod read;
mod schema;
mod unit;

use std::path::{Path, PathBuf};

use oaktwin_scene::Up;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

pub use camera::{BoxPlacement, CameraRule, RgbImagerRule, SpherePlacement, Target};
pub use imu::ImuRule;
pub use light::{Lamps, LightRule, Sky, Sun};
pub use motion::MotionRule;
pub use objects::{Appearance, LookRule, ObjectRule, Pose, Region};
pub use output::{OutputRule, ParameterValue, SensorRule};
pub use page::page;
pub use quantity::{Quantity, Texts};
pub use read::RecipeError;
pub use schema::schema;
pub use unit::{DriftRule, PopulationKind, UnitRule};

/// The contents of a data set. Every quantity is a number or a distribution; lengths are in metres and angles in degrees.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Recipe {
    /// The number of frames.
    pub frames: u64,
    /// The number of frames that see the same arrangement of objects, looks and lights from different poses.
    pub frames_per_scene: u64,
    /// The seed of all random numbers.
    pub seed: u64,
    /// The base scenes: files that `oaktwin render` opens, relative to the recipe. Each arrangement uses one of them. Without
    /// a scene, objects are placed on a grey floor.
    pub scene: Texts,
    /// Options for reading scene files.
    pub scene_options: SceneRule,
    /// The objects to place.
    pub objects: Vec<ObjectRule>,
    /// The appearance of parts of the base scene.
    pub looks: Vec<LookRule>,
    /// The lights.
    pub light: LightRule,
    /// The camera and its place.
    pub camera: CameraRule,
    /// The unit: nominal, calibrated, or units of a population.
    pub unit: UnitRule,
    /// The depth sensor.
    pub sensor: SensorRule,
    /// The annotations and the formats to write.
    pub output: OutputRule,
}

impl Default for Recipe {
    fn default() -> Self {
        Self {
            frames: 100,
            frames_per_scene: 1,
            seed: 0,
            scene: Texts::default(),
            scene_options: SceneRule::default(),
            objects: Vec::new(),
            looks: Vec::new(),
            light: LightRule::default(),
            camera: CameraRule::default(),
            unit: UnitRule::default(),
            sensor: SensorRule::default(),
            output: OutputRule::default(),
        }
    }
}

impl Recipe {
    /// Returns the number of the arrangement that a frame sees.
    #[must_use]
    pub fn scene_of(&self, frame: u64) -> u64 {
        frame / self.frames_per_scene
    }
}

/// Options for reading scene files.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct SceneRule {
    /// The up axis of glTF, Collada, OBJ, STL and PLY files.
    #[serde(
        with = "crate::recipe::choice::optional",
        skip_serializing_if = "Option::is_none"
    )]
    #[schemars(with = "Option<String>", extend("enum" = ["z", "y"]))]
    pub up: Option<Up>,
    /// The metres per unit of glTF, Collada, OBJ, STL and PLY files.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub scale: Option<f64>,
    /// The subdivision level of the meshes of USD stages.
    pub subdivide: u32,
    /// Whether surfaces without a texture get the fine one of paint, wood or cloth, by which stereo cameras match them.
    pub micro_texture: bool,
}

impl Default for SceneRule {
    fn default() -> Self {
        Self {
            up: None,
            scale: None,
            subdivide: 0,
            micro_texture: true,
        }
    }
}

/// A recipe with the place that its paths are relative to.
#[derive(Clone, Debug, PartialEq)]
pub struct RecipeFile {
    /// The file.
    pub path: PathBuf,
    /// Its contents.
    pub recipe: Recipe,
}

impl RecipeFile {
    /// Returns a path of the recipe.
    #[must_use]
    pub fn resolve(&self, path: &str) -> PathBuf {
        self.path.parent().unwrap_or(Path::new("")).join(path)
    }
}

/// Serialization of enumerations that are declared with `choice!`.
pub(crate) mod choice {
    use oaktwin_base::diagnostic::suggest;
    use oaktwin_base::parameter::Choice;
    use serde::de::Error;
    use serde::{Deserialize, Deserializer, Serializer};

    pub(crate) fn serialize<C: Choice, S: Serializer>(value: &C, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(value.text())
    }

    pub(crate) fn deserialize<'de, C: Choice, D: Deserializer<'de>>(deserializer: D) -> Result<C, D::Error> {
        let name = String::deserialize(deserializer)?;
        C::find(&name).ok_or_else(|| {
            D::Error::custom(format!(
                "invalid value '{name}'; {}",
                suggest(&name, C::NAMES.iter().copied())
            ))
        })
    }

    pub(crate) mod optional {
        use oaktwin_base::parameter::Choice;
        use serde::{Deserializer, Serializer};

        pub(crate) fn serialize<C: Choice, S: Serializer>(
            value: &Option<C>,
            serializer: S,
        ) -> Result<S::Ok, S::Error> {
            match value {
                Some(value) => super::serialize(value, serializer),
                None => serializer.serialize_none(),
            }
        }

        pub(crate) fn deserialize<'de, C: Choice, D: Deserializer<'de>>(
            deserializer: D,
        ) -> Result<Option<C>, D::Error> {
            super::deserialize(deserializer).map(Some)
        }
    }
}

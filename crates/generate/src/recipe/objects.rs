use oaktwin_base::parameter::choice;
use oaktwin_scene::Up;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{Quantity, Texts};

choice! {
    /// The pose of objects.
    Pose {
        /// On a horizontal surface with their up axis upright, turned by any angle.
        Upright = "upright",
        /// On a horizontal surface on one of the faces on which they are stable, turned by any angle.
        Resting = "resting",
        /// In any orientation, dropped so that they fall onto each other and come to rest: heaps in bins.
        Piled = "piled",
        /// Anywhere in the region, in any orientation.
        Floating = "floating",
    }
}

/// Objects to place, chosen from files and folders.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct ObjectRule {
    /// Files (USD, glTF, Collada, OBJ, STL or PLY) and folders of them, relative to the recipe. Each object is one of these files.
    pub files: Texts,
    /// The label of the objects; by default the name of the file without its extension.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub label: Option<String>,
    /// A factor on the size; 1 for files in metres, 0.001 for files in millimetres that do not state their unit.
    pub scale: Quantity,
    /// The longest edge of each object's box with the axes of its file, metres, instead of the size in the file: for folders of files with
    /// different units. `scale` multiplies it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub size_m: Option<Quantity>,
    /// The up axis of glTF, Collada, OBJ, STL and PLY files.
    #[serde(with = "super::choice::optional", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Option<String>", extend("enum" = ["z", "y"]))]
    pub up: Option<Up>,
    /// The number of objects, rounded to a whole number.
    pub count: Quantity,
    /// Their pose.
    #[serde(with = "super::choice")]
    #[schemars(with = "String", extend("enum" = ["upright", "resting", "piled", "floating"]))]
    pub pose: Pose,
    /// The prims of the base scene on which objects stand, with their descendants; by default every horizontal surface.
    pub on: Texts,
    /// The region of the objects' centres, or for objects that stand or rest, of the points below them; by default the region of the
    /// prims in `on`, or of the base scene.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub region: Option<Region>,
    /// The gap between an object and what it stands on, metres.
    pub gap_m: f64,
    /// The maximum number of attempts to place an object.
    pub attempts: u32,
    /// The appearance; by default the files' own materials.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub look: Option<Appearance>,
}

impl Default for ObjectRule {
    fn default() -> Self {
        Self {
            files: Texts::default(),
            label: None,
            scale: 1.0.into(),
            size_m: None,
            up: None,
            count: 1.0.into(),
            pose: Pose::default(),
            on: Texts::default(),
            region: None,
            gap_m: 0.0002,
            attempts: 200,
            look: None,
        }
    }
}

/// A box with axes of the world, metres.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Region {
    /// The minimum corner.
    pub min: [f64; 3],
    /// The maximum corner.
    pub max: [f64; 3],
}

/// The appearance of prims of the base scene.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct LookRule {
    /// The prims, with their descendants.
    pub prims: Texts,
    /// Their appearance, the same for all of them.
    pub look: Appearance,
}

/// A material that is drawn at random.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Appearance {
    /// The probability that the file's own materials are kept.
    pub keep: f64,
    /// The hue of the colour, degrees.
    pub hue_deg: Quantity,
    /// The saturation of the colour, 0 to 1.
    pub saturation: Quantity,
    /// The largest component of the linear colour, 0 to 1: the albedo of a grey surface.
    pub albedo: Quantity,
    /// The roughness, 0 to 1.
    pub roughness: Quantity,
    /// The metalness, 0 to 1.
    pub metallic: Quantity,
    /// The reflectance at 940 nm, 0 to 1, which the stereo pair, its dots and time of flight see; by default it follows from the colours.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub infrared: Option<Quantity>,
    /// Images and folders of images that colour the surface, multiplied by the colour. Objects without texture coordinates get
    /// the mean of the image.
    pub textures: Texts,
    /// The probability of a texture, if there are any.
    pub textured: f64,
}

impl Default for Appearance {
    fn default() -> Self {
        Self {
            keep: 0.0,
            hue_deg: Quantity::Uniform([0.0, 360.0]),
            saturation: Quantity::Uniform([0.0, 0.7]),
            albedo: Quantity::Uniform([0.1, 0.8]),
            roughness: Quantity::Uniform([0.2, 0.9]),
            metallic: 0.0.into(),
            infrared: None,
            textures: Texts::default(),
            textured: 1.0,
        }
    }
}

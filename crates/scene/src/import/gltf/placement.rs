//! Where a node is, whether it is visible, its instances and skins, from the raw JSON, whose numbers have double precision.

use oaktwin_camera::math::{DAffine3, DMat4, DQuat, DVec3};
use serde_json::{Map, Value, json};

use super::channel::Change;
use super::json::objects;

/// The extensions that hide a node and those below it: the ratified one, and the one that it was first drafted as.
pub(super) const VISIBILITY: [&str; 2] = ["KHR_node_visibility", "KHR_visibility"];

#[derive(Clone)]
pub(super) struct Placement {
    pub(super) parent_from_node: DAffine3,
    /// The weights of the morph targets of its mesh, if it has its own.
    pub(super) weights: Option<Vec<f64>>,
    scale: DVec3,
    rotation: DQuat,
    translation: DVec3,
    /// Whether the node and those below it are shown.
    pub(super) is_visible: bool,
}

impl Placement {
    pub(super) fn of(node: &Value) -> Self {
        let scale = numbers(node, "scale").map_or(DVec3::ONE, DVec3::from_array);
        let rotation = numbers(node, "rotation").map_or(DQuat::IDENTITY, rotation);
        let translation = numbers(node, "translation").map_or(DVec3::ZERO, DVec3::from_array);
        Self {
            parent_from_node: match numbers(node, "matrix") {
                Some(matrix) => DAffine3::from_mat4(DMat4::from_cols_array(&matrix)),
                None => DAffine3::from_scale_rotation_translation(scale, rotation, translation),
            },
            weights: node.get("weights").map(list),
            scale,
            rotation,
            translation,
            is_visible: !VISIBILITY.iter().any(|name| is_hidden(node, name)),
        }
    }
}

impl Placement {
    /// Moves the node to where an animation puts it. The matrix of a node that has one is replaced: the format has no such animations.
    pub(super) fn change(&mut self, change: Change) {
        match change {
            Change::Translation(translation) => self.translation = translation,
            Change::Rotation(rotation) => self.rotation = rotation,
            Change::Scale(scale) => self.scale = scale,
            Change::Weights(weights) => {
                self.weights = Some(weights);
                return;
            }
        }
        self.parent_from_node =
            DAffine3::from_scale_rotation_translation(self.scale, self.rotation, self.translation);
    }
}

/// The numbers of a list.
fn list(list: &Value) -> Vec<f64> {
    let list = list.as_array().map_or(&[][..], |list| list);
    list.iter().map(|number| number.as_f64().unwrap_or(0.0)).collect()
}

fn is_hidden(node: &Value, extension: &str) -> bool {
    let extension = node.get("extensions").and_then(|all| all.get(extension));
    let member = |name: &str| extension.and_then(|extension| extension.get(name)?.as_bool());
    // The second name is that of a draft.
    member("visible") == Some(false) || member("hidden") == Some(true)
}

/// The rotation of a quaternion whose length is only approximately 1; none of one without a direction.
pub(super) fn rotation(quaternion: [f64; 4]) -> DQuat {
    let quaternion = DQuat::from_array(quaternion);
    let length = quaternion.length();
    if length > 0.0 && length.is_finite() {
        quaternion / length
    } else {
        DQuat::IDENTITY
    }
}

fn numbers<const N: usize>(node: &Value, name: &str) -> Option<[f64; N]> {
    let list = node.get(name)?.as_array()?;
    let numbers: Vec<f64> = list.iter().filter_map(Value::as_f64).collect();
    numbers.try_into().ok()
}

/// The extension of nodes that place their mesh many times.
pub(super) const INSTANCING: &str = "EXT_mesh_gpu_instancing";

/// The accessors of the instances' transforms.
pub(super) struct Instancing {
    pub(super) translation: Option<usize>,
    pub(super) rotation: Option<usize>,
    pub(super) scale: Option<usize>,
    /// The attributes that are ignored.
    pub(super) others: Vec<String>,
}

impl Instancing {
    pub(super) fn of(node: &Value) -> Option<Self> {
        let extension = node.get("extensions")?.get(INSTANCING)?;
        let attributes = extension.get("attributes").and_then(Value::as_object);
        let find = |name: &str| usize::try_from(attributes?.get(name)?.as_u64()?).ok();
        let is_other = |name: &&String| !["TRANSLATION", "ROTATION", "SCALE"].contains(&name.as_str());
        let names = attributes.into_iter().flat_map(|attributes| attributes.keys());
        Some(Self {
            translation: find("TRANSLATION"),
            rotation: find("ROTATION"),
            scale: find("SCALE"),
            others: names.filter(is_other).cloned().collect(),
        })
    }
}

/// A skin as the file describes it.
pub(super) struct Skin {
    pub(super) joints: Vec<usize>,
    /// The accessor of the matrices from the mesh to each joint; without it they are the identity.
    pub(super) inverse_bind: Option<usize>,
}

impl Skin {
    /// Takes the skins out of the JSON, because only [`skin`](super::skin) checks them.
    pub(super) fn take_all(root: &mut Value) -> Vec<Self> {
        let index = |value: &Value| value.as_u64().and_then(|index| usize::try_from(index).ok());
        let take = |skin: &mut Map<String, Value>| {
            let joints = skin.get("joints").and_then(Value::as_array);
            let of = Self {
                // An index that is no number is one that does not exist.
                joints: joints
                    .into_iter()
                    .flatten()
                    .map(|joint| index(joint).unwrap_or(usize::MAX))
                    .collect(),
                inverse_bind: skin
                    .get("inverseBindMatrices")
                    .map(|at| index(at).unwrap_or(usize::MAX)),
            };
            *skin = Map::from_iter([("joints".into(), json!([]))]);
            of
        };
        objects(root, "skins").map(take).collect()
    }
}

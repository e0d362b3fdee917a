//! `EXT_mesh_gpu_instancing`: a node that places its mesh many times.

use oaktwin_camera::math::{DAffine3, DQuat, DVec3};
use serde_json::Value;

use super::accessor::Accessor;
use super::document::Document;
use super::placement;

pub(super) const EXTENSION: &str = "EXT_mesh_gpu_instancing";

/// What an instance counts of the numbers that a file may decode to.
const ALLOWANCE: u64 = 300;

/// The accessors of the instances' transforms.
pub(super) struct Instancing {
    translation: Option<usize>,
    rotation: Option<usize>,
    scale: Option<usize>,
    /// The attributes that are ignored.
    pub(super) others: Vec<String>,
}

impl Instancing {
    pub(super) fn of(node: &Value) -> Option<Self> {
        let extension = node.get("extensions")?.get(EXTENSION)?;
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

    /// The transforms from the mesh to the node, one for each instance; one alone if the node has no attributes.
    pub(super) fn node_from_mesh(&self, document: &Document) -> Result<Vec<DAffine3>, String> {
        let find = |index: Option<usize>, components: usize, name: &str| {
            let Some(index) = index else { return Ok(None) };
            let accessor = Accessor::find(document, index)?;
            if accessor.components() == components {
                Ok(Some(accessor))
            } else {
                Err(format!("{EXTENSION}: {name} is not a VEC{components}"))
            }
        };
        let translation = find(self.translation, 3, "TRANSLATION")?;
        let rotation = find(self.rotation, 4, "ROTATION")?;
        let scale = find(self.scale, 3, "SCALE")?;
        let mut counts = [&translation, &rotation, &scale]
            .into_iter()
            .flatten()
            .map(|accessor| accessor.count);
        let count = counts.next().unwrap_or(1);
        if let Some(other) = counts.find(|other| *other != count) {
            return Err(format!(
                "{EXTENSION}: its attributes have {count} and {other} values"
            ));
        }
        document.allow(ALLOWANCE.saturating_mul(count as u64))?;
        let vector = |accessor: &Option<Accessor<'_>>, at: usize, default: DVec3| {
            let Some(accessor) = accessor else { return default };
            DVec3::from(accessor.floats(at).map(f64::from))
        };
        let transform = |at: usize| {
            let turn = rotation.as_ref().map_or(DQuat::IDENTITY, |accessor| {
                placement::rotation(accessor.floats(at).map(f64::from))
            });
            DAffine3::from_scale_rotation_translation(
                vector(&scale, at, DVec3::ONE),
                turn,
                vector(&translation, at, DVec3::ZERO),
            )
        };
        Ok((0..count).map(transform).collect())
    }
}

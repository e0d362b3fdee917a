//! `EXT_mesh_gpu_instancing`: a node that places its mesh many times.

use oaktwin_camera::math::{DAffine3, DQuat, DVec3};

use super::accessor::Accessor;
use super::document::Document;
use super::placement::{self, INSTANCING as EXTENSION, Instancing};

/// What an instance counts of the numbers that a file may decode to.
const ALLOWANCE: u64 = 300;

impl Instancing {
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

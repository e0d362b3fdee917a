use oaktwin_camera::math::{DAffine3, DMat3, DVec3};
use oaktwin_scene::{Instance, Mesh, MeshAttribute};

use super::Builder;

/// The maximum number of triangles of flattened instances that get their own mesh.
const MAX_BAKED_TRIANGLES: usize = 10_000_000;

impl Builder {
    /// Makes every instance's transform invertible: flattened instances get their own mesh in the world frame, and
    /// instances without an area are removed.
    pub(super) fn drop_or_bake(&mut self) {
        let singular = |instance: &Instance| !is_invertible(&instance.world_from_mesh);
        if !self.scene.instances.iter().any(singular) {
            return;
        }
        let mut budget = MAX_BAKED_TRIANGLES;
        for mut instance in std::mem::take(&mut self.scene.instances) {
            if !singular(&instance) {
                self.scene.instances.push(instance);
                continue;
            }
            let place = instance.path.clone();
            if !instance.world_from_mesh.is_finite() {
                let message = "its transform is not finite; it is skipped";
                self.findings
                    .warn("singular-transform", &place, message, "correct its transform");
                continue;
            }
            // An instance flattened to a line or a point is invisible.
            let baked = (!is_thin(&instance.world_from_mesh.matrix3))
                .then(|| self.scene.meshes.get(instance.mesh as usize))
                .flatten()
                .filter(|mesh| mesh.triangles.len() <= budget)
                .map(|mesh| baked(mesh, &instance.world_from_mesh));
            let Some(mesh) = baked else {
                let message = "its transform collapses it to a line or a point; it is skipped";
                self.findings.warn("singular-transform", &place, message, "");
                continue;
            };
            if !mesh.positions.iter().flatten().all(|x| x.is_finite()) {
                let message = "its transform exceeds the range of positions; it is skipped";
                self.findings
                    .warn("singular-transform", &place, message, "correct its transform");
                continue;
            }
            budget -= mesh.triangles.len();
            let Some(index) = self.push_mesh(mesh) else {
                continue;
            };
            instance.mesh = index;
            instance.world_from_mesh = DAffine3::IDENTITY;
            self.scene.instances.push(instance);
            let message = "its transform flattens it to a plane";
            self.findings.warn("singular-transform", &place, message, "");
        }
    }
}

/// Whether a transform has an inverse.
pub(in crate::stage) fn is_invertible(transform: &DAffine3) -> bool {
    let inverse = transform.matrix3.inverse();
    transform.is_finite() && transform.matrix3.determinant() != 0.0 && inverse.is_finite()
}

/// Whether a matrix maps space onto a line or a point.
fn is_thin(matrix: &DMat3) -> bool {
    let DMat3 {
        x_axis,
        y_axis,
        z_axis,
    } = *matrix;
    let area = |a: DVec3, b: DVec3| a.cross(b).length_squared();
    area(x_axis, y_axis) == 0.0 && area(y_axis, z_axis) == 0.0 && area(z_axis, x_axis) == 0.0
}

/// Returns the mesh transformed into the world frame, without normals.
fn baked(mesh: &Mesh, world_from_mesh: &DAffine3) -> Mesh {
    let mut baked = mesh.clone();
    for position in &mut baked.positions {
        let [x, y, z] = position.map(f64::from);
        *position = world_from_mesh
            .transform_point3(DVec3::new(x, y, z))
            .as_vec3()
            .to_array();
    }
    // The transformed normals would be degenerate; the flat ones are correct.
    baked.normals = None::<MeshAttribute<[f32; 3]>>;
    baked
}

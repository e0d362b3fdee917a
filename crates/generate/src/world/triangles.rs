use oaktwin_camera::math::DVec3;
use oaktwin_scene::Scene;

/// The triangles of all instances of a scene, in the axes of the scene.
#[derive(Debug, Default)]
pub(crate) struct Triangles {
    pub(crate) points: Vec<DVec3>,
    pub(crate) corners: Vec<[u32; 3]>,
    /// The index of the first triangle of each instance, and the number of triangles.
    pub(super) first: Vec<u32>,
}

impl Triangles {
    #[expect(clippy::cast_possible_truncation, reason = "a scene's indices are u32")]
    pub(crate) fn of(scene: &Scene) -> Self {
        let mut all = Self::default();
        for instance in &scene.instances {
            all.first.push(all.corners.len() as u32);
            let Some(mesh) = scene.meshes.get(instance.mesh as usize) else {
                continue;
            };
            let start = all.points.len() as u32;
            let place = |p: &[f32; 3]| {
                instance
                    .world_from_mesh
                    .transform_point3(DVec3::from(p.map(f64::from)))
            };
            all.points.extend(mesh.positions.iter().map(place));
            let corners = mesh.triangles.iter();
            all.corners
                .extend(corners.map(|corners| corners.map(|index| start + index)));
        }
        all.first.push(all.corners.len() as u32);
        all
    }

    /// Returns the area of all triangles, m².
    pub(super) fn area(&self) -> f64 {
        let areas = self.corners.iter().map(|corners| {
            let [a, b, c] = corners.map(|index| self.points[index as usize]);
            0.5 * (b - a).cross(c - a).length()
        });
        areas.sum()
    }
}

use oaktwin_camera::math::{DAffine3, DVec3};

use crate::{Instance, Mesh, Scene};

/// An axis-aligned bounding box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// The minimum corner.
    pub min: DVec3,
    /// The maximum corner.
    pub max: DVec3,
}

impl Bounds {
    /// Creates the empty box at a point.
    #[must_use]
    pub const fn of(point: DVec3) -> Self {
        Self {
            min: point,
            max: point,
        }
    }

    /// Returns the smallest box that contains both.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        Self {
            min: self.min.min(other.min),
            max: self.max.max(other.max),
        }
    }

    /// Returns the centre.
    #[must_use]
    pub fn center(self) -> DVec3 {
        0.5 * self.min + 0.5 * self.max
    }

    /// Returns the lengths of the edges.
    #[must_use]
    pub fn size(self) -> DVec3 {
        self.max - self.min
    }

    /// Returns the smallest box in the target frame that contains this one.
    #[must_use]
    pub fn transformed(self, target_from_source: DAffine3) -> Self {
        let corner = |i: u8| {
            let pick = |bit: u8, min: f64, max: f64| if i & bit == 0 { min } else { max };
            Self::of(target_from_source.transform_point3(DVec3::new(
                pick(1, self.min.x, self.max.x),
                pick(2, self.min.y, self.max.y),
                pick(4, self.min.z, self.max.z),
            )))
        };
        (1..8).map(corner).fold(corner(0), Self::union)
    }
}

impl Mesh {
    /// Returns the bounding box of the triangles in the mesh's frame and unit; `None` if there are none.
    #[must_use]
    pub fn bounds(&self) -> Option<Bounds> {
        let mut min = [f32::INFINITY; 3];
        let mut max = [f32::NEG_INFINITY; 3];
        for vertex in self.triangles.iter().flatten() {
            let Some(position) = self.positions.get(*vertex as usize) else {
                continue;
            };
            for axis in 0..3 {
                min[axis] = min[axis].min(position[axis]);
                max[axis] = max[axis].max(position[axis]);
            }
        }
        let point = |p: [f32; 3]| DVec3::from(p.map(f64::from));
        (min[0] <= max[0]).then(|| Bounds {
            min: point(min),
            max: point(max),
        })
    }
}

impl Scene {
    /// Returns a bounding box of all instances in the world, in metres: the union of the transformed boxes of their meshes.
    /// `None` if the scene has no triangles.
    #[must_use]
    pub fn bounds(&self) -> Option<Bounds> {
        let meshes: Vec<Option<Bounds>> = self.meshes.iter().map(Mesh::bounds).collect();
        let of_instance = |instance: &Instance| {
            let bounds = meshes.get(instance.mesh as usize).copied().flatten()?;
            Some(bounds.transformed(instance.world_from_mesh))
        };
        self.instances
            .iter()
            .filter_map(of_instance)
            .reduce(Bounds::union)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape;

    #[test]
    fn bounds_ignore_unused_vertices() {
        let mut mesh = shape::cube(2.0);
        mesh.positions.push([9.0; 3]);
        let bounds = mesh.bounds().unwrap();
        assert_eq!((bounds.min, bounds.max), (DVec3::NEG_ONE, DVec3::ONE));
        assert_eq!(Mesh::default().bounds(), None);
        let at = |world_from_mesh| Instance {
            mesh: 0,
            path: String::new(),
            world_from_mesh,
            labels: Vec::new(),
            material_offset: 0,
        };
        let turned = DAffine3::from_rotation_z(std::f64::consts::FRAC_PI_4);
        let moved = DAffine3::from_translation(DVec3::new(0.0, 0.0, 5.0));
        let scene = Scene {
            meshes: vec![mesh],
            instances: vec![at(turned), at(moved)],
            ..Scene::default()
        };
        let bounds = scene.bounds().unwrap();
        let diagonal = 2.0_f64.sqrt();
        assert!((bounds.max - DVec3::new(diagonal, diagonal, 6.0)).length() < 1e-12);
        assert!((bounds.min - DVec3::new(-diagonal, -diagonal, -1.0)).length() < 1e-12);
        assert_eq!(Scene::default().bounds(), None);
    }
}

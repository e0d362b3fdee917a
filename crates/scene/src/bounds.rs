use oaktwin_camera::math::{DAffine3, DVec3};

use crate::{Instance, Mesh, Scene};

/// A box along the axes of its frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// The corner with the lowest coordinates.
    pub low: DVec3,
    /// The corner with the highest.
    pub high: DVec3,
}

impl Bounds {
    /// The box round a point.
    #[must_use]
    pub const fn of(point: DVec3) -> Self {
        Self {
            low: point,
            high: point,
        }
    }

    /// The smallest box round both.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        Self {
            low: self.low.min(other.low),
            high: self.high.max(other.high),
        }
    }

    /// Its middle.
    #[must_use]
    pub fn center(self) -> DVec3 {
        0.5 * self.low + 0.5 * self.high
    }

    /// Its edges.
    #[must_use]
    pub fn size(self) -> DVec3 {
        self.high - self.low
    }

    /// The smallest box in the target frame round this one.
    #[must_use]
    pub fn transformed(self, target_from_source: DAffine3) -> Self {
        let corner = |i: u8| {
            let pick = |bit: u8, low: f64, high: f64| if i & bit == 0 { low } else { high };
            Self::of(target_from_source.transform_point3(DVec3::new(
                pick(1, self.low.x, self.high.x),
                pick(2, self.low.y, self.high.y),
                pick(4, self.low.z, self.high.z),
            )))
        };
        (1..8).map(corner).fold(corner(0), Self::union)
    }
}

impl Mesh {
    /// The box round its triangles, in its own frame and unit; `None` where it has none.
    #[must_use]
    pub fn bounds(&self) -> Option<Bounds> {
        let mut low = [f32::INFINITY; 3];
        let mut high = [f32::NEG_INFINITY; 3];
        for vertex in self.triangles.iter().flatten() {
            let Some(position) = self.positions.get(*vertex as usize) else {
                continue;
            };
            for axis in 0..3 {
                low[axis] = low[axis].min(position[axis]);
                high[axis] = high[axis].max(position[axis]);
            }
        }
        let point = |p: [f32; 3]| DVec3::from(p.map(f64::from));
        (low[0] <= high[0]).then(|| Bounds {
            low: point(low),
            high: point(high),
        })
    }
}

impl Scene {
    /// A box round all instances, in the world, metres: the smallest round the boxes of their meshes. `None` where
    /// there is nothing to see.
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
    fn bounds_are_of_what_is_seen() {
        let mut mesh = shape::cube(2.0);
        mesh.positions.push([9.0; 3]);
        let bounds = mesh.bounds().unwrap();
        assert_eq!((bounds.low, bounds.high), (DVec3::NEG_ONE, DVec3::ONE));
        assert_eq!(Mesh::default().bounds(), None);
        let at = |world_from_mesh| Instance {
            mesh: 0,
            path: String::new(),
            world_from_mesh,
            labels: Vec::new(),
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
        assert!((bounds.high - DVec3::new(diagonal, diagonal, 6.0)).length() < 1e-12);
        assert!((bounds.low - DVec3::new(-diagonal, -diagonal, -1.0)).length() < 1e-12);
        assert_eq!(Scene::default().bounds(), None);
    }
}

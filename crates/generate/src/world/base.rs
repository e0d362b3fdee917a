use std::path::Path;
use std::sync::Arc;

use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::{DAffine3, DVec3};
use oaktwin_pipeline::render::{OpenOptions, SceneFile};
use oaktwin_scene::{Bounds, Instance, Label, Material, MaterialSpan, Mesh, Scene};
use parry3d_f64::math::Pose;
use parry3d_f64::query::{self, PointQuery, Ray, RayCast, ShapeCastOptions};
use parry3d_f64::shape::{FeatureId, Shape, SharedShape, TriMesh};

use super::asset::give_materials;
use super::hull::{Hull, from_parry, pose_to_parry, to_parry};
use super::triangles::Triangles;
use crate::GenerateError;
use crate::recipe::SceneRule;

/// The back of a triangle.
const BACK: FeatureId = FeatureId::Face(1);

/// A base scene.
#[derive(Debug)]
pub(crate) struct Base {
    /// The path in the recipe; empty for the floor.
    pub(crate) name: String,
    pub(crate) scene: Scene,
    pub(crate) bounds: Bounds,
    /// The triangles of all instances in the world.
    mesh: Arc<TriMesh>,
    /// The index of the first triangle of each instance, and their number.
    first: Vec<u32>,
}

/// A point on the surface of a base scene.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Contact {
    pub(crate) point: DVec3,
    /// The unit normal, towards the ray.
    pub(crate) normal: DVec3,
    pub(crate) instance: u32,
    /// Whether the ray hits the outside of the triangle.
    pub(crate) is_front: bool,
}

impl Base {
    /// Opens a scene file, whose surfaces get other looks if it `has_looks`.
    pub(crate) fn open(
        name: &str,
        path: &Path,
        rule: &SceneRule,
        has_looks: bool,
    ) -> Result<Self, GenerateError> {
        let options = OpenOptions {
            up: rule.up,
            scale: rule.scale,
            subdivide: rule.subdivide,
            texture_coordinates: has_looks,
            ..OpenOptions::default()
        };
        let mut scene = SceneFile::open(path, &options)?.scene;
        if has_looks {
            give_materials(&mut scene);
        }
        Self::new(name, scene).ok_or_else(|| GenerateError::Empty {
            file: path.to_owned(),
        })
    }

    /// Creates a floor of 4 m by 4 m with z up.
    pub(crate) fn floor() -> Option<Self> {
        let scene = Scene {
            meshes: vec![Mesh {
                positions: vec![
                    [-2.0, -2.0, 0.0],
                    [2.0, -2.0, 0.0],
                    [2.0, 2.0, 0.0],
                    [-2.0, 2.0, 0.0],
                ],
                triangles: vec![[0, 1, 2], [0, 2, 3]],
                materials: vec![MaterialSpan {
                    end: 2,
                    material: Some(0),
                }],
                ..Mesh::default()
            }],
            instances: vec![Instance {
                mesh: 0,
                path: "/Floor".to_owned(),
                world_from_mesh: DAffine3::IDENTITY,
                labels: vec![Label {
                    prim: "/Floor".to_owned(),
                    taxonomy: "class".to_owned(),
                    name: "floor".to_owned(),
                }],
                material_offset: 0,
            }],
            materials: vec![Material {
                name: "Floor".to_owned(),
                base_color: Some([0.4; 3]),
                ..Material::default()
            }],
            ..Scene::default()
        };
        Self::new("", scene)
    }

    /// Returns `None` for a scene without triangles.
    fn new(name: &str, scene: Scene) -> Option<Self> {
        let bounds = scene.bounds()?;
        let Triangles {
            points,
            corners,
            first,
        } = Triangles::of(&scene);
        let points = points.into_iter().map(to_parry).collect();
        Some(Self {
            name: name.to_owned(),
            mesh: Arc::new(TriMesh::new(points, corners).ok()?),
            first,
            bounds,
            scene,
        })
    }

    /// Returns the triangles of all instances, in the world.
    pub(crate) fn shape(&self) -> SharedShape {
        SharedShape(Arc::clone(&self.mesh) as _)
    }

    pub(crate) fn up(&self) -> DVec3 {
        self.scene.up.direction()
    }

    /// Finds the first surface on a ray with a unit direction.
    pub(crate) fn cast(&self, origin: DVec3, direction: DVec3, reach: f64) -> Option<Contact> {
        let ray = Ray::new(to_parry(origin), to_parry(direction));
        let hit = self.mesh.cast_local_ray_and_get_normal(&ray, reach, false)?;
        let triangle = hit.subshape as usize;
        let instance = self.first.partition_point(|first| *first as usize <= triangle) - 1;
        Some(Contact {
            point: origin + direction * hit.time_of_impact,
            normal: from_parry(hit.normal),
            instance: u32::try_from(instance).unwrap_or(u32::MAX),
            is_front: hit.feature != BACK,
        })
    }

    /// Whether a hull at a pose intersects a surface.
    pub(crate) fn intersects(&self, hull: &Hull, pose: &RigidTransform) -> bool {
        query::intersection_test(&Pose::identity(), &*self.mesh, &pose_to_parry(pose), &hull.shape)
            .is_ok_and(|found| found.intersecting)
    }

    /// Returns how far a hull can move along a unit direction until it is at a distance of `gap` from a surface.
    pub(crate) fn fall(
        &self,
        hull: &Hull,
        pose: &RigidTransform,
        direction: DVec3,
        reach: f64,
        gap: f64,
    ) -> Option<f64> {
        fall(
            (&Pose::identity(), &*self.mesh),
            hull,
            pose,
            direction,
            reach,
            gap,
        )
    }

    /// Returns the distance of a point from the nearest surface.
    pub(crate) fn distance(&self, point: DVec3) -> f64 {
        self.mesh.distance_to_local_point(to_parry(point), false)
    }

    /// Whether the closed surfaces around a point face away from it: it is inside something.
    pub(crate) fn contains(&self, point: DVec3) -> bool {
        let directions = [
            DVec3::X,
            DVec3::NEG_X,
            DVec3::Y,
            DVec3::NEG_Y,
            DVec3::Z,
            DVec3::NEG_Z,
        ];
        let reach = 2.0 * self.bounds.size().length() + 1.0;
        let faces_away = |direction: &DVec3| {
            let ray = Ray::new(to_parry(point), to_parry(*direction));
            let hit = self.mesh.cast_local_ray_and_get_normal(&ray, reach, false);
            hit.is_some_and(|hit| hit.feature == BACK)
        };
        // Two of six rays may leave through gaps.
        directions
            .iter()
            .filter(|direction| faces_away(direction))
            .count()
            >= 5
    }

    /// Whether an instance is one of some prims or below them; no prims mean all.
    pub(crate) fn is_below(&self, instance: u32, prims: &[String]) -> bool {
        let Some(instance) = self.scene.instances.get(instance as usize) else {
            return false;
        };
        prims.is_empty() || prims.iter().any(|prim| instance.is_below(prim))
    }

    /// Returns the bounding box of some prims with their descendants; `None` if there are none.
    pub(crate) fn bounds_of(&self, prims: &[String]) -> Option<Bounds> {
        if prims.is_empty() {
            return Some(self.bounds);
        }
        let of = |instance: &Instance| {
            let bounds = self.scene.meshes.get(instance.mesh as usize)?.bounds()?;
            Some(bounds.transformed(instance.world_from_mesh))
        };
        let chosen = self.scene.instances.iter();
        let chosen = chosen.filter(|instance| prims.iter().any(|prim| instance.is_below(prim)));
        chosen.filter_map(of).reduce(Bounds::union)
    }
}

/// Returns how far a hull can move along a unit direction until it is at a distance of `gap` from another shape.
pub(crate) fn fall(
    (other_pose, other): (&Pose, &dyn Shape),
    hull: &Hull,
    pose: &RigidTransform,
    direction: DVec3,
    reach: f64,
    gap: f64,
) -> Option<f64> {
    let options = ShapeCastOptions {
        max_time_of_impact: reach,
        target_distance: gap,
        stop_at_penetration: true,
        compute_impact_geometry_on_penetration: false,
    };
    let still = to_parry(DVec3::ZERO);
    let hit = query::cast_shapes(
        &pose_to_parry(pose),
        to_parry(direction),
        &hull.shape,
        other_pose,
        still,
        other,
        options,
    );
    hit.ok().flatten().map(|hit| hit.time_of_impact)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn casts_and_contains() {
        let mut scene = Scene::default();
        for (path, x) in [("/A", 0.0), ("/B/C", 5.0)] {
            scene.meshes.push(oaktwin_scene::shape::cube(2.0));
            scene.instances.push(Instance {
                mesh: if path == "/A" { 0 } else { 1 },
                path: path.to_owned(),
                world_from_mesh: DAffine3::from_translation(DVec3::new(x, 0.0, 0.0)),
                labels: Vec::new(),
                material_offset: 0,
            });
        }
        let base = Base::new("cubes", scene).unwrap();
        let hit = base.cast(DVec3::new(5.2, 0.1, 9.0), DVec3::NEG_Z, 100.0).unwrap();
        assert_eq!((hit.instance, hit.normal), (1, DVec3::Z));
        assert!((hit.point - DVec3::new(5.2, 0.1, 1.0)).length() < 1e-12);
        assert!(base.is_below(1, &["/B".to_owned()]) && !base.is_below(0, &["/B".to_owned()]));
        assert!(base.contains(DVec3::new(0.1, 0.2, 0.3)) && !base.contains(DVec3::new(2.5, 0.2, 0.3)));
        assert!((base.distance(DVec3::new(0.0, 0.0, 3.0)) - 2.0).abs() < 1e-12);
        let bounds = base.bounds_of(&["/B/C".to_owned()]).unwrap();
        assert_eq!(bounds.center(), DVec3::new(5.0, 0.0, 0.0));
        assert!(base.bounds_of(&["/D".to_owned()]).is_none());
    }

    #[test]
    fn hulls_fall_until_they_touch() {
        let base = Base::floor().unwrap();
        let points: Vec<DVec3> = oaktwin_scene::shape::cube(0.2)
            .positions
            .iter()
            .map(|p| DVec3::from(p.map(f64::from)))
            .collect();
        let hull = Hull::new(&points).unwrap();
        let pose = RigidTransform::new(
            crate::random::rotation_around(DVec3::X, 0.3),
            DVec3::new(0.0, 0.0, 1.0),
        );
        let fallen = base.fall(&hull, &pose, DVec3::NEG_Z, 10.0, 1e-3).unwrap();
        let lowest = hull
            .corners()
            .map(|corner| pose.apply(corner).z)
            .fold(f64::INFINITY, f64::min);
        assert!((fallen - (lowest - 1e-3)).abs() < 1e-6, "{fallen} {lowest}");
        assert!(!base.intersects(&hull, &pose));
        let low = RigidTransform::new(pose.rotation, DVec3::new(0.0, 0.0, 0.05));
        assert!(base.intersects(&hull, &low));
    }
}

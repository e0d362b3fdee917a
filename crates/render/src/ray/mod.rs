//! The ray caster, for every lens, shadows and single rays.

#[cfg(test)]
pub(crate) mod brute;
mod bundle;
mod bvh;
mod corners;
mod exact;
mod instances;
mod mesh_tree;
mod render;
mod single;
mod stack;
mod tile;
mod vector;

use std::sync::Arc;

use oaktwin_camera::math::{DAffine3, DVec3};
use oaktwin_image::{Image, ZDepth};
use oaktwin_scene::{Mesh, Scene};
use oaktwin_simd::{Level, run_lanes_at};
use rayon::prelude::*;

use self::bundle::{Bundle, Stopped};
pub(crate) use self::bundle::{RAYS, Rays, bits as ray_bits};
use self::instances::Instances;
use self::mesh_tree::MeshTree;
use self::single::{Cast, Until};
use self::stack::Leaf;
pub(crate) use self::stack::Stack;
use self::tile::RayTables;
pub(crate) use self::tile::{RayTable, ray_through};
pub(crate) use self::vector::Vector;
use crate::blocks::Blocks;
use crate::cutout::{Cutouts, Transparent};
use crate::visibility::SpareVisibility;
use crate::{Hit, View, Visibility};

/// A segment of a ray in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// The origin, metres.
    pub origin: DVec3,
    /// The direction, which need not be normalized; distances along the ray are in lengths of it.
    pub direction: DVec3,
    /// The start of the segment.
    pub near: f64,
    /// The end of the segment, which may be infinite.
    pub far: f64,
}

/// The hierarchies of a scene.
#[derive(Debug)]
pub(crate) struct RayCaster {
    trees: Vec<MeshTree>,
    instances: Instances,
    level: Level,
    tables: RayTables,
    cutouts: Option<Cutouts>,
    pub(crate) spare: SpareVisibility,
}

/// A scene with its hierarchies.
#[derive(Clone, Copy)]
pub(crate) struct Prepared<'a> {
    scene: &'a Scene,
    trees: &'a [MeshTree],
    instances: &'a Instances,
}

impl<'a> Prepared<'a> {
    /// Returns the mesh of an instance, its tree and its inverse transform.
    #[inline]
    fn instance(&self, instance: u32) -> Option<(&'a Mesh, &'a MeshTree, DAffine3)> {
        let index = instance as usize;
        let mesh = self.scene.instances.get(index)?.mesh as usize;
        Some((
            self.scene.meshes.get(mesh)?,
            self.trees.get(mesh)?,
            *self.instances.mesh_from_world.get(index)?,
        ))
    }
}

impl Prepared<'_> {
    /// Returns the triangle at an index in the tree of an instance's mesh.
    #[inline]
    fn hit(&self, instance: u32, slot: u32) -> Hit {
        let found = self
            .instance(instance)
            .and_then(|(_, tree, _)| tree.triangles.get(slot as usize));
        found.map_or(Hit::MISS, |triangle| Hit {
            instance,
            triangle: triangle[3],
        })
    }
}

impl RayCaster {
    pub(crate) fn new(scene: &Scene) -> Self {
        let trees: Vec<MeshTree> = scene.meshes.par_iter().map(MeshTree::new).collect();
        let instances = Instances::new(scene, &trees);
        Self {
            trees,
            instances,
            level: Level::detect(),
            tables: RayTables::default(),
            cutouts: Cutouts::new(scene, None),
            spare: SpareVisibility::default(),
        }
    }

    /// Builds the hierarchies of meshes that were added to the scene.
    pub(crate) fn add_meshes(&mut self, scene: &Scene) {
        let added = &scene.meshes[self.trees.len()..];
        self.trees.par_extend(added.par_iter().map(MeshTree::new));
    }

    /// Places the instances of a scene with the same meshes.
    pub(crate) fn place(&mut self, scene: &Scene) {
        self.instances = Instances::new(scene, &self.trees);
        self.cutouts = Cutouts::new(scene, self.cutouts.take());
    }

    fn prepared<'a>(&'a self, scene: &'a Scene) -> Prepared<'a> {
        Prepared {
            scene,
            trees: &self.trees,
            instances: &self.instances,
        }
    }

    pub(crate) fn depth(&self, scene: &Scene, view: &View) -> ZDepth {
        let size = view.camera.intrinsics.size;
        let mut z = Image::filled(size.width, size.height, f32::INFINITY);
        self.render(scene, view, None, &mut z, None);
        ZDepth(z)
    }

    pub(crate) fn visibility(&self, scene: &Scene, view: &View) -> Visibility {
        self.visible(scene, view, None)
    }

    /// Renders [`visibility`](Self::visibility) in some blocks; pixels elsewhere are misses.
    pub(crate) fn visibility_in(&self, blocks: &Blocks, scene: &Scene, view: &View) -> Visibility {
        self.visible(scene, view, Some(blocks))
    }

    fn visible(&self, scene: &Scene, view: &View, rendered: Option<&Blocks>) -> Visibility {
        let size = view.camera.intrinsics.size;
        let mut z = self.spare.z.image(size.width, size.height, f32::INFINITY);
        let mut hits = self.spare.hits.image(size.width, size.height, Hit::MISS);
        self.render(scene, view, rendered, &mut z, Some(&mut hits));
        Visibility { z: ZDepth(z), hits }
    }

    /// Returns the masks of the surfaces that are not solid everywhere.
    pub(crate) fn cutouts(&self) -> Option<&Cutouts> {
        self.cutouts.as_ref()
    }

    /// Returns the rays of a view.
    pub(crate) fn table(&self, view: &View) -> Arc<RayTable> {
        self.tables.get(&view.camera, view.clips_along_axis())
    }

    /// Returns the nearest triangle on the ray, both ends included, and its distance in lengths of `direction`; of equally near
    /// ones the first in the scene.
    pub(crate) fn cast(&self, scene: &Scene, ray: Ray, stack: &mut Stack) -> Option<(f64, Hit)> {
        self.search(scene, ray, Until::Nearest, Transparent::Surface, stack)
    }

    /// Returns the nearest triangle on the ray, as [`cast`](Self::cast) does, that is not clear.
    pub(crate) fn cast_through(&self, scene: &Scene, ray: Ray, stack: &mut Stack) -> Option<(f64, Hit)> {
        self.search(scene, ray, Until::Nearest, Transparent::Through, stack)
    }

    /// Returns the distance to the nearest triangle on the ray that is not clear, or `reach` if it is farther away. Rays of a kind, which
    /// is a number, are often stopped at the same place; the result does not depend on it.
    pub(crate) fn distance_within(
        &self,
        scene: &Scene,
        ray: Ray,
        reach: f64,
        kind: usize,
        stack: &mut Stack,
    ) -> Option<f64> {
        let until = Until::NearestWithin(reach);
        let found = self.search_of_kind(scene, ray, until, Transparent::Through, kind, stack);
        found.map(|(t, _)| t)
    }

    /// Whether anything lies on the ray between its ends.
    pub(crate) fn is_occluded(&self, scene: &Scene, ray: Ray, stack: &mut Stack) -> bool {
        self.search(scene, ray, Until::Any, Transparent::Surface, stack)
            .is_some()
    }

    /// Whether anything that is not clear lies on the ray between its ends: whether light is blocked. Kinds of rays are as in
    /// [`distance_within`](Self::distance_within).
    pub(crate) fn is_shadowed(&self, scene: &Scene, ray: Ray, kind: usize, stack: &mut Stack) -> bool {
        self.search_of_kind(scene, ray, Until::Any, Transparent::Through, kind, stack)
            .is_some()
    }

    /// Returns the bits of the rays from a point that anything stops that is not clear, before `far` lengths of their directions.
    pub(crate) fn shadowed(&self, scene: &Scene, rays: &Rays, kind: usize, stack: &mut Stack) -> u64 {
        let (entries, leaf) = stack.of_kind(kind);
        let kernel = Bundle {
            scene: &self.prepared(scene),
            cutouts: self.cutouts.as_ref(),
            rays,
            stack: entries,
            leaf,
        };
        let Stopped { certain, unclear } = run_lanes_at(self.level, kernel);
        let alone = ray_bits(unclear).filter(|ray| self.is_shadowed(scene, rays.ray(*ray), kind, stack));
        alone.fold(certain, |stopped, ray| stopped | 1 << ray)
    }

    fn search(
        &self,
        scene: &Scene,
        ray: Ray,
        until: Until,
        transparent: Transparent,
        stack: &mut Stack,
    ) -> Option<(f64, Hit)> {
        let kernel = Cast {
            scene: &self.prepared(scene),
            cutouts: self.cutouts.as_ref(),
            ray,
            until,
            transparent,
            stack: &mut stack.entries,
            leaf: &mut { Leaf::NONE },
        };
        run_lanes_at(self.level, kernel)
    }

    fn search_of_kind(
        &self,
        scene: &Scene,
        ray: Ray,
        until: Until,
        transparent: Transparent,
        kind: usize,
        stack: &mut Stack,
    ) -> Option<(f64, Hit)> {
        let (entries, leaf) = stack.of_kind(kind);
        let kernel = Cast {
            scene: &self.prepared(scene),
            cutouts: self.cutouts.as_ref(),
            ray,
            until,
            transparent,
            stack: entries,
            leaf,
        };
        run_lanes_at(self.level, kernel)
    }

    /// [`cast`](Self::cast) for each ray, in parallel.
    pub(crate) fn cast_all(&self, scene: &Scene, rays: &[Ray]) -> Vec<Option<(f64, Hit)>> {
        rays.par_iter()
            .with_min_len(256)
            .map_init(Stack::default, |stack, ray| self.cast(scene, *ray, stack))
            .collect()
    }

    /// [`is_occluded`](Self::is_occluded) for each ray, in parallel.
    pub(crate) fn are_occluded(&self, scene: &Scene, rays: &[Ray]) -> Vec<bool> {
        rays.par_iter()
            .with_min_len(256)
            .map_init(Stack::default, |stack, ray| self.is_occluded(scene, *ray, stack))
            .collect()
    }
}

#[cfg(test)]
mod tests;

//! Distances in double precision for hits that were found in single precision.

use oaktwin_camera::math::{DMat3, DVec3};
use oaktwin_simd::{F64Lanes, LaneKernel, Lanes};

use super::rays::{PACKETS, PerRay};
use super::state::TileHits;
use crate::ray::Prepared;
use crate::ray::corners::corners;
use crate::ray::mesh_tree::MeshTree;

/// Intersects rays with the planes of the triangles that they hit.
pub(crate) struct Solve<'a> {
    pub(crate) scene: &'a Prepared<'a>,
    /// The origin of the rays in the world.
    pub(crate) origin: DVec3,
    pub(crate) world_from_camera: DMat3,
    pub(crate) seen: &'a TileHits,
    /// The directions in the camera frame.
    pub(crate) directions: &'a PerRay<DVec3>,
    /// The output: the distance of each ray with a hit, in lengths of its direction.
    pub(crate) distances: &'a mut PerRay<f64>,
}

/// The origin and the axes of the rays in the frame of an instance's mesh.
struct LocalRays<'a> {
    positions: &'a [[f32; 3]],
    tree: &'a MeshTree,
    origin: DVec3,
    mesh_from_camera: DMat3,
}

impl LaneKernel for Solve<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self) {
        let mut known: Option<(u32, LocalRays)> = None;
        for packet in 0..PACKETS {
            let instances = &self.seen.instance[packet];
            let mut left = 0u32;
            for (lane, instance) in instances.iter().enumerate() {
                left |= u32::from(*instance != u32::MAX) << lane;
            }
            while left != 0 {
                let instance = instances[left.trailing_zeros() as usize & 7];
                if known.as_ref().is_none_or(|(of, _)| *of != instance) {
                    known = self.place(instance).map(|place| (instance, place));
                }
                let mut lanes = 0;
                for (lane, of) in instances.iter().enumerate() {
                    lanes |= u32::from(*of == instance) << lane;
                }
                left &= !lanes;
                let Some((_, place)) = &known else { continue };
                let mut distances = [0.0; 8];
                self.packet::<L>(place, packet, lanes).store(&mut distances);
                for (lane, distance) in distances.into_iter().enumerate() {
                    if lanes >> lane & 1 == 1 {
                        self.distances[packet][lane] = distance;
                    }
                }
            }
        }
    }
}

impl<'a> Solve<'a> {
    fn place(&self, instance: u32) -> Option<LocalRays<'a>> {
        let (mesh, tree, mesh_from_world) = self.scene.instance(instance)?;
        Some(LocalRays {
            positions: &mesh.positions,
            tree,
            origin: mesh_from_world.transform_point3(self.origin),
            mesh_from_camera: mesh_from_world.matrix3 * self.world_from_camera,
        })
    }

    /// Solves a packet's rays that hit an instance; `lanes` is not empty.
    #[inline(always)]
    fn packet<L: Lanes>(&self, place: &LocalRays, packet: usize, lanes: u32) -> L::F64 {
        let slots = &self.seen.triangle[packet];
        // Other lanes repeat a triangle.
        let first = slots[lanes.trailing_zeros() as usize & 7];
        let mut triangles = [[0; 4]; 8];
        for (lane, triangle) in triangles.iter_mut().enumerate() {
            let slot = if lanes >> lane & 1 == 1 {
                slots[lane]
            } else {
                first
            };
            *triangle = place.tree.triangles[slot as usize];
        }
        let [a, b, c] = corners::<L>(place.positions, &triangles);
        // Differences and products of single-precision numbers are almost exact here.
        let (ax, ay, az) = (a.x.widen(), a.y.widen(), a.z.widen());
        let (bx, by, bz) = (b.x.widen() - ax, b.y.widen() - ay, b.z.widen() - az);
        let (cx, cy, cz) = (c.x.widen() - ax, c.y.widen() - ay, c.z.widen() - az);
        let nx = by * cz - bz * cy;
        let ny = bz * cx - bx * cz;
        let nz = bx * cy - by * cx;
        let o = place.origin;
        let height =
            (ax - L::F64::splat(o.x)) * nx + (ay - L::F64::splat(o.y)) * ny + (az - L::F64::splat(o.z)) * nz;
        let mut direction = [[0.0; 8]; 3];
        for (lane, d) in self.directions[packet].iter().enumerate() {
            direction[0][lane] = d.x;
            direction[1][lane] = d.y;
            direction[2][lane] = d.z;
        }
        let m = place.mesh_from_camera;
        let (dx, dy, dz) = (
            L::F64::load(&direction[0]),
            L::F64::load(&direction[1]),
            L::F64::load(&direction[2]),
        );
        let fall =
            nx * row(m.row(0), dx, dy, dz) + ny * row(m.row(1), dx, dy, dz) + nz * row(m.row(2), dx, dy, dz);
        height / fall
    }
}

#[inline(always)]
fn row<D: F64Lanes>(row: DVec3, x: D, y: D, z: D) -> D {
    D::splat(row.x) * x + D::splat(row.y) * y + D::splat(row.z) * z
}

use oaktwin_simd::{I32Lanes, Lanes};

use super::rays::{PACKETS, PerRay, TileRays};
use super::triangles::Triangles;
use crate::Clip;
use crate::ray::mesh_tree::MeshTree;
use crate::ray::vector::Vector;

/// The nearest hits of a tile's rays.
#[derive(Clone, Debug)]
pub(crate) struct TileHits {
    /// Scaled 1/z in the tile frame; for a miss, at the far end.
    pub(crate) inverse_z: PerRay<f32>,
    /// `u32::MAX` for a miss.
    pub(crate) instance: PerRay<u32>,
    /// The index in the triangles of the mesh's tree.
    pub(crate) triangle: PerRay<u32>,
}

/// The triangles of a leaf.
pub(super) struct Leaf<'a> {
    pub(super) instance: u32,
    /// The index of the first one in the tree.
    pub(super) first: u32,
    pub(super) triangles: &'a [[u32; 4]],
    pub(super) tree: &'a MeshTree,
}

/// The state of a tile's rays.
pub(crate) struct TileState {
    pub(crate) seen: TileHits,
    /// 1/z of the near end.
    nearest: PerRay<f32>,
    /// The minimum 1/z in each packet, and of all.
    packet_min: [f32; 8],
    pub(super) min_inverse_z: f32,
    /// The maximum z that can still be nearest.
    pub(super) farthest: f32,
}

impl TileState {
    pub(crate) const NONE: Self = Self {
        seen: TileHits {
            inverse_z: [[0.0; 8]; PACKETS],
            instance: [[u32::MAX; 8]; PACKETS],
            triangle: [[u32::MAX; 8]; PACKETS],
        },
        nearest: [[0.0; 8]; PACKETS],
        packet_min: [0.0; 8],
        min_inverse_z: 0.0,
        farthest: 0.0,
    };

    /// Resets all rays to misses.
    #[inline(always)]
    #[allow(
        clippy::cast_possible_truncation,
        reason = "ends are tested again in double precision"
    )]
    pub(super) fn reset<L: Lanes>(&mut self, rays: &TileRays, clip: Clip, scale: f64) {
        let near = L::splat((1.0 / (clip.near_m * scale) * (1.0 + 1e-5)) as f32);
        let far = L::splat((1.0 / (clip.far_m * scale) * (1.0 - 1e-5)) as f32);
        self.seen.instance = [[u32::MAX; 8]; PACKETS];
        self.seen.triangle = [[u32::MAX; 8]; PACKETS];
        for packet in 0..PACKETS {
            let z_per_length = L::load(&rays.z_per_length[packet]);
            let is_there = L::splat(0.0).lt(z_per_length);
            // Where there is no ray, no surface is near enough.
            let min_inverse_z = L::select(is_there, far / z_per_length, L::splat(f32::INFINITY));
            let nearest = L::select(is_there, near / z_per_length, L::splat(-1.0));
            min_inverse_z.store(&mut self.seen.inverse_z[packet]);
            nearest.store(&mut self.nearest[packet]);
            self.packet_min[packet] = min_inverse_z.reduce_min();
        }
        self.update_min();
    }

    fn update_min(&mut self) {
        self.min_inverse_z = self.packet_min.into_iter().fold(f32::INFINITY, f32::min);
        self.farthest = 1.0 / self.min_inverse_z * (1.0 + 1e-6);
    }

    /// Tests the triangles of a leaf against the packets that they may touch.
    #[inline(always)]
    pub(super) fn test<L: Lanes>(&mut self, rays: &TileRays, ready: &Triangles, leaf: &Leaf) {
        let mut triangles = ready.seen & ((1 << leaf.triangles.len()) - 1);
        let mut is_nearer = false;
        while triangles != 0 {
            let slot = leaf.first + triangles.trailing_zeros();
            let index = triangles.trailing_zeros() as usize & 7;
            triangles &= triangles - 1;
            let max_inverse_z = L::splat(ready.max_inverse_z[index]);
            let touched = L::load(&rays.packets.u[0]).le(L::splat(ready.u[1][index]))
                & L::splat(ready.u[0][index]).le(L::load(&rays.packets.u[1]))
                & L::load(&rays.packets.v[0]).le(L::splat(ready.v[1][index]))
                & L::splat(ready.v[0][index]).le(L::load(&rays.packets.v[1]))
                & L::load(&self.packet_min).le(max_inverse_z);
            let mut packets = touched.signs();
            if packets == 0 {
                continue;
            }
            let ab = Vector::<L>::splat_lane(&ready.sides[0], index);
            let bc = Vector::<L>::splat_lane(&ready.sides[1], index);
            let ca = Vector::<L>::splat_lane(&ready.sides[2], index);
            let plane = Vector::<L>::splat_lane(&ready.plane, index);
            let min_inverse_z = L::splat(ready.min_inverse_z[index]);
            while packets != 0 {
                let packet = packets.trailing_zeros() as usize & 7;
                packets &= packets - 1;
                let (u, v) = (L::load(&rays.u[packet]), L::load(&rays.v[packet]));
                let inside = at(ab, u, v).min(at(bc, u, v)).min(at(ca, u, v));
                let w = at(plane, u, v).max(min_inverse_z).min(max_inverse_z);
                let best = L::load(&self.seen.inverse_z[packet]);
                let mut met = L::splat(0.0).le(inside) & best.le(w) & w.le(L::load(&self.nearest[packet]));
                let met_bits = met.signs();
                if met_bits == 0 {
                    continue;
                }
                is_nearer = true;
                let equal = met_bits & w.le(best).signs();
                if equal != 0 {
                    met = L::I32::load(&self.first_of_equals(met_bits, equal, packet, index, leaf));
                }
                let nearer = L::select(met, w, best);
                nearer.store(&mut self.seen.inverse_z[packet]);
                replace::<L::I32>(met, leaf.instance, &mut self.seen.instance[packet]);
                replace::<L::I32>(met, slot, &mut self.seen.triangle[packet]);
                self.packet_min[packet] = nearer.reduce_min();
            }
        }
        if is_nearer {
            self.update_min();
        }
    }

    /// Returns the mask of `met` without the lanes of `equal` that have hit an earlier instance or triangle at the same depth.
    #[cold]
    fn first_of_equals(&self, met: u32, equal: u32, packet: usize, index: usize, leaf: &Leaf) -> [i32; 8] {
        std::array::from_fn(|lane| {
            let known = self.seen.instance[packet][lane];
            let is_later = || {
                let slot = self.seen.triangle[packet][lane] as usize;
                known < leaf.instance
                    || (known == leaf.instance && leaf.tree.triangles[slot][3] < leaf.triangles[index][3])
            };
            let is_met = met >> lane & 1 == 1 && !(equal >> lane & 1 == 1 && is_later());
            -i32::from(is_met)
        })
    }
}

/// Stores a number where the mask is set.
#[inline(always)]
fn replace<I: I32Lanes>(mask: I, number: u32, numbers: &mut [u32; 8]) {
    I::select(mask, I::splat(number.cast_signed()), I::load_unsigned(numbers)).store_unsigned(numbers);
}

/// `(u, v, 1) · n`.
#[inline(always)]
fn at<L: Lanes>(n: Vector<L>, u: L, v: L) -> L {
    n.x * u + n.y * v + n.z
}

use super::frame::Extent;
use super::rays::{PACKETS, PerRay, TileRays};
use super::triangles::Triangles;
use crate::Clip;
use crate::ray::mesh_tree::MeshTree;
use crate::ray::simd::Lanes;
use crate::ray::vector::Vector;

/// What the rays of a tile see.
#[derive(Clone, Debug)]
pub(crate) struct Seen {
    /// 1/z in the tile's frame, scaled; where nothing is seen, of the far end.
    pub(crate) inverse_z: PerRay<f32>,
    /// `u32::MAX` where nothing is seen.
    pub(crate) instance: PerRay<u32>,
    /// Into the triangles of the mesh's tree.
    pub(crate) triangle: PerRay<u32>,
}

/// The triangles of a leaf.
pub(super) struct Leaf<'a> {
    pub(super) instance: u32,
    /// Where they stand in the tree.
    pub(super) first: u32,
    pub(super) triangles: &'a [[u32; 4]],
    pub(super) tree: &'a MeshTree,
}

/// What is known of a tile's rays so far.
pub(super) struct State {
    pub(super) seen: Seen,
    /// The greatest 1/z that is not before the near end.
    nearest: PerRay<f32>,
    /// Where each packet's rays are on the plane z = 1.
    u: [[f32; 8]; 2],
    v: [[f32; 8]; 2],
    /// The least 1/z in each packet, and of all.
    packet_least: [f32; 8],
    pub(super) least: f32,
    /// The greatest z that matters.
    pub(super) farthest: f32,
    pub(super) extent: Extent,
}

impl State {
    #[allow(
        clippy::cast_possible_truncation,
        reason = "ends are looked at again in double precision"
    )]
    pub(super) fn new(rays: &TileRays, clip: Clip, scale: f64) -> Self {
        let mut state = Self {
            seen: Seen {
                inverse_z: [[f32::INFINITY; 8]; PACKETS],
                instance: [[u32::MAX; 8]; PACKETS],
                triangle: [[u32::MAX; 8]; PACKETS],
            },
            nearest: [[-1.0; 8]; PACKETS],
            u: [[f32::INFINITY; 8], [f32::NEG_INFINITY; 8]],
            v: [[f32::INFINITY; 8], [f32::NEG_INFINITY; 8]],
            packet_least: [f32::INFINITY; 8],
            least: 0.0,
            farthest: 0.0,
            extent: Extent {
                u: [f32::INFINITY, f32::NEG_INFINITY],
                v: [f32::INFINITY, f32::NEG_INFINITY],
            },
        };
        let [near, far] = [clip.near_m, clip.far_m].map(|end| 1.0 / (end * scale));
        for packet in 0..PACKETS {
            for lane in 0..8 {
                if rays.present[packet] >> lane & 1 == 0 {
                    continue;
                }
                let per_length = 1.0 / f64::from(rays.z_per_length[packet][lane]);
                state.nearest[packet][lane] = ((near * per_length) * (1.0 + 1e-5)) as f32;
                state.seen.inverse_z[packet][lane] = ((far * per_length) * (1.0 - 1e-5)) as f32;
                for (range, at) in [
                    (&mut state.u, rays.u[packet][lane]),
                    (&mut state.v, rays.v[packet][lane]),
                ] {
                    range[0][packet] = range[0][packet].min(at);
                    range[1][packet] = range[1][packet].max(at);
                }
            }
            state.packet_least[packet] = smallest(&state.seen.inverse_z[packet]);
        }
        // A little more than the rays, so that rounding at a triangle's side does not hide it from a ray.
        for (packets, all) in [
            (&mut state.u, &mut state.extent.u),
            (&mut state.v, &mut state.extent.v),
        ] {
            let low = smallest(&packets[0]);
            let high = packets[1].iter().copied().fold(f32::NEG_INFINITY, f32::max);
            let slack = (high - low) / 256.0 + 2e-6 * (1.0 + low.abs().max(high.abs()));
            *all = [low - slack, high + slack];
            packets[0] = packets[0].map(|x| x - slack);
            packets[1] = packets[1].map(|x| x + slack);
        }
        state.update_least();
        state
    }

    fn update_least(&mut self) {
        self.least = smallest(&self.packet_least);
        self.farthest = 1.0 / self.least * (1.0 + 1e-6);
    }

    /// Tests the triangles of a leaf against the packets that they may touch.
    #[inline(always)]
    pub(super) fn test<L: Lanes>(&mut self, rays: &TileRays, ready: &Triangles, leaf: &Leaf) {
        let mut triangles = ready.seen & ((1 << leaf.triangles.len()) - 1);
        let mut is_nearer = false;
        while triangles != 0 {
            let index = triangles.trailing_zeros() as usize & 7;
            triangles &= triangles - 1;
            let greatest = L::splat(ready.greatest[index]);
            let touched = L::load(&self.u[0])
                .le(L::splat(ready.u[1][index]))
                .and(L::splat(ready.u[0][index]).le(L::load(&self.u[1])))
                .and(L::load(&self.v[0]).le(L::splat(ready.v[1][index])))
                .and(L::splat(ready.v[0][index]).le(L::load(&self.v[1])))
                .and(L::load(&self.packet_least).le(greatest));
            let mut packets = touched.signs();
            if packets == 0 {
                continue;
            }
            let ab = Vector::<L>::splat_lane(&ready.sides[0], index);
            let bc = Vector::<L>::splat_lane(&ready.sides[1], index);
            let ca = Vector::<L>::splat_lane(&ready.sides[2], index);
            let plane = Vector::<L>::splat_lane(&ready.plane, index);
            let least = L::splat(ready.least[index]);
            while packets != 0 {
                let packet = packets.trailing_zeros() as usize & 7;
                packets &= packets - 1;
                let (u, v) = (L::load(&rays.u[packet]), L::load(&rays.v[packet]));
                let inside = at(ab, u, v).min(at(bc, u, v)).min(at(ca, u, v));
                let w = at(plane, u, v).max(least).min(greatest);
                let best = L::load(&self.seen.inverse_z[packet]);
                let mut met = L::splat(0.0)
                    .le(inside)
                    .and(best.le(w))
                    .and(w.le(L::load(&self.nearest[packet])));
                let met_bits = met.signs();
                if met_bits == 0 {
                    continue;
                }
                is_nearer = true;
                let equal = met_bits & w.le(best).signs();
                if equal != 0 {
                    met = L::load_bits(&self.first_of_equals(met_bits, equal, packet, index, leaf));
                }
                let nearer = met.select(w, best);
                nearer.store(&mut self.seen.inverse_z[packet]);
                replace(met, leaf.instance, &mut self.seen.instance[packet]);
                replace(met, leaf.first + index as u32, &mut self.seen.triangle[packet]);
                self.packet_least[packet] = nearer.least();
            }
        }
        if is_nearer {
            self.update_least();
        }
    }

    /// `met` as lanes, without those of `equal` that saw an earlier instance or triangle equally near.
    #[cold]
    fn first_of_equals(&self, met: u32, equal: u32, packet: usize, index: usize, leaf: &Leaf) -> [u32; 8] {
        std::array::from_fn(|lane| {
            let known = self.seen.instance[packet][lane];
            let is_later = || {
                let slot = self.seen.triangle[packet][lane] as usize;
                known < leaf.instance
                    || (known == leaf.instance && leaf.tree.triangles[slot][3] < leaf.triangles[index][3])
            };
            let is_met = met >> lane & 1 == 1 && !(equal >> lane & 1 == 1 && is_later());
            if is_met { u32::MAX } else { 0 }
        })
    }
}

/// Puts a number where the lane is all ones.
#[inline(always)]
fn replace<L: Lanes>(place: L, number: u32, numbers: &mut [u32; 8]) {
    place
        .select(L::splat(f32::from_bits(number)), L::load_bits(numbers))
        .store_bits(numbers);
}

/// `(u, v, 1) · n`.
#[inline(always)]
fn at<L: Lanes>(n: Vector<L>, u: L, v: L) -> L {
    n.x.mul(u).add(n.y.mul(v)).add(n.z)
}

fn smallest(values: &[f32; 8]) -> f32 {
    values.iter().copied().fold(f32::INFINITY, f32::min)
}

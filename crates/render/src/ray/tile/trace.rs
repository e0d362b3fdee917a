use oaktwin_camera::math::{DAffine3, DMat3, DVec3};

use super::frame::{Extent, Frame};
use super::rays::{PACKETS, PerRay, TileRays};
use super::triangles::Triangles;
use crate::Clip;
use crate::ray::Prepared;
use crate::ray::bvh::Node;
use crate::ray::corners::corners;
use crate::ray::simd::{Kernel, Lanes};
use crate::ray::stack::{Entry, Stack, push_children};

/// Where all rays start.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Origin {
    /// In the world.
    pub(crate) point: DVec3,
    pub(crate) camera_from_world: DMat3,
    /// A power of two that lengths in the tile's frame are multiplied with, so that they are neither tiny nor huge.
    pub(crate) scale: f64,
}

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

/// The rays of one tile through the whole scene.
pub(crate) struct Trace<'a> {
    pub(crate) scene: &'a Prepared<'a>,
    pub(crate) origin: &'a Origin,
    pub(crate) rays: &'a TileRays,
    pub(crate) clip: Clip,
    pub(crate) stack: &'a mut Stack,
}

impl Kernel for Trace<'_> {
    type Output = Seen;

    #[inline(always)]
    fn run<L: Lanes>(self) -> Seen {
        let Self {
            scene,
            origin,
            rays,
            clip,
            stack,
        } = self;
        let mut state = State::new(rays, clip, origin.scale);
        if rays.present == [0; PACKETS] {
            return state.seen;
        }
        let top = scene.instances;
        let tile_from_world = rays.tile_from_camera * origin.camera_from_world * origin.scale;
        let world = Frame::new(
            &tile_from_world,
            origin.point,
            &DAffine3::IDENTITY,
            &top.bounds,
            &state.extent,
        );
        let Some(world) = world else { return state.seen };
        stack.clear();
        walk::<L>(
            &top.nodes,
            &world,
            &mut state,
            stack,
            &mut |first, count, state, stack| {
                for &instance in &top.order[first as usize..][..count as usize] {
                    let Some((mesh, tree, mesh_from_world)) = scene.instance(instance) else {
                        continue;
                    };
                    let frame = Frame::new(
                        &tile_from_world,
                        mesh_from_world.transform_point3(origin.point),
                        &scene.scene.instances[instance as usize].world_from_mesh,
                        &tree.bounds,
                        &state.extent,
                    );
                    let Some(frame) = frame else { continue };
                    walk::<L>(
                        &tree.nodes,
                        &frame,
                        state,
                        stack,
                        &mut |first, count, state, _| {
                            let triangles = &tree.triangles[first as usize..][..count as usize];
                            let corners = corners::<L>(&mesh.positions, triangles);
                            let ready = Triangles::new(corners, &frame, &state.extent, state.least);
                            state.test::<L>(rays, &ready, (1 << count) - 1, (instance, first), |slot| {
                                tree.triangles[slot as usize][3]
                            });
                        },
                    );
                }
            },
        );
        state.seen
    }
}

/// Calls `leaf` with the items of each leaf that the tile may see, near ones first.
#[inline(always)]
fn walk<L: Lanes>(
    nodes: &[Node],
    frame: &Frame,
    state: &mut State,
    stack: &mut Stack,
    leaf: &mut impl FnMut(u32, u32, &mut State, &mut Stack),
) {
    let base = stack.len();
    stack.push(Entry {
        start: f32::NEG_INFINITY,
        first: 0,
        count: 0,
    });
    while stack.len() > base {
        let Some(entry) = stack.pop() else { break };
        if entry.start > state.farthest {
            continue;
        }
        if entry.count != 0 {
            leaf(entry.first, entry.count, state, stack);
            continue;
        }
        let node = &nodes[entry.first as usize];
        let (mask, starts) = frame.children::<L>(node, state.farthest);
        push_children(stack, node, mask, &starts);
    }
}

/// What is known of a tile's rays so far.
struct State {
    seen: Seen,
    /// The greatest 1/z that is not before the near end.
    nearest: PerRay<f32>,
    /// Where each packet's rays are on the plane z = 1.
    u: [[f32; 8]; 2],
    v: [[f32; 8]; 2],
    /// The least 1/z in each packet, and of all.
    packet_least: [f32; 8],
    least: f32,
    /// The greatest z that matters.
    farthest: f32,
    extent: Extent,
}

impl State {
    #[allow(
        clippy::cast_possible_truncation,
        reason = "ends are looked at again in double precision"
    )]
    fn new(rays: &TileRays, clip: Clip, scale: f64) -> Self {
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

    /// Tests those triangles that `there` has.
    #[inline(always)]
    fn test<L: Lanes>(
        &mut self,
        rays: &TileRays,
        ready: &Triangles,
        there: u32,
        (instance, first): (u32, u32),
        number: impl Fn(u32) -> u32,
    ) {
        let packets_u = self.u.map(|x| L::load(&x));
        let packets_v = self.v.map(|x| L::load(&x));
        let mut triangles = ready.seen & there;
        let mut is_nearer = false;
        while triangles != 0 {
            let index = triangles.trailing_zeros();
            triangles &= triangles - 1;
            let of = |values: &[f32; 8]| L::splat(values[index as usize & 7]);
            let touched = packets_u[0]
                .le(of(&ready.u[1]))
                .and(of(&ready.u[0]).le(packets_u[1]))
                .and(packets_v[0].le(of(&ready.v[1])))
                .and(of(&ready.v[0]).le(packets_v[1]))
                .and(L::load(&self.packet_least).le(of(&ready.greatest)));
            let mut packets = touched.signs();
            if packets == 0 {
                continue;
            }
            let sides = ready.sides.each_ref().map(|side| side.each_ref().map(of));
            let plane = ready.plane.each_ref().map(of);
            let (least, greatest) = (of(&ready.least), of(&ready.greatest));
            while packets != 0 {
                let packet = packets.trailing_zeros() as usize & 7;
                packets &= packets - 1;
                let (u, v) = (L::load(&rays.u[packet]), L::load(&rays.v[packet]));
                let along = |n: [L; 3]| n[0].mul(u).add(n[1].mul(v)).add(n[2]);
                let [p, q, r] = sides.map(along);
                let w = along(plane).max(least).min(greatest);
                let best = L::load(&self.seen.inverse_z[packet]);
                let mut met = L::splat(0.0)
                    .le(p.min(q).min(r))
                    .and(best.le(w))
                    .and(w.le(L::load(&self.nearest[packet])));
                let met_bits = met.signs();
                if met_bits == 0 {
                    continue;
                }
                let slot = first + index;
                is_nearer = true;
                let equal = met_bits & w.le(best).signs();
                if equal != 0 {
                    met = self.first_of_equals(met, equal, packet, instance, slot, &number);
                }
                let nearer = met.select(w, best);
                nearer.store(&mut self.seen.inverse_z[packet]);
                for (known, new) in [
                    (&mut self.seen.instance[packet], instance),
                    (&mut self.seen.triangle[packet], slot),
                ] {
                    met.select(L::splat(f32::from_bits(new)), L::load_bits(known))
                        .store_bits(known);
                }
                self.packet_least[packet] = nearer.least();
            }
        }
        if is_nearer {
            self.update_least();
        }
    }
}

impl State {
    /// `met` without the lanes of `equal` that saw an earlier instance's or triangle equally near.
    #[inline(always)]
    fn first_of_equals<L: Lanes>(
        &self,
        met: L,
        equal: u32,
        packet: usize,
        instance: u32,
        slot: u32,
        number: &impl Fn(u32) -> u32,
    ) -> L {
        let mut values = met.values();
        for lane in (0..8).filter(|lane| equal >> lane & 1 == 1) {
            let known = self.seen.instance[packet][lane];
            let is_first = instance < known
                || (instance == known && number(slot) < number(self.seen.triangle[packet][lane]));
            if !is_first {
                values[lane] = 0.0;
            }
        }
        L::load(&values)
    }
}

fn smallest(values: &[f32; 8]) -> f32 {
    values.iter().copied().fold(f32::INFINITY, f32::min)
}

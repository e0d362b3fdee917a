//! Incident light at half resolution, interpolated for all pixels.
//!
//! The light of a point does not depend on the image: every point samples the same parts of lamps and the same directions. What is
//! sampled does: a grid of samples is refined where its light is not what the coarser grid predicts, in the end to pixels. Both images of a
//! stereo pair therefore show the same light, within the tolerance of that prediction.

mod between;
mod node;
mod refine;
mod samples;

use oaktwin_base::interrupt;
use oaktwin_image::Image;
use oaktwin_simd::{Level, run_lanes_at};
use rayon::prelude::*;

use self::between::{Between, MIN_SIMILARITY};
use self::node::{Around, Grid, Node};
use self::refine::{Detail, Spot};
use self::samples::{Rows, Sample, Samples};
use super::occlusion::{LightRows, Occlusion, ShadingPoint, Shares};
use super::strength::{Strengths, Strongest};
use super::surfaces::{Packet, PacketSurfaces};
use super::tiles::{TILE, in_tiles};
use super::visible_pixels::{VisiblePixel, each_visible_pixel};
use crate::ray::Stack;
use crate::rays::Rays;
use crate::spare::Spare;
use crate::{View, Visibility};

/// The distance between the nodes of the coarsest grid, in samples.
const COARSEST: u32 = 8;

/// The distance between the nodes of the finest grid that looks for shadows where the coarser one has none, in samples.
const FINEST_PROBES: u32 = 2;

/// The samples of a view and their light.
#[derive(Debug)]
pub(super) struct Coarse {
    samples: Samples,
    nodes: Image<Node>,
    /// The light of each sample, as [`Between`] interpolates it.
    light: Image<LightRows>,
}

/// The memory of earlier samples.
#[derive(Debug, Default)]
pub(super) struct SpareCoarse {
    samples: Spare<Rows>,
    light: Spare<LightRows>,
    nodes: Spare<Node>,
}

/// Samples the light of a view.
#[derive(Clone, Copy)]
struct Sampler<'a> {
    view: &'a View,
    rays: &'a Rays<'a>,
    seen: &'a Visibility,
    occlusion: &'a Occlusion<'a>,
    spare: &'a SpareCoarse,
    level: Level,
}

impl<'a> Sampler<'a> {
    /// Finds the surfaces of every other pixel of every other row.
    fn surfaces(&self, width: u32, height: u32) -> Samples {
        let mut samples = Samples::misses(width, height, &self.spare.samples);
        let scene = self.occlusion.scene;
        let row_length = (width as usize).max(1);
        let strips = samples.pixels_mut().par_chunks_mut(TILE as usize * row_length);
        strips.zip(0..height.div_ceil(TILE)).for_each_init(
            || {
                let packet = Packet::new(scene, self.view, self.rays, self.level);
                (Vec::new(), packet)
            },
            |(targets, packet), (strip, row)| {
                if interrupt::is_unwanted() {
                    return;
                }
                let first = TILE * row;
                targets.clear();
                for [x, y] in in_tiles(width, (first..height).take(TILE as usize)) {
                    let [column, line] = [2 * x, 2 * y];
                    let seen = self
                        .seen
                        .hits
                        .get(column, line)
                        .zip(self.seen.z.0.get(column, line));
                    let Some((hit, z)) = seen.filter(|(hit, _)| !hit.is_miss()) else {
                        continue;
                    };
                    targets.push(VisiblePixel {
                        tag: (y - first) as usize * row_length + x as usize,
                        place: [column, line],
                        hit: *hit,
                        z: *z,
                    });
                }
                for tile in targets.chunks_mut((TILE * TILE) as usize) {
                    each_visible_pixel(tile, scene, self.level, |VisiblePixel { tag, place, hit, z }| {
                        let Some(ray) = packet.ray(place) else { return };
                        if !packet.has_room_for(hit.instance) {
                            put(packet, strip);
                        }
                        packet.push(tag, place, ray, hit, z);
                    });
                }
                put(packet, strip);
            },
        );
        samples
    }

    /// Returns the light of all samples.
    fn nodes(&self, samples: &Samples) -> Image<Node> {
        let mut stride = COARSEST;
        let mut nodes = self.refined(samples, stride, None);
        while stride > 1 {
            let coarser = Grid {
                samples,
                nodes: &nodes,
                stride,
            };
            stride /= 2;
            let finer = self.refined(samples, stride, Some(coarser));
            self.spare.nodes.keep(std::mem::replace(&mut nodes, finer));
        }
        nodes
    }

    /// Returns a grid of nodes from one with twice the stride.
    fn refined(&self, samples: &Samples, stride: u32, coarser: Option<Grid<'_>>) -> Image<Node> {
        let [width, height] = [samples.width(), samples.height()].map(|size| size.div_ceil(stride));
        let mut nodes = self.spare.nodes.image(width, height, Node::default());
        let rows = nodes.pixels_mut().par_chunks_mut((width as usize).max(1));
        rows.zip(0..height)
            .for_each_init(Workspace::default, |workspace, (row, y)| {
                if interrupt::is_unwanted() {
                    return;
                }
                let Workspace { strengths, stack } = workspace;
                stack.forget();
                let mut first = 0;
                if let (Some(coarser), 0) = (&coarser, y % 2) {
                    for (x, node) in (0..).step_by(2).zip(row.iter_mut().step_by(2)) {
                        *node = coarser.nodes.get(x / 2, y / 2).copied().unwrap_or_default();
                    }
                    first = 1;
                }
                let step = 1 + first;
                let mut left = first;
                while left < width {
                    let columns = || (left..width).step_by(step as usize).take(8);
                    let sample = |x: u32| {
                        samples
                            .get(x * stride, y * stride)
                            .filter(|sample| !sample.is_miss())
                    };
                    for (lane, x) in columns().enumerate() {
                        if let Some(sample) = sample(x) {
                            let place = sample.place();
                            strengths.set(lane, place.from_eye, place.normal);
                        }
                    }
                    strengths.measure(self.occlusion.emitters, self.level);
                    for (lane, x) in columns().enumerate() {
                        let (Some(sample), Some(node)) = (sample(x), row.get_mut(x as usize)) else {
                            continue;
                        };
                        let around = (coarser.as_ref())
                            .map_or(Around::NOTHING, |coarser| Around::new(coarser, sample, [x, y]));
                        let spot = Spot {
                            place: sample.place(),
                            around,
                            probe: (stride >= FINEST_PROBES).then_some(5 * x + 3 * y),
                            detail: if stride > 1 {
                                Detail::Coarse
                            } else {
                                Detail::Finest
                            },
                        };
                        *node = self.occlusion.node(&spot, strengths.strongest(lane), stack);
                    }
                    left += 8 * step;
                }
            });
        nodes
    }
}

/// The reused memory of a thread.
#[derive(Default)]
struct Workspace {
    strengths: Strengths,
    stack: Stack,
}

impl Coarse {
    pub(super) fn new(
        view: &View,
        rays: &Rays<'_>,
        seen: &Visibility,
        occlusion: &Occlusion<'_>,
        memory: &SpareCoarse,
    ) -> Self {
        let sampler = Sampler {
            view,
            rays,
            seen,
            occlusion,
            spare: memory,
            level: occlusion.level,
        };
        let (width, height) = (seen.hits.width().div_ceil(2), seen.hits.height().div_ceil(2));
        let samples = sampler.surfaces(width, height);
        let nodes = sampler.nodes(&samples);
        let mut light = memory.light.image(width, height, LightRows::default());
        let rows = light.pixels_mut().par_iter_mut().with_min_len(4096);
        rows.zip(nodes.pixels()).for_each(|(rows, node)| {
            let light = node.light();
            *rows = [
                [light.some, light.all, light.ambient],
                [light.sky, light.direct(), 0.0],
            ];
        });
        Self {
            samples,
            nodes,
            light,
        }
    }

    /// Keeps the memory.
    pub(super) fn keep(self, memory: &SpareCoarse) {
        self.samples.keep(&memory.samples);
        memory.light.keep(self.light);
        memory.nodes.keep(self.nodes);
    }

    /// Returns the light at the points that a packet's pixels see, and the lanes that have it; the others see a surface that no sample
    /// lies on.
    pub(super) fn light(
        &self,
        found: &PacketSurfaces<'_, '_>,
        occlusion: &Occlusion<'_>,
        strengths: &mut Strengths,
        stack: &mut Stack,
    ) -> (Shares, u32) {
        let mut shares = Shares::default();
        let size = [self.samples.width(), self.samples.height()];
        let kernel = Between {
            samples: self.samples.pixels(),
            light: self.light.pixels(),
            size,
            found,
            shares: &mut shares,
        };
        let [mut known, edges] = run_lanes_at(occlusion.level, kernel);
        let pixels = (1u32 << found.count()) - 1;
        if edges & known & pixels != 0 {
            for lane in 0..found.count() {
                let place = ShadingPoint::new(found, lane);
                strengths.set(lane, place.from_eye, place.normal);
            }
            strengths.measure(occlusion.emitters, occlusion.level);
        }
        for lane in 0..found.count() {
            if (known >> lane) & 1 == 0 {
                if let Some(light) = self.farther(found.place(lane), &ShadingPoint::new(found, lane)) {
                    shares.set(lane, light);
                    known |= 1 << lane;
                }
            } else if (edges >> lane) & 1 != 0 {
                let strongest = strengths.strongest(lane);
                shares.direct[lane] = self.direct(found, lane, occlusion, strongest, stack);
            }
        }
        (shares, known)
    }

    /// Returns the share of the lamps' light that arrives at a pixel on the edge of a shadow.
    fn direct(
        &self,
        found: &PacketSurfaces<'_, '_>,
        lane: usize,
        occlusion: &Occlusion<'_>,
        strongest: Strongest,
        stack: &mut Stack,
    ) -> f32 {
        let place = ShadingPoint::new(found, lane);
        let grid = Grid {
            samples: &self.samples,
            nodes: &self.nodes,
            stride: 1,
        };
        let around = Around::new(&grid, Sample(&samples::rows(&place)), found.place(lane));
        let spot = Spot {
            place,
            around,
            probe: None,
            detail: Detail::Pixel,
        };
        occlusion.node(&spot, strongest, stack).light().direct()
    }

    /// Returns the weighted mean of the samples of the same surface, also of those one sample farther away than the nearest.
    #[cold]
    fn farther(&self, place: [u32; 2], at: &ShadingPoint) -> Option<[f32; 3]> {
        let rows = samples::rows(at);
        let [columns, rows_around] = place.map(|x| {
            let [first, last] = between::around(x);
            first.saturating_sub(1)..=last + 1
        });
        let within = |at: u32, count: u32| at.min(count.saturating_sub(1));
        let mut sum = [[0.0; 3]; 2];
        let mut weights = 0.0;
        for row in rows_around {
            let row = within(row, self.samples.height());
            for column in columns.clone() {
                let column = within(column, self.samples.width());
                if let (Some(sample), Some(light)) =
                    (self.samples.get(column, row), self.light.get(column, row))
                {
                    let weight = Sample(&rows).similarity(sample);
                    for (sum, light) in sum.as_flattened_mut().iter_mut().zip(light.as_flattened()) {
                        *sum += light * weight;
                    }
                    weights += weight;
                }
            }
        }
        let [[some, all, ambient], [sky, ..]] = sum;
        let direct = if all > 0.0 { some / all } else { 1.0 };
        (weights > MIN_SIMILARITY).then(|| [direct, ambient / weights, sky / weights])
    }
}

/// Stores the surfaces of a packet in a strip of samples, and clears the packet.
fn put(packet: &mut Packet<'_>, strip: &mut [Rows]) {
    if let Some(found) = packet.find() {
        for lane in 0..found.count() {
            if let Some(sample) = strip.get_mut(found.tag(lane)) {
                *sample = samples::rows(&ShadingPoint::new(&found, lane));
            }
        }
    }
    packet.clear();
}

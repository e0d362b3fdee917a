//! The motion within a sample: between its samples, a frame continues along the way that each pixel's surface takes in the image.
//!
//! Each pixel is the mean of its colours along that way, which is exact where neighbours move alike. At outlines, what is in front and moves
//! over a pixel counts for the part of the way on which it does, and what a pixel that moves away uncovers is taken from beside it.

use oaktwin_camera::math::{DAffine3, DVec3};
use oaktwin_camera::{PixelPoint, Usd};
use oaktwin_image::Image;
use oaktwin_render::{Backend, Renderer, View};
use rayon::prelude::*;

/// The longest way, px; longer ones are shortened.
const LONGEST_PX: f32 = 64.0;

/// Ways below this change nothing, px.
const SHORTEST_PX: f32 = 0.5;

/// The distance of what has none, m.
const FAR_M: f64 = 1e6;

/// A surface is in front of another if its depth is this part of it or less.
const IN_FRONT: f32 = 0.99;

/// Where everything is at a time.
pub(super) struct Snapshot {
    view: View,
    instances: Vec<DAffine3>,
}

impl Snapshot {
    pub(super) fn new(renderer: &Renderer, view: View) -> Self {
        let instances = renderer.scene().instances.iter();
        Self {
            view,
            instances: instances.map(|instance| instance.world_from_mesh).collect(),
        }
    }
}

/// The way of each pixel of a view, px, and its depth.
pub(super) struct Ways {
    pixels: Vec<MotionVector>,
    width: usize,
    longest: f32,
}

#[derive(Clone, Copy, Default)]
struct MotionVector {
    x: f32,
    y: f32,
    z: f32,
}

impl MotionVector {
    fn length(self) -> f32 {
        self.x.hypot(self.y)
    }
}

impl Ways {
    /// Returns the ways of what a view sees from one time to another; `None` if the scene has other instances then.
    pub(super) fn new(
        renderer: &Renderer,
        view: &View,
        backend: Backend,
        [from, to]: [&Snapshot; 2],
    ) -> Option<Self> {
        let instances = &renderer.scene().instances;
        let world_from_camera = DAffine3::from_mat3_translation(
            view.world_from_camera.rotation,
            view.world_from_camera.translation,
        );
        if [from, to]
            .iter()
            .any(|other| other.instances.len() != instances.len())
        {
            return None;
        }
        // From the camera now to the camera at each end, for each instance and for what stands still.
        let motion = |end: &Snapshot| -> Vec<DAffine3> {
            let end_from_world = end.view.camera_from_world();
            let of_instance = |(now, then): (&oaktwin_scene::Instance, &DAffine3)| {
                end_from_world * *then * now.world_from_mesh.inverse() * world_from_camera
            };
            let still = end_from_world * world_from_camera;
            let moved = instances.iter().zip(&end.instances).map(of_instance);
            moved.chain([still]).collect()
        };
        let ends = [motion(from), motion(to)];
        let seen = renderer.visibility(view, backend);
        let width = seen.hits.width().max(1);
        let both = seen.hits.pixels().par_iter().zip(seen.z.0.pixels());
        let pixels: Vec<MotionVector> = both
            .enumerate()
            .with_min_len(4096)
            .map(|(index, (hit, z))| {
                let index = u32::try_from(index).unwrap_or(u32::MAX);
                let (x, y) = (index % width, index / width);
                let pixel = PixelPoint::<Usd>::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
                let Some(ray) = view.camera.unproject(pixel).filter(|ray| ray.z > 1e-6) else {
                    return MotionVector::default();
                };
                let depth = if z.is_finite() { f64::from(*z) } else { FAR_M };
                let instance = (hit.instance as usize).min(instances.len());
                way(
                    view,
                    ray * (depth / ray.z),
                    ends.each_ref().map(|end| &end[instance]),
                )
            })
            .collect();
        let longest = pixels.iter().fold(0.0, |most: f32, way| most.max(way.length()));
        Some(Self {
            pixels,
            width: width as usize,
            longest,
        })
    }

    /// Smears an image of the view along the ways, in the channels that are chosen.
    pub(super) fn smear<const CHANNELS: usize>(
        &self,
        image: &mut Image<[f32; CHANNELS]>,
        channels: [bool; CHANNELS],
    ) {
        if self.longest < SHORTEST_PX {
            return;
        }
        // No way is longer than two tiles.
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "at most the longest way"
        )]
        let tile = ((self.longest / 2.0).ceil() as usize).clamp(4, LONGEST_PX as usize);
        let fastest = self.fastest(tile);
        let tiles = self.width.div_ceil(tile);
        let source = image.pixels().to_vec();
        let rows = image.pixels_mut().par_chunks_mut(self.width).enumerate();
        rows.for_each(|(y, row)| {
            for (x, pixel) in row.iter_mut().enumerate() {
                let along = fastest[y / tile * tiles + x / tile];
                if along.length() >= SHORTEST_PX {
                    let mean = self.mean(&source, [x, y], along);
                    for channel in (0..CHANNELS).filter(|channel| channels[*channel]) {
                        pixel[channel] = mean[channel];
                    }
                }
            }
        });
    }

    /// The mean of the colours that pass a pixel.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        clippy::cast_precision_loss,
        reason = "places in an image"
    )]
    fn mean<const CHANNELS: usize>(
        &self,
        source: &[[f32; CHANNELS]],
        [x, y]: [usize; 2],
        along: MotionVector,
    ) -> [f32; CHANNELS] {
        let here = y * self.width + x;
        let own = self.pixels[here];
        let height = self.pixels.len() / self.width;
        // The whole way of a pixel that moves, else the fastest of its neighbours'.
        let along = if own.length() >= SHORTEST_PX { own } else { along };
        let length = along.length();
        // Three for each pixel, because each takes the nearest pixel's colour.
        let count = (3.0 * length).ceil().max(1.0) as usize | 1;
        let mut sum = [0.0f32; CHANNELS];
        for tap in 0..count {
            let part = (tap as f32 + 0.5) / count as f32 - 0.5;
            let place = [x as f32 + part * along.x, y as f32 + part * along.y];
            let place = place.map(|place| place.round().max(0.0) as usize);
            let there = place[1].min(height - 1) * self.width + place[0].min(self.width - 1);
            let (other, distance) = (self.pixels[there], part.abs() * length);
            let passes = other.z <= own.z * IN_FRONT && other.length() / 2.0 >= distance;
            let leaves = own.length() / 2.0 >= distance;
            let is_hidden = own.z <= other.z * IN_FRONT && !leaves;
            let taken = if (passes || leaves) && !is_hidden {
                there
            } else {
                here
            };
            for (sum, value) in sum.iter_mut().zip(&source[taken]) {
                *sum += value;
            }
        }
        sum.map(|sum| sum / count as f32)
    }

    /// The longest way in each tile and those around it.
    fn fastest(&self, tile: usize) -> Vec<MotionVector> {
        let height = self.pixels.len() / self.width;
        let (columns, rows) = (self.width.div_ceil(tile), height.div_ceil(tile));
        let longer = |a: MotionVector, b: MotionVector| if b.length() > a.length() { b } else { a };
        let mut own = vec![MotionVector::default(); columns * rows];
        for (index, way) in self.pixels.iter().enumerate() {
            let at = index / self.width / tile * columns + index % self.width / tile;
            own[at] = longer(own[at], *way);
        }
        let around = |index: usize| {
            let (column, row) = (index % columns, index / columns);
            let mut most = MotionVector::default();
            for row in row.saturating_sub(1)..(row + 2).min(rows) {
                for column in column.saturating_sub(1)..(column + 2).min(columns) {
                    most = longer(most, own[row * columns + column]);
                }
            }
            most
        };
        (0..own.len()).map(around).collect()
    }
}

/// The way of a point in the image.
#[expect(clippy::cast_possible_truncation, reason = "images are single precision")]
fn way(view: &View, point: DVec3, ends: [&DAffine3; 2]) -> MotionVector {
    let [from, to] = ends.map(|end| view.camera.project(end.transform_point3(point)));
    let z = point.z as f32;
    let (Some(from), Some(to)) = (from, to) else {
        return MotionVector { x: 0.0, y: 0.0, z };
    };
    let (x, y) = ((to.x - from.x) as f32, (to.y - from.y) as f32);
    let shorter = (LONGEST_PX / x.hypot(y).max(f32::MIN_POSITIVE)).min(1.0);
    MotionVector {
        x: x * shorter,
        y: y * shorter,
        z,
    }
}

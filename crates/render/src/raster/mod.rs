//! From triangles to pixels, for ideal pinholes.
//!
//! Meshes are cut into clusters once. A frame finds the clusters that it can see and which tiles of the image they
//! touch; then every tile, by itself, draws its clusters from the nearest to the farthest, skipping those that are
//! hidden by then. A pixel keeps 1/z, which is linear over a triangle's image.

mod cluster;
mod cull;
mod draw;
mod frame;
mod large;
mod order;
mod small;
#[cfg(test)]
mod tests;
mod tile;

use oaktwin_image::{Image, ZDepth};
use oaktwin_scene::Scene;
use oaktwin_simd::{Level, run_lanes_at};
use rayon::prelude::*;

use self::cluster::{Bounds, ClusteredMesh};
use self::cull::Visible;
use self::draw::{DrawTile, Job};
use self::frame::Frame;
use self::small::Scratch;
use self::tile::Tile;
use crate::{Hit, View, Visibility};

/// What the rasterizer prepares of a scene.
#[derive(Debug)]
pub(crate) struct Rasterizer {
    meshes: Vec<ClusteredMesh>,
    groups: Vec<Group>,
    level: Level,
}

/// Clusters of an instance that are culled together first.
#[derive(Debug)]
struct Group {
    instance: u32,
    /// Of its mesh.
    clusters: std::ops::Range<u32>,
    bounds: Bounds,
}

/// Clusters in a group.
const GROUP: usize = 32;

impl Rasterizer {
    pub(crate) fn new(scene: &Scene) -> Self {
        Self::with_level(scene, Level::detect())
    }

    #[expect(clippy::cast_possible_truncation, reason = "a scene's indices are u32")]
    fn with_level(scene: &Scene, level: Level) -> Self {
        let meshes: Vec<_> = scene.meshes.par_iter().map(ClusteredMesh::new).collect();
        let mut groups = Vec::new();
        for (instance, placed) in scene.instances.iter().enumerate() {
            let Some(mesh) = meshes.get(placed.mesh as usize) else {
                continue;
            };
            for (first, clusters) in (0..).step_by(GROUP).zip(mesh.clusters.chunks(GROUP)) {
                groups.push(Group {
                    instance: instance as u32,
                    clusters: first..first + clusters.len() as u32,
                    bounds: clusters
                        .iter()
                        .map(|c| c.bounds)
                        .fold(Bounds::EMPTY, Bounds::union),
                });
            }
        }
        Self {
            meshes,
            groups,
            level,
        }
    }

    pub(crate) fn depth(&self, scene: &Scene, view: &View) -> ZDepth {
        self.render::<false>(scene, view).0
    }

    pub(crate) fn visibility(&self, scene: &Scene, view: &View) -> Visibility {
        let (z, hits) = self.render::<true>(scene, view);
        Visibility { z, hits }
    }

    /// The second image is empty where no ids are asked for.
    fn render<const IDS: bool>(&self, scene: &Scene, view: &View) -> (ZDepth, Image<Hit>) {
        let frame = Frame::new(scene, view);
        let (width, height) = (frame.width, frame.height);
        let mut z = Image::filled(width, height, 0.0f32);
        let mut hits = if IDS {
            Image::filled(width, height, Hit::MISS)
        } else {
            Image::filled(0, 0, Hit::MISS)
        };
        let visible = self.visible(&frame);
        let (first, entries) = bin(&frame, &visible);
        let [across, _] = Tile::count(width, height);
        let rows = split(z.pixels_mut(), width);
        let id_rows = split(hits.pixels_mut(), width);
        let id_rows = id_rows
            .into_iter()
            .map(Some)
            .chain(std::iter::repeat_with(|| None));
        let jobs: Vec<_> = rows.into_iter().zip(id_rows).zip(first.windows(2)).collect();
        jobs.into_par_iter().with_max_len(1).enumerate().for_each_init(
            || (Tile::default(), Scratch::default(), Vec::new()),
            |(tile, scratch, order), (at, ((mut z_rows, id_rows), range))| {
                tile.start::<IDS>(&frame, at % across, at / across);
                sort(
                    &visible,
                    entries.get(range[0]..range[1]).unwrap_or_default(),
                    order,
                );
                let job = Job {
                    frame: &frame,
                    meshes: &self.meshes,
                    visible: &visible,
                    entries: order,
                };
                let kernel = DrawTile::<IDS> {
                    job: &job,
                    tile,
                    scratch,
                    rows: &mut z_rows,
                };
                run_lanes_at(self.level, kernel);
                if let Some(mut rows) = id_rows {
                    draw::resolve_ids(&job, tile, &mut rows);
                }
            },
        );
        (ZDepth(z), hits)
    }

    /// Everything to draw, in the scene's order.
    fn visible(&self, frame: &Frame) -> Vec<Visible> {
        let parts: Vec<Vec<Visible>> = self
            .groups
            .par_chunks(16)
            .map(|groups| {
                let mut visible = Vec::new();
                for group in groups {
                    let Some(projection) = frame.projection(group.instance) else {
                        continue;
                    };
                    let Some(mesh) = (frame.scene.instances.get(group.instance as usize))
                        .and_then(|instance| self.meshes.get(instance.mesh as usize))
                    else {
                        continue;
                    };
                    if cull::is_unseen(frame, &projection, &group.bounds) {
                        continue;
                    }
                    for cluster in group.clusters.clone() {
                        cull::add(frame, &projection, mesh, group.instance, cluster, &mut visible);
                    }
                }
                visible
            })
            .collect();
        parts.concat()
    }
}

/// For every tile, and one after the last, where its entries begin; and the entries: places in `visible`.
#[expect(clippy::cast_possible_truncation, reason = "fewer than 2^32 can be seen")]
fn bin(frame: &Frame, visible: &[Visible]) -> (Vec<usize>, Vec<u32>) {
    let [across, down] = Tile::count(frame.width, frame.height);
    let touched = |item: &Visible| {
        let x = item.x.map(|x| x as usize / tile::WIDTH);
        let y = item.y.map(|y| y as usize / tile::HEIGHT);
        (y[0]..=y[1]).flat_map(move |row| (x[0]..=x[1]).map(move |column| row * across + column))
    };
    // Two ahead, so that filling them turns ends into beginnings.
    let mut first = vec![0; across * down + 2];
    for tile in visible.iter().flat_map(touched) {
        first[tile + 2] += 1;
    }
    for tile in 1..first.len() {
        first[tile] += first[tile - 1];
    }
    let mut entries = vec![0; first.last().copied().unwrap_or_default()];
    for (at, item) in visible.iter().enumerate() {
        for tile in touched(item) {
            entries[first[tile + 1]] = at as u32;
            first[tile + 1] += 1;
        }
    }
    first.pop();
    (first, entries)
}

/// The nearest first; the lower half of each is its place in `visible`.
fn sort(visible: &[Visible], entries: &[u32], order: &mut Vec<u64>) {
    order.clear();
    order.extend(entries.iter().map(|at| {
        let nearest = visible.get(*at as usize).map_or(0.0, |item| item.inverse_z);
        u64::from(!nearest.to_bits()) << 32 | u64::from(*at)
    }));
    order.sort_unstable();
}

/// The rows of every tile of an image.
fn split<T>(pixels: &mut [T], width: u32) -> Vec<Vec<&mut [T]>> {
    let width = (width as usize).max(1);
    let across = width.div_ceil(tile::WIDTH);
    let mut tiles = Vec::with_capacity(across * (pixels.len() / width).div_ceil(tile::HEIGHT));
    for band in pixels.chunks_mut(width * tile::HEIGHT) {
        let first = tiles.len();
        tiles.extend((0..across).map(|_| Vec::with_capacity(tile::HEIGHT)));
        for row in band.chunks_mut(width) {
            for (tile, part) in tiles[first..].iter_mut().zip(row.chunks_mut(tile::WIDTH)) {
                tile.push(part);
            }
        }
    }
    tiles
}

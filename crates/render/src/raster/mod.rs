//! The rasterizer, for ideal pinholes.
//!
//! Meshes are divided into clusters once. For each frame, visible clusters are assigned to the tiles that they touch; then each
//! tile independently draws its clusters from near to far and skips occluded ones. Pixels store 1/z, which is linear over the
//! image of a triangle.

mod bounds;
mod cluster;
mod cull;
mod draw;
mod frame;
mod id;
mod job;
mod large;
mod list;
mod order;
mod small;
#[cfg(test)]
mod tests;
mod tile;
mod visible;

use oaktwin_image::{Image, ZDepth};
use oaktwin_scene::Scene;
use oaktwin_simd::{Level, run_lanes_at};
use rayon::prelude::*;

use self::bounds::Bounds;
use self::cluster::ClusteredMesh;
use self::draw::DrawTile;
use self::frame::FrameConstants;
use self::job::Job;
use self::small::Scratch;
use self::tile::Tile;
use self::visible::Visible;
use crate::blocks::Blocks;
use crate::visibility::SpareVisibility;
use crate::{Hit, View, Visibility};

/// The clusters of a scene.
#[derive(Debug)]
pub(crate) struct Rasterizer {
    meshes: Vec<ClusteredMesh>,
    groups: Vec<Group>,
    level: Level,
    pub(crate) spare: SpareVisibility,
}

/// Clusters of an instance that are culled together first.
#[derive(Debug)]
struct Group {
    instance: u32,
    /// The range of clusters in the mesh.
    clusters: std::ops::Range<u32>,
    bounds: Bounds,
}

/// The number of clusters in a group.
const GROUP: usize = 32;

impl Rasterizer {
    pub(crate) fn new(scene: &Scene) -> Self {
        Self::with_level(scene, Level::detect())
    }

    fn with_level(scene: &Scene, level: Level) -> Self {
        let mut made = Self {
            meshes: Vec::new(),
            groups: Vec::new(),
            level,
            spare: SpareVisibility::default(),
        };
        made.add_meshes(scene);
        made.place(scene);
        made
    }

    /// Builds the clusters of meshes that were added to the scene.
    pub(crate) fn add_meshes(&mut self, scene: &Scene) {
        let added = &scene.meshes[self.meshes.len()..];
        self.meshes.par_extend(added.par_iter().map(ClusteredMesh::new));
    }

    /// Groups the clusters of the scene's instances.
    #[expect(clippy::cast_possible_truncation, reason = "a scene's indices are u32")]
    pub(crate) fn place(&mut self, scene: &Scene) {
        self.groups.clear();
        for (instance, placed) in scene.instances.iter().enumerate() {
            let Some(mesh) = self.meshes.get(placed.mesh as usize) else {
                continue;
            };
            for (first, clusters) in (0..).step_by(GROUP).zip(mesh.clusters.chunks(GROUP)) {
                self.groups.push(Group {
                    instance: instance as u32,
                    clusters: first..first + clusters.len() as u32,
                    bounds: clusters
                        .iter()
                        .map(|c| c.bounds)
                        .fold(Bounds::EMPTY, Bounds::union),
                });
            }
        }
    }

    pub(crate) fn depth(&self, scene: &Scene, view: &View) -> ZDepth {
        self.render::<false>(scene, view, None).0
    }

    pub(crate) fn visibility(&self, scene: &Scene, view: &View) -> Visibility {
        let (z, hits) = self.render::<true>(scene, view, None);
        Visibility { z, hits }
    }

    /// Renders [`visibility`](Self::visibility) in some blocks; pixels elsewhere are arbitrary.
    pub(crate) fn visibility_in(&self, blocks: &Blocks, scene: &Scene, view: &View) -> Visibility {
        let (z, hits) = self.render::<true>(scene, view, Some(blocks));
        Visibility { z, hits }
    }

    /// Renders some blocks, or all. The second image is empty unless `IDS` is set.
    fn render<const IDS: bool>(
        &self,
        scene: &Scene,
        view: &View,
        rendered: Option<&Blocks>,
    ) -> (ZDepth, Image<Hit>) {
        let frame = FrameConstants::new(scene, view);
        let (width, height) = (frame.width, frame.height);
        let (mut z, mut hits) = if IDS {
            (
                self.spare.z.image(width, height, 0.0),
                self.spare.hits.image(width, height, Hit::MISS),
            )
        } else {
            (Image::filled(width, height, 0.0), Image::filled(0, 0, Hit::MISS))
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
                if !tile.start::<IDS>(&frame, at % across, at / across, rendered) {
                    return;
                }
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

    /// Returns everything to draw, in the order of the scene.
    fn visible(&self, frame: &FrameConstants) -> Vec<Visible> {
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
                    if cull::is_outside(frame, &projection, &group.bounds) {
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

/// Assigns items to tiles: returns the index of each tile's first entry, with one more at the end, and the entries, which are
/// indices in `visible`.
#[expect(clippy::cast_possible_truncation, reason = "fewer than 2^32 can be seen")]
fn bin(frame: &FrameConstants, visible: &[Visible]) -> (Vec<usize>, Vec<u32>) {
    let [across, down] = Tile::count(frame.width, frame.height);
    let touched = |item: &Visible| {
        let x = item.x.map(|x| x as usize / tile::WIDTH);
        let y = item.y.map(|y| y as usize / tile::HEIGHT);
        (y[0]..=y[1]).flat_map(move |row| (x[0]..=x[1]).map(move |column| row * across + column))
    };
    // Counts are stored two ahead so that filling the entries turns end indices into start indices.
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

/// Sorts entries from near to far; the lower half of each is its index in `visible`.
fn sort(visible: &[Visible], entries: &[u32], order: &mut Vec<u64>) {
    order.clear();
    order.extend(entries.iter().map(|at| {
        let nearest = visible.get(*at as usize).map_or(0.0, |item| item.inverse_z);
        u64::from(!nearest.to_bits()) << 32 | u64::from(*at)
    }));
    order.sort_unstable();
}

/// Splits an image into the rows of each tile.
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

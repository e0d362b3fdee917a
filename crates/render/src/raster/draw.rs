//! Drawing of a tile.

use oaktwin_simd::{LaneKernel, Lanes};

use super::frame::Projection;
use super::id::Id;
use super::job::{Entry, Job};
use super::large;
use super::small::{self, Drawn, Scratch};
use super::tile::{Rectangle, STRIDE, Tile};
use super::visible::Visible;
use crate::Hit;

/// Draws a tile and writes its depth into the rows of an image.
pub(super) struct DrawTile<'a, 'r, const IDS: bool> {
    pub(super) job: &'a Job<'a>,
    pub(super) tile: &'a mut Tile,
    pub(super) scratch: &'a mut Scratch,
    pub(super) rows: &'a mut [&'r mut [f32]],
}

impl<const IDS: bool> LaneKernel for DrawTile<'_, '_, IDS> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self) {
        draw::<L, IDS>(self.job, self.tile, self.scratch);
        resolve(self.tile, self.rows);
    }
}

/// The number of clusters to prefetch ahead.
const AHEAD: usize = 2;

#[inline(always)]
fn draw<L: Lanes, const IDS: bool>(job: &Job, tile: &mut Tile, scratch: &mut Scratch) {
    let mut last: Option<(u32, Projection)> = None;
    for at in 0..job.entries.len() {
        if let Some(next) = job.entry(at + AHEAD) {
            small::prefetch::<L>(next.mesh, next.cluster);
        }
        let Some(Entry { item, mesh, cluster }) = job.entry(at) else {
            continue;
        };
        let rectangle = on_tile(item, tile);
        if tile.hides(rectangle, item.inverse_z) {
            continue;
        }
        let onto_tile = match last {
            Some((instance, onto_tile)) if instance == item.instance => onto_tile,
            _ => {
                let Some(projection) = job.frame.projection(item.instance) else {
                    continue;
                };
                let onto_tile = projection.on_tile(job.frame.grid, tile.x, tile.y);
                last = Some((item.instance, onto_tile));
                onto_tile
            }
        };
        if let Some(triangle) = item.triangle {
            if let Some(positions) = mesh.positions(cluster, triangle as usize) {
                let id = Id::new(at, triangle - cluster.first_triangle);
                large::draw::<L, IDS>(job, tile, &onto_tile, positions, id);
            }
        } else {
            let drawn = Drawn {
                mesh,
                cluster,
                onto_tile: &onto_tile,
                entry: at,
            };
            small::draw::<L, IDS>(job, tile, scratch, &drawn);
        }
        tile.touch(rectangle);
    }
}

/// Writes the z-depth of the tile in metres, infinite for a miss.
#[inline(always)]
fn resolve(tile: &Tile, rows: &mut [&mut [f32]]) {
    for (row, inverse_z) in rows.iter_mut().zip(tile.inverse_z.chunks(STRIDE)) {
        for (z, inverse_z) in row.iter_mut().zip(inverse_z) {
            *z = 1.0 / inverse_z;
        }
    }
}

/// Writes the visible triangles of the tile.
pub(super) fn resolve_ids(job: &Job, tile: &Tile, rows: &mut [&mut [Hit]]) {
    // Neighbouring pixels mostly belong to the same cluster.
    let mut last: Option<(usize, Entry)> = None;
    for (row, ids) in rows.iter_mut().zip(tile.id_rows()) {
        for (hit, id) in row.iter_mut().zip(ids) {
            if id == Id::NONE {
                *hit = Hit::MISS;
                continue;
            }
            let (at, triangle) = id.parts();
            if last.as_ref().is_none_or(|(last, _)| *last != at) {
                last = job.entry(at).map(|entry| (at, entry));
            }
            *hit = last.as_ref().map_or(Hit::MISS, |(_, entry)| entry.hit(triangle));
        }
    }
}

/// Returns the part of an item's rectangle on a tile that it touches.
#[expect(clippy::cast_possible_wrap, reason = "a tile is small")]
#[inline(always)]
fn on_tile(item: &Visible, tile: &Tile) -> Rectangle {
    let clip = |[low, high]: [u32; 2], first: u32, size: i32| {
        let last = (size - 1).cast_unsigned();
        [
            low.saturating_sub(first).min(last) as i32,
            high.saturating_sub(first).min(last) as i32,
        ]
    };
    Rectangle {
        x: clip(item.x, tile.x, tile.width),
        y: clip(item.y, tile.y, tile.height),
    }
}

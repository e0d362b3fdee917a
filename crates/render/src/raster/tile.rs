//! A block of pixels small enough for the fastest cache.

use oaktwin_simd::{I32Lanes, Lanes};

use super::frame::FrameConstants;
use super::id::Id;
use super::job::Job;
use crate::blocks::{self, Blocks};

/// The number of columns of a tile.
pub(super) const WIDTH: usize = 128;
/// The number of rows of a tile.
pub(super) const HEIGHT: usize = 80;
/// The distance between rows: triangles are drawn eight columns at a time, past a tile's right edge.
pub(super) const ROW: i32 = 136;
/// [`ROW`] as an index.
pub(super) const STRIDE: usize = ROW as usize;
const _: () = assert!(STRIDE == WIDTH + 8 && STRIDE * (HEIGHT + 1) <= SIZE);
/// A power of two with room for at least one row more than a tile has.
const SIZE: usize = 16384;
/// The number of columns and of rows of a block.
const BLOCK: usize = blocks::BLOCK as usize;
const BLOCKS_ACROSS: usize = WIDTH / BLOCK;
const BLOCKS: usize = BLOCKS_ACROSS * (HEIGHT / BLOCK);

/// A part of the image while it is being drawn.
#[derive(Debug)]
pub(super) struct Tile {
    /// Its first pixel in the image.
    pub(super) x: u32,
    pub(super) y: u32,
    /// The size of the part within the image, at least 1 by 1.
    pub(super) width: i32,
    pub(super) height: i32,
    /// 1/z of the nearest surface so far; 0 for a miss.
    pub(super) inverse_z: Box<[f32; SIZE]>,
    /// The nearest triangle so far; unused if only depth is rendered.
    ids: Box<[i32; SIZE]>,
    /// A lower bound of 1/z in each block; infinite where nothing is rendered.
    farthest: [f32; BLOCKS],
    /// Whether a block was drawn on since `farthest` was computed.
    is_stale: [bool; BLOCKS],
}

/// A rectangle of a tile's columns and rows, both inclusive.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rectangle {
    pub(super) x: [i32; 2],
    pub(super) y: [i32; 2],
}

impl Default for Tile {
    fn default() -> Self {
        Self {
            x: 0,
            y: 0,
            width: 1,
            height: 1,
            inverse_z: Box::new([0.0; SIZE]),
            ids: Box::new([Id::NONE.0; SIZE]),
            farthest: [0.0; BLOCKS],
            is_stale: [false; BLOCKS],
        }
    }
}

impl Tile {
    /// Returns the number of tiles of a frame, across and down.
    pub(super) fn count(width: u32, height: u32) -> [usize; 2] {
        [
            (width as usize).div_ceil(WIDTH),
            (height as usize).div_ceil(HEIGHT),
        ]
    }

    /// Returns the rows of triangles.
    pub(super) fn id_rows(&self) -> impl Iterator<Item = impl Iterator<Item = Id>> {
        self.ids.chunks(STRIDE).map(|row| row.iter().map(|id| Id(*id)))
    }

    /// Clears the tile and moves it to a column and a row. Returns whether any of its blocks is rendered; all are if none are given.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_possible_wrap,
        reason = "a tile lies inside an image, whose sides are u32"
    )]
    pub(super) fn start<const IDS: bool>(
        &mut self,
        frame: &FrameConstants,
        column: usize,
        row: usize,
        rendered: Option<&Blocks>,
    ) -> bool {
        self.x = (column * WIDTH) as u32;
        self.y = (row * HEIGHT) as u32;
        self.width = (frame.width - self.x).min(WIDTH as u32) as i32;
        self.height = (frame.height - self.y).min(HEIGHT as u32) as i32;
        let (first_column, first_row) = (self.x / blocks::BLOCK, self.y / blocks::BLOCK);
        for (at, farthest) in self.farthest.iter_mut().enumerate() {
            let column = first_column + (at % BLOCKS_ACROSS) as u32;
            let row = first_row + (at / BLOCKS_ACROSS) as u32;
            let is_rendered = rendered.is_none_or(|blocks| blocks.contains(column, row));
            *farthest = if is_rendered { 0.0 } else { f32::INFINITY };
        }
        if !self.farthest.contains(&0.0) {
            return false;
        }
        self.inverse_z[..STRIDE * (HEIGHT + 1)].fill(0.0);
        if IDS {
            self.ids[..STRIDE * (HEIGHT + 1)].fill(Id::NONE.0);
        }
        self.is_stale = [false; BLOCKS];
        true
    }

    /// Whether a surface with at most this 1/z would be hidden everywhere in the rectangle.
    #[inline(always)]
    pub(super) fn hides(&mut self, rectangle: Rectangle, inverse_z: f32) -> bool {
        for (at, first) in blocks(rectangle) {
            let farthest = &mut self.farthest[at];
            if inverse_z < *farthest {
                continue;
            }
            if !std::mem::take(&mut self.is_stale[at]) {
                return false;
            }
            let mut lowest = [f32::INFINITY; BLOCK];
            for row in 0..BLOCK {
                let pixels = &self.inverse_z[(first + row * STRIDE) % SIZE..][..BLOCK];
                for (lowest, pixel) in lowest.iter_mut().zip(pixels) {
                    *lowest = if *pixel < *lowest { *pixel } else { *lowest };
                }
            }
            *farthest = lowest.into_iter().fold(f32::INFINITY, f32::min);
            if inverse_z >= *farthest {
                return false;
            }
        }
        true
    }

    /// Marks the blocks of a rectangle as drawn on.
    #[inline(always)]
    pub(super) fn touch(&mut self, rectangle: Rectangle) {
        for (at, _) in blocks(rectangle) {
            self.is_stale[at] = true;
        }
    }

    /// Draws one pixel, given by its index in the arrays, if it is nearer.
    #[inline(always)]
    pub(super) fn put<const IDS: bool>(&mut self, job: &Job, at: usize, inverse_z: f32, id: Id) {
        let nearest = &mut self.inverse_z[at % SIZE];
        #[expect(clippy::float_cmp, reason = "ties are exact")]
        if IDS {
            let first = &mut self.ids[at % SIZE];
            if inverse_z > *nearest || inverse_z == *nearest && job.hit(id) < job.hit(Id(*first)) {
                (*nearest, *first) = (inverse_z, id.0);
            }
        } else {
            *nearest = if inverse_z > *nearest { inverse_z } else { *nearest };
        }
    }

    /// Draws eight pixels of a row where `inverse_z` is positive.
    #[inline(always)]
    pub(super) fn put_row<L: Lanes, const IDS: bool>(&mut self, job: &Job, at: usize, inverse_z: L, id: Id) {
        let Some(pixels) = self.inverse_z[at % SIZE..].first_chunk_mut::<8>() else {
            return;
        };
        let before = L::load(pixels);
        *pixels = inverse_z.max(before).to_array();
        if IDS && let Some(ids) = self.ids[at % SIZE..].first_chunk_mut::<8>() {
            let nearer = before.lt(inverse_z);
            let not_farther = L::splat(0.0).lt(inverse_z).signs() & !inverse_z.lt(before).signs();
            *ids = L::I32::select(nearer, L::I32::splat(id.0), L::I32::load(ids)).to_array();
            let mut ties = not_farther & !nearer.signs();
            while ties != 0 {
                let first = &mut ids[ties.trailing_zeros() as usize % 8];
                if job.hit(id) < job.hit(Id(*first)) {
                    *first = id.0;
                }
                ties &= ties - 1;
            }
        }
    }
}

/// Returns the blocks that a rectangle touches, and their first pixels.
#[inline(always)]
#[expect(clippy::cast_sign_loss, reason = "a rectangle lies in the tile")]
fn blocks(rectangle: Rectangle) -> impl Iterator<Item = (usize, usize)> {
    let [x0, x1] = rectangle.x.map(|x| x as usize / BLOCK);
    let [y0, y1] = rectangle.y.map(|y| y as usize / BLOCK);
    (y0..=y1).flat_map(move |y| {
        (x0..=x1).map(move |x| ((y * BLOCKS_ACROSS + x) % BLOCKS, y * BLOCK * STRIDE + x * BLOCK))
    })
}

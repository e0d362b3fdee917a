//! What the second imager does not see: its view is blocked by something nearer.
//!
//! A pixel at column x with disparity d lies at x − d in the right image. Seen from there, what is farther to the right
//! in the left image comes first: a pixel can be hidden only where something on its right lies at its place or left of
//! it (the running minimum of x − d from the right), and is hidden where that something covers its very place, so that
//! a wall between a thin pole and the pole's shadow stays visible.

use crate::simd::{self, Kernel, Level};

/// Pixels that are looked at together.
pub(super) const BLOCK: usize = 16;

/// 1.5·2²³: the sum with a number smaller than 2²² has its nearest whole number in the lowest bits.
const ROUNDER: f32 = 12_582_912.0;

/// What is farther left is out of every image.
const LEFTMOST: f32 = -1_048_576.0;

/// What hides something is this much nearer, image px: less is the slope of a surface.
pub(super) const NEARER: f32 = 1.0;

/// Places in the right image, and what is there.
#[derive(Clone, Debug, Default)]
pub(super) struct Shadow {
    /// A row after the other, each with a last one that is beyond all.
    places: Vec<f32>,
    /// The pixels that hold these places; below 0 left of the image.
    cells: Vec<i32>,
    falls: Vec<u8>,
    blocks: Vec<Block>,
    taken: Vec<f32>,
}

/// Where a block's pixels lie in the right image.
#[derive(Clone, Copy, Debug, Default)]
struct Block {
    /// From left to right, up to the next block's first: as seen without occlusion.
    in_order: bool,
    low: f32,
    high: f32,
    /// The largest of all before, the smallest of all after.
    before: f32,
    after: f32,
}

impl Block {
    fn may_be_hidden(&self) -> bool {
        !self.in_order || self.high >= self.after
    }

    /// Whether it may hide something: within a pixel, as pixels are wide.
    fn may_hide(&self) -> bool {
        !self.in_order || self.low < self.before + 1.0
    }
}

impl Shadow {
    /// Where the rows of a strip lie in the right image, `stride` pixels a row, a multiple of [`BLOCK`]. 0 is no
    /// surface.
    pub(super) fn place(
        &mut self,
        level: Level,
        (columns, disparities): (&[f32], &[f32]),
        stride: usize,
        image_px: f32,
    ) {
        let rows = disparities.len() / stride;
        self.places.resize(rows * (stride + 1), 0.0);
        self.cells.resize(rows * (stride + 1), 0);
        self.falls.resize(disparities.len(), 0);
        let places = Places {
            columns,
            disparities,
            stride,
            image_px,
            right: &mut self.places,
            cells: &mut self.cells,
            falls: &mut self.falls,
        };
        simd::run_at(level, places);
    }

    /// Tells which pixels of a row of the strip are hidden by something at least `nearer` image px nearer.
    pub(super) fn of_row(
        &mut self,
        row: usize,
        disparities: &[f32],
        image_px: f32,
        nearer: f32,
        mut hide: impl FnMut(usize),
    ) {
        let stride = disparities.len();
        let falls = self
            .falls
            .get(row * stride..(row + 1) * stride)
            .unwrap_or_default();
        let (falls, _) = falls.as_chunks::<BLOCK>();
        if falls.iter().all(is_in_order) {
            return;
        }
        let all = row * (stride + 1)..(row + 1) * (stride + 1);
        let right = self.places.get(all.clone()).unwrap_or_default();
        let cells = self.cells.get(all).unwrap_or_default();
        if !bound_blocks(&mut self.blocks, falls, right) {
            return;
        }
        self.taken.clear();
        self.taken.resize(stride, 0.0);
        for (b, _) in self
            .blocks
            .iter()
            .enumerate()
            .filter(|(_, block)| block.may_hide())
        {
            let start = b * BLOCK;
            let block = start..start + BLOCK;
            let (right, cells) = (&right[start..=block.end], &cells[start..=block.end]);
            take_places(&mut self.taken, right, cells, &disparities[block], image_px);
        }
        for (b, block) in self
            .blocks
            .iter()
            .enumerate()
            .filter(|(_, block)| block.may_be_hidden())
            .rev()
        {
            let mut leftmost = block.after;
            for x in (b * BLOCK..(b + 1) * BLOCK).rev() {
                if right[x] >= leftmost && right[x] >= 0.0 {
                    let there = self.taken.get(index(cells[x])).copied();
                    if there.unwrap_or(0.0) >= disparities[x] * image_px + nearer {
                        hide(x);
                    }
                }
                leftmost = if right[x] < leftmost { right[x] } else { leftmost };
            }
        }
    }
}

fn is_in_order(falls: &[u8; BLOCK]) -> bool {
    u128::from_ne_bytes(*falls) == 0
}

/// Whether any block may have hidden pixels.
fn bound_blocks(blocks: &mut Vec<Block>, falls: &[[u8; BLOCK]], right: &[f32]) -> bool {
    blocks.clear();
    let mut before = f32::NEG_INFINITY;
    blocks.extend(
        right
            .as_chunks::<BLOCK>()
            .0
            .iter()
            .zip(falls)
            .map(|(right, falls)| {
                let in_order = is_in_order(falls);
                let (low, high) = if in_order {
                    (right[0], right[BLOCK - 1])
                } else {
                    (least(*right, |a, b| a < b), least(*right, |a, b| a > b))
                };
                let block = Block {
                    in_order,
                    low,
                    high,
                    before,
                    after: f32::INFINITY,
                };
                before = before.max(high);
                block
            }),
    );
    let mut after = f32::INFINITY;
    let mut any = false;
    for block in blocks.iter_mut().rev() {
        block.after = after;
        after = after.min(block.low);
        any |= block.may_be_hidden();
    }
    any
}

/// The first of all, in an order.
fn least(mut values: [f32; BLOCK], is_before: impl Fn(f32, f32) -> bool) -> f32 {
    let mut half = BLOCK / 2;
    while half > 0 {
        let (low, high) = values.split_at_mut(half);
        for (a, &b) in low.iter_mut().zip(&*high) {
            *a = if is_before(b, *a) { b } else { *a };
        }
        half /= 2;
    }
    values[0]
}

/// The largest disparity at each place, image px. A pixel covers its place, and the next where the surface is stretched
/// to at most twice its width there. Places have one more than disparities.
fn take_places(taken: &mut [f32], right: &[f32], cells: &[i32], disparities: &[f32], image_px: f32) {
    let mut take = |cell: i32, d: f32| {
        if let Some(taken) = taken.get_mut(index(cell)) {
            *taken = if d > *taken { d } else { *taken };
        }
    };
    let places = right.windows(2).zip(cells.windows(2));
    for ((right, cells), &d) in places.zip(disparities) {
        take(cells[0], d * image_px);
        if cells[1].wrapping_sub(cells[0]) == 2 && right[1] - right[0] <= 2.0 {
            take(cells[0] + 1, d * image_px);
        }
    }
}

/// Beyond every image where it is below 0.
fn index(cell: i32) -> usize {
    cell.cast_unsigned() as usize
}

/// Disparities become places.
struct Places<'a> {
    columns: &'a [f32],
    disparities: &'a [f32],
    stride: usize,
    image_px: f32,
    right: &'a mut [f32],
    cells: &'a mut [i32],
    /// Whether the next pixel does not lie on the right.
    falls: &'a mut [u8],
}

impl Kernel for Places<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let rows = self
            .columns
            .chunks_exact(self.stride)
            .zip(self.disparities.chunks_exact(self.stride));
        let rights = self.right.chunks_exact_mut(self.stride + 1);
        let falls = self.falls.chunks_exact_mut(self.stride);
        for (((columns, disparities), right), falls) in rows.zip(rights).zip(falls) {
            for ((right, x), d) in right.iter_mut().zip(columns).zip(disparities) {
                let place = x - d * self.image_px;
                *right = if place > LEFTMOST { place } else { LEFTMOST };
            }
            if let Some(last) = right.last_mut() {
                *last = f32::INFINITY;
            }
            let next = right.get(1..).unwrap_or_default();
            for ((falls, this), next) in falls.iter_mut().zip(right.iter()).zip(next) {
                *falls = u8::from(next <= this);
            }
        }
        for (cell, &right) in self.cells.iter_mut().zip(self.right.iter()) {
            let shifted = right + ROUNDER;
            let nearest = shifted
                .to_bits()
                .cast_signed()
                .wrapping_sub(ROUNDER.to_bits().cast_signed());
            *cell = nearest - i32::from(shifted - ROUNDER > right);
        }
    }
}

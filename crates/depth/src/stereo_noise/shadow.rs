//! What the second imager does not see: its view is blocked by something nearer.
//!
//! A pixel at column x with disparity d lies at x − d in the right image. Seen from there, what is farther to the right
//! in the left image comes first: a pixel can be hidden only where something on its right lies at its place or left of
//! it (the running minimum of x − d from the right), and is hidden where that something covers its very place, so that
//! a wall between a thin pole and the pole's shadow stays visible.

use crate::simd::{self, Kernel, Level};

/// Pixels that are looked at together.
pub(super) const BLOCK: usize = 16;

/// What hides something is this much nearer, image px: less is the slope of a surface.
pub(super) const NEARER: f32 = 1.0;

/// Places in the right image, and what is there.
#[derive(Clone, Debug, Default)]
pub(super) struct Shadow {
    /// A row after the other, each with a last one that is beyond all.
    places: Vec<f32>,
    in_order: Vec<bool>,
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
        self.in_order.resize(disparities.len() / BLOCK, false);
        let places = Places {
            columns,
            disparities,
            stride,
            image_px,
            right: &mut self.places,
            in_order: &mut self.in_order,
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
        let (stride, count) = (disparities.len(), disparities.len() / BLOCK);
        let in_order = self
            .in_order
            .get(row * count..(row + 1) * count)
            .unwrap_or_default();
        if in_order.iter().all(|&in_order| in_order) {
            return;
        }
        let start = row * (stride + 1);
        let right = self.places.get(start..start + stride).unwrap_or_default();
        if !bound_blocks(&mut self.blocks, in_order, right) {
            return;
        }
        self.taken.clear();
        self.taken.resize(stride, 0.0);
        take_places(&mut self.taken, &self.blocks, right, disparities, image_px);
        let pixels = right.chunks_exact(BLOCK).zip(disparities.chunks_exact(BLOCK));
        for (b, (block, (right, disparities))) in self.blocks.iter().zip(pixels).enumerate().rev() {
            if !block.may_be_hidden() {
                continue;
            }
            let mut leftmost = block.after;
            for (x, (&right, &d)) in right.iter().zip(disparities).enumerate().rev() {
                if right >= leftmost && right >= 0.0 {
                    let place = usize::try_from(cell(right)).ok();
                    let there = place.and_then(|place| self.taken.get(place)).copied();
                    if there.unwrap_or(0.0) >= d * image_px + nearer {
                        hide(b * BLOCK + x);
                    }
                }
                leftmost = if right < leftmost { right } else { leftmost };
            }
        }
    }
}

/// Whether any block may have hidden pixels.
fn bound_blocks(blocks: &mut Vec<Block>, in_order: &[bool], right: &[f32]) -> bool {
    blocks.clear();
    let mut before = f32::NEG_INFINITY;
    blocks.extend(right.chunks_exact(BLOCK).zip(in_order).map(|(right, &in_order)| {
        let (first, last) = (right.first().copied(), right.last().copied());
        let (mut low, mut high) = (first.unwrap_or(0.0), last.unwrap_or(0.0));
        if !in_order {
            for &right in right {
                low = if right < low { right } else { low };
                high = if right > high { right } else { high };
            }
        }
        let block = Block {
            in_order,
            low,
            high,
            before,
            after: f32::INFINITY,
        };
        before = before.max(high);
        block
    }));
    let mut after = f32::INFINITY;
    let mut any = false;
    for block in blocks.iter_mut().rev() {
        block.after = after;
        after = after.min(block.low);
        any |= block.may_be_hidden();
    }
    any
}

/// The largest disparity at each place, image px. A pixel covers its place, and the next where the surface is stretched
/// to at most twice its width there.
fn take_places(taken: &mut [f32], blocks: &[Block], right: &[f32], disparities: &[f32], image_px: f32) {
    for (b, _) in blocks.iter().enumerate().filter(|(_, block)| block.may_hide()) {
        let start = b * BLOCK;
        let pixels = right.iter().zip(disparities).enumerate();
        for (x, (&place, &d)) in pixels.skip(start).take(BLOCK) {
            let first = cell(place);
            let next = right.get(x + 1).copied().unwrap_or(place);
            let stretched = next - place <= 2.0 && cell(next) - first == 2;
            for covered in first..=first + i32::from(stretched) {
                if let Some(taken) = usize::try_from(covered)
                    .ok()
                    .and_then(|covered| taken.get_mut(covered))
                {
                    let d = d * image_px;
                    *taken = if d > *taken { d } else { *taken };
                }
            }
        }
    }
}

/// The pixel of a place: one left of the image where it is left of it.
#[expect(
    clippy::cast_possible_truncation,
    reason = "places are finite, disparities at most 8192 px"
)]
fn cell(right: f32) -> i32 {
    if right < 0.0 {
        right as i32 - 1
    } else {
        right as i32
    }
}

/// Disparities become places.
struct Places<'a> {
    columns: &'a [f32],
    disparities: &'a [f32],
    stride: usize,
    image_px: f32,
    right: &'a mut [f32],
    in_order: &'a mut [bool],
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
        let blocks = self.in_order.chunks_exact_mut(self.stride / BLOCK);
        for (((columns, disparities), right), blocks) in rows.zip(rights).zip(blocks) {
            for ((right, x), d) in right.iter_mut().zip(columns).zip(disparities) {
                *right = x - d * self.image_px;
            }
            if let Some(last) = right.last_mut() {
                *last = f32::INFINITY;
            }
            let next = right.get(1..).unwrap_or_default().chunks_exact(BLOCK);
            for ((in_order, these), next) in blocks.iter_mut().zip(right.chunks_exact(BLOCK)).zip(next) {
                *in_order = these.iter().zip(next).fold(true, |all, (a, b)| all & (a < b));
            }
        }
    }
}

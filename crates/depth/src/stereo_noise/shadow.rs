//! Occlusion: pixels whose view from the second imager is blocked by something nearer.
//!
//! A pixel at column x with disparity d is at x − d in the right image. A pixel can be occluded only if a pixel on its
//! right is at its position or left of it in the right image (the running minimum of x − d from the right), and it is
//! occluded if that pixel covers its exact position, so that a wall between a thin pole and the pole's shadow stays visible.

use oaktwin_simd::{self as simd, Kernel, Level};

/// The pixels that are processed together.
pub(super) const BLOCK: usize = 16;

/// A position left of every image.
const LEFTMOST: f32 = -1_048_576.0;

/// The minimum disparity difference of an occlusion, image px; smaller differences are slopes of surfaces.
pub(super) const NEARER: f32 = 1.0;

/// The positions of a strip's pixels in the right image.
#[derive(Clone, Debug, Default)]
pub(super) struct Shadow {
    /// The positions, and one at the end beyond all.
    places: Vec<f32>,
    /// Whether the next pixel of the row is not on the right.
    falls: Vec<u8>,
    /// The blocks of a row.
    blocks: Vec<Block>,
}

/// The positions of a block's pixels in the right image.
#[derive(Clone, Copy, Debug, Default)]
struct Block {
    low: f32,
    high: f32,
    /// The minimum of all positions after the block.
    after: f32,
}

/// Rows of disparities; 0 means no surface.
#[derive(Clone, Copy)]
pub(super) struct Rows<'a> {
    /// The column of each pixel.
    pub(super) columns: &'a [f32],
    /// Disparities, matcher px.
    pub(super) disparities: &'a [f32],
    /// The pixels of a row, a multiple of [`BLOCK`].
    pub(super) stride: usize,
    /// Image pixels per matcher pixel.
    pub(super) image_px: f32,
}

impl Shadow {
    /// Finds the pixels that are occluded by something at least `nearer` image px nearer, in any order.
    pub(super) fn find(&mut self, level: Level, rows: Rows<'_>, nearer: f32, hidden: &mut Vec<usize>) {
        self.places.resize(rows.disparities.len() + 1, 0.0);
        self.falls.resize(rows.disparities.len(), 0);
        self.blocks.resize(rows.stride / BLOCK, Block::default());
        let places = Places {
            rows,
            places: &mut self.places,
            falls: &mut self.falls,
        };
        simd::run_at(level, places);
        let find = Find {
            shadow: self,
            rows,
            nearer,
            hidden,
        };
        simd::run_at(level, find);
    }
}

/// Converts disparities to positions.
struct Places<'a> {
    rows: Rows<'a>,
    places: &'a mut [f32],
    falls: &'a mut [u8],
}

impl Kernel for Places<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let pixels = self.rows.columns.iter().zip(self.rows.disparities);
        for (out, (x, d)) in self.places.iter_mut().zip(pixels) {
            let place = x - d * self.rows.image_px;
            *out = if place > LEFTMOST { place } else { LEFTMOST };
        }
        if let Some(last) = self.places.last_mut() {
            *last = f32::INFINITY;
        }
        let next = self.places.get(1..).unwrap_or_default();
        for ((falls, this), next) in self.falls.iter_mut().zip(self.places.iter()).zip(next) {
            *falls = u8::from(next <= this);
        }
        // Not for the last pixel of a row, whose next pixel is in another row.
        for falls in self.falls.chunks_exact_mut(self.rows.stride) {
            if let Some(last) = falls.last_mut() {
                *last = 0;
            }
        }
    }
}

/// Finds occluded pixels among those in the wrong order.
struct Find<'a> {
    shadow: &'a mut Shadow,
    rows: Rows<'a>,
    nearer: f32,
    hidden: &'a mut Vec<usize>,
}

impl Kernel for Find<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Rows {
            disparities,
            stride,
            image_px,
            ..
        } = self.rows;
        let Shadow {
            places,
            falls,
            blocks,
        } = self.shadow;
        for (row, falls) in falls.chunks_exact(stride).enumerate() {
            let falls = falls.as_chunks::<BLOCK>().0;
            if falls.iter().all(is_in_order) {
                continue;
            }
            let mut after = f32::INFINITY;
            for (b, falls) in falls.iter().enumerate().rev() {
                let start = row * stride + b * BLOCK;
                let (places, disparities) = (&places[start..], &disparities[start..]);
                let Some(block) = places.first_chunk::<BLOCK>() else {
                    continue;
                };
                let in_order = is_in_order(falls);
                let (low, high) = if in_order {
                    (block[0], block[BLOCK - 1])
                } else {
                    (least(*block, |a, b| a < b), least(*block, |a, b| a > b))
                };
                blocks[b] = Block { low, high, after };
                if !in_order || high >= after {
                    let mut passed = passed(block, after);
                    while passed != 0 {
                        let x = passed.trailing_zeros() as usize;
                        let least = disparities[x] * image_px + self.nearer;
                        let covering = Covering {
                            cell: places[x].trunc(),
                            least,
                            image_px,
                        };
                        if covering.is_in(&blocks[b..], places, disparities) {
                            self.hidden.push(start + x);
                        }
                        passed &= passed - 1;
                    }
                }
                after = if low < after { low } else { after };
            }
        }
    }
}

fn is_in_order(falls: &[u8; BLOCK]) -> bool {
    u128::from_ne_bytes(*falls) == 0
}

/// Returns the first of all, in an order.
#[inline(always)]
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

/// Returns a bit for each pixel of a block that a pixel on its right has passed, and none beyond the left border.
#[inline(always)]
fn passed(places: &[f32; BLOCK], after: f32) -> u32 {
    let (mut passed, mut leftmost) = (0, after);
    for (i, &place) in places.iter().enumerate().rev() {
        passed |= u32::from((place >= leftmost) & (place >= 0.0)) << i;
        leftmost = if place < leftmost { place } else { leftmost };
    }
    passed
}

/// A search for a pixel that covers a cell of the right image, with at least this disparity, image px.
struct Covering {
    cell: f32,
    least: f32,
    image_px: f32,
}

impl Covering {
    /// Whether there is one in the blocks from the pixel's own. Nearer pixels are on the right.
    #[inline(always)]
    fn is_in(&self, blocks: &[Block], places: &[f32], disparities: &[f32]) -> bool {
        for (b, block) in blocks.iter().enumerate() {
            if block.low < self.cell + 1.0 && block.high >= self.cell - 1.0 {
                let pixels = b * BLOCK..(b + 1) * BLOCK;
                let next = &places[pixels.start + 1..=pixels.end];
                if self.is_among(&places[pixels.clone()], next, &disparities[pixels]) {
                    return true;
                }
            }
            if block.after >= self.cell + 1.0 {
                return false;
            }
        }
        false
    }

    /// A pixel covers its cell, and the next one if the surface is stretched to at most twice its width there. The last
    /// pixel of a row has no next pixel on the right.
    #[inline(always)]
    fn is_among(&self, places: &[f32], next: &[f32], disparities: &[f32]) -> bool {
        let (before, cell, after) = (self.cell - 1.0, self.cell, self.cell + 1.0);
        let mut found = false;
        for ((&place, &next), &d) in places.iter().zip(next).zip(disparities) {
            let lies = (place >= cell) & (place < after);
            let stretches = (next >= after) & (next < after + 1.0) & (next - place <= 2.0);
            let reaches = (place >= before) & (place < cell) & stretches;
            found |= (lies | reaches) & (d * self.image_px >= self.least);
        }
        found
    }
}

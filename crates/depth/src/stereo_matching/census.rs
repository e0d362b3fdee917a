//! The census transform: the pixels of a window that are brighter than its mean or its centre.

use oaktwin_simd::{self as simd, Kernel, Level};

use super::plan::PassPlan;

/// The number of columns that are added on each side of an image.
const BORDER: usize = 8;

/// The census transform of an image, and its grey levels.
#[derive(Clone, Debug, Default)]
pub(super) struct Census {
    width: usize,
    height: usize,
    planes: usize,
    stride: usize,
    /// The 8-bit planes of each row, then its 8-bit grey levels, `stride` apart; a blank row follows the last one.
    rows: Vec<u8>,
    padded: Vec<i16>,
    sums: Vec<u16>,
    reference: Vec<i16>,
}

/// One image to transform.
pub(super) struct CensusInput<'a> {
    pub(super) width: usize,
    pub(super) height: usize,
    /// The number of bits of a pixel, at least 8.
    pub(super) bits: u32,
    pub(super) levels: &'a [i16],
}

impl Census {
    /// Transforms an image. If `is_reversed`, rows are mirrored, with room after them for pixels beyond the border.
    pub(super) fn make(&mut self, level: Level, plan: &PassPlan, image: &CensusInput<'_>, is_reversed: bool) {
        let (width, height) = (image.width, image.height);
        let [rows, columns] = plan.window;
        let above = rows / 2;
        let padded_width = width + 2 * BORDER;
        self.pad(image);
        self.width = width;
        self.height = height;
        self.planes = plan.planes();
        self.stride = if is_reversed {
            (width + plan.last() + 1).next_multiple_of(64)
        } else {
            width
        };
        let row_length = self.stride * (self.planes + 1);
        self.rows.clear();
        self.rows.resize(row_length * (height + 1), 0);
        self.sums.resize(padded_width, 0);
        self.reference.resize(width, 0);
        let more = image.bits - 8;
        for (y, out) in self.rows.chunks_exact_mut(row_length).enumerate().take(height) {
            let row = |dy: usize| {
                let y = (y + dy).saturating_sub(above).min(height - 1);
                self.padded.get(y * padded_width..(y + 1) * padded_width)
            };
            let Some(own) = row(above) else { return };
            let mut window: [&[i16]; 7] = [own; 7];
            for (dy, slot) in window.iter_mut().take(rows).enumerate() {
                *slot = row(dy).unwrap_or(own);
            }
            simd::run_at(
                level,
                Reference {
                    rows: window.get(..rows).unwrap_or_default(),
                    columns,
                    mean_mode: plan.mean_mode,
                    threshold: plan.census_threshold << more,
                    scale: plan.census_scale,
                    sums: &mut self.sums,
                    out: &mut self.reference,
                },
            );
            for (plane, pixels) in plan.pixels.chunks(8).enumerate() {
                let Some(out) = out.get_mut(plane * self.stride..plane * self.stride + width) else {
                    return;
                };
                for (bit, &[dy, dx]) in pixels.iter().enumerate() {
                    let first = BORDER + dx - columns / 2;
                    let Some(pixels) = window.get(dy).and_then(|row| row.get(first..first + width)) else {
                        return;
                    };
                    let bit = 1 << bit;
                    simd::run_at(
                        level,
                        Compare {
                            pixels,
                            reference: &self.reference,
                            bit,
                            out,
                        },
                    );
                }
            }
            let levels = self.planes * self.stride;
            if let (Some(out), Some(own)) = (out.get_mut(levels..levels + width), own.get(BORDER..)) {
                for (out, &own) in out.iter_mut().zip(own) {
                    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "8 bits")]
                    let own = (own >> more) as u8;
                    *out = own;
                }
            }
            if is_reversed {
                for plane in out.chunks_exact_mut(self.stride) {
                    if let Some(inside) = plane.get_mut(..width) {
                        inside.reverse();
                    }
                }
            }
        }
    }

    /// The planes of a row and then its grey levels, [`Census::stride`] apart; without a row, of the blank row.
    pub(super) fn row(&self, y: Option<usize>) -> &[u8] {
        let length = self.stride * (self.planes + 1);
        let y = y.unwrap_or(self.height);
        self.rows.get(y * length..(y + 1) * length).unwrap_or_default()
    }

    pub(super) fn width(&self) -> usize {
        self.width
    }

    pub(super) fn height(&self) -> usize {
        self.height
    }

    pub(super) fn planes(&self) -> usize {
        self.planes
    }

    pub(super) fn stride(&self) -> usize {
        self.stride
    }

    /// The 8-bit grey levels of a row.
    pub(super) fn levels(&self, y: usize) -> &[u8] {
        let row = self.row(Some(y));
        row.get(self.planes * self.stride..).unwrap_or_default()
    }

    /// Repeats the border outside the image.
    fn pad(&mut self, image: &CensusInput<'_>) {
        self.padded.clear();
        for row in image.levels.chunks_exact(image.width) {
            let (Some(&first), Some(&last)) = (row.first(), row.last()) else {
                return;
            };
            self.padded.extend_from_slice(&[first; BORDER]);
            self.padded.extend_from_slice(row);
            self.padded.extend_from_slice(&[last; BORDER]);
        }
    }
}

/// Computes the value with which a row's pixels are compared.
struct Reference<'a> {
    rows: &'a [&'a [i16]],
    columns: usize,
    mean_mode: bool,
    threshold: i32,
    /// The offset to the threshold for each 4096 grey levels.
    scale: i32,
    /// A buffer for a row with its borders.
    sums: &'a mut [u16],
    out: &'a mut [i16],
}

impl Kernel for Reference<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let width = self.out.len();
        if self.mean_mode {
            let (Some(first), Some(out)) = (self.rows.first(), self.out.get_mut(..width)) else {
                return;
            };
            let length = self.sums.len().min(first.len());
            let Some(sums) = self.sums.get_mut(..length) else {
                return;
            };
            sums.fill(0);
            for row in self.rows {
                for (sum, &level) in sums.iter_mut().zip(*row) {
                    *sum = sum.wrapping_add(level.cast_unsigned());
                }
            }
            let left = BORDER - self.columns / 2;
            // 63 times 1023 fits into 16 bits.
            match (self.rows.len(), self.columns) {
                (5, _) => mean::<5, 25>(sums.get(left..).unwrap_or_default(), out),
                (_, 7) => mean::<7, 49>(sums.get(left..).unwrap_or_default(), out),
                _ => mean::<9, 63>(sums.get(left..).unwrap_or_default(), out),
            }
        } else if let Some(middle) = self
            .rows
            .get(self.rows.len() / 2)
            .and_then(|row| row.get(BORDER..))
        {
            for (out, &level) in self.out.iter_mut().zip(middle) {
                *out = level;
            }
        }
        if self.threshold != 0 || self.scale != 0 {
            for out in self.out {
                let by_level = (self.scale * i32::from(*out)) >> 12;
                #[expect(clippy::cast_possible_truncation, reason = "a few thousand at most")]
                let raised = (i32::from(*out) + self.threshold + by_level) as i16;
                *out = raised;
            }
        }
    }
}

#[inline(always)]
fn mean<const COLUMNS: usize, const AREA: u16>(sums: &[u16], out: &mut [i16]) {
    let width = out.len();
    if sums.len() < width + COLUMNS - 1 {
        return;
    }
    for x in 0..width {
        let mut sum = 0u16;
        for dx in 0..COLUMNS {
            sum = sum.wrapping_add(sums[x + dx]);
        }
        out[x] = (sum / AREA).cast_signed();
    }
}

/// Sets a bit for each pixel brighter than the reference.
struct Compare<'a> {
    pixels: &'a [i16],
    reference: &'a [i16],
    bit: u8,
    out: &'a mut [u8],
}

impl Kernel for Compare<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        for ((out, &pixel), &reference) in self.out.iter_mut().zip(self.pixels).zip(self.reference) {
            *out |= if pixel > reference { self.bit } else { 0 };
        }
    }
}

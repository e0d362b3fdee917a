//! The field of independent random numbers whose window sums are the jitter.

use std::ops::Range;

use oaktwin_simd::{self as simd, Kernel, Level};

use crate::random::{RandomPlane, box_muller};

/// The numbers of the field: small integers, so that sums are exact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Numbers {
    /// Random bytes; the sum of many is normal.
    Bytes,
    /// Normal numbers in steps of 1/1024, plus [`OFFSET`].
    Normals,
}

/// The number of bytes from which their sum counts as normal: its excess kurtosis is −1.2 / 16.
const NORMAL_BYTES: usize = 16;

/// Steps per standard deviation.
const STEPS: f32 = 1024.0;

/// Normal numbers lie within 4.9 standard deviations: none is below 0, and the sum of four fits 16 bits.
const OFFSET: f32 = 8192.0;

/// 2²³: adding it rounds to an integer, in the lowest bits.
const ONE_A_STEP: f32 = 8_388_608.0;

/// The words in a group of normal numbers, which covers twice as many pixels.
const GROUP: usize = 32;

impl Numbers {
    /// Returns the numbers for a window of this side.
    pub(super) fn under(side: usize) -> Self {
        if side * side < NORMAL_BYTES {
            Self::Normals
        } else {
            Self::Bytes
        }
    }

    pub(super) fn mean(self) -> f64 {
        match self {
            Self::Bytes => 127.5,
            Self::Normals => f64::from(OFFSET),
        }
    }

    pub(super) fn variance(self) -> f64 {
        match self {
            Self::Bytes => (65536.0 - 1.0) / 12.0,
            Self::Normals => f64::from(STEPS) * f64::from(STEPS),
        }
    }
}

/// The memory for the rows of a strip.
#[derive(Clone, Debug, Default)]
pub(super) struct Field {
    width: usize,
    bytes: Vec<u8>,
    words: Vec<u32>,
    numbers: Vec<u16>,
}

impl Field {
    /// Prepares for rows of at least `width` columns and returns their width.
    pub(super) fn reset(&mut self, width: usize) -> usize {
        self.width = width.next_multiple_of(2 * GROUP);
        self.width
    }

    /// Returns rows of the field.
    ///
    /// Each word of a row makes two normal numbers: of 32 words, word i makes pixels i and 32 + i of 64. The upper 16 bits
    /// are the radius, the lower the angle.
    pub(super) fn rows(
        &mut self,
        level: Level,
        plane: &RandomPlane,
        rows: Range<u32>,
        numbers: Numbers,
    ) -> &[u16] {
        let pixels = rows.len() * self.width;
        self.numbers.resize(pixels, 0);
        match numbers {
            Numbers::Bytes => {
                self.bytes.resize(pixels, 0);
                for (row, bytes) in rows.zip(self.bytes.chunks_exact_mut(self.width)) {
                    plane.bytes(row, bytes);
                }
                let widen = Widen {
                    bytes: &self.bytes,
                    out: &mut self.numbers,
                };
                simd::run_at(level, widen);
            }
            Numbers::Normals => {
                self.words.resize(pixels / 2, 0);
                for (row, words) in rows.zip(self.words.chunks_exact_mut(self.width / 2)) {
                    plane.row_words(row, words);
                }
                let normals = Normals {
                    words: &self.words,
                    out: &mut self.numbers,
                };
                simd::run_at(level, normals);
            }
        }
        &self.numbers
    }
}

struct Widen<'a> {
    bytes: &'a [u8],
    out: &'a mut [u16],
}

impl Kernel for Widen<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        for (out, &byte) in self.out.iter_mut().zip(self.bytes) {
            *out = u16::from(byte);
        }
    }
}

struct Normals<'a> {
    words: &'a [u32],
    out: &'a mut [u16],
}

impl Kernel for Normals<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let groups = self
            .out
            .chunks_exact_mut(2 * GROUP)
            .zip(self.words.chunks_exact(GROUP));
        for (group, words) in groups {
            let (cosines, sines) = group.split_at_mut(GROUP);
            for ((cosine, sine), &word) in cosines.iter_mut().zip(sines).zip(words) {
                // The centre of the interval of the 16 bits.
                let numbers = box_muller(word & 0xFFFF_0000 | 0x8000, word << 16);
                [*cosine, *sine] = numbers.map(fixed);
            }
        }
    }
}

/// Rounds to steps, halves to even.
#[inline(always)]
#[expect(clippy::cast_possible_truncation, reason = "the number is in the low 16 bits")]
fn fixed(normal: f32) -> u16 {
    (normal * STEPS + OFFSET + ONE_A_STEP).to_bits() as u16
}

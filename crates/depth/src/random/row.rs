use std::marker::PhantomData;

use oaktwin_simd::{self as simd, Kernel};

use super::RandomPlane;
use super::normal::box_muller;
use super::philox::{LANES, philox_lanes};

/// The words of [`LANES`] blocks.
const GROUP: usize = 4 * LANES;

/// [`LANES`] in the type of block numbers.
const BLOCKS: u32 = 16;

/// Converts the words of a row to numbers `T`, in groups of [`GROUP`] words.
trait Groups<T> {
    /// Converts a group to `SIZE` numbers.
    const SIZE: usize;
    fn of(words: &[[u32; LANES]; 4], out: &mut [T]);
}

struct RandomRow<'a, T, G> {
    plane: &'a RandomPlane,
    row: u32,
    out: &'a mut [T],
    groups: PhantomData<G>,
}

impl<T: Copy + Default, G: Groups<T>> Kernel for RandomRow<'_, T, G> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let mut first = 0u32;
        let mut next = || {
            let words = philox_lanes(
                first,
                [self.row, self.plane.frame, self.plane.item],
                self.plane.key,
            );
            first = first.wrapping_add(BLOCKS);
            words
        };
        let mut whole = self.out.chunks_exact_mut(G::SIZE);
        for out in &mut whole {
            G::of(&next(), out);
        }
        let rest = whole.into_remainder();
        if !rest.is_empty() {
            // Groups of bytes are the longest.
            let mut last = [T::default(); 4 * GROUP];
            G::of(&next(), &mut last[..G::SIZE]);
            rest.copy_from_slice(&last[..rest.len()]);
        }
    }
}

struct Words;

impl Groups<u32> for Words {
    const SIZE: usize = GROUP;

    #[inline(always)]
    fn of(words: &[[u32; LANES]; 4], out: &mut [u32]) {
        for (out, words) in out.chunks_exact_mut(LANES).zip(words) {
            out.copy_from_slice(words);
        }
    }
}

struct Bytes;

impl Groups<u8> for Bytes {
    const SIZE: usize = 4 * GROUP;

    #[inline(always)]
    fn of(words: &[[u32; LANES]; 4], out: &mut [u8]) {
        for (out, word) in out.chunks_exact_mut(4).zip(words.as_flattened()) {
            out.copy_from_slice(&word.to_le_bytes());
        }
    }
}

struct Uniforms;

impl Groups<f32> for Uniforms {
    const SIZE: usize = GROUP;

    #[inline(always)]
    fn of(words: &[[u32; LANES]; 4], out: &mut [f32]) {
        for (out, word) in out.iter_mut().zip(words.as_flattened()) {
            *out = (word >> 8).cast_signed() as f32 * (1.0 / 16_777_216.0);
        }
    }
}

struct Normals;

impl Groups<f32> for Normals {
    const SIZE: usize = GROUP;

    #[inline(always)]
    fn of(words: &[[u32; LANES]; 4], out: &mut [f32]) {
        for (out, words) in out.chunks_exact_mut(2 * LANES).zip(words.chunks_exact(2)) {
            let (cosines, sines) = out.split_at_mut(LANES);
            for lane in 0..LANES {
                [cosines[lane], sines[lane]] = box_muller(words[0][lane], words[1][lane]);
            }
        }
    }
}

/// The numbers of a row. Word `i` of a row is word `i / 16 % 4` of block `16 · (i / 64) + i % 16`: sixteen blocks in
/// parallel. The number of a column does not depend on the number of columns.
impl RandomPlane {
    /// Fills `out` with the words of a row.
    pub fn row_words(&self, row: u32, out: &mut [u32]) {
        self.fill::<_, Words>(row, out);
    }

    /// Fills `out` with the bytes of the row's random words, lowest first.
    pub fn bytes(&self, row: u32, out: &mut [u8]) {
        self.fill::<_, Bytes>(row, out);
    }

    /// Fills `out` with uniform numbers in [0, 1), multiples of 2⁻²⁴: the upper 24 bits of the row's words.
    pub fn uniforms(&self, row: u32, out: &mut [f32]) {
        self.fill::<_, Uniforms>(row, out);
    }

    /// Fills `out` with standard normal numbers: of 32 words of the row, words `i` and `16 + i` give numbers `i` and `16 + i` by
    /// [`standard_normal`](super::standard_normal).
    pub fn normals(&self, row: u32, out: &mut [f32]) {
        self.fill::<_, Normals>(row, out);
    }

    /// [`RandomPlane::normals`] inlined, with the instruction set of its caller.
    #[inline(always)]
    pub(crate) fn normals_here(&self, row: u32, out: &mut [f32]) {
        self.kernel::<_, Normals>(row, out).run();
    }

    fn fill<T: Copy + Default, G: Groups<T>>(&self, row: u32, out: &mut [T]) {
        simd::run(self.kernel::<T, G>(row, out));
    }

    fn kernel<'a, T, G>(&'a self, row: u32, out: &'a mut [T]) -> RandomRow<'a, T, G> {
        RandomRow {
            plane: self,
            row,
            out,
            groups: PhantomData,
        }
    }
}

#[cfg(test)]
mod tests;

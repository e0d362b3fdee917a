use super::cluster::{LANES, MAX_TRIANGLES};

/// For each byte, the indices of its set bits, from the lowest, as bytes.
const SET_BITS: [u64; 256] = {
    let mut table = [0; 256];
    let mut mask = 0;
    while mask < 256 {
        let (mut bit, mut count) = (0, 0);
        while bit < 8 {
            if mask >> bit & 1 == 1 {
                table[mask] |= bit << (8 * count);
                count += 1;
            }
            bit += 1;
        }
        mask += 1;
    }
    table
};

/// A list of triangles of a cluster.
#[derive(Debug)]
pub(super) struct TriangleList {
    pub(super) triangles: [u8; MAX_TRIANGLES + LANES],
    pub(super) count: usize,
}

impl TriangleList {
    pub(super) const EMPTY: Self = Self {
        triangles: [0; MAX_TRIANGLES + LANES],
        count: 0,
    };

    /// Appends the triangles, of eight, whose bit is set.
    #[inline(always)]
    pub(super) fn push(&mut self, first: usize, mask: u32) {
        // All eight bytes are written; excess ones are overwritten by the next call.
        if let Some(slots) = self.triangles[self.count % MAX_TRIANGLES..].first_chunk_mut::<LANES>() {
            let packed = SET_BITS[mask as usize % 256] + first as u64 * 0x0101_0101_0101_0101;
            *slots = packed.to_le_bytes();
        }
        self.count += mask.count_ones() as usize;
    }

    /// Returns batches of eight and the number of valid triangles in each.
    #[inline(always)]
    pub(super) fn batches(&self) -> impl Iterator<Item = (&[u8; LANES], usize)> {
        (0..self.count)
            .step_by(LANES)
            .zip(self.triangles.as_chunks::<LANES>().0)
            .map(|(first, batch)| (batch, (self.count - first).min(LANES)))
    }
}

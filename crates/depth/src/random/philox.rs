const MULTIPLIERS: [u32; 2] = [0xD251_1F53, 0xCD9E_8D57];
const WEYL: [u32; 2] = [0x9E37_79B9, 0xBB67_AE85];
const ROUNDS: usize = 10;

/// Philox4x32-10: returns four independent words for a counter and a key.
#[must_use]
#[inline]
pub fn philox4x32_10(counter: [u32; 4], key: [u32; 2]) -> [u32; 4] {
    let mut words = counter;
    let mut key = key;
    for _ in 0..ROUNDS {
        let (low0, high0) = wide_product(MULTIPLIERS[0], words[0]);
        let (low1, high1) = wide_product(MULTIPLIERS[1], words[2]);
        words = [high1 ^ words[1] ^ key[0], low1, high0 ^ words[3] ^ key[1], low0];
        key = [key[0].wrapping_add(WEYL[0]), key[1].wrapping_add(WEYL[1])];
    }
    words
}

#[inline]
#[expect(clippy::cast_possible_truncation, reason = "the two halves of a product")]
fn wide_product(a: u32, b: u32) -> (u32, u32) {
    let product = u64::from(a) * u64::from(b);
    (product as u32, (product >> 32) as u32)
}

/// The number of blocks computed in parallel.
pub(super) const LANES: usize = 16;

/// Returns the words of [`LANES`] blocks from `first`: word `k` of block `first + j` is at `[k][j]`.
///
/// The counters and words are in the lower halves of 64-bit lanes, whose upper halves are ignored, so that products need no
/// shuffling.
#[inline(always)]
pub(super) fn philox_lanes(first: u32, [row, frame, item]: [u32; 3], key: [u32; 2]) -> [[u32; LANES]; 4] {
    const LOW: u64 = 0xFFFF_FFFF;
    let mut words = [
        [u64::from(first); LANES],
        [u64::from(row); LANES],
        [u64::from(frame); LANES],
        [u64::from(item); LANES],
    ];
    for (word, lane) in words[0].iter_mut().zip(0..) {
        *word += lane;
    }
    let mut key = key;
    for _ in 0..ROUNDS {
        #[expect(clippy::needless_range_loop, reason = "four arrays at once")]
        for lane in 0..LANES {
            let product0 = (words[0][lane] & LOW) * u64::from(MULTIPLIERS[0]);
            let product1 = (words[2][lane] & LOW) * u64::from(MULTIPLIERS[1]);
            words[0][lane] = (product1 >> 32) ^ words[1][lane] ^ u64::from(key[0]);
            words[1][lane] = product1;
            words[2][lane] = (product0 >> 32) ^ words[3][lane] ^ u64::from(key[1]);
            words[3][lane] = product0;
        }
        key = [key[0].wrapping_add(WEYL[0]), key[1].wrapping_add(WEYL[1])];
    }
    // Not `map`, which is a call.
    let mut out = [[0; LANES]; 4];
    for (out, words) in out.iter_mut().zip(&words) {
        for (out, &word) in out.iter_mut().zip(words) {
            #[expect(clippy::cast_possible_truncation, reason = "the lower half")]
            let low = word as u32;
            *out = low;
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lanes_are_blocks() {
        let (counter, key) = ([7, 0x8000_0001, u32::MAX], [0xdead_beef, 0xffff_fff0]);
        for first in [0, 16, 0xffff_fff0] {
            let words = philox_lanes(first, counter, key);
            for (lane, place) in (0..LANES).zip(0u32..) {
                let block = [first + place, counter[0], counter[1], counter[2]];
                assert_eq!(words.map(|word| word[lane]), philox4x32_10(block, key));
            }
        }
    }

    /// The known answers of Random123's `kat_vectors` for philox4x32-10.
    #[test]
    fn known_answers() {
        assert_eq!(
            philox4x32_10([0; 4], [0; 2]),
            [0x6627_e8d5, 0xe169_c58d, 0xbc57_ac4c, 0x9b00_dbd8]
        );
        assert_eq!(
            philox4x32_10([u32::MAX; 4], [u32::MAX; 2]),
            [0x408f_276d, 0x41c8_3b0e, 0xa20b_c7c6, 0x6d54_51fd]
        );
        assert_eq!(
            philox4x32_10(
                [0x243f_6a88, 0x85a3_08d3, 0x1319_8a2e, 0x0370_7344],
                [0xa409_3822, 0x299f_31d0]
            ),
            [0xd16c_fe09, 0x94fd_cceb, 0x5001_e420, 0x2412_6ea1]
        );
    }
}

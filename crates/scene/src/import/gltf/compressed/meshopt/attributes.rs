//! Vertex attributes: the differences of consecutive elements, byte by byte, in groups of 16.

/// No stream decodes to more than this many bytes per byte: 256 elements of which the control bits say that all are equal.
const MAX_RATIO: usize = 1024;
const GROUP: usize = 16;

/// The bits per difference of a group by its mode: first version 0, then version 1 by control mode.
const BITS: [[usize; 4]; 3] = [[0, 2, 4, 8], [0, 1, 2, 4], [1, 2, 4, 8]];

pub(super) fn decode(bytes: &[u8], count: usize, stride: usize) -> Option<Vec<u8>> {
    let is_newer = match bytes.first()? {
        0xa0 => false,
        0xa1 => true,
        _ => return None,
    };
    let size = count.checked_mul(stride)?;
    if !(4..=256).contains(&stride) || !stride.is_multiple_of(4) || size / MAX_RATIO > bytes.len() {
        return None;
    }
    let channels = stride / 4;
    let (tail, padded) = if is_newer {
        (stride + channels, (stride + channels).max(24))
    } else {
        (stride, stride.max(32))
    };
    let mut reader = Reader(bytes.get(1..bytes.len().checked_sub(padded)?)?);
    let (baseline, modes) = bytes[bytes.len() - tail..].split_at(stride);
    let mut decoded = vec![0; size];
    let mut previous = baseline.to_vec();
    let per_block = ((8192 / stride) & !(GROUP - 1)).min(256);
    for block in decoded.chunks_mut(per_block * stride) {
        let control = if is_newer { reader.take(channels)? } else { &[] };
        for channel in 0..channels {
            let mut deltas = [[0; 256]; 4];
            for (i, delta) in deltas.iter_mut().enumerate() {
                let delta = &mut delta[..block.len() / stride];
                match control.get(channel).map(|byte| byte >> (2 * i) & 3) {
                    None => reader.groups(&BITS[0], delta)?,
                    Some(3) => delta.copy_from_slice(reader.take(delta.len())?),
                    Some(2) => {}
                    Some(mode) => reader.groups(&BITS[1 + usize::from(mode)], delta)?,
                }
            }
            let mode = modes.get(channel).copied().unwrap_or(0);
            let last = previous[4 * channel..].first_chunk_mut()?;
            for (element, i) in block.chunks_exact_mut(stride).zip(0..) {
                *last = apply(mode, *last, deltas.map(|delta| delta[i]))?;
                element[4 * channel..4 * channel + 4].copy_from_slice(last);
            }
        }
    }
    reader.0.is_empty().then_some(decoded)
}

/// The four bytes that follow from the previous ones and their difference; `None` for an unknown mode.
fn apply(mode: u8, last: [u8; 4], delta: [u8; 4]) -> Option<[u8; 4]> {
    let byte = |i: usize| last[i].wrapping_add(delta[i] >> 1 ^ (delta[i] & 1).wrapping_neg());
    let short = |i: usize| {
        let delta = u16::from_le_bytes([delta[i], delta[i + 1]]);
        let difference = delta >> 1 ^ (delta & 1).wrapping_neg();
        u16::from_le_bytes([last[i], last[i + 1]])
            .wrapping_add(difference)
            .to_le_bytes()
    };
    Some(match (mode & 15, mode >> 4) {
        (0, 0) => [byte(0), byte(1), byte(2), byte(3)],
        (1, 0) => {
            let ([a, b], [c, d]) = (short(0), short(2));
            [a, b, c, d]
        }
        (2, turn) => {
            // The encoder rotates to the left.
            let difference = u32::from_le_bytes(delta).rotate_right(turn.into());
            (u32::from_le_bytes(last) ^ difference).to_le_bytes()
        }
        _ => return None,
    })
}

struct Reader<'a>(&'a [u8]);

impl<'a> Reader<'a> {
    fn take(&mut self, count: usize) -> Option<&'a [u8]> {
        let (taken, rest) = self.0.split_at_checked(count)?;
        self.0 = rest;
        Some(taken)
    }

    /// Reads the differences of one byte of all elements in a block.
    fn groups(&mut self, bits: &[usize; 4], deltas: &mut [u8]) -> Option<()> {
        let modes = self.take(deltas.len().div_ceil(GROUP).div_ceil(4))?;
        for (i, group) in deltas.chunks_mut(GROUP).enumerate() {
            let mode = modes[i / 4] >> (2 * (i % 4)) & 3;
            self.group(bits[usize::from(mode)], group)?;
        }
        Some(())
    }

    fn group(&mut self, bits: usize, deltas: &mut [u8]) -> Option<()> {
        let packed = self.take(GROUP * bits / 8)?;
        // The highest value means that a whole byte follows.
        let escape = (1_u16 << bits) - 1;
        for i in 0..GROUP {
            let value = match bits {
                0 => 0,
                1 => packed[i / 8] >> (i % 8) & 1,
                8 => packed[i],
                _ => {
                    let per_byte = 8 / bits;
                    let shift = 8 - bits * (1 + i % per_byte);
                    packed[i / per_byte] >> shift & ((1 << bits) - 1)
                }
            };
            let value = match bits {
                1..=4 if u16::from(value) == escape => *self.take(1)?.first()?,
                _ => value,
            };
            if let Some(delta) = deltas.get_mut(i) {
                *delta = value;
            }
        }
        Some(())
    }
}

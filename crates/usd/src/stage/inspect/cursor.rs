/// The maximum compression ratio of LZ4.
pub(super) const LZ4_RATIO: u64 = 255;
/// The maximum number of integers per byte: they are packed to at least a quarter of a byte each before LZ4.
pub(super) const INTS_PER_BYTE: u64 = 4 * LZ4_RATIO;

/// A little-endian reader; reads past the end return `None`.
#[derive(Clone, Copy)]
pub(super) struct Cursor<'a> {
    bytes: &'a [u8],
    at: u64,
}

impl<'a> Cursor<'a> {
    pub(super) fn new(bytes: &'a [u8], at: u64) -> Self {
        Self { bytes, at }
    }

    pub(super) fn position(&self) -> u64 {
        self.at
    }

    pub(super) fn remaining(&self) -> u64 {
        u64::try_from(self.bytes.len())
            .unwrap_or(u64::MAX)
            .saturating_sub(self.at)
    }

    pub(super) fn take(&mut self, count: u64) -> Option<&'a [u8]> {
        let end = self.at.checked_add(count)?;
        let taken = self
            .bytes
            .get(usize::try_from(self.at).ok()?..usize::try_from(end).ok()?)?;
        self.at = end;
        Some(taken)
    }

    pub(super) fn u8(&mut self) -> Option<u8> {
        self.take(1)?.first().copied()
    }

    pub(super) fn u32(&mut self) -> Option<u32> {
        Some(u32::from_le_bytes(self.take(4)?.try_into().ok()?))
    }

    pub(super) fn u64(&mut self) -> Option<u64> {
        Some(u64::from_le_bytes(self.take(8)?.try_into().ok()?))
    }

    pub(super) fn i64(&mut self) -> Option<i64> {
        Some(i64::from_le_bytes(self.take(8)?.try_into().ok()?))
    }

    /// Skips blocks that are each preceded by their length.
    pub(super) fn chunks(&mut self, count: usize) -> Option<()> {
        for _ in 0..count {
            let length = self.u64()?;
            self.take(length)?;
        }
        Some(())
    }
}

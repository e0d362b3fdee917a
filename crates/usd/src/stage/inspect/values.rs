//! Checks the lengths of the values in a binary layer. The layout follows the reader in OpenUSD's `crateFile.cpp`.

use super::cursor::{Cursor, INTS_PER_BYTE};

const ARRAY: u64 = 1 << 63;
const INLINED: u64 = 1 << 62;
const COMPRESSED: u64 = 1 << 61;
const PAYLOAD: u64 = (1 << 48) - 1;

/// The maximum number of elements of a compressed array: a gigabyte of integers.
const MAX_ELEMENTS: u64 = 1 << 28;
/// The maximum depth of dictionaries.
const MAX_DEPTH: usize = 64;
/// The maximum total number of dictionary entries and time samples, so that offsets pointing back cannot cause a loop.
const MAX_STEPS: usize = 50_000_000;

/// Checks the values of one layer. Checks return `None` for a value that claims more bytes than the file has.
pub(super) struct Values<'a> {
    bytes: &'a [u8],
    version: (u8, u8, u8),
    steps: usize,
}

impl<'a> Values<'a> {
    pub(super) fn new(bytes: &'a [u8], version: (u8, u8, u8)) -> Self {
        Self {
            bytes,
            version,
            steps: 0,
        }
    }

    /// Checks a value by its 8-byte representation.
    pub(super) fn check(&mut self, value: u64, depth: usize) -> Option<()> {
        self.steps += 1;
        if depth > MAX_DEPTH || self.steps > MAX_STEPS {
            return None;
        }
        if value & INLINED != 0 {
            return Some(());
        }
        let mut at = Cursor::new(self.bytes, value & PAYLOAD);
        let kind = (value >> 48) & 0xff;
        match kind {
            // Strings, asset paths and path expressions.
            10 | 12 | 57 if value & ARRAY != 0 => elements(&mut at, 4),
            31 => self.dictionary(&mut at, depth),
            32..=34 | 36 | 38 | 54 => lists(&mut at, |at| elements(at, 4)),
            37 | 39 => lists(&mut at, |at| elements(at, 8)),
            35 => lists(&mut at, |at| {
                for _ in 0..counted(at, 32)? {
                    at.take(24)?;
                    self.dictionary(at, depth)?;
                }
                Some(())
            }),
            55 => {
                let size = if self.version >= (0, 8, 0) { 24 } else { 8 };
                lists(&mut at, |at| elements(at, size))
            }
            40 | 41 | 50 => elements(&mut at, 4),
            45 | 58 => elements(&mut at, 8),
            46 => self.time_samples(&mut at, depth),
            49 => elements(&mut at, 16),
            48 => self.array(value, kind),
            _ if value & ARRAY != 0 => self.array(value, kind),
            _ => Some(()),
        }
    }

    fn array(&self, value: u64, kind: u64) -> Option<()> {
        if value & PAYLOAD == 0 {
            return Some(());
        }
        let mut at = Cursor::new(self.bytes, value & PAYLOAD);
        if self.version < (0, 5, 0) {
            at.u32()?;
        }
        let count = if self.version < (0, 7, 0) {
            u64::from(at.u32()?)
        } else {
            at.u64()?
        };
        let integers = matches!(kind, 3..=6) && self.version >= (0, 5, 0);
        let floats = matches!(kind, 7..=9 | 48 | 56) && self.version >= (0, 6, 0);
        if value & COMPRESSED == 0 || count < 4 || !(integers || floats) {
            return (count <= at.remaining() / element_size(kind)).then_some(());
        }
        if floats && at.u8()? == b't' {
            let table = u64::from(at.u32()?);
            at.take(table.checked_mul(element_size(kind))?)?;
        }
        let packed = at.u64()?;
        let fits = packed <= at.remaining()
            && count <= packed.saturating_mul(INTS_PER_BYTE)
            && count <= MAX_ELEMENTS;
        fits.then_some(())
    }

    fn dictionary(&mut self, at: &mut Cursor<'a>, depth: usize) -> Option<()> {
        for _ in 0..counted(at, 12)? {
            at.u32()?;
            self.jump(at)?;
            let value = at.u64()?;
            self.check(value, depth + 1)?;
        }
        Some(())
    }

    fn time_samples(&mut self, at: &mut Cursor<'a>, depth: usize) -> Option<()> {
        self.jump(at)?;
        let times = at.u64()?;
        self.check(times, depth + 1)?;
        self.jump(at)?;
        for _ in 0..counted(at, 8)? {
            let value = at.u64()?;
            self.check(value, depth + 1)?;
        }
        Some(())
    }

    /// Follows an offset relative to its own position.
    fn jump(&self, at: &mut Cursor<'a>) -> Option<()> {
        let from = at.position();
        let offset = at.i64()?;
        *at = Cursor::new(self.bytes, from.checked_add_signed(offset)?);
        Some(())
    }
}

/// Reads a count of items of at least `size` bytes that fit in the remaining bytes.
fn counted(at: &mut Cursor, size: u64) -> Option<u64> {
    let count = at.u64()?;
    (count <= at.remaining() / size).then_some(count)
}

/// Skips a counted run of elements of `size` bytes.
fn elements(at: &mut Cursor, size: u64) -> Option<()> {
    let count = counted(at, size)?;
    at.take(count * size)?;
    Some(())
}

/// Checks a list operation, whose first byte is a bit set of the lists that follow.
fn lists<'a>(at: &mut Cursor<'a>, mut list: impl FnMut(&mut Cursor<'a>) -> Option<()>) -> Option<()> {
    const FOLLOWING: u8 = 0b0111_1110;
    let header = at.u8()?;
    for _ in 0..(header & FOLLOWING).count_ones() {
        list(at)?;
    }
    Some(())
}

/// Returns the size of an element of an uncompressed array, in bytes.
fn element_size(kind: u64) -> u64 {
    match kind {
        1 | 2 => 1,
        7 => 2,
        25 => 6,
        5 | 6 | 9 | 18 | 20 | 22 | 29 | 48 | 56 => 8,
        24 | 26 => 12,
        17 | 19 | 28 | 30 => 16,
        23 => 24,
        13 | 16 | 27 => 32,
        14 => 72,
        15 => 128,
        // int, uint, float, token, half2
        _ => 4,
    }
}

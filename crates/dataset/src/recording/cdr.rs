//! The serialization of ROS 2's messages.

/// Writes plain CDR, little-endian, as RTPS frames it: four bytes that say so, then the fields one after the other, each
/// aligned to its own size counted from behind those four (OMG "DDS-XTypes" 7.4.1, "DDSI-RTPS" 10).
#[derive(Debug, Default)]
pub(super) struct Cdr {
    bytes: Vec<u8>,
}

/// The representation identifier of little-endian plain CDR, and no options.
const LITTLE_ENDIAN: [u8; 4] = [0, 1, 0, 0];

impl Cdr {
    /// Forgets the last message and begins the next one, in the same memory.
    pub(super) fn begin(&mut self) -> &mut Self {
        self.bytes.clear();
        self.bytes.extend(LITTLE_ENDIAN);
        self
    }

    /// The message.
    pub(super) fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    fn align(&mut self, size: usize) {
        let payload = self.bytes.len() - LITTLE_ENDIAN.len();
        self.bytes
            .resize(LITTLE_ENDIAN.len() + payload.next_multiple_of(size), 0);
    }

    pub(super) fn bool(&mut self, value: bool) -> &mut Self {
        self.u8(value.into())
    }

    pub(super) fn u8(&mut self, value: u8) -> &mut Self {
        self.bytes.push(value);
        self
    }

    pub(super) fn u32(&mut self, value: u32) -> &mut Self {
        self.align(4);
        self.bytes.extend(value.to_le_bytes());
        self
    }

    pub(super) fn i32(&mut self, value: i32) -> &mut Self {
        self.align(4);
        self.bytes.extend(value.to_le_bytes());
        self
    }

    /// An array of fixed length, or one number.
    pub(super) fn f64s(&mut self, values: &[f64]) -> &mut Self {
        for value in values {
            self.align(8);
            self.bytes.extend(value.to_le_bytes());
        }
        self
    }

    /// Its length with the zero that ends it, then both.
    pub(super) fn string(&mut self, text: &str) -> &mut Self {
        self.length(text.len() + 1);
        self.bytes.extend(text.as_bytes());
        self.u8(0)
    }

    /// What a sequence begins with.
    pub(super) fn length(&mut self, length: usize) -> &mut Self {
        // Images have at most 2^31 pixels; a message that is longer still is refused before it is begun.
        self.u32(u32::try_from(length).unwrap_or(u32::MAX))
    }

    /// A sequence of bytes, `length` of them, that `fill` appends.
    pub(super) fn byte_sequence(&mut self, length: usize, fill: impl FnOnce(&mut Vec<u8>)) -> &mut Self {
        self.length(length);
        self.bytes.reserve(length);
        let start = self.bytes.len();
        fill(&mut self.bytes);
        debug_assert_eq!(self.bytes.len() - start, length, "what was announced");
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_aligned_from_behind_the_header() {
        let mut cdr = Cdr::default();
        cdr.begin().u8(7).u32(0x0102_0304).bool(true).f64s(&[1.0]);
        let expected = [
            &[0, 1, 0, 0][..],               // little-endian
            &[7, 0, 0, 0],                   // uint8 at 0, padded to 4
            &[4, 3, 2, 1],                   // uint32 at 4
            &[1, 0, 0, 0, 0, 0, 0, 0],       // bool at 8, padded to 16
            &[0, 0, 0, 0, 0, 0, 0xf0, 0x3f], // float64 at 16
        ];
        assert_eq!(cdr.bytes(), expected.concat());
    }

    #[test]
    fn strings_and_sequences_begin_with_their_length() {
        let mut cdr = Cdr::default();
        cdr.begin()
            .string("ab")
            .string("")
            .byte_sequence(3, |bytes| bytes.extend([9, 8, 7]))
            .i32(-2);
        let expected = [
            &[0, 1, 0, 0][..],
            &[3, 0, 0, 0, b'a', b'b', 0, 0], // to 8
            &[1, 0, 0, 0, 0, 0, 0, 0],       // to 16
            &[3, 0, 0, 0, 9, 8, 7, 0],       // to 24
            &[0xfe, 0xff, 0xff, 0xff],
        ];
        assert_eq!(cdr.bytes(), expected.concat());
    }

    #[test]
    fn an_empty_sequence_is_its_length() {
        let mut cdr = Cdr::default();
        cdr.begin().length(0).u8(5);
        assert_eq!(cdr.bytes(), [0, 1, 0, 0, 0, 0, 0, 0, 5]);
        // The next message begins anew.
        assert_eq!(cdr.begin().u8(1).bytes(), [0, 1, 0, 0, 1]);
    }
}

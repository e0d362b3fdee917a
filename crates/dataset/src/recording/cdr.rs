//! Serialization of ROS 2 messages.

/// Writes plain little-endian CDR with the header of RTPS: four bytes of identifier and options, then the fields, each aligned to
/// its own size relative to the end of the header (OMG "DDS-XTypes" 7.4.1, "DDSI-RTPS" 10).
#[derive(Debug, Default)]
pub(super) struct Cdr {
    bytes: Vec<u8>,
}

/// The representation identifier of little-endian plain CDR, and no options.
const LITTLE_ENDIAN: [u8; 4] = [0, 1, 0, 0];

impl Cdr {
    /// Starts a new message in the memory of the last one.
    pub(super) fn begin(&mut self) -> &mut Self {
        self.bytes.clear();
        self.bytes.extend(LITTLE_ENDIAN);
        self
    }

    /// Returns the message.
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

    /// Writes an array of fixed length, or a number.
    pub(super) fn f64s(&mut self, values: &[f64]) -> &mut Self {
        for value in values {
            self.align(8);
            self.bytes.extend(value.to_le_bytes());
        }
        self
    }

    /// Writes the length including the terminating zero, then both.
    pub(super) fn string(&mut self, text: &str) -> &mut Self {
        self.length(text.len() + 1);
        self.bytes.extend(text.as_bytes());
        self.u8(0)
    }

    /// Writes the length of a sequence.
    pub(super) fn length(&mut self, length: usize) -> &mut Self {
        // Images have at most 2^31 pixels; messages that are too long are rejected earlier.
        self.u32(u32::try_from(length).unwrap_or(u32::MAX))
    }

    /// Writes a sequence of `length` bytes that `fill` appends.
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
    fn alignment_is_relative_to_the_header() {
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
    fn strings_and_sequences_have_a_length() {
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
    fn empty_sequences_have_a_length() {
        let mut cdr = Cdr::default();
        cdr.begin().length(0).u8(5);
        assert_eq!(cdr.bytes(), [0, 1, 0, 0, 0, 0, 0, 0, 5]);
        // The next message starts from scratch.
        assert_eq!(cdr.begin().u8(1).bytes(), [0, 1, 0, 0, 1]);
    }
}

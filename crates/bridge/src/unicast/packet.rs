//! Samples as datagrams of RTPS, the protocol of DDS (OMG "DDSI-RTPS" 2.3, 8.3 and 9.4).

/// The version of the protocol, which all implementations in use understand.
const VERSION: [u8; 2] = [2, 3];
/// The vendor of the DDS library, which announces the writer (OMG's list of vendor identifiers: `RustDDS`).
const VENDOR: [u8; 2] = [0x01, 0x12];
/// The entity identifier that addresses all matched readers of a participant.
const ALL_READERS: [u8; 4] = [0; 4];

const INFO_TIMESTAMP: u8 = 0x09;
const DATA: u8 = 0x15;
const DATA_FRAGMENT: u8 = 0x16;
/// The flag of numbers that begin with the lowest byte.
const LITTLE_ENDIAN: u8 = 0x01;
/// The flag of a submessage with data.
const HAS_DATA: u8 = 0x04;

/// The bytes before a message in the payload of a sample: its representation, and the bytes of padding at its end.
#[cfg(test)]
const ENCAPSULATION: usize = 4;
/// The bytes of a datagram beside the data.
pub(super) const OVERHEAD: u16 = 20 + 12 + 36;

/// A sample of a writer.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sample<'a> {
    /// The identifier of the writer: the prefix of its participant, and its entity.
    pub(super) writer: [u8; 16],
    /// The number, which counts from 1.
    pub(super) number: u64,
    /// The time since 1970, in units of 2⁻³² s.
    pub(super) time: u64,
    /// The representation and the message; see [`payload`].
    pub(super) payload: &'a [u8],
}

/// Returns the payload of a sample: a message that `serialize` appends as little-endian CDR, with its representation before it,
/// padded to whole words.
pub(super) fn payload<E>(serialize: impl FnOnce(&mut Vec<u8>) -> Result<(), E>) -> Result<Vec<u8>, E> {
    // CDR of the lower byte order; the last byte is the padding.
    let mut payload = vec![0, 1, 0, 0];
    serialize(&mut payload)?;
    let padding = payload.len().next_multiple_of(4) - payload.len();
    payload.resize(payload.len() + padding, 0);
    payload[3] = u8::try_from(padding).unwrap_or(0);
    Ok(payload)
}

impl Sample<'_> {
    /// Sends the sample in datagrams of up to `fragment` bytes of data, a multiple of 4, until sending fails.
    pub(super) fn send<E>(
        &self,
        fragment: u16,
        mut send: impl FnMut(&[u8]) -> Result<(), E>,
    ) -> Result<(), E> {
        let mut datagram = Vec::with_capacity(usize::from(OVERHEAD) + usize::from(fragment));
        if self.payload.len() <= usize::from(fragment) {
            self.begin(&mut datagram);
            self.data(&mut datagram);
            return send(&datagram);
        }
        for (number, part) in (1u32..).zip(self.payload.chunks(usize::from(fragment))) {
            datagram.clear();
            self.begin(&mut datagram);
            self.fragment(number, fragment, part, &mut datagram);
            send(&datagram)?;
        }
        Ok(())
    }

    /// The header of a datagram and the time of the sample.
    fn begin(&self, to: &mut Vec<u8>) {
        to.extend(b"RTPS");
        to.extend(VERSION);
        to.extend(VENDOR);
        to.extend(&self.writer[..12]);
        submessage(INFO_TIMESTAMP, LITTLE_ENDIAN, 8, to);
        words(self.time, to);
    }

    /// The whole sample.
    fn data(&self, to: &mut Vec<u8>) {
        submessage(DATA, LITTLE_ENDIAN | HAS_DATA, 20 + self.payload.len(), to);
        self.entities(16, to);
        to.extend(self.payload);
    }

    /// A fragment; fragments count from 1.
    fn fragment(&self, number: u32, size: u16, part: &[u8], to: &mut Vec<u8>) {
        submessage(DATA_FRAGMENT, LITTLE_ENDIAN, 32 + part.len(), to);
        self.entities(28, to);
        to.extend(number.to_le_bytes());
        to.extend(1u16.to_le_bytes());
        to.extend(size.to_le_bytes());
        // Messages of ROS have less than 4 GiB.
        to.extend(
            u32::try_from(self.payload.len())
                .unwrap_or(u32::MAX)
                .to_le_bytes(),
        );
        to.extend(part);
    }

    /// The flags, the distance from its end to the data, the readers, the writer and the number.
    fn entities(&self, distance: u16, to: &mut Vec<u8>) {
        to.extend(0u16.to_le_bytes());
        to.extend(distance.to_le_bytes());
        to.extend(ALL_READERS);
        to.extend(&self.writer[12..]);
        words(self.number, to);
    }
}

/// A number in two words, the high one first, each of which begins with its lowest byte.
fn words(number: u64, to: &mut Vec<u8>) {
    // Rotation by half swaps the words.
    to.extend(number.rotate_left(32).to_le_bytes());
}

/// The header of a submessage with `bytes` after it.
fn submessage(kind: u8, flags: u8, bytes: usize, to: &mut Vec<u8>) {
    to.extend([kind, flags]);
    // A longer one reaches to the end of the datagram, which 0 says.
    to.extend(u16::try_from(bytes).unwrap_or(0).to_le_bytes());
}

#[cfg(test)]
mod tests {
    use super::*;

    fn datagrams(payload: &[u8], fragment: u16) -> Vec<Vec<u8>> {
        let sample = Sample {
            writer: [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15],
            number: (1 << 32) + 7,
            time: (5 << 32) + 9,
            payload,
        };
        let mut sent = Vec::new();
        let all: Result<(), ()> = sample.send(fragment, |datagram| {
            sent.push(datagram.to_vec());
            Ok(())
        });
        all.unwrap();
        sent
    }

    fn u16_at(bytes: &[u8], at: usize) -> u16 {
        u16::from_le_bytes([bytes[at], bytes[at + 1]])
    }

    fn u32_at(bytes: &[u8], at: usize) -> u32 {
        u32::from(u16_at(bytes, at)) | u32::from(u16_at(bytes, at + 2)) << 16
    }

    #[test]
    fn payloads_are_whole_words_and_state_their_padding() {
        for length in 0..9 {
            let message = vec![9; length];
            let made: Result<Vec<u8>, ()> = payload(|to| {
                to.extend(&message);
                Ok(())
            });
            let made = made.unwrap();
            assert_eq!(made.len() % 4, 0);
            assert_eq!(made[..3], [0, 1, 0]);
            assert_eq!(made.len() - usize::from(made[3]), ENCAPSULATION + length);
            assert_eq!(made[ENCAPSULATION..][..length], message);
        }
    }

    #[test]
    fn a_small_sample_is_one_datagram() {
        let payload: Vec<u8> = (0..64).collect();
        let sent = datagrams(&payload, 64);
        assert_eq!(sent.len(), 1);
        let datagram = &sent[0];
        assert_eq!(datagram[..8], *b"RTPS\x02\x03\x01\x12");
        assert_eq!(datagram[8..20], [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11]);
        assert_eq!((datagram[20], u16_at(datagram, 22)), (INFO_TIMESTAMP, 8));
        assert_eq!((u32_at(datagram, 24), u32_at(datagram, 28)), (5, 9));
        assert_eq!((datagram[32], datagram[33]), (DATA, 5));
        assert_eq!(usize::from(u16_at(datagram, 34)), datagram.len() - 36);
        // The data begins 16 bytes after the field with the distance.
        assert_eq!(
            (u16_at(datagram, 38), datagram[40 + 16..].to_vec()),
            (16, payload)
        );
        assert_eq!(datagram[44..48], [12, 13, 14, 15]);
        assert_eq!((u32_at(datagram, 48), u32_at(datagram, 52)), (1, 7));
    }

    #[test]
    fn a_large_sample_is_fragments_that_count_from_one() {
        let payload: Vec<u8> = (0..200).collect();
        let sent = datagrams(&payload, 64);
        assert_eq!(sent.len(), 4);
        let mut whole: Vec<u8> = Vec::new();
        for (number, datagram) in (1..).zip(&sent) {
            assert_eq!((datagram[32], datagram[33]), (DATA_FRAGMENT, 1));
            assert_eq!(usize::from(u16_at(datagram, 34)), datagram.len() - 36);
            assert_eq!(u16_at(datagram, 38), 28);
            assert_eq!(u32_at(datagram, 56), number);
            assert_eq!((u16_at(datagram, 60), u16_at(datagram, 62)), (1, 64));
            assert_eq!(u32_at(datagram, 64), 200);
            assert!(datagram.len() <= usize::from(OVERHEAD) + 64);
            whole.extend(&datagram[40 + 28..]);
        }
        assert_eq!(whole, payload);
    }
}

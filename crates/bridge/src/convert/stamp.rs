use super::MessageError;
use crate::message::Time;

/// The nanoseconds of a second.
const SECOND: u32 = 1_000_000_000;

/// Returns a stamp in nanoseconds.
///
/// # Errors
/// Returns an error if it is negative, or if it has a whole second of nanoseconds.
pub fn nanoseconds(stamp: Time) -> Result<u64, MessageError> {
    let wrong = |what: String| {
        MessageError::new(
            "header.stamp",
            what,
            "publish the time since the epoch, or since the simulation began",
        )
    };
    let seconds = u64::try_from(stamp.sec).map_err(|_| wrong(format!("{} s is negative", stamp.sec)))?;
    if stamp.nanosec >= SECOND {
        return Err(wrong(format!("{} ns is a second or more", stamp.nanosec)));
    }
    Ok(seconds * u64::from(SECOND) + u64::from(stamp.nanosec))
}

/// The frame numbers of a topic. A number is the stamp in nanoseconds, so that a message has the same noise whenever it is
/// replayed, whatever was lost before it.
#[derive(Clone, Copy, Debug, Default)]
pub struct Frames {
    last: Option<(u64, u64)>,
}

/// The frame of a message.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stamped {
    /// The number of the frame, which keys its noise.
    pub number: u64,
    /// Whether the stamp equals the previous frame's.
    pub is_repeated: bool,
    /// Whether the stamp is earlier than the previous frame's: the simulation began again.
    pub is_earlier: bool,
}

impl Frames {
    /// Returns the frame of the next message. Where stamps do not advance, numbers are counted.
    ///
    /// # Errors
    /// Returns an error if the stamp is invalid.
    pub fn next(&mut self, stamp: Time) -> Result<Stamped, MessageError> {
        let time = nanoseconds(stamp)?;
        let is_repeated = self.last.is_some_and(|(before, _)| before == time);
        let is_earlier = self.last.is_some_and(|(before, _)| time < before);
        let number = match self.last {
            Some((before, number)) if before == time => number.wrapping_add(1),
            _ => time,
        };
        self.last = Some((time, number));
        Ok(Stamped {
            number,
            is_repeated,
            is_earlier,
        })
    }
}

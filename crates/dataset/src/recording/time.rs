//! Times of recordings.

use super::RecordingError;

/// A time in nanoseconds since the epoch of the clock.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Time {
    nanoseconds: u64,
}

const SECOND: u64 = 1_000_000_000;

/// The maximum seconds of ROS 2 stamps, which have 31 bits.
const END_S: f64 = 2_147_483_648.0;

impl Time {
    /// Converts seconds, rounded to the nearest nanosecond.
    ///
    /// # Errors
    /// Returns an error for negative times and from 2³¹ s, which are out of the range of ROS stamps.
    pub fn from_seconds(seconds: f64) -> Result<Self, RecordingError> {
        // False for NaN.
        let fits = (0.0..END_S).contains(&seconds);
        if !fits {
            return Err(RecordingError::Time { seconds });
        }
        let whole = seconds.floor();
        let rest = ((seconds - whole) * 1e9).round();
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "both are whole, and in their ranges"
        )]
        let nanoseconds = whole as u64 * SECOND + rest as u64;
        Ok(Self {
            nanoseconds: nanoseconds.min((1 << 31) * SECOND - 1),
        })
    }

    /// Returns the time of a frame, from 0, at `rate` frames per second.
    ///
    /// # Errors
    /// Returns the same errors as [`from_seconds`](Self::from_seconds).
    pub fn of_frame(frame: u64, rate: f64) -> Result<Self, RecordingError> {
        #[expect(clippy::cast_precision_loss, reason = "there are fewer than 2^53 frames")]
        let seconds = frame as f64 / rate;
        Self::from_seconds(seconds)
    }

    /// Returns the time this number of seconds later, rounded to the nearest nanosecond.
    ///
    /// # Errors
    /// Returns an error for negative seconds, and for times from 2³¹ s.
    pub fn plus(self, seconds: f64) -> Result<Self, RecordingError> {
        let nanoseconds = self.nanoseconds + Self::from_seconds(seconds)?.nanoseconds;
        if nanoseconds >= (1 << 31) * SECOND {
            return Err(RecordingError::Time {
                seconds: nanoseconds as f64 / 1e9,
            });
        }
        Ok(Self { nanoseconds })
    }

    /// Returns the time this number of nanoseconds after the epoch of the clock.
    #[must_use]
    pub const fn from_nanoseconds(nanoseconds: u64) -> Self {
        Self { nanoseconds }
    }

    /// Returns the nanoseconds since the epoch of the clock.
    #[must_use]
    pub fn nanoseconds(self) -> u64 {
        self.nanoseconds
    }

    /// Returns the integer seconds and the remaining nanoseconds.
    pub(super) fn stamp(self) -> (i32, u32) {
        let (seconds, rest) = (self.nanoseconds / SECOND, self.nanoseconds % SECOND);
        (
            i32::try_from(seconds).unwrap_or(i32::MAX),
            u32::try_from(rest).unwrap_or(0),
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounds_to_nanoseconds() {
        let stamp = |seconds| Time::from_seconds(seconds).map(Time::stamp).ok();
        assert_eq!(stamp(0.0), Some((0, 0)));
        assert_eq!(stamp(1.5), Some((1, 500_000_000)));
        assert_eq!(stamp(0.999_999_999_9), Some((1, 0)));
        assert_eq!(stamp(2_147_483_647.75), Some((i32::MAX, 750_000_000)));
        for none in [-1e-9, f64::NAN, f64::INFINITY, 2_147_483_648.0] {
            assert_eq!(stamp(none), None, "{none}");
        }
        let start = Time::from_seconds(1_700_000_000.25).unwrap();
        assert_eq!(
            start.plus(0.002_5).unwrap().nanoseconds(),
            1_700_000_000_252_500_000
        );
        assert!(start.plus(-1.0).is_err() && start.plus(5e8).is_err());
        assert_eq!(Time::of_frame(1, 30.0).unwrap().nanoseconds(), 33_333_333);
    }
}

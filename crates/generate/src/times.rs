//! The times of frames.

use crate::GenerateError;
use crate::context::Context;

/// The time between frames if nothing states it, seconds.
const INTERVAL_S: f64 = 1.0 / 30.0;

impl Context {
    /// Checks the times in the trajectory's file, after which formats name files.
    ///
    /// # Errors
    /// Returns an error if they are negative or do not increase.
    pub(crate) fn check_times(&self) -> Result<(), GenerateError> {
        let Some(times) = &self.times else {
            return Ok(());
        };
        let used = (times.len() as u64).min(self.file.recipe.frames_per_scene.saturating_add(1));
        let used = usize::try_from(used).unwrap_or(usize::MAX);
        let is_wrong = |pair: &[f64]| pair[0] < 0.0 || pair[1] <= pair[0];
        match times[..used].windows(2).position(is_wrong) {
            None => Ok(()),
            Some(index) => Err(self.unfit(
                "camera.trajectory",
                format!(
                    "the times of the poses {index} and {} are negative or do not increase",
                    index + 1
                ),
                "correct the file, or set output.interval_s",
            )),
        }
    }

    /// Returns the time of a frame of an arrangement, nanoseconds: the time of its pose in the trajectory's file, unless the recipe has an
    /// interval. A trajectory that begins again goes on one interval after its last pose.
    pub(crate) fn time_ns(&self, index: u64) -> u64 {
        match self.times.as_deref() {
            Some(times @ [first, .., before, last]) => {
                let (round, place) = (index / times.len() as u64, index % times.len() as u64);
                let time_s = usize::try_from(place).ok().and_then(|place| times.get(place));
                #[expect(clippy::cast_precision_loss, reason = "a number of rounds")]
                let passed_s = round as f64 * (last - first + (last - before));
                nanoseconds(time_s.copied().unwrap_or_default() + passed_s)
            }
            _ => {
                let interval_s = self.file.recipe.output.interval_s.unwrap_or(INTERVAL_S);
                #[expect(clippy::cast_precision_loss, reason = "a number of frames")]
                let time_s = index as f64 * interval_s;
                nanoseconds(time_s)
            }
        }
    }
}

/// Rounds seconds to nanoseconds, or to microseconds for times since 1970, which floats resolve to a quarter of a microsecond.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "times of files; the cast saturates"
)]
fn nanoseconds(time_s: f64) -> u64 {
    if time_s < 1e6 {
        (time_s * 1e9).round() as u64
    } else {
        (time_s * 1e6).round() as u64 * 1000
    }
}

#[cfg(test)]
mod tests {
    use super::nanoseconds;

    #[test]
    fn times_keep_the_digits_of_their_file() {
        assert_eq!(nanoseconds(1_305_031_102.175_304), 1_305_031_102_175_304_000);
        assert_eq!(nanoseconds(0.033_333_333), 33_333_333);
        assert_eq!(nanoseconds(-1.0), 0);
    }
}

//! Frames that take time: exposure blurs what moves, and sensors that roll read their rows one after another.
//!
//! The middle row's middle of the exposure is the time of the frame, its stamp. Ground truth is the scene at that time. Colours and the
//! images of a stereo pair are sums of linear light at several times ([`plan`]), each rendered in the rows that are exposed then; so they
//! have everything that moves in the scene, shadows and reflections included, and the same bytes in every run.

mod ages;
mod expose;
mod motion;
mod plan;
mod smear;

pub(super) use motion::Later;
pub use motion::{Moments, Passing, Twist};

pub(super) use ages::{Earlier, earlier, velocities};
pub(crate) use expose::exposed;
pub(super) use expose::{Colours, colours};

use std::collections::BTreeMap;

use oaktwin_base::diagnostic::{Message, message, opt};
use serde::{Deserialize, Serialize};

use self::plan::Timing;
use super::PlacedCamera;

/// The longest exposure and readout, ms: above those of any camera, and far below what would not be a frame.
const MAX_MS: f64 = 10_000.0;

/// How long the frames of a rig take.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Shutter {
    /// The exposure of each row, ms.
    pub exposure_ms: f64,
    /// The readout time, ms: how much later the last row is exposed than the first, on sensors that roll and in cameras whose sensor is unknown.
    /// By default the catalog's; 0 of unknown ones.
    pub readout_ms: Option<f64>,
}

impl Shutter {
    /// Checks the ranges.
    ///
    /// # Errors
    /// Returns what is wrong and what to do if a time is negative, not finite or above 10 s.
    pub fn check(&self) -> Result<(), Message> {
        let times = [("exposure", Some(self.exposure_ms)), ("readout", self.readout_ms)];
        for (name, time) in times {
            if let Some(time) = time.filter(|time| !(0.0..=MAX_MS).contains(time)) {
                return Err(message![
                    opt(name),
                    format!(": {time} ms is out of range; give 0 to {MAX_MS} ms")
                ]);
            }
        }
        Ok(())
    }

    /// Checks that a camera can expose and read a frame within the period of frames.
    ///
    /// # Errors
    /// Returns what is wrong and what to do if it cannot.
    pub fn check_period(&self, camera: &PlacedCamera, period_s: f64) -> Result<(), Message> {
        let timing = self.timing(camera.readout_s);
        // Times of files are rounded.
        let is_longer = |time_s: f64| time_s > period_s * (1.0 + 1e-3);
        let period = format!("the frame period of {:.4} ms", period_s * 1e3);
        if is_longer(timing.exposure_s) {
            return Err(message![
                opt("exposure"),
                format!(
                    ": {} ms is longer than {period}; expose for less, or render fewer frames per second",
                    self.exposure_ms
                )
            ]);
        }
        if is_longer(timing.readout_s) {
            return Err(message![
                format!(
                    "{}: reads its rows in {} ms, longer than {period}; render fewer frames per second, or set ",
                    camera.path,
                    timing.readout_s * 1e3
                ),
                opt("readout")
            ]);
        }
        Ok(())
    }

    /// Returns the exposure of a camera's rows and its readout time, s.
    #[must_use]
    pub fn times_s(&self, camera: &PlacedCamera) -> [f64; 2] {
        let timing = self.timing(camera.readout_s);
        [timing.exposure_s, timing.readout_s]
    }

    /// The times of a camera with a readout of its own, s.
    pub(crate) fn timing(&self, readout_s: Option<f64>) -> Timing {
        let given_s = self.readout_ms.map(|readout_ms| readout_ms * 1e-3);
        Timing {
            exposure_s: self.exposure_ms * 1e-3,
            readout_s: match readout_s {
                // A global shutter.
                Some(0.0) => 0.0,
                own => given_s.or(own).unwrap_or(0.0),
            },
        }
    }
}

/// Returns how long after the time of a frame each camera takes it, s, from ms by the cameras' names.
///
/// # Errors
/// Returns what is wrong and what to do if no camera has a name, or a time is negative, not finite or above 10 s.
pub(super) fn offsets_s(
    cameras: &[PlacedCamera],
    offsets_ms: &BTreeMap<String, f64>,
) -> Result<Vec<f64>, Message> {
    let mut offsets_s = vec![0.0; cameras.len()];
    for (asked, offset_ms) in offsets_ms {
        let option = || opt("camera-offset").with(format!("{asked}={offset_ms}"));
        if !(0.0..=MAX_MS).contains(offset_ms) {
            return Err(message![
                option(),
                format!(": is out of range; give 0 to {MAX_MS} ms")
            ]);
        }
        let Some(index) = cameras.iter().position(|camera| camera.is_called(asked)) else {
            let names: Vec<String> = cameras
                .iter()
                .map(|camera| camera.role.clone().unwrap_or_else(|| camera.path.clone()))
                .collect();
            return Err(message![
                option(),
                format!(": no such camera is rendered; choose one of {}", names.join(", "))
            ]);
        };
        offsets_s[index] = offset_ms * 1e-3;
    }
    Ok(offsets_s)
}

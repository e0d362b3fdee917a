//! What the inertial sensor of an OAK reports along a trajectory.
//!
//! [`motion`] interpolates the poses of the body smoothly, [`ImuSimulation`] yields the samples of the sensor one by one, and
//! [`write_euroc`] writes them. Memory does not depend on the number of samples.
//!
//! A sample is the momentary angular velocity and specific force in the frame of the sensor, with white noise, the random walk of the
//! bias, saturation and quantization of the part. It depends on the poses, the part, the rate and the seed only, not on
//! the frames of cameras.

use std::io::{BufWriter, Write};
use std::path::Path;

use oaktwin_base::diagnostic::{Finding, Level, Message, message, nearest, opt};
use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::DVec3;
use oaktwin_catalog::{Catalog, Device, InertialPart, Twin};
pub use oaktwin_dataset::ImuSample;
use oaktwin_dataset::euroc;
use oaktwin_dataset::recording::{RecordedImu, RecordingError, Time};
use oaktwin_depth::random::{NoiseStage, Stream, standard_normal};
use oaktwin_files::{AtomicFile, FileError, WrittenFile};
use oaktwin_imu::{Channel, ChannelNoise, Draws};
pub use oaktwin_imu::{Motion, MotionError};
use oaktwin_scene::Up;
use oaktwin_usd::asset::IMU;

use crate::progress::{Progress, Watch};
use crate::render::trajectory::TimedPose;

/// The rate in Hz unless the part reports less.
pub const DEFAULT_RATE_HZ: f64 = 400.0;

/// The highest rate in Hz, far above any part's.
const MAX_RATE_HZ: f64 = 100_000.0;

/// The maximum number of samples: seven hours at 8 kHz, or 25 GB of text.
const MAX_SAMPLES: f64 = 2e8;

/// Standard gravity in m/s².
const STANDARD_GRAVITY: f64 = 9.806_65;

/// Samples between two looks at the progress.
const BATCH: u64 = 4096;

/// An error of an inertial sensor's options: `what is wrong; what to do`.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{message}; {remedy}")]
pub struct ImuError {
    /// What is wrong.
    pub message: Message,
    /// What to do.
    pub remedy: Message,
    /// Whether the trajectory is at fault, and not an option.
    pub is_of_trajectory: bool,
}

/// A trajectory along which no inertial sensor can be simulated.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum TrajectoryError {
    /// A pose has no time.
    #[error("pose {index}: has no time, which an inertial sensor requires; give every pose a time")]
    NoTime {
        /// The index of the pose.
        index: usize,
    },
    /// The poses do not form a motion.
    #[error(transparent)]
    Motion(#[from] MotionError),
}

/// The options of an inertial sensor.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ImuOptions {
    /// The samples per second; by default 400, or the part's maximum if lower.
    pub rate_hz: Option<f64>,
    /// The noise seed.
    pub seed: u64,
}

/// The samples of an inertial sensor in order.
#[derive(Clone, Debug)]
pub struct ImuSimulation {
    motion: Motion,
    body_from_imu: RigidTransform,
    gravity: DVec3,
    start: Time,
    rate_hz: f64,
    count: u64,
    next: u64,
    stream: Stream,
    gyroscope: Channel,
    accelerometer: Channel,
    part: String,
}

/// Returns the inertial part of a device, or the named one instead.
///
/// # Errors
/// Returns an error if the name is unknown or names a part without accelerometer or gyroscope, or if no source names a part of
/// the device.
pub fn inertial_part<'a>(
    catalog: &'a Catalog,
    device: &Device,
    name: Option<&str>,
) -> Result<&'a InertialPart, ImuError> {
    let known = || {
        let parts = catalog.inertial_parts().iter().filter(|part| part.is_inertial());
        parts.map(|part| part.id.as_str())
    };
    let found = match name {
        Some(name) => catalog.inertial_part(name).filter(|part| part.is_inertial()),
        None => catalog.inertial_part_of(device),
    };
    found.ok_or_else(|| match name {
        Some(name) => ImuError {
            message: format!("unknown inertial part '{name}'").into(),
            remedy: match nearest(name, known()).first() {
                Some(near) => format!("did you mean '{near}'?").into(),
                None => format!("choose one of {}", known().collect::<Vec<_>>().join(", ")).into(),
            },
            is_of_trajectory: false,
        },
        None => ImuError {
            message: format!("no source names the inertial part of the {}", device.name).into(),
            remedy: message!["choose one with ", opt("imu-part")],
            is_of_trajectory: false,
        },
    })
}

/// Returns the motion through the poses of a trajectory.
///
/// # Errors
/// Returns an error if there are fewer than two poses, one has no time, or the times do not increase.
pub fn motion(poses: &[TimedPose]) -> Result<Motion, TrajectoryError> {
    let timed = poses.iter().enumerate().map(|(index, pose)| {
        let time_s = pose.time_s.ok_or(TrajectoryError::NoTime { index })?;
        Ok((time_s, pose.world_from_mount))
    });
    Ok(Motion::new(&timed.collect::<Result<Vec<_>, TrajectoryError>>()?)?)
}

impl ImuSimulation {
    /// Creates the samples of a twin's inertial sensor along the motion of its body, in a world with this up axis.
    ///
    /// # Errors
    /// Returns an error if the device has no inertial sensor, the rate is out of range, there are too many samples, or times are out of
    /// the range of recordings.
    pub fn new(
        twin: &Twin,
        part: &InertialPart,
        motion: Motion,
        up: Up,
        options: ImuOptions,
    ) -> Result<(Self, Vec<Finding>), ImuError> {
        let body_from_imu = twin.body_from_imu.ok_or_else(|| ImuError {
            message: format!(
                "the {} has no inertial sensor whose pose is known",
                twin.device.name
            )
            .into(),
            remedy: "choose another model, or describe its pose in a catalog file".into(),
            is_of_trajectory: false,
        })?;
        let default_hz = part
            .max_rate_hz()
            .map_or(DEFAULT_RATE_HZ, |hz| hz.min(DEFAULT_RATE_HZ));
        let rate_hz = options.rate_hz.unwrap_or(default_hz);
        let count = sample_count(&motion, rate_hz)?;
        let out_of_range = |error: RecordingError| ImuError {
            message: error.to_string().into(),
            remedy: "shift the times of the poses".into(),
            is_of_trajectory: true,
        };
        let start = Time::from_seconds(motion.start_s()).map_err(out_of_range)?;
        start.plus(motion.duration_s()).map_err(out_of_range)?;
        let stream = Stream::new(options.seed, IMU);
        let channel = |noise: Option<ChannelNoise>, item| {
            let turn_on = draws(&stream, 0, item + 2).white;
            Channel::new(noise.unwrap_or(ChannelNoise::NONE), rate_hz, turn_on)
        };
        let findings = findings(part, &motion, rate_hz);
        Ok((
            Self {
                gyroscope: channel(part.gyroscope_noise(), GYROSCOPE),
                accelerometer: channel(part.accelerometer_noise(), ACCELEROMETER),
                motion,
                body_from_imu,
                gravity: -STANDARD_GRAVITY * up.direction(),
                start,
                rate_hz,
                count,
                next: 0,
                stream,
                part: part.id.clone(),
            },
            findings,
        ))
    }

    /// Returns the samples per second.
    #[must_use]
    pub const fn rate_hz(&self) -> f64 {
        self.rate_hz
    }

    /// Returns the pose of the sensor in the body's frame, metres.
    #[must_use]
    pub const fn body_from_imu(&self) -> &RigidTransform {
        &self.body_from_imu
    }

    /// Returns the number of samples of the whole trajectory.
    #[must_use]
    pub const fn sample_count(&self) -> u64 {
        self.count
    }

    /// Returns the id of the part.
    #[must_use]
    pub fn part(&self) -> &str {
        &self.part
    }

    /// Returns the description of the sensor in recordings, on a body with this name.
    #[must_use]
    pub fn recorded(&self, name: &str, body: &str) -> RecordedImu {
        RecordedImu {
            name: name.to_owned(),
            body: body.to_owned(),
            body_from_imu: self.body_from_imu,
            angular_velocity_deviation: self.gyroscope.white_deviation(),
            linear_acceleration_deviation: self.accelerometer.white_deviation(),
        }
    }
}

/// The items of random numbers.
const GYROSCOPE: u32 = 0;
const ACCELEROMETER: u32 = 1;

fn draws(stream: &Stream, sample: u64, item: u32) -> Draws {
    let plane = stream.plane(NoiseStage::Inertial, sample, item);
    let pairs = [0, 1].map(|block| {
        let [a, b, c, d] = plane.words(block, 0);
        [standard_normal(a, b), standard_normal(c, d)]
    });
    let [[[x, y], [z, _]], [[p, q], [r, _]]] = pairs;
    Draws {
        white: DVec3::new(x, y, z),
        walk: DVec3::new(p, q, r),
    }
}

impl ImuSimulation {
    /// Returns the same samples with the stamps of an EuRoC sequence that begins at this time, nanoseconds; see [`euroc::stamp`].
    #[must_use]
    pub fn in_sequence(self, first_ns: u64) -> Self {
        Self {
            start: Time::from_nanoseconds(euroc::stamp(first_ns)),
            ..self
        }
    }

    /// Returns the time of the first sample, nanoseconds.
    #[must_use]
    pub fn first_ns(&self) -> u64 {
        self.start.nanoseconds()
    }

    /// Returns the biases of the gyroscope, rad/s, and of the accelerometer, m/s², in the next sample.
    #[must_use]
    pub fn biases(&self) -> [DVec3; 2] {
        [self.gyroscope.bias(), self.accelerometer.bias()]
    }
}

#[expect(clippy::cast_precision_loss, reason = "there are fewer than 2^53 samples")]
impl Iterator for ImuSimulation {
    type Item = ImuSample;

    fn next(&mut self) -> Option<ImuSample> {
        if self.next >= self.count {
            return None;
        }
        let sample = self.next;
        self.next += 1;
        let since_start_s = sample as f64 / self.rate_hz;
        let truth = self
            .motion
            .at(since_start_s)
            .reading(&self.body_from_imu, self.gravity);
        let of = |item| draws(&self.stream, sample, item);
        let (gyroscope, accelerometer) = (of(GYROSCOPE), of(ACCELEROMETER));
        Some(ImuSample {
            // The last time was checked.
            time: self.start.plus(since_start_s).unwrap_or(self.start),
            angular_velocity: self.gyroscope.measure(truth.angular_velocity, gyroscope),
            linear_acceleration: self.accelerometer.measure(truth.specific_force, accelerometer),
        })
    }
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "in range")]
fn sample_count(motion: &Motion, rate_hz: f64) -> Result<u64, ImuError> {
    // False for NaN.
    let is_valid = rate_hz > 0.0 && rate_hz <= MAX_RATE_HZ;
    if !is_valid {
        return Err(ImuError {
            message: message![opt("imu-rate").with(rate_hz), " is out of range"],
            remedy: format!("give Hz above 0, at most {MAX_RATE_HZ}").into(),
            is_of_trajectory: false,
        });
    }
    // A millionth of a sample makes up for the rounding of times.
    let count = (motion.duration_s() * rate_hz + 1e-6).floor() + 1.0;
    if count > MAX_SAMPLES {
        return Err(ImuError {
            message: format!(
                "{} s at {rate_hz} Hz are {count:.3e} samples, more than {MAX_SAMPLES:.0e}",
                motion.duration_s()
            )
            .into(),
            remedy: message!["check the times of the poses, or lower ", opt("imu-rate")],
            is_of_trajectory: true,
        });
    }
    Ok(count as u64)
}

fn findings(part: &InertialPart, motion: &Motion, rate_hz: f64) -> Vec<Finding> {
    let mut findings = Vec::new();
    if let Some((index, turn)) = motion.large_turn() {
        findings.push(Finding::new(
            "large-turn",
            Level::Warning,
            "trajectory",
            format!(
                "turns by {:.0}° after pose {index}; above 90° the rotation between two poses is uncertain",
                turn.to_degrees()
            ),
            "give more poses",
        ));
    }
    if let Some(max_hz) = part.max_rate_hz().filter(|max_hz| rate_hz > *max_hz) {
        findings.push(Finding::new(
            "imu-rate",
            Level::Warning,
            &part.id,
            format!("reports at most {max_hz} Hz, not {rate_hz} Hz"),
            message!["lower ", opt("imu-rate")],
        ));
    }
    let is_unknown = [part.accelerometer_noise(), part.gyroscope_noise()]
        .into_iter()
        .flatten()
        .any(|noise| noise.random_walk == DVec3::ZERO);
    if is_unknown {
        let message = "no source states the random walk of its biases; it is 0";
        findings.push(Finding::new("imu-noise", Level::Note, &part.id, message, ""));
    }
    findings
}

/// Writes all samples as CSV in the format of the EuRoC data sets. Returns the file, or `None` if the task was interrupted, which
/// leaves no file.
///
/// # Errors
/// Returns an error if the file cannot be written.
pub fn write_euroc(
    samples: ImuSimulation,
    path: &Path,
    watch: &Watch<'_>,
) -> Result<Option<WrittenFile>, FileError> {
    let total = samples.sample_count();
    let failed = |error: std::io::Error| FileError::writing(path, &error);
    let mut output = BufWriter::new(AtomicFile::create(path)?);
    output.write_all(euroc::HEADER.as_bytes()).map_err(failed)?;
    for (done, sample) in (0u64..).zip(samples) {
        if done % BATCH == 0 && watch(Progress { done, total }).is_break() {
            return Ok(None);
        }
        write!(output, "{}", euroc::EurocLine(&sample)).map_err(failed)?;
    }
    let file = output.into_inner().map_err(|error| failed(error.into_error()))?;
    let (path, bytes) = file.finish()?;
    Ok(Some(WrittenFile { path, bytes }))
}

#[cfg(test)]
mod tests;

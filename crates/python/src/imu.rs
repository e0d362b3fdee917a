use numpy::{PyArray1, PyArrayMethods};
use oaktwin::imu::{self, ImuOptions, ImuSample, ImuSimulation};
use oaktwin::memory;
use oaktwin::render::trajectory::TimedPose;
use oaktwin::scene::Up;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::array::numbers;
use crate::choice::named;
use crate::device::{self, Device};
use crate::error::{error, text, wrong};
use crate::finding;
use crate::pose::Of;
use crate::settings::seed_or_entropy;

/// The bytes of a sample: its time and two vectors, in the list and in the arrays.
const SAMPLE_BYTES: u64 = 2 * 7 * 8;

/// Samples between two looks for Ctrl-C.
const BATCH: usize = 1 << 16;

/// Simulates the inertial sensor of a device along a trajectory, as `oaktwin render --imu` does.
///
/// times: (N,) the times of the poses in seconds, increasing; at least two.
/// poses: (N, 4, 4) world_from_body: the poses of the device's body, metres; a `CameraPose` is rejected.
/// rate: the samples per second; by default 400, or the part's maximum if lower.
/// part: the inertial part, such as "BMI270"; by default the device's.
/// seed: the noise seed; None for one of fresh entropy.
/// up: the vertical axis of the world, "z" or "y".
///
/// Returns a mapping: "timestamp" (M,) int64 nanoseconds, "angular_velocity" (M, 3) float64 rad/s and "linear_acceleration"
/// (M, 3) float64 m/s², which is +9.81 upwards at rest; both in the frame of the sensor, `device.extrinsics("imu", "body")`;
/// and "seed".
///
/// Warns with oaktwin.FindingWarning. Raises oaktwin.Error for invalid input, and for a device without an inertial sensor.
#[pyfunction]
#[pyo3(signature = (device, times, poses, *, rate = None, part = None, seed = 0, up = "z"))]
#[expect(clippy::needless_pass_by_value, reason = "required by PyO3")]
#[expect(clippy::too_many_arguments, reason = "options of Python")]
pub(crate) fn simulate_imu<'py>(
    py: Python<'py>,
    #[pyo3(from_py_with = device::argument::required)] device: Bound<'py, Device>,
    times: &Bound<'py, PyAny>,
    poses: &Bound<'py, PyAny>,
    rate: Option<f64>,
    part: Option<&str>,
    #[pyo3(from_py_with = seed_or_entropy)] seed: u64,
    up: &str,
) -> PyResult<Bound<'py, PyDict>> {
    let up: Up = named("up", up)?;
    let path = trajectory(times, poses)?;
    let device = device.get();
    let twin = &device.twin;
    let part = imu::inertial_part(device.models.get(), &twin.device, part).map_err(error)?;
    let motion = imu::motion(&path).map_err(|cause| error(format!("poses: {cause}")))?;
    let options = ImuOptions { rate_hz: rate, seed };
    let (mut samples, findings) = ImuSimulation::new(twin, part, motion, up, options).map_err(|cause| {
        if cause.is_of_trajectory {
            error(format!("times: {}", text(&cause)))
        } else {
            error(cause)
        }
    })?;
    memory::check(samples.sample_count().saturating_mul(SAMPLE_BYTES)).map_err(|shortage| {
        let what = format!("{} samples: {}", samples.sample_count(), shortage.what());
        wrong("poses", what, "pass a shorter trajectory, or a lower rate")
    })?;
    let mut all: Vec<ImuSample> = Vec::new();
    loop {
        let more: Vec<ImuSample> = py.detach(|| samples.by_ref().take(BATCH).collect());
        if more.is_empty() {
            break;
        }
        all.extend(more);
        py.check_signals()?;
    }
    finding::warn(py, &findings)?;
    let vectors = |of: fn(&ImuSample) -> [f64; 3]| {
        let numbers: Vec<f64> = all.iter().flat_map(of).collect();
        PyArray1::from_vec(py, numbers).reshape([all.len(), 3])
    };
    let stamps = all.iter().map(|sample| sample.time.nanoseconds().cast_signed());
    let arrays = PyDict::new(py);
    arrays.set_item("timestamp", PyArray1::from_iter(py, stamps))?;
    arrays.set_item(
        "angular_velocity",
        vectors(|sample| sample.angular_velocity.to_array())?,
    )?;
    arrays.set_item(
        "linear_acceleration",
        vectors(|sample| sample.linear_acceleration.to_array())?,
    )?;
    arrays.set_item("seed", seed)?;
    Ok(arrays)
}

fn trajectory(times: &Bound<'_, PyAny>, object: &Bound<'_, PyAny>) -> PyResult<Vec<TimedPose>> {
    let (shape, array) = numbers("times", times)?;
    let (poses, is_batch) = Of::Body.several("poses", object)?;
    if !is_batch || shape[..] != [poses.len()] {
        let found = format!("has shape {shape:?} for {} poses", poses.len());
        return Err(wrong("times", found, "pass times (N,) and poses (N, 4, 4)"));
    }
    let seconds = array.as_slice().map_err(error)?;
    let timed = seconds
        .iter()
        .zip(poses)
        .map(|(time_s, world_from_mount)| TimedPose {
            time_s: Some(*time_s),
            world_from_mount,
        });
    Ok(timed.collect())
}

use oaktwin::camera::{ImageSize, OpenCv};
use pyo3::prelude::*;

use super::DepthSensor;

/// What the kernels of `oaktwin.warp` need to know of a pair that has drifted, for images of a size: fx, fy, cx and cy of the actual cameras,
/// the rotation (by columns) and the translation from the left to the right camera, the focal length and baseline of the calibration, the factor
/// of the processor, and whether there is drift besides it. None without either.
#[pyfunction]
pub(crate) fn _drift(
    py: Python<'_>,
    sensor: &Bound<'_, DepthSensor>,
    width: u32,
    height: u32,
) -> PyResult<Option<Vec<f64>>> {
    let size = ImageSize::new(width, height);
    let made = sensor.get().now(py, Some(size))?.sensor;
    Ok(made.drifted().map(|pair| {
        let (matches, scale) = pair.matches(size);
        let actual = matches.actual;
        let centre = actual.principal_point::<OpenCv>();
        let pose = matches.right_from_left;
        let mut numbers = vec![actual.fx, actual.fy, centre.x, centre.y];
        numbers.extend(pose.rotation.to_cols_array());
        numbers.extend(pose.translation.to_array());
        numbers.extend([matches.stereo.focal_length_px, matches.stereo.baseline_m, scale]);
        numbers.push(f64::from(u8::from(!pair.drift.is_none())));
        numbers
    }))
}

//! Rendered stereo pairs as NumPy arrays.

use oaktwin::camera::{self, ImageSize, LensModel, StereoDrift};
use oaktwin::depth::imager;
use oaktwin::pair::{Pair, PairCameras, PairOptions};
use oaktwin::render::check_size;
use oaktwin::sensor::{SensorOptions, stereo_cameras};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::camera::Camera;
use crate::device::Device;
use crate::error::error;
use crate::grey::recorded;
use crate::images::array;
use crate::memory::check_free;
use crate::settings::assignments;

/// The bytes per pixel: light, recorded value, rectification map and rectified value of both cameras, and the ground
/// truth.
const BYTES_OF_PIXEL: u64 = 2 * (3 * 4 + 2 + 8 + 2) + 4;

/// The options of `Scene.render_pair`.
pub(crate) struct PairSettings<'a, 'py> {
    /// The depth sensor whose pair is rendered; by default the device's first pair.
    pub(crate) sensor: Option<&'a str>,
    pub(crate) size: Option<(u32, u32)>,
    pub(crate) projector: f64,
    pub(crate) ambient: f64,
    pub(crate) imager: Option<&'a Bound<'py, PyAny>>,
    pub(crate) seed: u64,
    pub(crate) device_seed: Option<u64>,
    pub(crate) drift: Option<String>,
}

impl PairSettings<'_, '_> {
    pub(crate) fn options(&self, device: &Device) -> PyResult<PairOptions> {
        let mut sensors = imager::Parameters::default();
        if let Some(values) = self.imager {
            for (name, value) in assignments("imager", values)? {
                sensors
                    .set(&name, &value)
                    .map_err(|failed| error(format!("imager: {failed}")))?;
            }
        }
        let size = self.size.map(|(width, height)| ImageSize::new(width, height));
        let cameras = stereo_cameras(&device.twin, self.sensor).map_err(error)?;
        let own = device.twin.camera(cameras.0).map(|left| left.intrinsics.size);
        if let Some(size) = size.or(own) {
            check_memory(device, size)?;
        }
        let drift = self.drift.as_deref().map(StereoDrift::parse).transpose();
        let sensor = SensorOptions {
            seed: self.seed,
            device_seed: self.device_seed,
            drift: drift.map_err(error)?,
            ..SensorOptions::default()
        };
        let options = PairOptions {
            cameras,
            imager: sensors,
            projector: self.projector,
            ambient: self.ambient,
            lens: device.lens,
            size,
            ..PairOptions::default()
        };
        options.of_sensor(&sensor).map_err(error)
    }
}

fn check_memory(device: &Device, size: ImageSize) -> PyResult<()> {
    let name = &device.twin.device.name;
    check_size(size).map_err(|found| error(format!("{name}: {found}")))?;
    let needed = u64::from(size.width) * u64::from(size.height) * BYTES_OF_PIXEL;
    check_free(name, needed, "reduce the image size")
}

/// The geometry of the rectified pair.
pub(crate) struct Rectified {
    left: Camera,
    baseline_m: f64,
}

impl Rectified {
    pub(crate) fn of(cameras: &PairCameras) -> Self {
        let geometry = cameras.rectify().geometry();
        let left = camera::Camera::new(geometry.left, LensModel::Pinhole);
        Self {
            left: Camera::rectified(left, cameras.body_from_rectified_left()),
            baseline_m: geometry.baseline,
        }
    }
}

/// Returns a dictionary of arrays by name, with the geometry of the rectified pair.
pub(crate) fn arrays(py: Python<'_>, pair: Pair, rectified: Rectified) -> PyResult<Bound<'_, PyDict>> {
    let all = PyDict::new(py);
    all.set_item("left", recorded(py, pair.left)?)?;
    all.set_item("right", recorded(py, pair.right)?)?;
    all.set_item("rectified_left", recorded(py, pair.rectified_left)?)?;
    all.set_item("rectified_right", recorded(py, pair.rectified_right)?)?;
    all.set_item("z", array(py, pair.z.0)?)?;
    all.set_item("camera", rectified.left)?;
    all.set_item("baseline", rectified.baseline_m)?;
    Ok(all)
}

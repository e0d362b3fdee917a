pub(crate) mod argument;
mod make;
mod parts;

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;

use numpy::PyArray2;
use oaktwin::camera::RectifiedIntrinsics;
use oaktwin::catalog::{Origin, Role, Twin};
use oaktwin::diagnostic;
use oaktwin::report::DeviceReport;
use oaktwin::sensor::depth_sensor;
use oaktwin::usd::asset::LensChoice;
use pyo3::prelude::*;
use pyo3::types::PyDict;

pub(crate) use make::_device;
use make::{Calibrated, Choices};

use crate::arguments::{count, isaac, seed};
use crate::asset::{self, AssetSettings};
use crate::camera::Camera;
use crate::choice::named;
use crate::error::{error, writing, wrong};
use crate::finding::{self, Finding};
use crate::json;
use crate::models::Models;
use crate::pose::rows;
use crate::rectification::Rectification;
use crate::robot;

/// A digital twin of a depth camera: the nominal device of a model, or one unit by its calibration.
///
/// model: the name, such as "OAK4-D"; case, spaces, hyphens and underscores are ignored. See `models()`.
/// lens: "pinhole" (default), or "fisheye" for the left and right cameras of the wide models.
/// imu_frame: the source of the axes of the inertial unit, about which sources disagree: "driver" (default, RTAB-Map's) or "board-file" (the
///     vendor's). A calibration with inertial extrinsics has its own.
/// catalog: a folder of TOML files with additional devices and sensors. Unpickling reads it again.
///
/// Frames: a camera's is OpenCV's (x right, y down, z forward); the body's is x forward, y left, z up, with the origin midway
/// between the left and right optical centres. Metres.
///
/// Raises oaktwin.Error for an unknown model, with the nearest names, or a lens that the model does not have.
#[pyclass(frozen, module = "oaktwin")]
#[derive(Debug)]
pub(crate) struct Device {
    pub(crate) twin: Arc<Twin>,
    pub(crate) lens: LensChoice,
    choices: Choices,
    pub(crate) findings: Vec<diagnostic::Finding>,
    pub(crate) models: Models,
    calibration: Option<Calibrated>,
}

#[pymethods]
impl Device {
    #[new]
    #[pyo3(signature = (model, *, lens = "pinhole", imu_frame = "driver", catalog = None))]
    fn py_new(
        py: Python<'_>,
        model: &str,
        lens: &str,
        imu_frame: &str,
        catalog: Option<PathBuf>,
    ) -> PyResult<Self> {
        let choices = Choices::new(lens, imu_frame)?;
        let models = Models::open(catalog)?;
        let device = parts::entry(&models, model)?;
        let findings: Vec<_> = device.stand_in(model).into_iter().collect();
        let twin = models.get().nominal(&device.with_imu_frame(choices.imu_frame));
        let made = Self::new(twin, choices, models, None, findings)?;
        finding::warn(py, &made.findings)?;
        Ok(made)
    }

    /// Creates the twin of one unit from its DepthAI calibration (JSON).
    ///
    /// calibration: the path of the file; its text, as a string or bytes; its content as a dictionary; or a `CalibrationHandler` of
    ///     DepthAI.
    /// model: the model of the unit; by default the product name in the calibration. A calibration of no model is a rig, such as two cameras on
    ///     an FFC board, whose cameras are known from it alone: `StereoMatcher` matches their images.
    /// pair: the sockets of the left and the right camera of a rig, such as ("CAM_B", "CAM_C"); by default those that the calibration names.
    /// platform: the processor of a rig, "rvc2" (default) or "rvc4".
    /// force: whether to ignore calibration errors, which become findings.
    /// lens: see `Device`; a calibrated camera always has its own lens.
    /// imu_frame: see `Device`; a finding says if the calibration has its own.
    /// catalog: see `Device`.
    ///
    /// Warnings about the file are in `findings`. Raises FileNotFoundError and other OSErrors for files that cannot be read,
    /// oaktwin.Error for an invalid calibration or one of another model.
    #[staticmethod]
    #[expect(clippy::too_many_arguments, reason = "options of Python")]
    #[pyo3(signature = (calibration, model = None, *, pair = None, platform = None, force = false, lens = "pinhole", imu_frame = "driver", catalog = None))]
    fn from_calibration(
        calibration: &Bound<'_, PyAny>,
        model: Option<&str>,
        pair: Option<(String, String)>,
        platform: Option<&str>,
        force: bool,
        lens: &str,
        imu_frame: &str,
        catalog: Option<PathBuf>,
    ) -> PyResult<Self> {
        let choices = Choices::new(lens, imu_frame)?.with_rig(pair, platform)?;
        let raw = parts::calibration(calibration)?;
        let path = PathBuf::from(&raw.name);
        Self::unit(Models::open(catalog)?, raw, model, &path, force, choices)
    }

    /// Returns units of the model with realistic variation: their cameras are drawn around the nominal values with the spread of
    /// factory calibrations.
    ///
    /// count: the number of units, 1 to 10000.
    /// seed: the seed of the population; a unit depends on the model, the seed and its number.
    ///
    /// A unit has a calibration, which `oaktwin population` also writes. Its findings state the source of the spread. Raises
    /// oaktwin.Error for the device of a calibration.
    #[pyo3(signature = (count, *, seed = 0))]
    fn population(
        &self,
        #[pyo3(from_py_with = count)] count: u64,
        #[pyo3(from_py_with = seed)] seed: u64,
    ) -> PyResult<Vec<Self>> {
        self.units(count, seed)
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let calibration = self.calibration.as_ref();
        let calibration = calibration.map(|own| (&own.raw.name, own.raw.to_text(), own.force));
        let restore = py.import("oaktwin._oaktwin")?.getattr("_device")?;
        let is_rig = self.calibration.as_ref().is_some_and(|own| own.is_rig);
        let model = (!is_rig).then(|| self.name());
        let state = (model, self.choices.names(), self.models.folder(), calibration);
        Ok((restore, state).into_pyobject(py)?.into_any())
    }

    /// The name of the model.
    #[getter]
    fn name(&self) -> &str {
        &self.twin.device.name
    }

    /// "nominal", or the calibration file's name.
    #[getter]
    fn origin(&self) -> &str {
        match &self.twin.origin {
            Origin::Nominal => "nominal",
            Origin::Calibration { file_name, .. } => file_name,
        }
    }

    /// The findings about the calibration, or about a model that stands in for another.
    #[getter]
    fn findings(&self) -> Vec<Finding> {
        finding::list(&self.findings)
    }

    /// The cameras by role: "rgb", "left", "right", "tof".
    #[getter]
    fn cameras(&self) -> PyResult<BTreeMap<&'static str, Camera>> {
        let roles = self.twin.cameras.iter().map(|camera| camera.spec.role.as_str());
        roles.map(|role| Ok((role, self.placed(role)?))).collect()
    }

    /// Returns the camera of a depth sensor's images: a pinhole with the depth sensor's clipping range. For a calibrated
    /// stereo pair, it is the device's rectified left camera, as in `StereoMatcher`: rotated, and on RVC2 with the right camera's K.
    ///
    /// sensor: "stereo", "tof" or a prim; by default "tof" if the device has it.
    #[pyo3(signature = (sensor = None))]
    fn depth_camera(&self, sensor: Option<&str>) -> PyResult<Camera> {
        let sensor = depth_sensor(&self.twin, sensor).map_err(error)?;
        self.placed(&sensor.spec.prim)
    }

    /// The parameters of the depth sensors by kind ("stereo", "tof"; further stereo pairs by prim), with the catalog's names, which
    /// include units.
    #[getter]
    fn depth_sensors<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let sensors = PyDict::new(py);
        for sensor in &self.twin.depth_sensors {
            let spec = json::to_python(py, &sensor.spec)?;
            spec.set_item("focal_length_px", sensor.focal_length_px)?;
            let kind = sensor.spec.kind.as_str();
            // A device with several stereo pairs.
            let key = if sensors.contains(kind)? {
                &sensor.spec.prim
            } else {
                kind
            };
            sensors.set_item(key, spec)?;
        }
        Ok(sensors)
    }

    /// (4, 4) float64, target_from_source: takes points in the frame of one part to the frame of another, metres.
    ///
    /// source, target: a camera's role ("rgb", "left", "right", "tof"), "imu" or "body".
    ///
    /// Raises oaktwin.Error for a part that the device does not have.
    fn extrinsics<'py>(
        &self,
        py: Python<'py>,
        source: &str,
        target: &str,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        rows(py, &(self.body_from(target)?.inverse() * self.body_from(source)?))
    }

    /// The rectification of the stereo pair at the size of its images, as cv2.stereoRectify computes it.
    ///
    /// intrinsics: the intrinsics of the rectified images: "right-camera" (RVC2), "left-camera" (RVC4 and DepthAI's host), "zero-disparity"
    ///     (OpenCV's default) or "free-disparity" (OpenCV without CALIB_ZERO_DISPARITY); by default those of the device's processor, and
    ///     OpenCV's for devices of other makers.
    ///
    /// Raises oaktwin.Error for a device without a stereo pair, or cameras that cannot be rectified.
    #[pyo3(signature = (*, intrinsics = None))]
    fn rectification(&self, intrinsics: Option<&str>) -> PyResult<Rectification> {
        if [Role::Left, Role::Right]
            .iter()
            .any(|role| self.twin.camera(*role).is_none())
        {
            return Err(wrong(self.name(), "has no stereo pair", "use another model"));
        }
        let own = || match self.twin.platform() {
            Some(platform) => RectifiedIntrinsics::of(platform).name(),
            None => "zero-disparity",
        };
        let intrinsics = intrinsics.unwrap_or_else(own);
        Rectification::of(self.placed("left")?, self.placed("right")?, intrinsics)
    }

    /// Writes the USD asset for Isaac Sim and Omniverse.
    ///
    /// path: the file: .usd or .usda for text, .usdz for a package.
    /// isaac: the version of Isaac Sim, "5.1" or "6".
    /// target: "isaac", or "ovrtx" (experimental).
    /// aperture_offsets: the representation of a calibrated principal point: "openusd", "document" or "zero".
    /// extended_disparity: whether the depth sensor uses the extended mode.
    /// legacy_distortion: whether to write the old distortion attributes too.
    /// rigid_body: whether to add mass and a collider.
    /// body: whether to add the visible body.
    /// over: an existing asset of the model: the file is then a layer of overrides on it, which refers to it by a relative path.
    /// scene_limit: a factor on the limits on the prims, references and instances of `over`; by default 1.
    ///
    /// Warns with oaktwin.FindingWarning. Raises oaktwin.Error for an option that the model does not support or an unknown
    /// extension, OSError for files that cannot be written; incomplete files are removed.
    #[pyo3(
        signature = (path, *, isaac = "5.1".to_owned(), target = "isaac", aperture_offsets = "openusd", extended_disparity = false,
            legacy_distortion = false, rigid_body = false, body = true, over = None, scene_limit = 1.0),
        text_signature = "($self, path, *, isaac='5.1', target='isaac', aperture_offsets='openusd', extended_disparity=False, \
            legacy_distortion=False, rigid_body=False, body=True, over=None, scene_limit=1.0)"
    )]
    #[expect(clippy::too_many_arguments, reason = "options of Python")]
    #[expect(clippy::fn_params_excessive_bools, reason = "options of Python")]
    #[expect(clippy::needless_pass_by_value, reason = "what PyO3 hands over")]
    fn write_usd(
        &self,
        py: Python<'_>,
        path: PathBuf,
        #[pyo3(from_py_with = isaac)] isaac: String,
        target: &str,
        aperture_offsets: &str,
        extended_disparity: bool,
        legacy_distortion: bool,
        rigid_body: bool,
        body: bool,
        over: Option<PathBuf>,
        scene_limit: f64,
    ) -> PyResult<()> {
        let settings = AssetSettings {
            isaac: &isaac,
            target,
            aperture_offsets,
            extended_disparity,
            legacy_distortion,
            rigid_body,
            body,
        };
        let options = settings.options(self.lens)?;
        let format = asset::format(&path)?;
        let limit = asset::scene_limit(scene_limit)?;
        let twin = &self.twin;
        let (bytes, findings) = py.detach(|| match &over {
            Some(base) => asset::overrides(twin, &options, format, (base, limit), &path),
            None => asset::bytes(twin, &options, format),
        })?;
        py.detach(|| oaktwin::files::write(&path, &bytes))
            .map_err(|error| writing(&path, &error))?;
        finding::warn(py, &findings)
    }

    /// Writes a description for robots and simulators, and returns the paths of its files.
    ///
    /// folder: the folder for the files, which is created.
    /// format: "urdf", "sdf", "drake", "mjcf", "webots" or "blender".
    /// name: the name of the device, the prefix of its frames.
    /// parent: the robot's link that carries the device.
    /// mount: the point of the device that xyz places: "cameras" (midway between the left and the right optical centre), or the centre of
    ///     the housing's face "front", "back", "bottom" or "top".
    /// xyz: the position of that point in the parent's frame in metres; by default its origin.
    /// rpy: roll, pitch and yaw of the device in the parent's frame in radians; by default 0.
    ///
    /// Warns with oaktwin.FindingWarning about what the format cannot represent. Raises oaktwin.Error for an unknown format or an invalid
    /// name, OSError for files that cannot be written.
    #[pyo3(signature = (folder, format, *, name = "oak", parent = None, mount = "cameras", xyz = None, rpy = None))]
    #[expect(clippy::too_many_arguments, reason = "options of Python")]
    #[expect(clippy::needless_pass_by_value, reason = "what PyO3 hands over")]
    fn export(
        &self,
        py: Python<'_>,
        folder: PathBuf,
        format: &str,
        name: &str,
        parent: Option<String>,
        mount: &str,
        xyz: Option<[f64; 3]>,
        rpy: Option<[f64; 3]>,
    ) -> PyResult<Vec<PathBuf>> {
        let at = robot::attachment(name, parent, mount, (xyz, rpy))?;
        let format = named("format", format)?;
        robot::write(py, (self.models.get(), &self.twin), &at, format, &folder)
    }

    /// Returns ROS's camera_info YAML: a mapping from file names to texts, one per camera.
    ///
    /// Warns with oaktwin.FindingWarning about information that the format cannot represent.
    fn to_ros<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        self.exported(py, oaktwin::calibration::export::Format::Ros)
    }

    /// Returns OpenCV's FileStorage YAML: a mapping from file names to texts, one per camera and "stereo.yml".
    fn to_opencv<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        self.exported(py, oaktwin::calibration::export::Format::OpenCv)
    }

    /// Returns Kalibr's camchain, and imu.yaml of the inertial sensor: a mapping from file names to texts.
    ///
    /// Warns with oaktwin.FindingWarning about information that the format cannot represent.
    fn to_kalibr<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        self.exported(py, oaktwin::calibration::export::Format::Kalibr)
    }

    /// Returns DepthAI's calibration JSON: a mapping from a file name to its text; for a nominal device, the ideal unit's.
    fn to_depthai<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        self.exported(py, oaktwin::calibration::export::Format::DepthAi)
    }

    /// Everything known about the device, each number with its source: what `oaktwin show --json` prints.
    fn report<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let report = DeviceReport::new(self.models.get(), &self.twin, self.lens, self.findings.clone());
        json::to_python(py, &report)
    }

    fn _repr_html_<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        slf.py().import("oaktwin._html")?.getattr("device")?.call1((slf,))
    }

    fn __repr__(&self) -> String {
        let roles: Vec<&str> = self
            .twin
            .cameras
            .iter()
            .map(|camera| camera.spec.role.as_str())
            .collect();
        let sensors: Vec<&str> = self
            .twin
            .depth_sensors
            .iter()
            .map(|sensor| sensor.spec.kind.as_str())
            .collect();
        format!(
            "<oaktwin.Device {} ({}): cameras {}; depth {}>",
            self.name(),
            self.origin(),
            roles.join(", "),
            sensors.join(", ")
        )
    }
}

mod intrinsics;
mod state;

use std::hash::{DefaultHasher, Hash, Hasher};

use numpy::{PyArray1, PyArray2, PyArray3, PyArrayDyn};
use oaktwin::camera::{self, ImageSize, Intrinsics, LensFamily, OpenCv, PixelPoint, RigidTransform};
use oaktwin::render::{Clip, PlacedCamera, check_size};
use oaktwin::sense::check_hfov;
use pyo3::prelude::*;

use crate::arguments::{self, Size, distortion};
use crate::choice::choose;
use crate::error::{error, wrong};
use crate::finding::warn;
use crate::pose::{Of, matrix};
use crate::projection;
pub(crate) use state::_camera;
use state::CameraState;

/// A camera: intrinsics, lens, and its pose on a device.
///
/// Its frame is OpenCV's: x right, y down, z forward; metres. Pixel coordinates are OpenCV's: the centre of the first
/// pixel is (0, 0), so the centre of the image is ((width - 1) / 2, (height - 1) / 2).
///
/// size, height: (width, height) of the image, px, or two numbers.
/// K: camera matrix (3, 3), px; or give hfov_deg or vfov_deg.
/// hfov_deg: horizontal field of view of an ideal centred camera, degrees between 0 and 180.
/// vfov_deg: the vertical one instead, such as the `fovy` of MuJoCo.
/// distortion: OpenCV's coefficients, up to 14 of the lens "opencv" (k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4 tx ty), up to 4 of
///     "fisheye"; none by default.
/// lens: "pinhole", "opencv" or "fisheye"; by default "opencv" if distortion is given, otherwise "pinhole".
/// body_from_camera: (4, 4), the camera's pose on its device; by default the identity.
/// near, far: the clipping range, metres.
/// name: the name in messages.
///
/// Raises oaktwin.Error for an image without pixels, an invalid K or field of view, and too many coefficients.
#[pyclass(frozen, eq, module = "oaktwin")]
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Camera {
    pub(crate) name: String,
    pub(crate) camera: camera::Camera,
    pub(crate) clip: Clip,
    pub(crate) body_from_camera: RigidTransform,
}

impl Camera {
    /// Creates the camera of an asset.
    pub(crate) fn placed(name: &str, placed: &PlacedCamera) -> Self {
        Self {
            name: name.to_owned(),
            camera: placed.camera,
            clip: placed.clip,
            body_from_camera: placed.mount_from_camera,
        }
    }

    /// Creates the camera of a stereo pair's depth images.
    pub(crate) fn rectified(camera: camera::Camera, body_from_camera: RigidTransform) -> Self {
        Self {
            name: "depth".to_owned(),
            camera,
            clip: Clip {
                near_m: 0.01,
                far_m: 1e7,
            },
            body_from_camera,
        }
    }

    fn with(&self, intrinsics: Intrinsics) -> PyResult<Self> {
        check_size(intrinsics.size).map_err(error)?;
        Ok(Self {
            camera: camera::Camera::new(intrinsics, self.camera.lens),
            ..self.clone()
        })
    }
}

/// Returns a function for the cameras of other libraries.
fn adapter<'py>(py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyAny>> {
    py.import("oaktwin._adapters")?.getattr(name)
}

#[pymethods]
impl Camera {
    #[new]
    #[pyo3(signature = (size, height = None, *, K = None, hfov_deg = None, vfov_deg = None, distortion = None, lens = None,
        body_from_camera = None, near = 0.01, far = 1e7, name = "camera"))]
    #[expect(clippy::too_many_arguments, reason = "options of Python")]
    #[expect(non_snake_case, reason = "the usual name of the camera matrix")]
    #[expect(clippy::needless_pass_by_value, reason = "what PyO3 hands over")]
    fn new(
        size: &Bound<'_, PyAny>,
        height: Option<&Bound<'_, PyAny>>,
        K: Option<Bound<'_, PyAny>>,
        hfov_deg: Option<f64>,
        vfov_deg: Option<f64>,
        #[pyo3(from_py_with = distortion)] distortion: Option<Vec<f64>>,
        lens: Option<&str>,
        body_from_camera: Option<Bound<'_, PyAny>>,
        near: f64,
        far: f64,
        name: &str,
    ) -> PyResult<Self> {
        let py = size.py();
        let Size(width, height) = arguments::size(size, height)?;
        let size = ImageSize::new(width, height);
        check_size(size).map_err(|found| error(format!("size: {found}")))?;
        warn(py, hfov_deg.and_then(check_hfov).as_slice())?;
        let intrinsics = intrinsics::read(size, K.as_ref(), hfov_deg, vfov_deg)?;
        let default = if distortion.is_some() { "opencv" } else { "pinhole" };
        let coefficients = distortion.unwrap_or_default();
        let lens = intrinsics::lens(lens.unwrap_or(default), &coefficients)?;
        // A smaller distance has no normal reciprocal in single precision.
        if !(near >= f64::from(f32::MIN_POSITIVE) && far > near) {
            let is = format!("{near:e} to {far:e} m is not a valid range");
            return Err(wrong(
                "near, far",
                is,
                "pass metres, with near above 0 and below far",
            ));
        }
        let body_from_camera = match &body_from_camera {
            Some(pose) => Of::Mount.one("body_from_camera", pose)?,
            None => RigidTransform::IDENTITY,
        };
        Ok(Self {
            name: name.to_owned(),
            camera: camera::Camera::new(intrinsics, lens),
            clip: Clip {
                near_m: near,
                far_m: far,
            },
            body_from_camera,
        })
    }

    /// The name in messages: the role on its device.
    #[getter]
    fn name(&self) -> &str {
        &self.name
    }

    /// Camera matrix (3, 3), px: [[fx, 0, cx], [0, fy, cy], [0, 0, 1]].
    #[getter(K)]
    fn k<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        matrix(py, &self.camera.intrinsics.opencv_matrix())
    }

    /// The lens model: "pinhole", "opencv" or "fisheye"; "f-theta" for cameras of scenes.
    #[getter]
    fn lens(&self) -> &'static str {
        self.camera.lens.names().option
    }

    /// The lens coefficients in OpenCV's order: (14,) for "opencv", (4,) for "fisheye", (0,) for "pinhole".
    #[getter]
    fn distortion<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        let lens = &self.camera.lens;
        match LensFamily::of(lens) {
            Some(_) => PyArray1::from_slice(py, lens.coefficients()),
            None => PyArray1::from_slice(py, &[]),
        }
    }

    /// (width, height) of the image, px.
    #[getter]
    fn size(&self) -> (u32, u32) {
        let size = self.camera.intrinsics.size;
        (size.width, size.height)
    }

    /// The width of the image, px.
    #[getter]
    fn width(&self) -> u32 {
        self.size().0
    }

    /// The height of the image, px.
    #[getter]
    fn height(&self) -> u32 {
        self.size().1
    }

    /// Horizontal field of view through the principal point, degrees: the lens's for a fisheye, otherwise
    /// the pinhole's.
    #[getter]
    fn hfov_deg(&self) -> f64 {
        self.camera.field_of_view()[0].to_degrees()
    }

    /// Vertical field of view, likewise.
    #[getter]
    fn vfov_deg(&self) -> f64 {
        self.camera.field_of_view()[1].to_degrees()
    }

    fn __hash__(&self) -> u64 {
        let mut hasher = DefaultHasher::new();
        let k = self.camera.intrinsics.opencv_matrix();
        (&self.name, self.size(), k.map(|row| row.map(f64::to_bits))).hash(&mut hasher);
        hasher.finish()
    }

    /// The clipping range (near, far), metres.
    #[getter]
    fn clip(&self) -> (f64, f64) {
        (self.clip.near_m, self.clip.far_m)
    }

    /// (4, 4): the transform from the camera's frame (x right, y down, z forward) to the device's body (x forward, y left, z up, its origin
    /// midway between left and right), metres.
    #[getter]
    fn body_from_camera<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        Of::Mount.array(py, &self.body_from_camera)
    }

    /// Returns the camera at another image size.
    ///
    /// width, height: px, or the pair (width, height).
    /// keep_aspect_ratio: whether to scale the image to cover the size and crop it; otherwise each axis is scaled separately.
    /// rule: "center" (default): a principal point in the centre stays there, as in simulators and for images resized by cv2.resize.
    ///     "depthai": as DepthAI computes it, without regard to the half pixel between the border and the first pixel's centre.
    ///
    /// Raises oaktwin.Error for an image without pixels.
    #[pyo3(signature = (width, height = None, *, keep_aspect_ratio = true, rule = "center"))]
    fn resized(
        &self,
        width: &Bound<'_, PyAny>,
        height: Option<&Bound<'_, PyAny>>,
        keep_aspect_ratio: bool,
        rule: &str,
    ) -> PyResult<Self> {
        let Size(width, height) = arguments::size(width, height)?;
        let size = ImageSize::new(width, height);
        check_size(size).map_err(error)?;
        let own = &self.camera.intrinsics;
        self.with(
            if choose("rule", rule, &[("center", true), ("depthai", false)])? {
                own.resized_about_centre(size, keep_aspect_ratio)
            } else {
                own.resized(size, keep_aspect_ratio)
            },
        )
    }

    /// Projects points to pixels, with the lens's distortion.
    ///
    /// points: (..., 3), metres, in the camera's frame, or in the world if world_from_camera is given.
    /// world_from_camera: (4, 4), the camera's pose.
    ///
    /// Returns (pixels, depth): (..., 2) float64 px, which may be outside the image, NaN behind the camera and outside the lens's
    /// field of view; and (...) float64 metres along the optical axis, negative behind the camera.
    ///
    /// Raises oaktwin.Error for other shapes.
    #[pyo3(signature = (points, world_from_camera = None))]
    fn project<'py>(
        &self,
        py: Python<'py>,
        points: &Bound<'py, PyAny>,
        world_from_camera: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<projection::Projected<'py>> {
        projection::project(py, &self.camera, points, world_from_camera)
    }

    /// Converts depth images to points.
    ///
    /// depth: (H, W), or a batch (N, H, W), of this camera's size: float32 metres along the optical axis, or uint16 millimetres.
    /// world_from_camera: (4, 4), the camera's pose, or (N, 4, 4) for a batch; by default the points are in the camera's frame.
    ///
    /// Returns the point of each pixel, (..., H, W, 3) float32 metres; NaN where the depth is invalid.
    ///
    /// Raises oaktwin.Error for images of another size.
    #[pyo3(signature = (depth, world_from_camera = None))]
    fn unproject<'py>(
        &self,
        py: Python<'py>,
        depth: &Bound<'py, PyAny>,
        world_from_camera: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyArrayDyn<f32>>> {
        projection::unproject(py, &self.camera, depth, world_from_camera)
    }

    /// Returns the unit direction in which each pixel's centre sees, (H, W, 3) float32 in the camera's frame; NaN outside the
    /// lens's field of view.
    fn rays<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArrayDyn<f32>>> {
        projection::rays(py, &self.camera)
    }

    /// The position in this camera's image of each pixel of an undistorted image, (x, y) in px, (H, W, 2) float32, for
    /// `cv2.remap(image, maps, None, cv2.INTER_LINEAR)`.
    ///
    /// target: the camera of the undistorted image, a pinhole, whose size and K are used; by default this camera's.
    ///
    /// Positions may lie outside the image; they are NaN outside the lens's field of view. Raises oaktwin.Error for a target with
    /// distortion.
    #[pyo3(signature = (target = None))]
    fn undistortion_maps<'py>(
        &self,
        py: Python<'py>,
        target: Option<&Self>,
    ) -> PyResult<Bound<'py, PyArray3<f32>>> {
        projection::undistortion_maps(py, &self.camera, target.map(|target| &target.camera))
    }

    /// Returns the camera of a part of the image: width x height pixels, or the pair of both, with the upper left corner (x, y).
    ///
    /// Raises oaktwin.Error for an image without pixels, and for a part that is not within the image.
    #[pyo3(signature = (x, y, width, height = None))]
    fn cropped(
        &self,
        x: f64,
        y: f64,
        width: &Bound<'_, PyAny>,
        height: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Self> {
        let Size(width, height) = arguments::size(width, height)?;
        let own = self.camera.intrinsics.size;
        let is_within =
            |from: f64, length: u32, all: u32| from >= 0.0 && from + f64::from(length) <= f64::from(all);
        if !(is_within(x, width, own.width) && is_within(y, height, own.height)) {
            let is = format!("{width} x {height} px from ({x}, {y}) on are not within the image, {own}");
            return Err(wrong("x, y, width, height", is, "pass a part of the image"));
        }
        let corner = PixelPoint::<OpenCv>::new(x, y);
        self.with(
            self.camera
                .intrinsics
                .cropped(corner, ImageSize::new(width, height)),
        )
    }

    /// Returns the camera of ROS's calibration, a pinhole or with a lens.
    ///
    /// info: a sensor_msgs/CameraInfo, or a mapping with its fields: "width", "height", "distortion_model", "d" and "k".
    #[staticmethod]
    fn from_ros<'py>(info: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        adapter(info.py(), "from_ros")?.call1((info,))
    }

    /// The fields of a sensor_msgs/CameraInfo: `CameraInfo(**camera.to_ros())`.
    ///
    /// Raises oaktwin.Error for a lens that ROS does not have.
    fn to_ros<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        adapter(slf.py(), "to_ros")?.call1((slf,))
    }

    /// Returns the camera of a configuration of Isaac Lab: a CameraCfg, a TiledCameraCfg or a RayCasterCameraCfg, whose principal point is
    /// in the centre.
    ///
    /// cfg: the configuration, or a PinholeCameraCfg or PinholePatternCfg with `size`.
    /// size: (width, height) of the images; by default the configuration's.
    #[staticmethod]
    #[pyo3(signature = (cfg, *, size = None))]
    fn from_isaac<'py>(
        cfg: &Bound<'py, PyAny>,
        size: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        adapter(cfg.py(), "from_isaac")?.call1((cfg, size))
    }

    /// Returns the camera of an intrinsic of Open3D, an open3d.camera.PinholeCameraIntrinsic.
    #[staticmethod]
    fn from_open3d<'py>(intrinsic: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        adapter(intrinsic.py(), "from_open3d")?.call1((intrinsic,))
    }

    /// The arguments of Open3D's camera: `open3d.camera.PinholeCameraIntrinsic(**camera.to_open3d())`.
    ///
    /// Raises oaktwin.Error for a camera that is not a pinhole.
    fn to_open3d<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        adapter(slf.py(), "to_open3d")?.call1((slf,))
    }

    /// Returns a camera of a MuJoCo model, version 3.6 or newer.
    ///
    /// model: the mujoco.MjModel.
    /// name: the name of the camera, or its number.
    /// size: (width, height) of its images, px; by default its resolution.
    ///
    /// MuJoCo's camera frame is OpenGL's: the pose of its camera is `CameraPose.of(matrix, "mujoco")`.
    #[staticmethod]
    #[pyo3(signature = (model, name, *, size = None))]
    fn from_mujoco<'py>(
        model: &Bound<'py, PyAny>,
        name: &Bound<'py, PyAny>,
        size: Option<Size>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let size = size.map(|Size(width, height)| (width, height));
        adapter(model.py(), "from_mujoco")?.call1((model, name, size))
    }

    /// The intrinsics as arguments of MuJoCo's `MjSpec`: `body.add_camera(name="left", **camera.to_mujoco())`.
    ///
    /// Raises oaktwin.Error for a camera that is not a pinhole.
    fn to_mujoco<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        adapter(slf.py(), "to_mujoco")?.call1((slf,))
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, CameraState)> {
        let restore = py.import("oaktwin._oaktwin")?.getattr("_camera")?;
        Ok((restore, self.state()?))
    }

    fn _repr_html_<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        slf.py().import("oaktwin._html")?.getattr("camera")?.call1((slf,))
    }

    fn __repr__(&self) -> String {
        format!(
            "<oaktwin.Camera {}: {}, fx {:.2} px, {:.2}° x {:.2}°, {}>",
            self.name,
            self.camera.intrinsics.size,
            self.camera.intrinsics.fx,
            self.hfov_deg(),
            self.vfov_deg(),
            self.lens()
        )
    }
}

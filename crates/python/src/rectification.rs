use numpy::{PyArray1, PyArray2, PyArray3, PyArrayMethods};
use oaktwin::camera::math::DMat3;
use oaktwin::camera::{self, Intrinsics, RectifiedIntrinsics, stereo_rectify_to, undistort_rectify_map};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::camera::Camera;
use crate::choice::choose;
use crate::error::wrong;
use crate::pose::matrix;
use crate::threads;

const INTRINSICS: [(&str, RectifiedIntrinsics); 3] = [
    ("zero-disparity", RectifiedIntrinsics::ZeroDisparity),
    ("free-disparity", RectifiedIntrinsics::FreeDisparity),
    ("left-camera", RectifiedIntrinsics::LeftCamera),
];

/// A stereo pair turned so that rows meet: cv2.stereoRectify's numbers, and the maps for cv2.remap.
///
/// left, right: the cameras, with their places on the device. `Device.rectification` has a device's.
/// intrinsics: of the rectified images: "zero-disparity" (default, OpenCV's default), "free-disparity" (OpenCV without
///     CALIB_ZERO_DISPARITY), "left-camera" (DepthAI's host and RVC4).
///
/// Raises oaktwin.Error for cameras that cannot be rectified.
#[pyclass(frozen, module = "oaktwin")]
#[derive(Debug)]
pub(crate) struct Rectification {
    left: Camera,
    right: Camera,
    intrinsics: &'static str,
    rectification: camera::Rectification,
}

impl Rectification {
    pub(crate) fn of(left: Camera, right: Camera, intrinsics: &str) -> PyResult<Self> {
        let choice = choose("intrinsics", intrinsics, &INTRINSICS)?;
        let right_from_left = right.body_from_camera.inverse() * left.body_from_camera;
        let rectification = stereo_rectify_to(&left.camera, &right.camera, &right_from_left, choice);
        let rectification = rectification.map_err(|error| {
            let pair = format!("{}, {}", left.name, right.name);
            wrong(pair, error, "calibrate the stereo pair again")
        })?;
        let name = INTRINSICS.iter().find(|(_, known)| *known == choice);
        Ok(Self {
            left,
            right,
            intrinsics: name.map_or("zero-disparity", |(name, _)| *name),
            rectification,
        })
    }
}

fn rotation<'py>(py: Python<'py>, matrix: DMat3) -> PyResult<Bound<'py, PyArray2<f64>>> {
    self::matrix(py, &matrix.transpose().to_cols_array_2d())
}

#[pymethods]
impl Rectification {
    #[new]
    #[pyo3(signature = (left, right, *, intrinsics = "zero-disparity"))]
    fn new(left: &Camera, right: &Camera, intrinsics: &str) -> PyResult<Self> {
        Self::of(left.clone(), right.clone(), intrinsics)
    }

    fn __getnewargs_ex__<'py>(&self, py: Python<'py>) -> PyResult<((Camera, Camera), Bound<'py, PyDict>)> {
        let options = PyDict::new(py);
        options.set_item("intrinsics", self.intrinsics)?;
        Ok(((self.left.clone(), self.right.clone()), options))
    }

    /// (3, 3): rotates points of the left camera's frame into the rectified one.
    #[getter(R1)]
    fn r1<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        rotation(py, self.rectification.rectified_from_left)
    }

    /// (3, 3): rotates points of the right camera's frame into the rectified one.
    #[getter(R2)]
    fn r2<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        rotation(py, self.rectification.rectified_from_right)
    }

    /// (3, 4): projects points of the rectified left frame, metres, to pixels of the rectified left image.
    #[getter(P1)]
    fn p1<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        matrix(py, &self.rectification.projection_left())
    }

    /// (3, 4): projects points of the rectified left frame, metres, to pixels of the rectified right image.
    #[getter(P2)]
    fn p2<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        matrix(py, &self.rectification.projection_right())
    }

    /// (4, 4): from (x, y, disparity, 1) in pixels to homogeneous points of the rectified left frame, metres.
    #[getter(Q)]
    fn q<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        matrix(
            py,
            &self
                .rectification
                .disparity_to_depth()
                .transpose()
                .to_cols_array_2d(),
        )
    }

    /// The distance of the optical centres, metres.
    #[getter]
    fn baseline(&self) -> f64 {
        self.rectification.baseline
    }

    /// (H, W, 2) float32: where in a camera's image each pixel of its rectified image lies, (x, y), px: for
    /// `cv2.remap(image, maps, None, cv2.INTER_LINEAR)`.
    ///
    /// camera: "left" or "right".
    ///
    /// Positions may lie outside the image; NaN where the lens sees nothing. Raises oaktwin.Error for another camera.
    fn maps<'py>(&self, py: Python<'py>, camera: &str) -> PyResult<Bound<'py, PyArray3<f32>>> {
        let own = &self.rectification;
        let left = (&self.left.camera, own.rectified_from_left, &own.left);
        let right = (&self.right.camera, own.rectified_from_right, &own.right);
        let (camera, rotation, rectified): (_, _, &Intrinsics) =
            choose("camera", camera, &[("left", left), ("right", right)])?;
        let map = threads::run(py, || {
            undistort_rectify_map(camera, rotation, rectified).collect::<Vec<_>>()
        })?;
        let shape = [rectified.size.height as usize, rectified.size.width as usize, 2];
        PyArray1::from_vec(py, map.into_flattened()).reshape(shape)
    }

    fn __repr__(&self) -> String {
        format!(
            "<oaktwin.Rectification {}, fx {:.2} px, baseline {:.3} mm>",
            self.rectification.left.size,
            self.rectification.left.fx,
            self.rectification.baseline * 1e3
        )
    }
}

use numpy::{PyArray1, PyArray2, PyArray3, PyArrayMethods};
use oaktwin::camera::math::DMat3;
use oaktwin::camera::{self, Intrinsics, RectifiedIntrinsics, stereo_rectify_to, undistort_rectify_map};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::camera::Camera;
use crate::choice::{choose, named};
use crate::error::wrong;
use crate::pose::matrix;
use crate::threads;

/// The rectification of a stereo pair: the matrices of cv2.stereoRectify, and the maps for cv2.remap.
///
/// left, right: the cameras, with their poses on the device. `Device.rectification` returns a device's.
/// intrinsics: the intrinsics of the rectified images: "zero-disparity" (default, OpenCV's default), "free-disparity" (OpenCV without
///     CALIB_ZERO_DISPARITY), "left-camera" (DepthAI's host and RVC4), "right-camera" (RVC2).
///
/// Raises oaktwin.Error if the cameras cannot be rectified.
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
        let choice: RectifiedIntrinsics = named("intrinsics", intrinsics)?;
        let right_from_left = right.body_from_camera.inverse() * left.body_from_camera;
        let rectification = stereo_rectify_to(&left.camera, &right.camera, &right_from_left, choice);
        let rectification = rectification.map_err(|error| {
            let pair = format!("{}, {}", left.name, right.name);
            wrong(pair, error, "calibrate the stereo pair again")
        })?;
        Ok(Self {
            left,
            right,
            intrinsics: choice.name(),
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

    /// The rotation from the left camera's frame to the rectified left frame, (3, 3).
    #[getter(R1)]
    fn r1<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        rotation(py, self.rectification.rectified_from_left)
    }

    /// The rotation from the right camera's frame to the rectified right frame, (3, 3).
    #[getter(R2)]
    fn r2<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        rotation(py, self.rectification.rectified_from_right)
    }

    /// The projection from the rectified left frame, metres, to pixels of the rectified left image, (3, 4).
    #[getter(P1)]
    fn p1<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        matrix(py, &self.rectification.projection_left())
    }

    /// The projection from the rectified left frame, metres, to pixels of the rectified right image, (3, 4).
    #[getter(P2)]
    fn p2<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        matrix(py, &self.rectification.projection_right())
    }

    /// The matrix from (x, y, disparity, 1) in pixels to homogeneous points in the rectified left frame, metres, (4, 4).
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

    /// The baseline in metres.
    #[getter]
    fn baseline(&self) -> f64 {
        self.rectification.baseline
    }

    /// The position in a camera's image of each pixel of its rectified image, (x, y) in px, (H, W, 2) float32, for
    /// `cv2.remap(image, maps, None, cv2.INTER_LINEAR)`.
    ///
    /// camera: "left" or "right".
    ///
    /// Positions may lie outside the image; they are NaN outside the lens's field of view. Raises oaktwin.Error for any other
    /// camera name.
    fn maps<'py>(&self, py: Python<'py>, camera: &str) -> PyResult<Bound<'py, PyArray3<f32>>> {
        let own = &self.rectification;
        let left = (&self.left.camera, own.rectified_from_left, &own.left);
        let right = (&self.right.camera, own.rectified_from_right, &own.right);
        let (camera, rotation, rectified): (_, _, &Intrinsics) =
            choose("camera", camera, &[("left", left), ("right", right)])?;
        let map = threads::run(py, || {
            undistort_rectify_map(camera, rotation, rectified).collect::<Vec<_>>()
        })?;
        if let Some(at) = map.iter().flatten().position(|position| position.is_infinite()) {
            let is = format!("the lens model has no finite position for pixel {}", at / 2);
            return Err(wrong("distortion", is, "calibrate the camera again"));
        }
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

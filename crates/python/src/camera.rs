use std::hash::{DefaultHasher, Hash, Hasher};

use numpy::{PyArray1, PyArray2, PyArray3, PyArrayDyn};
use oaktwin::camera::{
    self, ImageSize, Intrinsics, LensFamily, LensModel, OpenCv, PixelPoint, RigidTransform,
};
use oaktwin::render::{Clip, PlacedCamera, check_size};
use oaktwin::sense::check_hfov;
use pyo3::prelude::*;

use crate::arguments::{Size, distortion, height, width};
use crate::array::numbers;
use crate::choice::choose;
use crate::error::{error, wrong};
use crate::finding::warn;
use crate::pose::{matrix, one_pose, rows};
use crate::projection;

/// A camera: intrinsics, lens, and its pose on a device.
///
/// Its frame is OpenCV's: x right, y down, z forward; metres. Pixel coordinates are OpenCV's: the centre of the first
/// pixel is (0, 0), so the centre of the image is ((width - 1) / 2, (height - 1) / 2).
///
/// size: (width, height) of the image, px.
/// K: camera matrix (3, 3), px; or give hfov_deg.
/// hfov_deg: horizontal field of view of an ideal centred camera, degrees between 0 and 180.
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

/// The state of a camera in pickles: name, size, K, lens and coefficients, clipping range, and pose on its device.
type State = (
    String,
    (u32, u32),
    [[f64; 3]; 3],
    &'static str,
    Vec<f64>,
    (f64, f64),
    [[f64; 4]; 4],
);

/// Restores the camera of a pickle without loss.
#[pyfunction]
#[expect(clippy::needless_pass_by_value, reason = "what PyO3 hands over")]
pub(crate) fn _camera(
    name: String,
    size: (u32, u32),
    k: [[f64; 3]; 3],
    lens: &str,
    coefficients: Vec<f64>,
    clip: (f64, f64),
    body_from_camera: [[f64; 4]; 4],
) -> PyResult<Camera> {
    let size = ImageSize::new(size.0, size.1);
    check_size(size).map_err(error)?;
    let lens = self::lens(lens, &coefficients)?;
    Ok(Camera {
        name,
        camera: camera::Camera::new(Intrinsics::from_opencv_matrix(size, k), lens),
        clip: Clip {
            near_m: clip.0,
            far_m: clip.1,
        },
        body_from_camera: RigidTransform::from_rows(body_from_camera),
    })
}

impl Camera {
    fn state(&self) -> PyResult<State> {
        let lens = &self.camera.lens;
        if LensFamily::of(lens).is_none() {
            let what = format!("its {} lens cannot be pickled", lens.names().option);
            return Err(wrong(&self.name, what, "open its scene again instead"));
        }
        Ok((
            self.name.clone(),
            self.size(),
            self.camera.intrinsics.opencv_matrix(),
            self.lens(),
            lens.coefficients().to_vec(),
            self.clip(),
            self.body_from_camera.rows(),
        ))
    }

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

fn lens(name: &str, coefficients: &[f64]) -> PyResult<LensModel> {
    let families: Vec<_> = LensFamily::ALL
        .iter()
        .map(|family| (family.name, family))
        .collect();
    let family = choose("lens", name, &families)?;
    (family.from_coefficients)(coefficients).map_err(|found| error(format!("distortion: {found}")))
}

fn intrinsics(size: ImageSize, k: Option<&Bound<'_, PyAny>>, hfov_deg: Option<f64>) -> PyResult<Intrinsics> {
    match (k, hfov_deg) {
        (Some(k), None) => {
            let (shape, array) = numbers("K", k)?;
            let values = array.as_slice().map_err(error)?;
            let (rows, _) = values.as_chunks::<3>();
            let ([3, 3], [a, b, c]) = (&shape[..], rows) else {
                return Err(wrong(
                    "K",
                    format_args!("has shape {shape:?}"),
                    "pass a 3x3 camera matrix",
                ));
            };
            let made = Intrinsics::from_opencv_matrix(size, [*a, *b, *c]);
            let is_camera = values.iter().all(|number| number.is_finite())
                && made.fx > 0.0
                && made.fy > 0.0
                && a[1] == 0.0
                && b[0] == 0.0
                && *c == [0.0, 0.0, 1.0];
            if is_camera && !made.has_finite_rays() {
                let is = format!(
                    "has focal lengths of {:e} and {:e} px, too short for its principal point",
                    made.fx, made.fy
                );
                return Err(wrong("K", is, "pass focal lengths and principal point in pixels"));
            }
            if is_camera {
                Ok(made)
            } else {
                Err(wrong(
                    "K",
                    "is not a camera matrix",
                    "pass [[fx, 0, cx], [0, fy, cy], [0, 0, 1]], px",
                ))
            }
        }
        (None, Some(hfov)) if hfov > 0.0 && hfov < 180.0 => {
            Ok(Intrinsics::from_hfov(size, hfov.to_radians()))
        }
        (None, Some(hfov)) => {
            let is = format!("{hfov} is out of range");
            Err(wrong("hfov_deg", is, "pass degrees above 0 and below 180"))
        }
        _ => Err(wrong(
            "K, hfov_deg",
            "exactly one is required",
            "pass one of them",
        )),
    }
}

#[pymethods]
impl Camera {
    #[new]
    #[pyo3(signature = (size, *, K = None, hfov_deg = None, distortion = None, lens = None, body_from_camera = None,
        near = 0.01, far = 1e7, name = "camera"))]
    #[expect(clippy::too_many_arguments, reason = "options of Python")]
    #[expect(non_snake_case, reason = "the usual name of the camera matrix")]
    #[expect(clippy::needless_pass_by_value, reason = "what PyO3 hands over")]
    fn new(
        py: Python<'_>,
        size: Size,
        K: Option<Bound<'_, PyAny>>,
        hfov_deg: Option<f64>,
        #[pyo3(from_py_with = distortion)] distortion: Option<Vec<f64>>,
        lens: Option<&str>,
        body_from_camera: Option<Bound<'_, PyAny>>,
        near: f64,
        far: f64,
        name: &str,
    ) -> PyResult<Self> {
        let size = ImageSize::new(size.0, size.1);
        check_size(size).map_err(|found| error(format!("size: {found}")))?;
        warn(py, hfov_deg.and_then(check_hfov).as_slice())?;
        let intrinsics = intrinsics(size, K.as_ref(), hfov_deg)?;
        let default = if distortion.is_some() { "opencv" } else { "pinhole" };
        let coefficients = distortion.unwrap_or_default();
        let lens = self::lens(lens.unwrap_or(default), &coefficients)?;
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
            Some(pose) => one_pose("body_from_camera", pose)?,
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
    fn body_from_camera<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        rows(py, &self.body_from_camera)
    }

    /// Returns the camera at another image size, as DepthAI computes it.
    ///
    /// width, height: px.
    /// keep_aspect_ratio: whether to scale the image to cover the size and crop it; otherwise each axis is scaled separately.
    /// keep_center: whether a principal point in the centre stays there, as for images resized by cv2.resize. DepthAI scales it
    ///     without regard to the half pixel between the border and the first pixel's centre (default).
    ///
    /// Raises oaktwin.Error for an image without pixels.
    #[pyo3(signature = (width, height, *, keep_aspect_ratio = true, keep_center = false))]
    fn resized(
        &self,
        #[pyo3(from_py_with = width)] width: u32,
        #[pyo3(from_py_with = height)] height: u32,
        keep_aspect_ratio: bool,
        keep_center: bool,
    ) -> PyResult<Self> {
        let size = ImageSize::new(width, height);
        check_size(size).map_err(error)?;
        let own = &self.camera.intrinsics;
        self.with(if keep_center {
            own.resized_about_centre(size, keep_aspect_ratio)
        } else {
            own.resized(size, keep_aspect_ratio)
        })
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

    /// Returns the camera of a part of the image: width x height pixels with the upper left corner (x, y).
    ///
    /// Raises oaktwin.Error for an image without pixels, or a corner that is not finite.
    #[pyo3(signature = (x, y, width, height))]
    fn cropped(
        &self,
        x: f64,
        y: f64,
        #[pyo3(from_py_with = width)] width: u32,
        #[pyo3(from_py_with = height)] height: u32,
    ) -> PyResult<Self> {
        if !(x.is_finite() && y.is_finite()) {
            return Err(wrong(
                "x, y",
                format_args!("({x}, {y}) is not finite"),
                "pass pixels",
            ));
        }
        let corner = PixelPoint::<OpenCv>::new(x, y);
        self.with(
            self.camera
                .intrinsics
                .cropped(corner, ImageSize::new(width, height)),
        )
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, State)> {
        let restore = py.import("oaktwin._oaktwin")?.getattr("_camera")?;
        Ok((restore, self.state()?))
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

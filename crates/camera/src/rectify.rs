//! Stereo rectification after Bouguet, as `cv2.stereoRectify` computes it.

use glam::{DMat3, DMat4, DQuat, DVec2, DVec3, DVec4};
use oaktwin_base::parameter::{Platform, choice};

use crate::{
    Camera, ImageSize, Intrinsics, LensModel, OpenCv, OpenCvLens, OpenCvPinhole, PixelPoint, RigidTransform,
};

/// The axis of the rectified images that the baseline is parallel to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BaselineAxis {
    /// The cameras are side by side; epipolar lines are rows.
    Horizontal,
    /// One camera is above the other; epipolar lines are columns.
    Vertical,
}

choice! {
    /// The intrinsics of the rectified images.
    RectifiedIntrinsics {
        /// `cv2.stereoRectify` with `CALIB_ZERO_DISPARITY`, its default: the mean focal length perpendicular to the baseline,
        /// and a common principal point that centres the undistorted corners.
        ZeroDisparity = "zero-disparity",
        /// `cv2.stereoRectify` without that flag: principal points that differ along the baseline.
        FreeDisparity = "free-disparity",
        /// The left camera's, for both: `DepthAI`'s host-side rectification and RVC4 devices.
        LeftCamera = "left-camera",
        /// The right camera's, for both: RVC2 devices.
        RightCamera = "right-camera",
    }
}

impl RectifiedIntrinsics {
    /// Returns the choice of the devices of a platform.
    #[must_use]
    pub const fn of(platform: Platform) -> Self {
        match platform {
            Platform::Rvc2 => Self::RightCamera,
            Platform::Rvc4 => Self::LeftCamera,
        }
    }
}

/// The rectification of a pair, which aligns rows (or columns). Rectified images have no distortion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rectification {
    /// OpenCV's R1: the rotation of points in the left camera's frame.
    pub rectified_from_left: DMat3,
    /// OpenCV's R2: the rotation of points in the right camera's frame.
    pub rectified_from_right: DMat3,
    /// The intrinsics in OpenCV's P1.
    pub left: Intrinsics,
    /// The intrinsics in OpenCV's P2.
    pub right: Intrinsics,
    /// The axis of the baseline.
    pub axis: BaselineAxis,
    /// The distance of the optical centres, in the unit of the given transform.
    pub baseline: f64,
    /// The position of the left camera's centre along the baseline in the rectified right frame, in the same unit: negative
    /// if the right camera is to the right or below.
    pub offset: f64,
}

/// An error in the geometry of a pair.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum RectifyError {
    /// The baseline is zero or not finite.
    #[error("the distance of the cameras is {0}; rectification needs a finite distance above 0")]
    Baseline(f64),
    /// The matrix is singular or a reflection.
    #[error(
        "the rotation between the cameras has determinant {0}; give an orthonormal matrix with determinant 1"
    )]
    Rotation(f64),
    /// The lens model of a camera has no finite point at the corners of its image.
    #[error("the lens model of the {0} camera has no finite point at the corners of its image")]
    Lens(&'static str),
    /// A number of the result is too large.
    #[error("the rectified {0} is not finite")]
    NotFinite(&'static str),
    /// The images differ in size.
    #[error("the image sizes {0} and {1} differ; resize the intrinsics first")]
    Sizes(ImageSize, ImageSize),
}

/// Rectifies a pair as `cv2.stereoRectify` does, with its default flags.
///
/// See [`stereo_rectify_to`]; the intrinsics are [`RectifiedIntrinsics::ZeroDisparity`].
///
/// # Errors
/// Returns an error if the baseline is zero, the matrix is not a rotation, or the image sizes differ.
///
/// ```
/// use oaktwin_camera::math::{DMat3, DVec3};
/// use oaktwin_camera::{Camera, ImageSize, Intrinsics, LensModel, RigidTransform, stereo_rectify};
///
/// let camera = Camera::new(Intrinsics::from_hfov(ImageSize::new(1280, 800), 1.34), LensModel::Pinhole);
/// let right_from_left = RigidTransform::new(DMat3::from_rotation_y(0.02), DVec3::new(-0.075, 0.001, 0.0));
/// let pair = stereo_rectify(&camera, &camera, &right_from_left)?;
///
/// let point_in_left = DVec3::new(0.2, -0.1, 2.0);
/// let left = pair.rectified_from_left * point_in_left;
/// let right = pair.rectified_from_right * right_from_left.apply(point_in_left);
/// assert!((left.y / left.z - right.y / right.z).abs() < 1e-12); // the same row
/// # Ok::<(), oaktwin_camera::RectifyError>(())
/// ```
pub fn stereo_rectify(
    left: &Camera,
    right: &Camera,
    right_from_left: &RigidTransform,
) -> Result<Rectification, RectifyError> {
    stereo_rectify_to(left, right, right_from_left, RectifiedIntrinsics::default())
}

/// Rectifies a pair with the given choice of intrinsics.
///
/// Each camera is rotated by half of the rotation between them, then both by the smallest angle that aligns an axis with the
/// baseline. The rotations depend on `right_from_left` only, for any lens. A matrix that is not quite orthonormal (float32
/// numbers) is replaced by the nearest rotation, as in OpenCV.
///
/// Both of OpenCV's choices of intrinsics need the image's corners on the plane z = 1, where fisheye and f-theta cameras have
/// none. A pair with such a lens always uses [`RectifiedIntrinsics::LeftCamera`], as in `DepthAI`.
///
/// # Errors
/// Returns an error if the baseline is zero, the matrix is not a rotation, or the image sizes differ.
pub fn stereo_rectify_to(
    left: &Camera,
    right: &Camera,
    right_from_left: &RigidTransform,
    intrinsics: RectifiedIntrinsics,
) -> Result<Rectification, RectifyError> {
    let size = left.intrinsics.size;
    if size != right.intrinsics.size {
        return Err(RectifyError::Sizes(size, right.intrinsics.size));
    }
    let baseline = right_from_left.translation.length();
    if !(baseline > 0.0 && baseline.is_finite()) {
        return Err(RectifyError::Baseline(baseline));
    }
    let rotation = nearest_rotation(right_from_left.rotation)?;

    let half = half_rotation(rotation);
    let between = half.transpose() * right_from_left.translation;
    let axis = if between.x.abs() > between.y.abs() {
        BaselineAxis::Horizontal
    } else {
        BaselineAxis::Vertical
    };
    let along = match axis {
        BaselineAxis::Horizontal => DVec3::X,
        BaselineAxis::Vertical => DVec3::Y,
    };
    let aligned = rotation_onto(between, along * along.dot(between).signum());
    let rectified_from_left = aligned * half;
    let rectified_from_right = aligned * half.transpose();
    let offset = along.dot(rectified_from_right * right_from_left.translation);

    let (left, right) = match (intrinsics, opencv_lens(&left.lens), opencv_lens(&right.lens)) {
        (RectifiedIntrinsics::RightCamera, ..) => (right.intrinsics, right.intrinsics),
        (RectifiedIntrinsics::LeftCamera, ..) | (_, None, _) | (_, _, None) => {
            (left.intrinsics, left.intrinsics)
        }
        (choice, Some(left_lens), Some(right_lens)) => {
            let (a, b) = (&left.intrinsics, &right.intrinsics);
            // Perpendicular to the baseline, so that the epipolar lines of both images keep their scale.
            let focal = match axis {
                BaselineAxis::Horizontal => f64::midpoint(a.fy, b.fy),
                BaselineAxis::Vertical => f64::midpoint(a.fx, b.fx),
            };
            let mut ca = centre_of_corners(a, &left_lens, rectified_from_left, focal);
            let mut cb = centre_of_corners(b, &right_lens, rectified_from_right, focal);
            for (centre, side) in [(ca, "left"), (cb, "right")] {
                if !centre.is_finite() {
                    return Err(RectifyError::Lens(side));
                }
            }
            let mean = ca.midpoint(cb);
            let both = choice == RectifiedIntrinsics::ZeroDisparity;
            if both || axis == BaselineAxis::Vertical {
                (ca.x, cb.x) = (mean.x, mean.x);
            }
            if both || axis == BaselineAxis::Horizontal {
                (ca.y, cb.y) = (mean.y, mean.y);
            }
            (
                Intrinsics::new(size, focal, focal, PixelPoint::<OpenCv>::from(ca)),
                Intrinsics::new(size, focal, focal, PixelPoint::<OpenCv>::from(cb)),
            )
        }
    };
    let rectification = Rectification {
        rectified_from_left,
        rectified_from_right,
        left,
        right,
        axis,
        baseline,
        offset,
    };
    match rectification.not_finite() {
        Some(what) => Err(RectifyError::NotFinite(what)),
        None => Ok(rectification),
    }
}

impl Rectification {
    /// The first part that is not finite.
    fn not_finite(&self) -> Option<&'static str> {
        let rows =
            |projection: [[f64; 4]; 3]| projection.as_flattened().iter().all(|number| number.is_finite());
        [
            (
                "rotation of the left camera",
                self.rectified_from_left.is_finite(),
            ),
            (
                "rotation of the right camera",
                self.rectified_from_right.is_finite(),
            ),
            ("projection of the left camera", rows(self.projection_left())),
            ("projection of the right camera", rows(self.projection_right())),
        ]
        .into_iter()
        .find_map(|(what, is_finite)| (!is_finite).then_some(what))
    }

    /// Returns the rows of OpenCV's P1, which projects points in the rectified left frame into the left image.
    #[must_use]
    pub fn projection_left(&self) -> [[f64; 4]; 3] {
        self.left.opencv_matrix().map(|[a, b, c]| [a, b, c, 0.0])
    }

    /// Returns the rows of OpenCV's P2, which projects points in the rectified *left* frame into the right image.
    #[must_use]
    pub fn projection_right(&self) -> [[f64; 4]; 3] {
        let mut p = self.right.opencv_matrix().map(|[a, b, c]| [a, b, c, 0.0]);
        match self.axis {
            BaselineAxis::Horizontal => p[0][3] = self.right.fx * self.offset,
            BaselineAxis::Vertical => p[1][3] = self.right.fy * self.offset,
        }
        p
    }

    /// Returns OpenCV's Q: `Q · (x, y, disparity, 1)` is the homogeneous point in the rectified left frame of a left pixel
    /// and its disparity (left minus right, along the baseline).
    ///
    /// Like OpenCV's, Q has one focal length. With [`RectifiedIntrinsics::LeftCamera`] it is that along the baseline, which
    /// is exact for square pixels.
    #[must_use]
    pub fn disparity_to_depth(&self) -> DMat4 {
        let (a, b) = (
            self.left.principal_point::<OpenCv>(),
            self.right.principal_point::<OpenCv>(),
        );
        let (focal, shift) = match self.axis {
            BaselineAxis::Horizontal => (self.left.fx, a.x - b.x),
            BaselineAxis::Vertical => (self.left.fy, a.y - b.y),
        };
        DMat4::from_cols(
            DVec4::X,
            DVec4::Y,
            DVec4::new(0.0, 0.0, 0.0, -1.0 / self.offset),
            DVec4::new(-a.x, -a.y, focal, shift / self.offset),
        )
    }

    /// Returns the stereo geometry, if the given transform was in metres.
    #[must_use]
    pub fn stereo_geometry(&self) -> crate::StereoGeometry {
        let focal_length_px = match self.axis {
            BaselineAxis::Horizontal => self.left.fx,
            BaselineAxis::Vertical => self.left.fy,
        };
        crate::StereoGeometry {
            focal_length_px,
            baseline_m: self.baseline,
        }
    }
}

/// Returns the nearest rotation, the orthogonal factor of the polar decomposition, by Higham's iteration.
fn nearest_rotation(m: DMat3) -> Result<DMat3, RectifyError> {
    let determinant = m.determinant();
    if !(m.is_finite() && determinant > 1e-6) {
        return Err(RectifyError::Rotation(determinant));
    }
    let mut r = m;
    for _ in 0..40 {
        let next = (r + r.inverse().transpose()) * 0.5;
        let change = (next - r)
            .to_cols_array()
            .into_iter()
            .fold(0.0, |a: f64, x| a.max(x.abs()));
        r = next;
        if change < 1e-15 {
            break;
        }
    }
    Ok(r)
}

/// Returns the rotation about the same axis by half the angle.
fn half_rotation(rotation: DMat3) -> DMat3 {
    let q = DQuat::from_mat3(&rotation).normalize();
    let q = if q.w < 0.0 { -q } else { q };
    // q = (sin(θ/2) a, cos(θ/2)); adding 1 to its scalar part halves the angle.
    DMat3::from_quat(DQuat::from_xyzw(q.x, q.y, q.z, q.w + 1.0).normalize())
}

/// Returns the smallest rotation that aligns `from` with the unit vector `onto`.
fn rotation_onto(from: DVec3, onto: DVec3) -> DMat3 {
    let cross = from.cross(onto);
    let Some(axis) = cross.try_normalize() else {
        return DMat3::IDENTITY;
    };
    DMat3::from_axis_angle(axis, cross.length().atan2(from.dot(onto)))
}

fn opencv_lens(lens: &LensModel) -> Option<OpenCvPinhole> {
    match lens.as_opencv() {
        Some(OpenCvLens::Pinhole(coefficients)) => Some(OpenCvPinhole::new(coefficients)),
        _ => None,
    }
}

/// Returns the principal point that moves the mean of the four undistorted, rotated corners to the image's centre. Corners are
/// pixel centres, (0 | W − 1, 0 | H − 1).
fn centre_of_corners(camera: &Intrinsics, lens: &OpenCvPinhole, rotation: DMat3, focal: f64) -> DVec2 {
    let (right, bottom) = (
        f64::from(camera.size.width) - 1.0,
        f64::from(camera.size.height) - 1.0,
    );
    let mut sum = DVec2::ZERO;
    for (x, y) in [(0.0, 0.0), (right, 0.0), (0.0, bottom), (right, bottom)] {
        let pixel = PixelPoint::<OpenCv>::new(x, y);
        let undistorted = as_f32(opencv_undistort(lens, camera.normalized_from_pixel(pixel)));
        let p = rotation * undistorted.extend(1.0);
        let z = if p.z == 0.0 { 1.0 } else { p.z };
        sum += as_f32(focal * p.truncate() / z);
    }
    DVec2::new(right / 2.0, bottom / 2.0) - sum / 4.0
}

/// Undistorts a point like `cv2.undistortPoints` in `cv2.stereoRectify`: with five steps of a fixed-point iteration, converged
/// or not.
///
/// It determines only the principal point, for which any choice is valid; this one is OpenCV's.
fn opencv_undistort(lens: &OpenCvPinhole, distorted: DVec2) -> DVec2 {
    let Some(target) = lens.untilt(distorted) else {
        return distorted;
    };
    let flat = lens.without_tilt();
    let [k1, k2, _, _, k3, k4, k5, k6, ..] = *flat.coefficients();
    let mut at = target;
    for _ in 0..5 {
        let u = at.length_squared();
        let radial = (1.0 + u * (k1 + u * (k2 + u * k3))) / (1.0 + u * (k4 + u * (k5 + u * k6)));
        if 1.0 / radial < 0.0 {
            return distorted;
        }
        at = (target - (flat.distort(at) - at * radial)) / radial;
    }
    at
}

/// Rounds to float32, as OpenCV stores these corners.
fn as_f32(p: DVec2) -> DVec2 {
    p.as_vec2().as_dvec2()
}

#[cfg(test)]
mod tests;

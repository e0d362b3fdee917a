//! Stereo rectification after Bouguet, as `cv2.stereoRectify` computes it.

use glam::{DMat3, DMat4, DQuat, DVec2, DVec3, DVec4};
use oaktwin_parameter::choice;

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
        /// Those of the left camera, for both: `DepthAI`'s host-side rectification and RVC4 devices.
        LeftCamera = "left-camera",
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
    Ok(Rectification {
        rectified_from_left,
        rectified_from_right,
        left,
        right,
        axis,
        baseline,
        offset,
    })
}

impl Rectification {
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
        Some(OpenCvLens::Pinhole(coefficients)) => Some(OpenCvPinhole { coefficients }),
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
    let [k1, k2, _, _, k3, k4, k5, k6, ..] = flat.coefficients;
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
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn camera(f: f64, cx: f64, cy: f64) -> Camera {
        let lens = LensModel::OpenCvPinhole(OpenCvPinhole::from_slice(&[-0.05, 0.01, 1e-3, -1e-3]).unwrap());
        let centre = PixelPoint::<OpenCv>::new(cx, cy);
        Camera::new(
            Intrinsics::new(ImageSize::new(1280, 800), f, f + 1.0, centre),
            lens,
        )
    }

    #[test]
    fn ideal_pairs_do_not_change() {
        let camera = Camera::new(
            Intrinsics::from_hfov(ImageSize::new(1280, 800), 1.34),
            LensModel::Pinhole,
        );
        let shift = RigidTransform::new(DMat3::IDENTITY, DVec3::new(-0.075, 0.0, 0.0));
        let pair = stereo_rectify(&camera, &camera, &shift).unwrap();
        assert_eq!(pair.rectified_from_left, DMat3::IDENTITY);
        assert_eq!(pair.rectified_from_right, DMat3::IDENTITY);
        assert_eq!(
            (pair.baseline, pair.offset, pair.axis),
            (0.075, -0.075, BaselineAxis::Horizontal)
        );
        assert_eq!(pair.projection_right()[0][3], -0.075 * pair.right.fx);
        assert_eq!(pair.stereo_geometry().disparity(4.0), pair.left.fx * 0.075 / 4.0);
    }

    #[test]
    fn rejects_invalid_geometry() {
        let a = camera(800.0, 640.0, 400.0);
        let of = |b: &Camera, rotation, x| {
            stereo_rectify(&a, b, &RigidTransform::new(rotation, DVec3::new(x, 0.0, 0.0)))
        };
        assert_eq!(of(&a, DMat3::IDENTITY, 0.0), Err(RectifyError::Baseline(0.0)));
        assert!(matches!(
            of(&a, DMat3::IDENTITY, f64::NAN),
            Err(RectifyError::Baseline(_))
        ));
        assert_eq!(of(&a, DMat3::ZERO, 1.0), Err(RectifyError::Rotation(0.0)));
        assert_eq!(of(&a, -DMat3::IDENTITY, 1.0), Err(RectifyError::Rotation(-1.0)));
        let mut b = a;
        b.intrinsics.size = ImageSize::new(640, 400);
        let error = of(&b, DMat3::IDENTITY, 1.0).unwrap_err();
        assert_eq!(
            error.to_string(),
            "the image sizes 1280x800 and 640x400 differ; resize the intrinsics first"
        );
    }

    #[test]
    fn fisheye_pairs_use_the_left_intrinsics() {
        let mut a = camera(560.0, 640.0, 400.0);
        a.lens = LensModel::OpenCvFisheye(crate::OpenCvFisheye::default());
        let b = camera(570.0, 630.0, 410.0);
        let shift = RigidTransform::new(DMat3::from_rotation_z(0.01), DVec3::new(-0.075, 0.0, 0.0));
        let pair = stereo_rectify(&a, &b, &shift).unwrap();
        assert_eq!((pair.left, pair.right), (a.intrinsics, a.intrinsics));
    }

    proptest! {
        #[test]
        fn aligns_epipolar_lines_and_preserves_depth(
            turn in prop::array::uniform3(-0.1..0.1f64), t in prop::array::uniform3(-0.02..0.02f64),
            vertical: bool, sign: bool, p in prop::array::uniform2(-0.5..0.5f64), z in 1.0..5.0f64,
            choice in prop::sample::select(vec![RectifiedIntrinsics::ZeroDisparity, RectifiedIntrinsics::FreeDisparity]),
        ) {
            let rotation = DMat3::from_euler(glam::EulerRot::XYZ, turn[0], turn[1], turn[2]);
            let mut t = DVec3::from(t);
            t[usize::from(vertical)] = if sign { 0.08 } else { -0.08 };
            let right_from_left = RigidTransform::new(rotation, t);
            let pair =
                stereo_rectify_to(&camera(800.0, 630.0, 410.0), &camera(805.0, 650.0, 390.0), &right_from_left, choice)
                    .unwrap();

            let point_in_left = DVec3::new(p[0], p[1], z);
            let left = pair.rectified_from_left * point_in_left;
            let right = pair.rectified_from_right * right_from_left.apply(point_in_left);
            let a = pair.left.pixel_from_normalized(left.truncate() / left.z);
            let b = pair.right.pixel_from_normalized(right.truncate() / right.z);
            let (across, disparity) = match pair.axis {
                BaselineAxis::Horizontal => (a.y - b.y, a.x - b.x),
                BaselineAxis::Vertical => (a.x - b.x, a.y - b.y),
            };
            prop_assert!(across.abs() < 1e-9);
            prop_assert_eq!(pair.axis, if vertical { BaselineAxis::Vertical } else { BaselineAxis::Horizontal });

            let h = pair.disparity_to_depth() * DVec4::new(a.x, a.y, disparity, 1.0);
            prop_assert!((h.truncate() / h.w - left).length() < 1e-9);

            let [row, ..] = pair.projection_right();
            let through_p = (row[0] * left.x + row[2] * left.z + row[3]) / left.z;
            if !vertical {
                prop_assert!((through_p - b.x).abs() < 1e-9);
            }
        }

        #[test]
        fn returns_rotations(turn in prop::array::uniform3(-1.5..1.5f64), noise in prop::array::uniform9(-1e-7..1e-7f64)) {
            let rotation = DMat3::from_euler(glam::EulerRot::XYZ, turn[0], turn[1], turn[2]);
            let near = nearest_rotation(rotation + DMat3::from_cols_array(&noise)).unwrap();
            let error = |m: DMat3| RigidTransform::new(m, DVec3::ZERO).orthonormality_error();
            prop_assert!(error(near) < 1e-14);
            let half = half_rotation(rotation);
            prop_assert!(error(half) < 1e-14);
            prop_assert!(half.mul_mat3(&half).abs_diff_eq(rotation, 1e-14));
        }
    }
}

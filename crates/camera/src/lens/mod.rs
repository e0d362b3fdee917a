//! Lens models: how a lens bends the rays of an ideal pinhole.

mod ftheta;
mod monotone;
mod opencv_fisheye;
mod opencv_pinhole;

pub use ftheta::FTheta;
pub use opencv_fisheye::OpenCvFisheye;
pub use opencv_pinhole::OpenCvPinhole;

use glam::{DVec2, DVec3};

/// How a lens bends the ideal pinhole's rays.
///
/// A *distorted* point is what [`Intrinsics`](crate::Intrinsics) turn into a pixel: `pixel = f · distorted + c`.
///
/// Every lens polynomial folds back somewhere: beyond that, several rays share a distorted point. A model is taken to
/// hold from the axis up to the fold and no further; [`project_ray`](Self::project_ray) and
/// [`unproject`](Self::unproject) answer `None` outside, never a ray that is not there.
///
/// ```
/// use oaktwin_camera::{LensModel, OpenCvPinhole, math::DVec2};
///
/// let lens = LensModel::OpenCvPinhole(OpenCvPinhole::from_slice(&[-0.3, 0.1, 1e-3, -5e-4])?);
/// let distorted = lens.distort(DVec2::new(0.4, -0.2));
/// let undistorted = lens.undistort(distorted).ok_or("folded")?;
/// assert!((undistorted - DVec2::new(0.4, -0.2)).length() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum LensModel {
    /// No distortion.
    #[default]
    Pinhole,
    /// OpenCV's rational, thin-prism and tilt model.
    OpenCvPinhole(OpenCvPinhole),
    /// OpenCV's fisheye model (equidistant with four odd terms).
    OpenCvFisheye(OpenCvFisheye),
    /// NVIDIA's f-theta model (a polynomial from pixel radius to angle).
    FTheta(FTheta),
}

impl LensModel {
    /// The distorted point of a point on the plane z = 1: the model's formula as it stands, beyond its fold too, as
    /// OpenCV evaluates it. NaN where the f-theta model has no value.
    #[must_use]
    pub fn distort(&self, normalized: DVec2) -> DVec2 {
        match self {
            Self::Pinhole => normalized,
            Self::OpenCvPinhole(lens) => lens.distort(normalized),
            Self::OpenCvFisheye(lens) => lens.distort(normalized),
            Self::FTheta(lens) => lens.project_ray(normalized.extend(1.0)).unwrap_or(DVec2::NAN),
        }
    }

    /// The point on the plane z = 1 that lies behind a distorted one, or `None` where the model has no inverse or the
    /// ray does not meet the plane.
    #[must_use]
    pub fn undistort(&self, distorted: DVec2) -> Option<DVec2> {
        match self {
            Self::Pinhole => distorted.is_finite().then_some(distorted),
            Self::OpenCvPinhole(lens) => lens.undistort(distorted),
            Self::OpenCvFisheye(_) | Self::FTheta(_) => on_plane(self.unproject(distorted)?),
        }
    }

    /// The distorted point of a point in the camera's frame, any distance away: `None` behind a pinhole, outside the
    /// region where the model is one to one, and at the optical centre.
    #[must_use]
    pub fn project_ray(&self, point_in_camera: DVec3) -> Option<DVec2> {
        match self {
            Self::Pinhole => on_plane(point_in_camera),
            Self::OpenCvPinhole(lens) => {
                let normalized = on_plane(point_in_camera)?;
                lens.is_monotone_at(normalized).then(|| lens.distort(normalized))
            }
            Self::OpenCvFisheye(lens) => lens.project_ray(point_in_camera),
            Self::FTheta(lens) => lens.project_ray(point_in_camera),
        }
    }

    /// The unit ray in the camera's frame that is seen at a distorted point, or `None` where the model has none.
    #[must_use]
    pub fn unproject(&self, distorted: DVec2) -> Option<DVec3> {
        match self {
            Self::Pinhole => unit_ray(distorted),
            Self::OpenCvPinhole(lens) => unit_ray(lens.undistort(distorted)?),
            Self::OpenCvFisheye(lens) => lens.unproject(distorted),
            Self::FTheta(lens) => lens.unproject(distorted),
        }
    }
}

/// Coefficients that make no lens.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum LensError {
    /// A list longer than the model's.
    #[error("{model}: {count} coefficients, the model has at most {most}; drop the surplus")]
    TooMany {
        /// The model's name.
        model: &'static str,
        /// How many were given.
        count: usize,
        /// How many it takes.
        most: usize,
    },
    /// A NaN or an infinity.
    #[error("{model}: coefficient {index} is {value}; give a finite number")]
    NotFinite {
        /// The model's name.
        model: &'static str,
        /// Which one, from 0.
        index: usize,
        /// What it is.
        value: f64,
    },
    /// An f-theta lens whose angle does not grow at the optical centre.
    #[error("f-theta: k1 is {k1} rad/px; the angle must grow with the radius, so k1 must be above 0")]
    NoAngle {
        /// The coefficient.
        k1: f64,
    },
}

/// `given`, checked and padded with zeros.
fn padded<const N: usize>(model: &'static str, given: &[f64]) -> Result<[f64; N], LensError> {
    if given.len() > N {
        return Err(LensError::TooMany {
            model,
            count: given.len(),
            most: N,
        });
    }
    if let Some((index, &value)) = given.iter().enumerate().find(|(_, value)| !value.is_finite()) {
        return Err(LensError::NotFinite { model, index, value });
    }
    let mut all = [0.0; N];
    all[..given.len()].copy_from_slice(given);
    Ok(all)
}

fn on_plane(point: DVec3) -> Option<DVec2> {
    let normalized = point.truncate() / point.z;
    (point.z > 0.0 && normalized.is_finite()).then_some(normalized)
}

fn unit_ray(normalized: DVec2) -> Option<DVec3> {
    normalized.extend(1.0).try_normalize()
}

/// The angle from the optical axis, 0 to π, and the unit direction across it (zero on the axis itself).
fn polar(point: DVec3) -> Option<(f64, DVec2)> {
    let across = point.truncate();
    let distance = across.length();
    let angle = distance.atan2(point.z);
    (point.is_finite() && point != DVec3::ZERO).then(|| (angle, across.normalize_or_zero()))
}

/// The unit ray at `angle` from the axis towards `across`.
fn ray_at(angle: f64, across: DVec2) -> DVec3 {
    let (sin, cos) = angle.sin_cos();
    (across.normalize_or_zero() * sin).extend(cos)
}

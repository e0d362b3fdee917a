//! Lens models.

mod ftheta;
mod monotone;
mod names;
mod opencv_fisheye;
mod opencv_pinhole;
mod rational;

pub use ftheta::FTheta;
pub use names::{LensFamily, LensNames};
pub use opencv_fisheye::OpenCvFisheye;
pub use opencv_pinhole::OpenCvPinhole;

use glam::{DVec2, DVec3};

/// A lens model: the relation between rays and distorted points.
///
/// [`Intrinsics`](crate::Intrinsics) convert a *distorted* point to a pixel: `pixel = f · distorted + c`.
///
/// Every lens polynomial folds back at some radius, beyond which several rays share a distorted point. A model is valid
/// from the axis up to the fold; outside, [`project_ray`](Self::project_ray) and [`unproject`](Self::unproject) return
/// `None`.
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
    /// Returns the distorted point of a point on the plane z = 1. Like OpenCV, this evaluates the model's formula beyond
    /// its fold too. NaN where the f-theta model has no value.
    #[must_use]
    pub fn distort(&self, normalized: DVec2) -> DVec2 {
        match self {
            Self::Pinhole => normalized,
            Self::OpenCvPinhole(lens) => lens.distort(normalized),
            Self::OpenCvFisheye(lens) => lens.distort(normalized),
            Self::FTheta(lens) => lens.project_ray(normalized.extend(1.0)).unwrap_or(DVec2::NAN),
        }
    }

    /// Returns the point on the plane z = 1 of a distorted point, or `None` if the model has no inverse there or the ray
    /// does not intersect the plane.
    #[must_use]
    pub fn undistort(&self, distorted: DVec2) -> Option<DVec2> {
        match self {
            Self::Pinhole => distorted.is_finite().then_some(distorted),
            Self::OpenCvPinhole(lens) => lens.undistort(distorted),
            Self::OpenCvFisheye(_) | Self::FTheta(_) => on_plane(self.unproject(distorted)?),
        }
    }

    /// Returns the distorted point of a point in the camera's frame at any distance, or `None` behind a pinhole, where the
    /// model is not injective, and at the optical centre.
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

    /// Returns the unit ray in the camera's frame of a distorted point, or `None` where the model has none.
    #[must_use]
    pub fn unproject(&self, distorted: DVec2) -> Option<DVec3> {
        match self {
            Self::Pinhole => unit_ray(distorted),
            Self::OpenCvPinhole(lens) => unit_ray(lens.undistort(distorted)?),
            Self::OpenCvFisheye(lens) => lens.unproject(distorted),
            Self::FTheta(lens) => lens.unproject(distorted),
        }
    }

    /// Returns the model's coefficients in its own order.
    #[must_use]
    pub const fn coefficients(&self) -> &[f64] {
        match self {
            Self::Pinhole => &[],
            Self::OpenCvPinhole(lens) => lens.coefficients(),
            Self::OpenCvFisheye(lens) => &lens.k,
            Self::FTheta(lens) => &lens.k,
        }
    }

    /// Returns the names of the model.
    #[must_use]
    pub const fn names(&self) -> &'static LensNames {
        match self {
            Self::Pinhole => &LensNames::PINHOLE,
            Self::OpenCvPinhole(_) => &LensNames::OPENCV_PINHOLE,
            Self::OpenCvFisheye(_) => &LensNames::OPENCV_FISHEYE,
            Self::FTheta(_) => &LensNames::F_THETA,
        }
    }

    /// Whether the model maps the plane z = 1, so that it sees less than 180°.
    #[must_use]
    pub const fn is_perspective(&self) -> bool {
        match self {
            Self::Pinhole | Self::OpenCvPinhole(_) => true,
            Self::OpenCvFisheye(_) | Self::FTheta(_) => false,
        }
    }

    /// Returns the lens as one of OpenCV's two models, or `None` if OpenCV cannot represent it.
    #[must_use]
    pub const fn as_opencv(&self) -> Option<OpenCvLens> {
        match self {
            Self::Pinhole => Some(OpenCvLens::Pinhole([0.0; 14])),
            Self::OpenCvPinhole(lens) => Some(OpenCvLens::Pinhole(*lens.coefficients())),
            Self::OpenCvFisheye(lens) => Some(OpenCvLens::Fisheye(lens.k)),
            Self::FTheta(_) => None,
        }
    }
}

/// The coefficients of OpenCV's two camera models, which calibration formats are limited to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum OpenCvLens {
    /// k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4 τx τy.
    Pinhole([f64; 14]),
    /// k1 k2 k3 k4.
    Fisheye([f64; 4]),
}

/// Invalid coefficients.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum LensError {
    /// More coefficients than the model has.
    #[error("{model}: {count} coefficients, the model has at most {max}; drop the surplus")]
    TooMany {
        /// The model's name.
        model: &'static str,
        /// The number of given coefficients.
        count: usize,
        /// The number of the model's coefficients.
        max: usize,
    },
    /// A coefficient is NaN or infinite.
    #[error("{model}: coefficient {index} is {value}; give a finite number")]
    NotFinite {
        /// The model's name.
        model: &'static str,
        /// The index, from 0.
        index: usize,
        /// The value.
        value: f64,
    },
    /// The angle of an f-theta lens does not grow at the optical centre.
    #[error("f-theta: k1 is {k1} rad/px; the angle must grow with the radius, so k1 must be above 0")]
    NoAngle {
        /// The coefficient.
        k1: f64,
    },
}

/// Checks coefficients and pads them with zeros.
fn padded<const N: usize>(model: &'static str, given: &[f64]) -> Result<[f64; N], LensError> {
    if given.len() > N {
        return Err(LensError::TooMany {
            model,
            count: given.len(),
            max: N,
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

/// Returns the angle from the optical axis, 0 to π, and the unit direction perpendicular to it (zero on the axis).
fn polar(point: DVec3) -> Option<(f64, DVec2)> {
    let across = point.truncate();
    let distance = across.length();
    let angle = distance.atan2(point.z);
    (point.is_finite() && point != DVec3::ZERO).then(|| (angle, across.normalize_or_zero()))
}

/// Returns the unit ray at `angle` from the axis towards `across`.
fn ray_at(angle: f64, across: DVec2) -> DVec3 {
    let (sin, cos) = angle.sin_cos();
    (across.normalize_or_zero() * sin).extend(cos)
}

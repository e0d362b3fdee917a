//! Approximations of cameras by simpler models: intrinsics and coefficients that project the camera's rays to nearly the same pixels.

mod family;
mod fit;

use oaktwin_base::diagnostic::{Finding, Level, Message, message, opt};
use oaktwin_camera::math::DVec2;
use oaktwin_camera::{Camera, Intrinsics, LensModel, OpenCv, OpenCvFisheye, OpenCvPinhole, PixelPoint};

use crate::check::FITTED;

/// The number of samples along each side of the image.
const GRID: u32 = 25;
/// The least number of samples for a fit, twice the unknowns of the largest model.
const MIN_SAMPLES: usize = 24;
/// The residual that causes a warning, px (root mean square): a calibration of these cameras has one below 1 px.
const SUSPICIOUS_PX: f64 = 1.0;
/// The residual that is an error, px (root mean square).
const WRONG_PX: f64 = 5.0;

/// A ray of a camera, as its point on the plane z = 1, and its pixel in OpenCV's convention.
#[derive(Clone, Copy)]
struct Sample {
    point: DVec2,
    pixel: DVec2,
}

/// A camera that approximates another one, and the distance between their projections over the image, px.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fitted {
    /// The approximation.
    pub(super) camera: Camera,
    /// The root mean square of the residual, px.
    pub(super) rms_px: f64,
    /// The maximum of the residual, px.
    pub(super) max_px: f64,
    /// Whether each sampled ray has a pixel of its own, so that images can be undistorted.
    is_injective: bool,
}

impl Fitted {
    /// Whether to prefer this approximation to another.
    fn is_better_than(&self, other: &Self) -> bool {
        (other.is_injective, self.rms_px) < (self.is_injective, other.rms_px)
    }

    /// Returns the finding that states the residual. `what` says what was fitted, and why.
    pub(super) fn finding(&self, place: String, what: &str, remedy: &str) -> Finding {
        let level = match self.rms_px {
            rms if rms > WRONG_PX => Level::Error,
            rms if rms > SUSPICIOUS_PX => Level::Warning,
            _ => Level::Note,
        };
        let remedy: Message = match level {
            Level::Error => message![remedy, "; ", opt("force"), " exports it nevertheless"],
            Level::Warning => remedy.into(),
            Level::Note => "".into(),
        };
        let (rms, max) = (self.rms_px, self.max_px);
        let message = format!("{what}; the residual is {rms:.2} px (root mean square), at most {max:.2} px");
        Finding::new(FITTED, level, place, message, remedy)
    }
}

/// Fits intrinsics and the radial-tangential model (k1, k2, p1, p2), or `None` if too few pixels have a ray.
pub(super) fn radial_tangential(camera: &Camera) -> Option<Fitted> {
    let lens = |k: [f64; 4]| pinhole(&k);
    best(camera, family::radial_tangential, &[[0.0; 4]], lens)
}

/// Fits intrinsics and the equidistant model (k1 to k4), or `None` if too few pixels have a ray.
pub(super) fn equidistant(camera: &Camera) -> Option<Fitted> {
    let lens = |k| LensModel::OpenCvFisheye(OpenCvFisheye { k });
    best(camera, family::equidistant, &[[0.0; 4]], lens)
}

/// Fits intrinsics and the rational model (the first eight coefficients of OpenCV's), or `None` if too few pixels have a ray.
pub(super) fn rational(camera: &Camera, start: [f64; 8]) -> Option<Fitted> {
    let lens = |coefficients: [f64; 8]| pinhole(&coefficients);
    best(camera, family::rational, &[start, [0.0; 8]], lens)
}

/// Returns the better one of two approximations.
pub(super) fn better(a: Option<Fitted>, b: Option<Fitted>) -> Option<Fitted> {
    match (a, b) {
        (Some(a), Some(b)) => Some(if b.is_better_than(&a) { b } else { a }),
        (a, b) => a.or(b),
    }
}

fn pinhole(first: &[f64]) -> LensModel {
    let mut coefficients = [0.0; 14];
    for (to, from) in coefficients.iter_mut().zip(first) {
        *to = *from;
    }
    LensModel::OpenCvPinhole(OpenCvPinhole::new(coefficients))
}

/// Fits a family of lenses from several starts.
fn best<const N: usize>(
    camera: &Camera,
    family: family::Family<N>,
    starts: &[[f64; N]],
    lens: impl Fn([f64; N]) -> LensModel,
) -> Option<Fitted> {
    let samples = samples(camera);
    if samples.len() < MIN_SAMPLES {
        return None;
    }
    let from = &camera.intrinsics;
    let fits = starts.iter().filter_map(|start| {
        let found = fit::fit(&samples, family, from, *start)?;
        let [fx, fy, cx, cy] = found.intrinsics;
        let intrinsics = Intrinsics::new(from.size, fx, fy, PixelPoint::<OpenCv>::new(cx, cy));
        judge(Camera::new(intrinsics, lens(found.coefficients)), &samples)
    });
    fits.fold(None, |best, fit| better(best, Some(fit)))
}

/// Returns the rays over the whole image. Pixels without a ray are skipped.
fn samples(camera: &Camera) -> Vec<Sample> {
    let size = camera.intrinsics.size;
    let along =
        |i: u32, extent: u32| f64::from(extent.saturating_sub(1)) * f64::from(i) / f64::from(GRID - 1);
    (0..GRID)
        .flat_map(|j| (0..GRID).map(move |i| DVec2::new(along(i, size.width), along(j, size.height))))
        .filter_map(|pixel| {
            let at = PixelPoint::<OpenCv>::new(pixel.x, pixel.y);
            let distorted = camera.intrinsics.normalized_from_pixel(at);
            let point = camera.lens.undistort(distorted)?;
            Some(Sample { point, pixel })
        })
        .collect()
}

/// Measures an approximation; `None` if a number of it is not finite.
fn judge(camera: Camera, samples: &[Sample]) -> Option<Fitted> {
    let (mut sum, mut max_px) = (0.0, 0.0_f64);
    let mut is_injective = true;
    for Sample { point, pixel } in samples {
        let found = camera
            .intrinsics
            .pixel_from_normalized(camera.lens.distort(*point));
        let error = (DVec2::new(found.x, found.y) - *pixel).length();
        sum += error * error;
        max_px = max_px.max(error);
        is_injective &= camera.lens.project_ray(point.extend(1.0)).is_some();
    }
    #[expect(clippy::cast_precision_loss, reason = "at most GRID² samples")]
    let n = samples.len().max(1) as f64;
    let rms_px = (sum / n).sqrt();
    rms_px.is_finite().then_some(Fitted {
        camera,
        rms_px,
        max_px,
        is_injective,
    })
}

#[cfg(test)]
mod tests;

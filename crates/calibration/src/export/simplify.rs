//! Approximations of lenses by simpler models.

use oaktwin_camera::math::{DMat4, DVec2, DVec4};
use oaktwin_camera::{Camera, LensModel, OpenCv, OpenCvFisheye, OpenCvPinhole, PixelPoint};

/// The number of samples along each side of the image.
const GRID: u32 = 41;

/// Returns points of the plane z = 1 over the whole image, each with its distorted point. Pixels without a ray are skipped.
fn samples(camera: &Camera) -> Vec<(DVec2, DVec2)> {
    let size = camera.intrinsics.size;
    let along =
        |i: u32, extent: u32| f64::from(extent.saturating_sub(1)) * f64::from(i) / f64::from(GRID - 1);
    (0..GRID)
        .flat_map(|j| (0..GRID).map(move |i| (along(i, size.width), along(j, size.height))))
        .filter_map(|(x, y)| {
            let distorted = camera
                .intrinsics
                .normalized_from_pixel(PixelPoint::<OpenCv>::new(x, y));
            Some((camera.lens.undistort(distorted)?, distorted))
        })
        .collect()
}

/// Returns the difference of another lens over the image, px: (root mean square, maximum).
pub(super) fn error_px(camera: &Camera, lens: &LensModel) -> (f64, f64) {
    let focal = DVec2::new(camera.intrinsics.fx, camera.intrinsics.fy);
    let samples = samples(camera);
    let (mut sum, mut worst) = (0.0, 0.0_f64);
    for (point, distorted) in &samples {
        let error = (focal * (lens.distort(*point) - *distorted)).length();
        sum += error * error;
        worst = worst.max(error);
    }
    #[expect(clippy::cast_precision_loss, reason = "at most GRID² samples")]
    let n = samples.len().max(1) as f64;
    ((sum / n).sqrt(), worst)
}

/// Fits the radial-tangential model (k1, k2, p1, p2) to a camera's lens over its image.
pub(super) fn radial_tangential(camera: &Camera) -> Option<OpenCvPinhole> {
    let basis = |p: DVec2| {
        let u = p.length_squared();
        [
            p * u,
            p * u * u,
            DVec2::new(2.0 * p.x * p.y, u + 2.0 * p.y * p.y),
            DVec2::new(u + 2.0 * p.x * p.x, 2.0 * p.x * p.y),
        ]
    };
    let c = least_squares(camera, |p| p, basis)?;
    let mut coefficients = [0.0; 14];
    coefficients[..4].copy_from_slice(&c);
    Some(OpenCvPinhole::new(coefficients))
}

/// Fits the equidistant model (k1 to k4) to a camera's lens over its image.
pub(super) fn equidistant(camera: &Camera) -> Option<OpenCvFisheye> {
    let direction_and_angle = |p: DVec2| (p.normalize_or_zero(), p.length().atan());
    let basis = |p: DVec2| {
        let (direction, angle) = direction_and_angle(p);
        [3, 5, 7, 9].map(|n| direction * angle.powi(n))
    };
    let ideal = |p: DVec2| {
        let (direction, angle) = direction_and_angle(p);
        direction * angle
    };
    Some(OpenCvFisheye {
        k: least_squares(camera, ideal, basis)?,
    })
}

/// Returns the coefficients c that minimize the distance of `ideal(p) + Σ c basis(p)` from the distorted p. Both models are
/// linear in them, so that four normal equations suffice.
fn least_squares(
    camera: &Camera,
    ideal: impl Fn(DVec2) -> DVec2,
    basis: impl Fn(DVec2) -> [DVec2; 4],
) -> Option<[f64; 4]> {
    let samples = samples(camera);
    if samples.len() < 16 {
        return None;
    }
    let (mut normal, mut right) = (DMat4::ZERO, DVec4::ZERO);
    for (point, distorted) in samples {
        let basis = basis(point);
        let rest = distorted - ideal(point);
        let axis = |pick: fn(DVec2) -> f64| (DVec4::from(basis.map(pick)), pick(rest));
        for (row, value) in [axis(|v| v.x), axis(|v| v.y)] {
            normal += DMat4::from_cols(row * row.x, row * row.y, row * row.z, row * row.w);
            right += row * value;
        }
    }
    let c = normal.inverse() * right;
    c.is_finite().then(|| c.to_array())
}

#[cfg(test)]
mod tests {
    use super::*;
    use oaktwin_camera::{ImageSize, Intrinsics};
    use proptest::prelude::*;

    fn camera(lens: LensModel) -> Camera {
        Camera::new(Intrinsics::from_hfov(ImageSize::new(1280, 800), 1.34), lens)
    }

    proptest! {
        #[test]
        fn recovers_lenses_of_the_family(k in prop::array::uniform4(-0.02..0.02f64)) {
            let mut coefficients = [0.0; 14];
            coefficients[..4].copy_from_slice(&k);
            let given = camera(LensModel::OpenCvPinhole(OpenCvPinhole::new(coefficients)));
            let found = radial_tangential(&given).unwrap();
            for (a, b) in found.coefficients().iter().zip(coefficients) {
                prop_assert!((a - b).abs() < 1e-9);
            }
            let given = camera(LensModel::OpenCvFisheye(OpenCvFisheye { k }));
            let found = equidistant(&given).unwrap();
            prop_assert!(error_px(&given, &LensModel::OpenCvFisheye(found)).1 < 1e-6);
        }
    }

    #[test]
    fn error_is_in_pixels() {
        let given = camera(LensModel::OpenCvPinhole(
            OpenCvPinhole::from_slice(&[0.1]).unwrap(),
        ));
        let (rms, worst) = error_px(&given, &LensModel::Pinhole);
        // At the corner the distorted radius is r, the undistorted one u with u (1 + 0.1 u²) = r.
        let corner = given
            .lens
            .undistort(
                given
                    .intrinsics
                    .normalized_from_pixel(PixelPoint::<OpenCv>::new(0.0, 0.0)),
            )
            .unwrap();
        let expected = given.intrinsics.fx * 0.1 * corner.length().powi(3);
        assert!((worst - expected).abs() < 1e-6 && rms < worst && rms > 0.0);
    }
}

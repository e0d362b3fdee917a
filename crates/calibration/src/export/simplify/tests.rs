use super::*;
use oaktwin_camera::ImageSize;
use proptest::prelude::*;

fn camera(lens: LensModel) -> Camera {
    Camera::new(Intrinsics::from_hfov(ImageSize::new(1280, 800), 1.34), lens)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    #[test]
    fn recovers_lenses_of_the_family(k in prop::array::uniform4(-0.02..0.02f64)) {
        let given = camera(pinhole(&k));
        let found = radial_tangential(&given).unwrap();
        prop_assert!(found.max_px < 1e-4, "{found:?}");
        prop_assert!((found.camera.intrinsics.fx - given.intrinsics.fx).abs() < 1e-3);
        let given = camera(LensModel::OpenCvFisheye(OpenCvFisheye { k }));
        let found = equidistant(&given).unwrap();
        prop_assert!(found.max_px < 1e-4, "{found:?}");
    }

    /// A pinhole's principal point and small rotations replace most of a small tilt.
    #[test]
    fn fits_tilted_lenses_better_than_dropping_the_tilt(tau in prop::array::uniform2(-0.01..0.01f64)) {
        let kept = [-6.3, 21.6, 2e-4, -4e-4, 13.9, -6.284, 21.417, 14.2];
        let all: Vec<f64> = kept.into_iter().chain([0.0; 4]).chain(tau).collect();
        let given = camera(pinhole(&all));
        let found = rational(&given, kept).unwrap();
        let dropped = judge(camera(pinhole(&kept)), &samples(&given)).unwrap();
        prop_assert!(found.rms_px <= dropped.rms_px + 1e-9, "{found:?} {dropped:?}");
        prop_assert!(found.is_injective);
    }
}

#[test]
fn the_derivatives_are_those_of_the_functions() {
    fn check<const N: usize>(family: family::Family<N>, at: [f64; N]) {
        let point = DVec2::new(0.4, -0.3);
        let (_, slopes) = family(point, &at);
        for (i, slope) in slopes.into_iter().enumerate() {
            let moved = |by: f64| {
                let mut there = at;
                there[i] += by;
                family(point, &there).0
            };
            let difference = (moved(1e-5) - moved(-1e-5)) / 2e-5;
            assert!((difference - slope).length() < 1e-8, "{i}: {difference} {slope}");
        }
    }
    check(family::radial_tangential, [-0.1, 0.05, 1e-3, -2e-3]);
    check(family::equidistant, [-0.1, 0.05, 0.01, -0.02]);
    check(family::rational, [2.0, 1.5, 1e-3, -2e-3, 0.4, 1.9, 1.4, 0.3]);
}

#[test]
fn residuals_are_in_pixels() {
    let given = camera(pinhole(&[0.1]));
    let judged = judge(camera(LensModel::Pinhole), &samples(&given)).unwrap();
    // At the corner the distorted radius is r, the undistorted one u with u (1 + 0.1 u²) = r.
    let corner = given
        .intrinsics
        .normalized_from_pixel(PixelPoint::<OpenCv>::new(0.0, 0.0));
    let corner = given.lens.undistort(corner).unwrap();
    let expected = given.intrinsics.fx * 0.1 * corner.length().powi(3);
    assert!((judged.max_px - expected).abs() < 1e-6 && judged.rms_px < judged.max_px && judged.rms_px > 0.0);
}

#[test]
fn too_few_rays_have_no_fit() {
    // Every pixel but a few near the centre is beyond the fold.
    let given = camera(pinhole(&[-40.0]));
    assert!(radial_tangential(&given).is_none());
}

use oaktwin_camera::math::{DMat3, DVec3};
use oaktwin_camera::{
    Camera, ImageSize, Intrinsics, LensModel, OpenCvFisheye, OpenCvPinhole, PixelPoint, RigidTransform, Usd,
};
use oaktwin_image::{Image, ZDepth};
use proptest::prelude::*;

use super::*;

fn camera(size: [u32; 2], f: f64, lens: LensModel) -> Camera {
    let size = ImageSize::new(size[0], size[1]);
    let centre = PixelPoint::<Usd>::new(
        f64::from(size.width) / 2.0 + 0.7,
        f64::from(size.height) / 2.0 - 1.3,
    );
    Camera::new(Intrinsics::new(size, f, f * 1.01, centre), lens)
}

fn splat(fill: Fill) -> AlignMode {
    AlignMode {
        fill,
        ..AlignMode::default()
    }
}

fn distorted() -> LensModel {
    LensModel::OpenCvPinhole(OpenCvPinhole::from_slice(&[-0.2, 0.05, 1e-3, -2e-3, 0.01]).unwrap())
}

/// Sample by sample with the cameras' own functions.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "within the image"
)]
fn brute_force(align: &Align, depth: &Image<f32>) -> Vec<f32> {
    let (source, target) = (&align.source, &align.target);
    let size = target.intrinsics.size;
    let mut out = vec![0f32; (size.width * size.height) as usize];
    for y in 0..depth.height() {
        for x in 0..depth.width() {
            let z = *depth.get(x, y).unwrap();
            if !(z.is_finite() && z > 0.0) {
                continue;
            }
            let pixel = PixelPoint::<Usd>::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
            let Some(ray) = source.unproject(pixel) else {
                continue;
            };
            let point = align.target_from_source.apply(ray / ray.z * f64::from(z));
            if point.z <= 0.0 {
                continue;
            }
            let Some(seen) = target.project(point) else {
                continue;
            };
            let seen = seen.to::<Usd>();
            if seen.x < 0.0
                || seen.y < 0.0
                || seen.x >= f64::from(size.width)
                || seen.y >= f64::from(size.height)
            {
                continue;
            }
            let place = &mut out[seen.y as usize * size.width as usize + seen.x as usize];
            let z = point.z as f32;
            if *place == 0.0 || z < *place {
                *place = z;
            }
        }
    }
    out
}

fn turned(x: f64, y: f64, z: f64, t: [f64; 3]) -> RigidTransform {
    let rotation = DMat3::from_rotation_z(z) * DMat3::from_rotation_y(y) * DMat3::from_rotation_x(x);
    RigidTransform::new(rotation, DVec3::from(t))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]
    #[test]
    fn the_nearest_of_all_that_fall_into_a_pixel(
        depths in prop::collection::vec(prop_oneof![4 => 0.3f32..8.0, 1 => Just(0.0), 1 => Just(f32::NAN),
            1 => Just(f32::INFINITY), 1 => Just(-1.0)], 40 * 25),
        turn in prop::array::uniform3(-0.2..0.2f64), t in prop::array::uniform3(-0.3..0.3f64),
        lens in 0..3usize, source_lens in 0..2usize,
    ) {
        let lenses = [LensModel::Pinhole, distorted(), LensModel::OpenCvFisheye(OpenCvFisheye { k: [-0.02, 0.001, 0.0, 0.0] })];
        let align = Align::new(
            camera([40, 25], 30.0, lenses[source_lens]),
            camera([55, 33], 37.0, lenses[lens]),
            turned(turn[0], turn[1], turn[2], t),
            splat(Fill::Nearest),
        );
        let depth = Image::new(40, 25, depths).unwrap();
        let ZDepth(aligned) = align.align((&depth).into()).unwrap();
        let expected = brute_force(&align, &depth);
        // A projection on a pixel's border, or a depth between two floats, may fall on either side of it by the last bit.
        let differ = aligned.pixels().iter().zip(&expected).filter(|(a, b)| (**a - **b).abs() > 1e-6).count();
        prop_assert!(differ <= 1, "{differ} pixels differ");
    }

    /// A plane n·p = h in the source, seen by any camera: z = h' / (n'·ray) in closed form.
    #[test]
    fn a_plane_is_the_plane_that_the_target_sees(
        slope in prop::array::uniform2(-0.4..0.4f64), turn in prop::array::uniform3(-0.05..0.05f64),
        t in prop::array::uniform3(-0.08..0.08f64), larger in 1..4u32, lens in 0..2usize,
    ) {
        let source = camera([64, 40], 40.0, LensModel::Pinhole);
        // A narrower view than the source's, so that all of it is measured.
        let size = [32 * larger, 20 * larger];
        let target = camera(size, 40.0 * f64::from(larger), [LensModel::Pinhole, distorted()][lens]);
        let target_from_source = turned(turn[0], turn[1], turn[2], t);
        let normal = DVec3::new(slope[0], slope[1], 1.0).normalize();
        let height = 2.0;
        let plane = |camera: &Camera, normal: DVec3, height: f64, x: u32, y: u32| {
            let ray = camera.unproject(PixelPoint::<Usd>::new(f64::from(x) + 0.5, f64::from(y) + 0.5)).unwrap();
            height * ray.z / normal.dot(ray)
        };
        #[expect(clippy::cast_possible_truncation, reason = "depth is single precision")]
        let depth: Vec<f32> = (0..40).flat_map(|y| (0..64).map(move |x| (x, y)))
            .map(|(x, y)| plane(&source, normal, height, x, y) as f32).collect();
        let depth = Image::new(64, 40, depth).unwrap();
        let align = Align::new(source, target, target_from_source, splat(Fill::Footprint));
        let ZDepth(aligned) = align.align((&depth).into()).unwrap();
        let normal_in_target = target_from_source.rotation * normal;
        let height_in_target = height + normal_in_target.dot(target_from_source.translation);
        let mut holes = 0;
        for y in 0..size[1] {
            for x in 0..size[0] {
                let z = f64::from(*aligned.get(x, y).unwrap());
                if z == 0.0 {
                    holes += 1;
                    continue;
                }
                // A sample represents its footprint: it is as far off as the plane slopes over a source pixel and a half.
                let expected = plane(&target, normal_in_target, height_in_target, x, y);
                let tolerance = 1.6 * expected / 40.0 * (slope[0].abs() + slope[1].abs() + 0.15);
                prop_assert!((z - expected).abs() < tolerance, "({x}, {y}): {z} for {expected}");
            }
        }
        prop_assert_eq!(holes, 0);
    }
}

#[test]
fn a_wall_in_front_by_the_closed_form_of_disparity() {
    // 75 mm to the right, 800 px: everything moves left by 60 px·m over z.
    let size = ImageSize::new(200, 4);
    let k = Intrinsics::new(size, 800.0, 800.0, PixelPoint::<Usd>::new(100.0, 2.0));
    let pinhole = Camera::new(k, LensModel::Pinhole);
    let right_from_left = RigidTransform::new(DMat3::IDENTITY, DVec3::new(-0.075, 0.0, 0.0));
    let row: Vec<f32> = (0..200)
        .map(|x| if (80..120).contains(&x) { 2.0 } else { 6.0 })
        .collect();
    let depth = Image::new(200, 4, row.repeat(4)).unwrap();
    for fill in [Fill::Nearest, Fill::Footprint] {
        let align = Align::new(pinhole, pinhole, right_from_left, splat(fill));
        let ZDepth(aligned) = align.align((&depth).into()).unwrap();
        let row = &aligned.pixels()[..200];
        // The wall moves by 10 px and the thing by 30: it hides what was left of it and uncovers 20 px on its right.
        assert!(row[..50].iter().all(|&z| z == 6.0));
        assert!(row[50..90].iter().all(|&z| z == 2.0), "{fill:?}: {row:?}");
        assert!(row[90..110].iter().all(|&z| z == 0.0), "{fill:?}");
        assert!(row[110..190].iter().all(|&z| z == 6.0), "{fill:?}");
        assert!(row[190..].iter().all(|&z| z == 0.0), "{fill:?}");
    }
}

#[test]
fn a_larger_target_is_a_grid_of_holes_only_if_asked() {
    let wall = Image::filled(64, 40, 3f32);
    let small = camera([64, 40], 50.0, LensModel::Pinhole);
    let large = camera([256, 160], 200.0, LensModel::Pinhole);
    let filled = |fill| {
        let align = Align::new(small, large, RigidTransform::IDENTITY, splat(fill));
        let ZDepth(aligned) = align.align((&wall).into()).unwrap();
        assert!(aligned.pixels().iter().all(|&z| z == 0.0 || z == 3.0));
        aligned.pixels().iter().filter(|&&z| z > 0.0).count()
    };
    assert!(filled(Fill::Nearest) <= 64 * 40);
    // All but the rim that the principal points' difference leaves unseen.
    assert!(filled(Fill::Footprint) > 256 * 160 * 95 / 100);
}

#[test]
fn what_is_no_sample_goes_nowhere() {
    let pinhole = camera([8, 4], 8.0, LensModel::Pinhole);
    let align = Align::new(pinhole, pinhole, RigidTransform::IDENTITY, splat(Fill::Footprint));
    for z in [0.0, -1.0, f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        let ZDepth(aligned) = align.align((&Image::filled(8, 4, z)).into()).unwrap();
        assert!(aligned.pixels().iter().all(|&z| z == 0.0), "{z}");
    }
    let behind = Align::new(
        pinhole,
        pinhole,
        RigidTransform::new(DMat3::IDENTITY, DVec3::new(0.0, 0.0, -2.0)),
        splat(Fill::Footprint),
    );
    let ZDepth(aligned) = behind.align((&Image::filled(8, 4, 1f32)).into()).unwrap();
    assert!(aligned.pixels().iter().all(|&z| z == 0.0));
    let error = align.align((&Image::filled(7, 4, 1f32)).into()).unwrap_err();
    assert!(error.to_string().contains("8x4"), "{error}");
}

#[test]
fn a_sample_at_the_lens_covers_no_more_than_allowed() {
    let source = camera([8, 4], 8.0, LensModel::Pinhole);
    let target = camera([1000, 500], 4000.0, LensModel::Pinhole);
    let align = Align::new(source, target, RigidTransform::IDENTITY, splat(Fill::Footprint));
    let mut depth = Image::filled(8, 4, 0f32);
    depth.pixels_mut()[8 + 3] = 1e-3;
    let ZDepth(aligned) = align.align((&depth).into()).unwrap();
    let covered = aligned.pixels().iter().filter(|&&z| z > 0.0).count();
    assert!(
        covered <= (MOST_PIXELS_A_SIDE * MOST_PIXELS_A_SIDE) as usize,
        "{covered}"
    );
}

#[test]
fn the_same_bytes_on_any_number_of_threads() {
    let depth: Vec<f32> = (0..320 * 200)
        .map(|i: u32| 0.5 + (i.wrapping_mul(2_654_435_761) >> 24) as f32 / 40.0)
        .collect();
    let depth = Image::new(320, 200, depth).unwrap();
    let align = Align::new(
        camera([320, 200], 200.0, LensModel::Pinhole),
        camera([500, 300], 330.0, distorted()),
        turned(0.02, -0.03, 0.01, [0.05, 0.01, 0.0]),
        splat(Fill::Footprint),
    );
    let on = |threads| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        pool.install(|| align.align((&depth).into()).unwrap())
    };
    let one = on(1);
    assert!(one.0.pixels().iter().any(|&z| z > 0.0));
    for threads in [2, 8] {
        assert_eq!(on(threads), one);
    }
}

#[test]
fn measured_depth_moves_and_keeps_its_value() {
    let source = camera([64, 40], 50.0, LensModel::Pinhole);
    let target = camera([64, 40], 62.0, LensModel::Pinhole);
    // Turned and 2 cm behind, so that no depth along the target's axis equals the measured one.
    let pose = turned(0.01, 0.02, 0.0, [0.03, 0.0, 0.02]);
    let depth: Vec<f32> = (0..64 * 40u16).map(|i| 1.5 + 0.001 * f32::from(i % 64)).collect();
    let depth = Image::new(64, 40, depth).unwrap();
    let aligned = |z| {
        let mode = AlignMode {
            z,
            ..AlignMode::default()
        };
        let ZDepth(image) = Align::new(source, target, pose, mode)
            .align((&depth).into())
            .unwrap();
        image.pixels().to_vec()
    };
    let (measured, geometric) = (aligned(AlignedZ::Measured), aligned(AlignedZ::Geometric));
    assert!(measured.iter().filter(|&&z| z > 0.0).count() > 1500);
    for (&own, &turned) in measured.iter().zip(&geometric) {
        assert_eq!(own > 0.0, turned > 0.0);
        assert!(own == 0.0 || depth.pixels().contains(&own), "{own}");
        assert!(turned == 0.0 || !depth.pixels().contains(&turned), "{turned}");
    }
}

#[test]
fn each_platform_has_its_depth() {
    assert_eq!(AlignedZ::of_stereo(Some(Platform::Rvc2)), AlignedZ::Measured);
    assert_eq!(AlignedZ::of_stereo(Some(Platform::Rvc4)), AlignedZ::Geometric);
    assert_eq!(AlignedZ::of_stereo(None), AlignedZ::Geometric);
}

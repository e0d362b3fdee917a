use oaktwin_camera::math::{DMat3, DVec3};
use oaktwin_camera::{
    Camera, ImageSize, Intrinsics, LensModel, OpenCv, OpenCvPinhole, PixelPoint, RigidTransform,
};
use oaktwin_image::Image;

use super::*;
use crate::preset::Platform;

fn lens(scale: f64) -> LensModel {
    LensModel::OpenCvPinhole(
        OpenCvPinhole::from_slice(&[-0.05 * scale, 0.02 * scale, 1e-3, -5e-4, 0.01]).unwrap(),
    )
}

fn camera(size: ImageSize, f: f64, cx: f64, cy: f64, lens: LensModel) -> Camera {
    let scale = f64::from(size.width) / 1280.0;
    let centre = PixelPoint::<OpenCv>::new(cx * scale, cy * scale);
    Camera::new(Intrinsics::new(size, f * scale, f * scale, centre), lens)
}

fn pair(size: ImageSize, f: f64) -> (Camera, Camera, RigidTransform) {
    let rotation =
        DMat3::from_rotation_z(0.012) * DMat3::from_rotation_y(-0.017) * DMat3::from_rotation_x(0.004);
    (
        camera(size, f, 645.3, 411.8, lens(1.0)),
        camera(size, f + 1.7, 628.1, 395.2, lens(1.3)),
        RigidTransform::new(rotation, DVec3::new(-0.0745, 0.0006, -0.0009)),
    )
}

const SIZE: ImageSize = ImageSize::new(640, 400);

/// An image of a smooth spot, bright enough to measure its centre.
fn spot(size: ImageSize, at: PixelPoint<OpenCv>) -> Image<u16> {
    let pixels = (0..size.height).flat_map(|y| (0..size.width).map(move |x| (f64::from(x), f64::from(y))));
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "0 to 60000"
    )]
    let value = pixels.map(|(x, y)| {
        let d2 = (x - at.x).powi(2) + (y - at.y).powi(2);
        (60_000.0 * (-d2 / 18.0).exp()) as u16
    });
    Image::new(size.width, size.height, value.collect()).unwrap()
}

fn middle(image: &Image<u16>) -> [f64; 2] {
    let mut sums = [0.0; 3];
    for (y, row) in image.rows().enumerate() {
        for (x, &value) in row.iter().enumerate() {
            let weight = f64::from(value);
            sums = [
                sums[0] + weight * x as f64,
                sums[1] + weight * y as f64,
                sums[2] + weight,
            ];
        }
    }
    [sums[0] / sums[2], sums[1] / sums[2]]
}

/// The errors of points in the rectified images relative to the projections of the rectified cameras, px.
fn errors(f: f64, options: &RectifyOptions) -> Vec<[[f64; 2]; 2]> {
    let (left, right, right_from_left) = pair(SIZE, f);
    let both = StereoRectify::new(&left, &right, &right_from_left, options).unwrap();
    let geometry = both.geometry();
    let points = [
        (0.0, 0.0),
        (-0.55, 0.3),
        (0.5, -0.33),
        (-0.3, -0.3),
        (0.55, 0.3),
        (0.2, 0.1),
    ];
    points
        .map(|(x, y)| {
            let in_left = DVec3::new(x, y, 1.0) * 1.7;
            let in_right = right_from_left.apply(in_left);
            let images = both
                .rectify(
                    (&spot(SIZE, left.project(in_left).unwrap())).into(),
                    (&spot(SIZE, right.project(in_right).unwrap())).into(),
                )
                .unwrap();
            let expected = [
                (geometry.left, geometry.rectified_from_left * in_left),
                (geometry.right, geometry.rectified_from_right * in_right),
            ]
            .map(|(k, point)| k.pixel_from_normalized(point.truncate() / point.z));
            let off = |i: usize| {
                let found = middle(&images[i]);
                [found[0] - expected[i].x, found[1] - expected[i].y]
            };
            [off(0), off(1)]
        })
        .to_vec()
}

#[test]
fn rectified_points_match_the_rectified_cameras() {
    let rvc4 = RectifyOptions::of(Platform::Rvc4);
    let mesh = RectifyOptions {
        method: Method::Mesh,
        ..RectifyOptions::default()
    };
    for (f, options) in [(794.0, rvc4), (794.0, mesh), (572.0, RectifyOptions::default())] {
        for [left, right] in errors(f, &options) {
            for off in [left, right].as_flattened() {
                assert!(off.abs() < 0.06, "{f} {options:?}: {left:?} {right:?}");
            }
            assert!((left[1] - right[1]).abs() < 0.06);
        }
    }
}

#[test]
fn a_homography_keeps_the_lens_distortion() {
    let worst = errors(794.0, &RectifyOptions::default())
        .iter()
        .flatten()
        .flatten()
        .fold(0.0, |worst: f64, off| worst.max(off.abs()));
    assert!(worst > 1.0, "{worst}");
}

#[test]
fn measures_the_distortion_that_a_homography_leaves() {
    let transform = RigidTransform::new(DMat3::IDENTITY, DVec3::new(-0.075, 0.0, 0.0));
    let of = |k1: f64, method: Method| {
        let mut coefficients = [0.0; 14];
        coefficients[0] = k1;
        let lens = LensModel::OpenCvPinhole(OpenCvPinhole::new(coefficients));
        let camera = camera(SIZE, 800.0, 640.0, 400.0, lens);
        let options = RectifyOptions {
            method,
            ..RectifyOptions::default()
        };
        StereoRectify::new(&camera, &camera, &transform, &options)
            .unwrap()
            .remaining()
    };
    // With r the normalized radius, k1 moves a pixel by f k1 r^3. The first pixel is in the corner.
    let k1 = 0.1;
    let corner = (320.0_f64 / 400.0).hypot(200.0 / 400.0);
    let left = of(k1, Method::Homography);
    assert!(
        (left.max_px - 400.0 * k1 * corner.powi(3)).abs() < 1e-3,
        "{left:?}"
    );
    // The share is what lies outside a circle of this radius.
    let radius = (1.0 / (400.0 * k1)).cbrt() * 400.0;
    let mut outside = 0;
    for y in (0..400).step_by(16) {
        for x in (0..640).step_by(16) {
            outside += u32::from((f64::from(x) - 320.0).hypot(f64::from(y) - 200.0) > radius);
        }
    }
    assert!(
        (left.share - f64::from(outside) / (40.0 * 25.0)).abs() < 1e-9,
        "{left:?}"
    );
    assert_eq!(of(0.0, Method::Homography).share, 0.0);
    assert_eq!(of(k1, Method::Full), RemainingDistortion::default());
}

#[test]
fn chooses_the_method_by_field_of_view() {
    let options = RectifyOptions::default();
    let method = |f| {
        let (left, right, transform) = pair(SIZE, f);
        let both = StereoRectify::new(&left, &right, &transform, &options).unwrap();
        assert_eq!(both.geometry().left, right.intrinsics);
        both.method()
    };
    assert_eq!(method(794.0), Method::Homography);
    assert_eq!(method(572.0), Method::Mesh);
    let (left, right, transform) = pair(SIZE, 572.0);
    let both = StereoRectify::new(&left, &right, &transform, &RectifyOptions::of(Platform::Rvc4)).unwrap();
    assert_eq!(
        (both.method(), both.geometry().right),
        (Method::Full, left.intrinsics)
    );
}

#[test]
fn fills_borders_with_the_edge_fill() {
    let (left, right, transform) = pair(SIZE, 794.0);
    let white = Image::filled(640, 400, 200u8);
    let image = |edge_fill| {
        let options = RectifyOptions {
            edge_fill,
            ..RectifyOptions::default()
        };
        let both = StereoRectify::new(&left, &right, &transform, &options).unwrap();
        let [left, right] = both.rectify((&white).into(), (&white).into()).unwrap();
        [left, right].map(Image::into_pixels)
    };
    let count =
        |images: &[Vec<u8>; 2], value| images.iter().flatten().filter(|&&pixel| pixel == value).count();
    let black = image(EdgeFill::Value(0));
    assert!(count(&black, 0) > 2000 && count(&black, 200) > 480_000);
    assert_eq!(count(&black, 0), count(&image(EdgeFill::Value(7)), 7));
    assert_eq!(count(&image(EdgeFill::Replicate), 200), 512_000);
}

#[test]
fn leaves_an_ideal_pair_unchanged() {
    let ideal = Camera::new(Intrinsics::from_hfov(SIZE, 1.3), LensModel::Pinhole);
    let shift = RigidTransform::new(DMat3::IDENTITY, DVec3::new(-0.075, 0.0, 0.0));
    let pixels: Vec<u8> = (0..640 * 400u32)
        .map(|i| (i.wrapping_mul(2_654_435_761) >> 24) as u8)
        .collect();
    let image = Image::new(640, 400, pixels).unwrap();
    for options in [RectifyOptions::default(), RectifyOptions::of(Platform::Rvc4)] {
        let both = StereoRectify::new(&ideal, &ideal, &shift, &options).unwrap();
        let [left, right] = both.rectify((&image).into(), (&image).into()).unwrap();
        assert!(left == image && right == image);
    }
}

#[test]
fn interpolates_and_handles_positions_outside() {
    let raw = Image::new(3, 2, vec![0u8, 100, 200, 40, 80, 120]).unwrap();
    let at = [
        [0.5, 0.0],
        [0.0, 0.5],
        [1.25, 0.75],
        [-0.5, 0.0],
        [2.5, 1.0],
        [2.0, 1.5],
        [-1.0, 0.0],
        [f32::NAN, 0.0],
        [1e30, -1e30],
        [2.0, 1.0],
    ];
    let (size, raw_size) = (ImageSize::new(10, 1), ImageSize::new(3, 2));
    let of = |fill| {
        let rectify = Rectify::from_positions(raw_size, size, &at, fill);
        rectify.rectify((&raw).into()).unwrap().into_pixels()
    };
    assert_eq!(of(EdgeFill::default()), [50, 20, 99, 0, 60, 60, 0, 0, 0, 120]);
    assert_eq!(of(EdgeFill::Replicate), [50, 20, 99, 0, 120, 120, 0, 0, 200, 120]);
    // Missing positions are outside; images of another size are rejected.
    let short = Rectify::from_positions(raw_size, size, &at[..1], EdgeFill::Value(9));
    assert_eq!(short.rectify((&raw).into()).unwrap().pixels()[1..], [9; 9]);
    assert!(short.rectify((&Image::filled(2, 3, 0u8)).into()).is_none());
}

#[test]
fn does_not_depend_on_instructions_or_threads() {
    use oaktwin_simd::{Level, run_at};
    let raw: Vec<u16> = (0..5000u32)
        .map(|i| (i.wrapping_mul(2_654_435_761) >> 16) as u16)
        .collect();
    let places: Vec<u32> = (0..999u32).map(|i| i * 37 % 4800).collect();
    let parts: Vec<[u8; 2]> = (0..999u32)
        .map(|i| [(i % 32) as u8, (i / 32 % 32) as u8])
        .collect();
    let with = |level| {
        let mut out = vec![0u16; 999];
        let remap = rows::Remap {
            raw: &raw,
            stride: 100,
            places: &places,
            parts: &parts,
            out: &mut out,
        };
        run_at(level, remap);
        out
    };
    let levels = Level::available();
    assert!(levels.iter().all(|&level| with(level) == with(Level::BASELINE)));

    let (left, right, transform) = pair(SIZE, 572.0);
    let image = spot(SIZE, PixelPoint::new(300.0, 200.0));
    let threads = |count| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(count)
            .build()
            .unwrap();
        pool.install(|| {
            let both = StereoRectify::new(&left, &right, &transform, &RectifyOptions::default()).unwrap();
            both.rectify((&image).into(), (&image).into()).unwrap()
        })
    };
    assert!(threads(1) == threads(3));
}

use super::*;
use crate::dots::{Dots, Projector};
use crate::stereo_noise::scale::DOTS_PER_PX;

/// The share of a plain wall's pixels that are measured, for walls at several distances.
fn shares(dot_contrast: f64, level: u8, confidence_threshold: u8) -> Vec<f64> {
    let (width, height) = (320, 40);
    let rgb = Image::filled(width, height, [level; 4]);
    let p = Parameters {
        dot_contrast,
        confidence_threshold,
        occlusion: false,
        stereo: StereoGeometry {
            focal_length_px: 200.0,
            ..STEREO
        },
        width_px: width,
        ..exact()
    };
    let share = |metres: f32| {
        let depth = Image::filled(width, height, metres);
        let shot = shot(&depth, 0).with_rgb((&rgb).into()).unwrap();
        let distance = sensor(p).sense(&shot, &random());
        distance.0.pixels().iter().filter(|&&z| z > 0.0).count() as f64 / 12800.0
    };
    [1.0, 2.0, 4.0, 8.0].map(share).to_vec()
}

#[test]
fn plain_walls_are_measured_as_far_as_dots_are_bright() {
    let none = [0.0; 4];
    assert_eq!(shares(0.0, 128, 55), none);
    // 4 m: 128 grey levels × (√(1 + 3/16) − 1) × 15/200 px = 0.86 grey levels, a confidence of 109.
    assert_eq!(shares(3.0, 128, 109), [1.0, 1.0, 1.0, 0.0]);
    assert_eq!(shares(3.0, 128, 110), [1.0, 1.0, 0.0, 0.0]);
    // A darker wall reflects less, and a black one nothing.
    assert_eq!(shares(3.0, 40, 55), [1.0, 1.0, 0.0, 0.0]);
    assert_eq!(shares(1e6, 0, 55), none);
}

#[test]
#[expect(clippy::cast_possible_truncation, reason = "light is float32")]
fn texture_is_that_of_the_pattern() {
    let dots = Dots::new(&Projector {
        model: "ams Belago 1.1".to_owned(),
        dots: 4700,
        field_rad: [78f64, 61.0].map(f64::to_radians),
        dot_width_rad: 3e-3,
        brightness: 1.0,
    });
    for focal_length_px in [800.0f64, 1600.0] {
        let half = (0.3 * focal_length_px) as i32;
        let light = |x: i32, y: i32| {
            // Averaged over the pixel, as a camera does.
            let at = |i: i32, k: i32| ((f64::from(4 * i + k) + 0.5) / (4.0 * focal_length_px)) as f32;
            let parts = (0..16).map(|k| dots.luminance([at(x, k % 4), at(y, k / 4)]));
            f64::from(parts.sum::<f32>()) / 16.0
        };
        let mut sum = 0.0;
        for y in -half..half {
            let row: Vec<f64> = (-half..=half).map(|x| light(x, y)).collect();
            sum += row.windows(2).map(|pair| (pair[1] - pair[0]).abs()).sum::<f64>();
        }
        let mean = sum / f64::from(4 * half * half);
        let expected = DOTS_PER_PX / focal_length_px;
        assert!((mean / expected - 1.0).abs() < 0.1, "{mean} {expected}");
    }
}

use super::*;
use crate::dots::{DotProjector, Dots};
use crate::stereo_noise::texture::dots_of;

/// The share of a plain wall's pixels that are measured, for walls at several distances.
fn shares(dot_contrast: f64, ambient: f64, level: u8, confidence_threshold: u8) -> Vec<f64> {
    let (width, height) = (320, 40);
    let rgb = Image::filled(width, height, [level; 4]);
    let p = Parameters {
        dot_contrast,
        ambient,
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
    assert_eq!(shares(0.0, 1.0, 128, 55), none);
    // 2 m: 128 grey levels × (√(1 + 3/4) − 1) × 0.53 × 0.046 = 1.01 grey levels, a confidence of 72.
    assert_eq!(shares(3.0, 1.0, 128, 72), [1.0, 1.0, 0.0, 0.0]);
    assert_eq!(shares(3.0, 1.0, 128, 73), [1.0, 0.0, 0.0, 0.0]);
    // A darker wall reflects less, and a black one nothing.
    assert_eq!(shares(3.0, 1.0, 80, 55), [1.0, 0.0, 0.0, 0.0]);
    assert_eq!(shares(1e6, 1.0, 0, 55), none);
    // Dots reach farther in the dark, where their own light is what limits them.
    assert_eq!(shares(3.0, 0.1, 128, 55), [1.0, 1.0, 1.0, 0.0]);
    assert_eq!(shares(3.0, 0.0, 128, 55), [1.0; 4]);
    assert_eq!(shares(3.0, 0.0, 128, 254), [1.0, 1.0, 1.0, 0.0]);
    assert_eq!(shares(0.0, 0.0, 128, 1), none);
}

#[test]
fn noise_hides_texture_in_little_light() {
    let (width, height) = (64, 16);
    let stripes: Vec<[u8; 4]> = (0..width * height)
        .map(|i| if i % 8 < 4 { [100; 4] } else { [102; 4] })
        .collect();
    let rgb = Image::new(width, height, stripes).unwrap();
    let depth = Image::filled(width, height, 1.0);
    let shot = shot(&depth, 0).with_rgb((&rgb).into()).unwrap();
    let level = |ambient: f64| {
        let p = Parameters {
            ambient,
            width_px: width,
            ..exact()
        };
        *sensor(p).confidence(&shot).unwrap().get(32, 8).unwrap()
    };
    // Every difference over 4 px is 2 grey levels.
    assert_eq!([1.0, 0.5, 100.0].map(level), [144, 144, 144]);
    let electrons = 6300.0 * (101.0 / 255.0f64).powi(2);
    for ambient in [0.2, 0.1, 0.01, 0.001] {
        let share = 2.0 * ambient;
        let clearness = share * ((electrons + 6.25) / (share * electrons + 6.25)).sqrt();
        let expected = 144.0 * clearness;
        assert!((f64::from(level(ambient)) - expected).abs() < 3.0, "{ambient}");
    }
    assert_eq!(level(0.0), 0);
}

#[test]
#[expect(clippy::cast_sign_loss, reason = "grey levels")]
fn images_of_any_width_have_the_same_texture() {
    // A surface with fine and coarse texture, more of it from top to bottom, seen by cameras whose pixels average it.
    let share = |width: u32| {
        let height = width / 4;
        let at = |x: f64, y: f64| {
            let waves = (0..7).map(|octave| {
                let length = 200.0 / f64::from(1 << octave);
                (std::f64::consts::TAU * x / length + f64::from(octave) + y / 50.0).sin()
            });
            128.0 + 2.0 * y / 320.0 * waves.sum::<f64>()
        };
        let light = |x: u32, y: u32| {
            let side = 1280.0 / f64::from(width);
            let places = (0..4).map(|i| side * (f64::from(x) + (f64::from(i) + 0.5) / 4.0));
            (places.map(|x| at(x, side * (f64::from(y) + 0.5))).sum::<f64>() / 4.0).round() as u8
        };
        let pixels = (0..height).flat_map(|y| (0..width).map(move |x| [light(x, y); 4]));
        let rgb = Image::new(width, height, pixels.collect()).unwrap();
        let depth = Image::filled(width, height, 5.0);
        let p = Parameters {
            width_px: 1280,
            ..Parameters::new(Platform::Rvc2, STEREO, 1280)
        };
        let shot = shot(&depth, 0).with_rgb((&rgb).into()).unwrap();
        let levels = sensor(p).confidence(&shot).unwrap();
        let lost = levels.pixels().iter().filter(|&&level| level < 55).count();
        lost as f64 / f64::from(width * height)
    };
    let full = share(1280);
    assert!((0.05..0.95).contains(&full), "{full}");
    for width in [2560, 960, 640, 480, 320] {
        let narrow = share(width);
        assert!((narrow - full).abs() < 0.07, "{width}: {narrow} {full}");
    }
}

#[test]
#[expect(clippy::cast_possible_truncation, reason = "light is float32")]
fn texture_is_that_of_the_pattern() {
    let dots = Dots::new(&DotProjector {
        model: "ams Belago 1.1".to_owned(),
        dots: 4700,
        field_rad: [78f64, 61.0].map(f64::to_radians),
        dot_width_rad: 3e-3,
        brightness: 1.0,
    });
    for focal_length_px in [300.0f64, 400.0, 800.0, 1600.0, 2400.0] {
        let half = (0.3 * focal_length_px) as i32;
        let light = |x: i32, y: i32| {
            // Averaged over the pixel, as a camera does.
            let at = |i: i32, k: i32| ((f64::from(4 * i + k) + 0.5) / (4.0 * focal_length_px)) as f32;
            let parts = (0..16).map(|k| dots.luminance([at(x, k % 4), at(y, k / 4)]));
            f64::from(parts.sum::<f32>()) / 16.0
        };
        let mut sum = 0.0;
        for y in -half..half {
            let row: Vec<f64> = (-half..half + 4).map(|x| light(x, y)).collect();
            sum += row.windows(5).map(|part| (part[4] - part[0]).abs()).sum::<f64>();
        }
        let mean = sum / f64::from(4 * half * half);
        let expected = dots_of(focal_length_px);
        assert!((mean / expected - 1.0).abs() < 0.1, "{mean} {expected}");
    }
}

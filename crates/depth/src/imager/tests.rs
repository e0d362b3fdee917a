use oaktwin_camera::{ImageSize, Intrinsics};
use oaktwin_image::{Image, ImageView};

use super::*;
use crate::random::{NoiseStage, Stream};

fn intrinsics(width: u32, height: u32) -> Intrinsics {
    Intrinsics::from_hfov(ImageSize::new(width, height), 77f64.to_radians())
}

fn random(frame: u64) -> RandomPlane {
    Stream::new(5, "left").plane(NoiseStage::Exposure, frame, 0)
}

fn fixed(exposure: f64) -> Parameters {
    Parameters {
        auto_exposure: false,
        exposure,
        bits: Bits::Ten,
        ..Parameters::default()
    }
}

fn record(parameters: Parameters, light: &Image<f32>, frame: u64) -> Image<u16> {
    let imager = Imager::new(parameters).unwrap();
    let intrinsics = intrinsics(light.width(), light.height());
    let exposure = imager.expose(&[(light.into(), &intrinsics)]);
    match imager.record(light.into(), &intrinsics, exposure, &random(frame)) {
        Recorded::Eight(image) => image.map(|&number| u16::from(number)),
        Recorded::Ten(image) => image,
    }
}

fn mean_and_variance(image: &Image<u16>) -> (f64, f64) {
    let n = image.pixels().len() as f64;
    let mean = image.pixels().iter().map(|&v| f64::from(v)).sum::<f64>() / n;
    let squares = image.pixels().iter().map(|&v| (f64::from(v) - mean).powi(2));
    (mean, squares.sum::<f64>() / n)
}

/// The variance of λ electrons is λ + r² at any gain.
#[test]
fn noise_has_the_variance_of_shot_and_read_noise() {
    for (exposure, light) in [(0.8, 0.5), (0.8, 0.02), (8.0, 0.08), (2.0, 0.3)] {
        let p = fixed(exposure);
        let image = record(p, &Image::filled(640, 480, light), 0);
        let time = exposure.min(p.max_exposure_time);
        let (electrons, gain) = (f64::from(light) * time * p.full_well_e, exposure / time);
        let number = 1023.0 * gain / p.full_well_e;
        let (mean, variance) = mean_and_variance(&image);
        // Rounding to whole numbers adds 1/12.
        let expected = (electrons + p.read_noise_e.powi(2)) * number * number + 1.0 / 12.0;
        assert!(
            (mean / (electrons * number) - 1.0).abs() < 2e-3,
            "{mean} {exposure} {light}"
        );
        assert!(
            (variance / expected - 1.0).abs() < 0.02,
            "{variance} {expected} {exposure} {light}"
        );
    }
}

#[test]
fn automatic_exposure_reaches_the_target_mean() {
    let p = Parameters {
        noise: false,
        bits: Bits::Ten,
        ..Parameters::default()
    };
    let imager = Imager::new(p).unwrap();
    let k = intrinsics(640, 400);
    let scene = |scale: f32| {
        let pixels: Vec<f32> = (0..640 * 400)
            .map(|i| scale * ((i % 97) as f32 / 40.0).powi(2))
            .collect();
        Image::new(640, 400, pixels).unwrap()
    };
    for scale in [0.05, 0.4, 20.0] {
        let light = scene(scale);
        let exposure = imager.expose(&[(ImageView::from(&light), &k)]);
        let (mean, _) = mean_and_variance(&record(p, &light, 0));
        assert!((mean / 1023.0 - 0.35).abs() < 4e-3, "{scale}: {mean}");
        assert!(exposure.gain >= 1.0 && (exposure.gain == 1.0 || exposure.time == 2.0));
    }
    let dark = Image::filled(640, 400, 1e-4);
    let exposure = imager.expose(&[(ImageView::from(&dark), &k)]);
    assert_eq!((exposure.time, exposure.gain), (2.0, 16.0));
    // All images share one exposure.
    let bright = Image::filled(640, 400, 0.5);
    let both = imager.expose(&[(ImageView::from(&dark), &k), (ImageView::from(&bright), &k)]);
    assert!((both.total() - 1.4).abs() < 1e-2, "{both:?}");
}

#[test]
fn vignetting_follows_cos4() {
    let p = Parameters {
        vignetting: 1.0,
        noise: false,
        ..fixed(0.9)
    };
    let image = record(p, &Image::filled(1280, 800, 1.0), 0);
    let k = intrinsics(1280, 800);
    for (x, y) in [(639u32, 400u32), (0, 0), (1279, 10), (200, 700)] {
        let a = (f64::from(x) + 0.5 - 640.0) / k.fx;
        let b = (f64::from(y) + 0.5 - 400.0) / k.fy;
        let cosine = 1.0 / (1.0 + a * a + b * b).sqrt();
        let expected = 1023.0 * 0.9 * cosine.powi(4);
        let found = f64::from(*image.get(x, y).unwrap());
        assert!((found - expected).abs() < 0.6, "{x} {y}: {found} {expected}");
    }
}

#[test]
fn clamps_values_and_invalid_light() {
    let p = Parameters {
        noise: false,
        bits: Bits::Eight,
        lens_blur_px: 0.0,
        ..fixed(1.0)
    };
    let light = [
        0.0,
        1.0,
        7.0,
        f32::INFINITY,
        f32::NAN,
        -1.0,
        f32::NEG_INFINITY,
        0.5,
    ];
    let image = record(p, &Image::new(8, 1, light.to_vec()).unwrap(), 0);
    assert_eq!(image.pixels(), [0, 255, 255, 255, 0, 0, 0, 128]);
    let image = record(
        Parameters { noise: true, ..p },
        &Image::new(8, 1, light.to_vec()).unwrap(),
        0,
    );
    assert_eq!(image.pixels()[2..4], [255, 255]);
    let nothing = Image::new(0, 0, Vec::new()).unwrap();
    assert_eq!(record(p, &nothing, 0).pixels().len(), 0);
}

#[test]
fn noise_depends_on_the_frame_but_not_on_threads() {
    let light = Image::filled(333, 77, 0.4);
    let with = |threads, frame| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        pool.install(|| record(fixed(0.8), &light, frame))
    };
    assert_eq!(with(1, 0), with(3, 0));
    assert_ne!(with(1, 0), with(1, 1));
    // A pixel does not depend on the width of the image.
    let narrow = record(fixed(0.8), &Image::filled(100, 77, 0.4), 0);
    let wide = with(2, 0);
    assert_eq!(narrow.get(99, 76), wide.get(99, 76));
}

#[test]
fn sets_and_reads_every_parameter() {
    let values = [
        "false", "0.2", "3", "4", "8", "9000", "3.5", "false", "1.5", "0.5", "10",
    ];
    for (name, value) in Parameters::names().into_iter().zip(values) {
        let mut p = Parameters::default();
        assert_ne!(p.get(name).unwrap(), value, "{name}");
        p.set(name, value).unwrap();
        assert_eq!(p.get(name).unwrap(), value, "{name}");
    }
    let mut p = Parameters::default();
    p.set("full-well", "7000").unwrap();
    for (name, value) in [
        ("bits", "9"),
        ("noise", "some"),
        ("maxGain", "0.5"),
        ("readNoise", "NaN"),
        ("exposure", "-1"),
    ] {
        assert_eq!(p.set(name, value).unwrap_err().name, name);
    }
    assert_eq!(
        p.set("fulwell", "1").unwrap_err().to_string(),
        "fulwell: unknown parameter of imager; did you mean 'fullWell'?"
    );
    assert_eq!(p.full_well_e, 7000.0);
}

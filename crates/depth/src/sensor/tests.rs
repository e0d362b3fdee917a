use oaktwin_camera::StereoGeometry;

use oaktwin_image::{Image, ImageView, ZDepth};

use super::*;
use crate::engines::spread;
use crate::filter::parse;
use crate::preset::Platform;
use crate::single_view::{Assumptions, SingleView};
use crate::stereo_matching::{RectifiedPair, StereoMatching};
use crate::stereo_noise::StereoNoise;
use crate::{DepthShot, single_view, stereo_matching, stereo_noise};

const WIDTH: u32 = 64;
const HEIGHT: u32 = 20;

/// A wall at 2 m with a nearer thing before it.
fn scene() -> Image<f32> {
    let mut depth = Image::filled(WIDTH, HEIGHT, 2.0);
    for row in depth.pixels_mut().chunks_exact_mut(WIDTH as usize) {
        row[30..40].fill(1.0);
    }
    depth
}

fn parameters() -> stereo_noise::Parameters {
    let stereo = StereoGeometry {
        focal_length_px: 800.0,
        baseline_m: 0.075,
    };
    stereo_noise::Parameters::new(Platform::Rvc2, stereo, 1280)
}

fn sensor(engine: impl Engine, filters: &[&str]) -> Sensor {
    let filters = filters.iter().map(|text| parse(text).unwrap()).collect();
    Sensor::new(Arc::new(engine), Chain::new(filters), Stream::new(1, "camera"))
}

fn stereo(filters: &[&str]) -> Sensor {
    sensor(StereoNoise::new(parameters()).unwrap(), filters)
}

fn single(filters: &[&str]) -> Sensor {
    let single = SingleView::new(single_view::Parameters::isaac_5_1(), Assumptions::default());
    sensor(single.unwrap(), filters)
}

fn frame(sensor: &mut Sensor, number: u64) -> ZDepth {
    let depth = scene();
    let mut shot = DepthShot::new((&depth).into());
    shot.frame = number;
    sensor.capture(shot, &[]).unwrap().distance
}

#[test]
fn disparities_are_spread_for_all_but_a_median_at_the_end() {
    let scale = |filters: &[&str]| {
        let filters: Vec<Filter> = filters.iter().map(|text| parse(text).unwrap()).collect();
        let mut disparity = Image::filled(3, 1, 0u16);
        disparity.pixels_mut().copy_from_slice(&[0, 1, 3040]);
        let p = parameters();
        let scale = spread(&filters, p.max_disparity_px(), p.subpixel, &mut disparity);
        (scale, disparity.into_pixels())
    };
    let (as_it_was, spread) = ((1.0, vec![0, 1, 3040]), (8192.0 / 3040.0, vec![0, 3, 8192]));
    assert_eq!(scale(&[]), as_it_was);
    assert_eq!(scale(&["median"]), as_it_was);
    assert_eq!(scale(&["threshold:max=500", "brightness"]), as_it_was);
    assert_eq!(scale(&["speckle", "spatial", "median"]), as_it_was);
    assert_eq!(scale(&["speckle", "median", "threshold:max=500"]), as_it_was);
    for filters in [
        &["spatial"][..],
        &["temporal"],
        &["speckle"],
        &["decimation:factor=2"],
        &["median", "spatial"],
        &["spatial", "threshold:max=9"],
    ] {
        assert_eq!(scale(filters), spread, "{filters:?}");
    }
}

#[test]
fn a_filter_that_changes_nothing_changes_depth_by_less_than_a_step() {
    let plain = frame(&mut stereo(&[]), 0);
    let filtered = frame(&mut stereo(&["spatial:alpha=1,radius=0", "decimation"]), 0);
    for (a, b) in plain.0.pixels().iter().zip(filtered.0.pixels()) {
        assert_eq!(*a == 0.0, *b == 0.0);
        // Half of 1/2.69 of a step of 1/32 px, and of 1 mm twice.
        assert!((a - b).abs() <= 0.0021 + a * a / 60.0 * 0.006, "{a} {b}");
    }
}

#[test]
fn thresholds_are_millimetres_wherever_they_stand() {
    for filters in [
        &["threshold:min=500,max=1500"][..],
        &["threshold:min=500,max=1500", "median"],
        &["median", "threshold:min=500,max=1500"],
    ] {
        for mut sensor in [stereo(filters), single(filters)] {
            let distance = frame(&mut sensor, 0);
            let seen: Vec<f32> = distance.0.pixels().iter().copied().filter(|&z| z > 0.0).collect();
            assert!(!seen.is_empty());
            assert!(seen.iter().all(|z| (0.5..=1.5).contains(z)), "{filters:?}");
        }
    }
}

#[test]
fn decimation_changes_the_size_and_not_the_depth() {
    let filters = ["decimation:factor=2"];
    for (mut small, mut whole) in [(stereo(&filters), stereo(&[])), (single(&filters), single(&[]))] {
        let (small, whole) = (frame(&mut small, 0).0, frame(&mut whole, 0).0);
        assert_eq!((small.width(), small.height()), (WIDTH / 2, HEIGHT / 2));
        for y in 0..HEIGHT / 2 {
            for x in 0..WIDTH / 2 {
                let (a, b) = (small.get(x, y).unwrap(), whole.get(2 * x, 2 * y).unwrap());
                assert!((a - b).abs() < 0.003, "({x}, {y}): {a} {b}");
            }
        }
    }
}

#[test]
fn frames_depend_on_earlier_ones_with_a_temporal_filter_only() {
    for filters in [&[][..], &["median", "spatial", "speckle"], &["temporal"]] {
        for make in [stereo, single] {
            let mut in_order = make(filters);
            let first = frame(&mut in_order, 0);
            let second = frame(&mut in_order, 1);
            let mut alone = make(filters);
            let same = frame(&mut alone, 1) == second;
            let remembers = filters.contains(&"temporal");
            // Every frame has its own noise.
            assert!(first != second);
            assert!(same || remembers, "{filters:?}");
            in_order.reset();
            assert_eq!(frame(&mut in_order, 1), frame(&mut make(filters), 1));
        }
    }
    let mut remembering = stereo(&["temporal:delta=255,alpha=0.1"]);
    let _ = frame(&mut remembering, 0);
    assert_ne!(
        frame(&mut remembering, 1),
        frame(&mut stereo(&["temporal:delta=255,alpha=0.1"]), 1)
    );
}

#[test]
fn speckles_are_told_apart_in_pixels_of_disparity() {
    // A wall aslant: neighbours differ by more than a subpixel step, by less than a pixel of disparity.
    let wall = |x: u32, _| 0.8 + 0.02 * x as f32;
    let pixels = (0..WIDTH * HEIGHT).map(|i| wall(i % WIDTH, i / WIDTH)).collect();
    let depth = Image::new(WIDTH, HEIGHT, pixels).unwrap();
    let seen = |filters: &[&str]| {
        let shot = DepthShot::new((&depth).into());
        let distance = stereo(filters).capture(shot, &[]).unwrap().distance;
        distance.0.pixels().iter().filter(|&&z| z > 0.0).count()
    };
    assert_eq!(seen(&["speckle:range=50,difference=2"]), seen(&[]));
    assert_eq!(
        seen(&["speckle:range=50,difference=2", "spatial:delta=20"]),
        seen(&["spatial:delta=20"])
    );
}

#[test]
fn brightness_looks_at_the_picture() {
    let depth = scene();
    let mut rgb = Image::filled(WIDTH, HEIGHT, [100u8, 100, 100, 255]);
    rgb.pixels_mut()[..WIDTH as usize].fill([0, 0, 0, 255]);
    let shot = DepthShot::new((&depth).into()).with_rgb((&rgb).into()).unwrap();
    for filters in [
        &["brightness:min=50"][..],
        &["decimation:factor=2", "brightness:min=50"],
    ] {
        let mut p = parameters();
        p.confidence_threshold = 0;
        let mut sensor = sensor(StereoNoise::new(p).unwrap(), filters);
        let distance = sensor.capture(shot, &[]).unwrap().distance.0;
        let mut rows = distance.rows();
        assert!(rows.next().unwrap().iter().all(|&z| z == 0.0));
        assert!(rows.next().unwrap().iter().any(|&z| z > 0.0));
    }
}

#[test]
fn a_batch_is_its_images_one_by_one() {
    let rgb = Image::filled(WIDTH, HEIGHT, [40, 90, 160, 255u8]);
    let pixels = (WIDTH * HEIGHT) as usize;
    let depth: Vec<f32> = [1.0, 1.5, 2.5]
        .iter()
        .flat_map(|scale| scene().map(|z| z * scale).into_pixels())
        .collect();
    let pictures = rgb.pixels().repeat(3);
    let shape = [3, HEIGHT as usize, WIDTH as usize];
    let cases: [&[&str]; 3] = [
        &[],
        &["temporal", "median:size=3"],
        &["decimation:factor=2", "threshold:max=4000"],
    ];
    for filters in cases {
        for sensor in [stereo(filters), single(filters)] {
            for pictures in [None, Some(&pictures[..])] {
                let (width, height) = sensor.filters().size(WIDTH, HEIGHT);
                let one = (width * height) as usize;
                let mut out = vec![-1.0; 3 * one];
                sensor
                    .sense_batch(&depth, pictures, shape, 9, 5, &mut out)
                    .unwrap();
                for ((i, out), item) in out.chunks_exact(one).enumerate().zip(5..) {
                    let image = Image::new(WIDTH, HEIGHT, depth[i * pixels..][..pixels].to_vec()).unwrap();
                    let mut shot = DepthShot::new((&image).into());
                    (shot.frame, shot.item) = (9, item);
                    if pictures.is_some() {
                        shot = shot.with_rgb((&rgb).into()).unwrap();
                    }
                    let alone = sensor.clone().capture(shot, &[]).unwrap().distance;
                    assert_eq!(out, alone.0.pixels(), "{filters:?} {i}");
                }
            }
        }
    }
}

#[test]
fn a_batch_that_does_not_fit() {
    let sensor = stereo(&["decimation:factor=2"]);
    let mut out = [7.0; 6];
    for (depth, shape) in [(12, [1, 3, 4]), (11, [1, 3, 4]), (12, [2, 3, 4])] {
        let error = sensor.sense_batch(&vec![1.0; depth], None, shape, 0, 0, &mut out);
        assert!(error.unwrap_err().to_string().contains("C-contiguous"));
    }
    let rgb = [[0u8; 4]; 3];
    assert!(
        sensor
            .sense_batch(&[1.0; 12], Some(&rgb), [1, 3, 4], 0, 0, &mut out)
            .is_err()
    );
    assert_eq!(out, [7.0; 6]);
    assert!(!sensor.remembers() && stereo(&["temporal"]).remembers());
    sensor.sense_batch(&[], None, [0, 3, 4], 0, 0, &mut []).unwrap();
}

/// A pair of another size than the depth, of a wall at 20 px.
fn wall() -> [Image<u8>; 2] {
    let level = |x: u32, y: u32| {
        (x.wrapping_mul(0x9E37_79B9) ^ y.wrapping_mul(0x85EB_CA6B)).wrapping_mul(0xC2B2_AE35)
    };
    let image = |shift: u32| {
        let pixels = (0..30).flat_map(|y| (0..200).map(move |x| (level(x + shift, y) >> 24) as u8));
        Image::new(200, 30, pixels.collect()).unwrap()
    };
    [image(0), image(20)]
}

fn matcher() -> StereoMatching {
    let mut p = stereo_matching::Parameters::new(Platform::Rvc2, parameters().stereo, 200);
    p.stereo.focal_length_px = 800.0;
    p.stereo.baseline_m = 0.075;
    StereoMatching::new(p).unwrap()
}

#[test]
fn a_pair_is_matched_and_filtered() {
    let images = wall();
    let [left, right] = images.each_ref().map(ImageView::from);
    let pair = RectifiedPair::new(left, right).unwrap();
    let shot = pair;
    let sensor = |filters: &[&str]| {
        let filters = filters.iter().map(|text| parse(text).unwrap()).collect();
        Sensor::new(Arc::new(matcher()), Chain::new(filters), Stream::new(7, "camera"))
    };
    let capture = sensor(&[]).capture(shot, &[Annotator::Confidence]).unwrap();
    assert_eq!(capture.distance, matcher().sense(&pair));
    let confidence = capture.extra::<Image<u8>>(Annotator::Confidence);
    assert_eq!(confidence, Some(&matcher().disparity(&pair).confidence));
    assert_eq!(capture.extras.len(), 1);
    let at = 15 * 200 + 100;
    assert!((capture.distance.0.pixels()[at] - 3.0).abs() < 0.01);
    // Spread over 13 bits and back: the same depth within a step.
    let own = capture.distance.0.pixels()[at];
    let filtered = sensor(&["speckle"]).capture(shot, &[]).unwrap().distance;
    assert!((filtered.0.pixels()[at] - own).abs() < 0.003);
    let near = sensor(&["threshold:min=0,max=2900"]).capture(shot, &[]).unwrap();
    assert!(near.distance.0.pixels().iter().all(|&z| z < 2.9));
    let halved = sensor(&["decimation:factor=2"]).capture(shot, &[]).unwrap();
    assert_eq!((halved.distance.0.width(), halved.distance.0.height()), (100, 15));
    // The left image is the picture.
    let bright = sensor(&["brightness:min=128,max=256"])
        .capture(shot, &[])
        .unwrap()
        .distance;
    for ((z, all), &level) in bright
        .0
        .pixels()
        .iter()
        .zip(capture.distance.0.pixels())
        .zip(left.pixels())
    {
        assert_eq!(*z, if level > 128 { *all } else { 0.0 });
    }
}

#[test]
fn rejects_the_wrong_kind_of_input() {
    let depth = scene();
    let shot = DepthShot::new((&depth).into());
    let mut matching = sensor(matcher(), &[]);
    assert_eq!(
        matching.capture(shot, &[]).unwrap_err().to_string(),
        "engine: stereo-matching requires a stereo pair; pass a rectified pair, or choose another engine"
    );
    let shape = [1, HEIGHT as usize, WIDTH as usize];
    let mut out = vec![0.0; depth.pixels().len()];
    let error = matching
        .sense_batch(depth.pixels(), None, shape, 0, 0, &mut out)
        .unwrap_err();
    assert_eq!(error.what, "stereo pairs");
    let images = wall();
    let [left, right] = images.each_ref().map(ImageView::from);
    let pair = RectifiedPair::new(left, right).unwrap();
    for mut depth_only in [stereo(&[]), single(&[])] {
        assert!(depth_only.capture(pair, &[]).is_err());
    }
}

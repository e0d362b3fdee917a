//! Why pixels have no value: one scene for each cause, and the rule that holds for every output.

#![expect(clippy::unwrap_used, clippy::cast_possible_truncation, reason = "tests")]

use oaktwin_depth::engines::{SINGLE_VIEW, STEREO_MATCHING, STEREO_NOISE, TIME_OF_FLIGHT};
use oaktwin_depth::filter::NAMES;
use oaktwin_depth::stereo_matching::{LuminanceImage, RectifiedPair};
use oaktwin_depth::{Capture, DepthShot, EngineKind, Input, Reason, ReasonCodes, Sensor, reason};
use oaktwin_image::Image;
use oaktwin_image::annotation::Annotator;

use crate::support::Optics;

const WIDTH: u32 = 320;
const HEIGHT: u32 = 96;
const FOCAL_LENGTH_PX: f64 = 200.0;
const REASON: [Annotator; 1] = [Annotator::DepthSensorReason];

fn sensor(kind: &EngineKind, parameters: &[(&str, &str)], filters: &[&str]) -> Sensor {
    let optics = Optics {
        focal_length_px: FOCAL_LENGTH_PX,
        width: WIDTH,
    };
    optics.sensor(kind, parameters, filters)
}

fn codes(capture: &Capture) -> &Image<u8> {
    let codes: &ReasonCodes = capture.extra(Annotator::DepthSensorReason).unwrap();
    &codes.0
}

/// Measures with and without reasons, checks the rule, and returns the codes.
fn explained<'a>(sensor: &mut Sensor, input: impl Into<Input<'a>>) -> Image<u8> {
    let input = input.into();
    let mut plain = sensor.clone();
    let capture = sensor.capture(input, &REASON).unwrap();
    assert!(plain.capture(input, &[]).unwrap().distance == capture.distance);
    let (distance, codes) = (&capture.distance.0, codes(&capture));
    assert_eq!(
        (distance.width(), distance.height()),
        (codes.width(), codes.height())
    );
    let legend = reason::legend();
    for (metres, code) in distance.pixels().iter().zip(codes.pixels()) {
        assert_eq!(*metres > 0.0, *code == 0, "{metres} {code}");
        assert!(legend.contains_key(code), "{code}");
    }
    codes.clone()
}

/// The code of a pixel in the middle row.
fn at(codes: &Image<u8>, x: u32) -> u8 {
    *codes.get(x, codes.height() / 2).unwrap()
}

fn wall(metres: f32) -> Image<f32> {
    Image::filled(WIDTH, HEIGHT, metres)
}

/// A wall at 4 m with something at 1 m before its middle.
fn post() -> Image<f32> {
    let mut depth = wall(4.0);
    for row in depth.pixels_mut().chunks_exact_mut(WIDTH as usize) {
        row[150..190].fill(1.0);
    }
    depth
}

/// Numbers that look random, the same on every run.
fn noise(seed: u32) -> impl Iterator<Item = u32> {
    (0u32..).map(move |n| {
        let mut x = n.wrapping_mul(0x9E37_79B9) ^ seed.wrapping_mul(0x85EB_CA6B);
        for _ in 0..3 {
            x = (x ^ (x >> 15)).wrapping_mul(0x2C1B_3C6D);
        }
        x ^ (x >> 13)
    })
}

fn texture() -> Image<[u8; 4]> {
    let pixels = noise(7).take((WIDTH * HEIGHT) as usize);
    let pixels = pixels.map(|x| [x as u8, x as u8, x as u8, 255]).collect();
    Image::new(WIDTH, HEIGHT, pixels).unwrap()
}

/// Blocks at all kinds of distances, with misses, NaN and negative numbers among them.
fn anything(seed: u32) -> Image<f32> {
    let blocks: Vec<u32> = noise(seed).take(200).collect();
    let pixels = (0..HEIGHT).flat_map(|y| (0..WIDTH).map(move |x| (x, y)));
    let pixels = pixels.map(|(x, y)| {
        let block = blocks[((y / 12) * 20 + x / 16) as usize];
        match block % 11 {
            0 => f32::INFINITY,
            1 => f32::NAN,
            2 => -1.0,
            3 => 0.0002,
            4 => 70.0,
            5 => 2e4,
            _ => 0.05 * 1.02f32.powi((block % 300) as i32) + 0.001 * (x % 16) as f32,
        }
    });
    Image::new(WIDTH, HEIGHT, pixels.collect()).unwrap()
}

#[test]
fn codes_are_zero_exactly_where_something_was_measured() {
    let mut chains: Vec<Vec<&str>> = NAMES.iter().map(|name| vec![*name]).collect();
    chains.push(Vec::new());
    chains.push(vec![
        "threshold:min=300,max=3000",
        "spatial:radius=3",
        "decimation:factor=3",
        "speckle",
        "temporal",
        "median",
    ]);
    let picture = texture();
    for (kind, parameters) in [
        (&SINGLE_VIEW, &[][..]),
        (
            &SINGLE_VIEW,
            &[
                ("outlierRemovalEnabled", "2"),
                ("maxDistance", "5"),
                ("direction", "left"),
                ("rangeCut", "after"),
            ],
        ),
        (&STEREO_NOISE, &[]),
        (
            &STEREO_NOISE,
            &[
                ("edgeDilation", "4"),
                ("dropout", "0.1"),
                ("numInvalidateEdgePixels", "5"),
                ("disparityShift", "3"),
            ],
        ),
        (&TIME_OF_FLIGHT, &[]),
    ] {
        for filters in &chains {
            let mut sensor = sensor(kind, parameters, filters);
            for frame in 0..3 {
                let depth = anything(frame);
                let mut shot = DepthShot::new((&depth).into())
                    .with_rgb((&picture).into())
                    .unwrap();
                shot.frame = frame.into();
                explained(&mut sensor, shot);
            }
        }
    }
}

/// A pair of random texture, whose left image sees a wall at a disparity, with a nearer post.
fn pair() -> [Image<u8>; 2] {
    let right: Vec<u8> = noise(3)
        .take((WIDTH * HEIGHT) as usize)
        .map(|x| x as u8)
        .collect();
    let mut left = right.clone();
    for (y, row) in left.chunks_exact_mut(WIDTH as usize).enumerate() {
        let source = &right[y * WIDTH as usize..][..WIDTH as usize];
        for (x, pixel) in row.iter_mut().enumerate() {
            let d = if (150..190).contains(&x) { 30 } else { 8 };
            *pixel = x.checked_sub(d).map_or((x * 37 + y * 91) as u8, |x| source[x]);
        }
        row[230..260].fill(100);
        row[270..300].fill(255);
    }
    [left, right].map(|pixels| Image::new(WIDTH, HEIGHT, pixels).unwrap())
}

fn matched(parameters: &[(&str, &str)], filters: &[&str]) -> Image<u8> {
    let images = pair();
    let [left, right] = images.each_ref().map(|image| LuminanceImage::Bits8(image.into()));
    let pair = RectifiedPair::new(left, right).unwrap();
    explained(&mut sensor(&STEREO_MATCHING, parameters, filters), pair)
}

#[test]
fn matching_explains_every_pixel() {
    for platform in ["rvc2", "rvc4"] {
        for more in [
            &[][..],
            &[("extendedDisparity", "true")],
            &[("leftRightCheck", "false"), ("confidenceThreshold", "0")],
            &[("numInvalidateEdgePixels", "20"), ("disparityShift", "5")],
        ] {
            let parameters = [&[("platform", platform)], more].concat();
            for filters in [
                &[][..],
                &["speckle", "spatial", "decimation"],
                &["median", "threshold:max=1500"],
            ] {
                matched(&parameters, filters);
            }
        }
    }
}

#[test]
fn matching_reports_each_cause() {
    let codes = matched(&[("platform", "rvc2"), ("confidenceThreshold", "100")], &[]);
    assert_eq!(at(&codes, 100), Reason::Measured.code());
    assert_eq!(at(&codes, 170), Reason::Measured.code());
    let among =
        |mut columns: std::ops::Range<u32>, reason: Reason| columns.any(|x| at(&codes, x) == reason.code());
    assert!(among(230..260, Reason::NoTexture) && !among(230..260, Reason::Saturated));
    assert!(among(270..300, Reason::Saturated) && !among(270..300, Reason::NoTexture));
    let count = |reason: Reason| {
        codes
            .pixels()
            .iter()
            .filter(|code| **code == reason.code())
            .count()
    };
    assert!(count(Reason::OutsideOtherView) > 0);
    assert!(count(Reason::LeftRightCheck) > 0);
    let edge = matched(&[("platform", "rvc2"), ("numInvalidateEdgePixels", "60")], &[]);
    assert_eq!(at(&edge, 59), Reason::Border.code());
    let near = matched(&[("platform", "rvc2")], &["threshold:min=1000"]);
    assert_eq!(reason::legend()[&at(&near, 170)].name, "filter_threshold");
}

fn noise_at(depth: &Image<f32>, parameters: &[(&str, &str)], filters: &[&str], x: u32) -> String {
    let picture = texture();
    let shot = DepthShot::new(depth.into()).with_rgb((&picture).into()).unwrap();
    let codes = explained(&mut sensor(&STEREO_NOISE, parameters, filters), shot);
    reason::legend()[&at(&codes, x)].name.clone()
}

#[test]
fn stereo_noise_reports_each_cause() {
    assert_eq!(noise_at(&wall(2.0), &[], &[], 200), "measured");
    assert_eq!(noise_at(&wall(f32::INFINITY), &[], &[], 200), "no_surface");
    assert_eq!(noise_at(&wall(0.1), &[], &[], 200), "too_near");
    assert_eq!(
        noise_at(
            &wall(5000.0),
            &[("jitter", "0"), ("bias", "0"), ("pixelLocking", "0")],
            &[],
            200
        ),
        "too_far"
    );
    // 80 px m of disparity times depth by baseline: 15 px at 1 m.
    assert_eq!(noise_at(&wall(1.0), &[], &[], 5), "outside_other_view");
    assert_eq!(noise_at(&post(), &[], &[], 145), "occluded");
    assert_eq!(noise_at(&post(), &[], &[], 100), "measured");
    assert_eq!(
        noise_at(&wall(2.0), &[("numInvalidateEdgePixels", "60")], &[], 50),
        "border"
    );
    assert_eq!(noise_at(&wall(2.0), &[("dropout", "1")], &[], 50), "dropout");
    assert_eq!(
        noise_at(&wall(2.0), &[], &["threshold:max=1000"], 200),
        "filter_threshold"
    );
    assert_eq!(
        noise_at(&post(), &[], &["speckle:range=5000,differenceThreshold=1"], 170),
        "filter_speckle"
    );
    let widened = [("edgeDilation", "6"), ("window", "1")];
    let found: Vec<String> = (130..150).map(|x| noise_at(&post(), &widened, &[], x)).collect();
    assert!(found.iter().any(|name| name == "left_right_check"), "{found:?}");

    let plain = Image::filled(WIDTH, HEIGHT, [90, 90, 90, 255]);
    let depth = wall(2.0);
    let shot = DepthShot::new((&depth).into()).with_rgb((&plain).into()).unwrap();
    let codes = explained(&mut sensor(&STEREO_NOISE, &[], &[]), shot);
    assert_eq!(at(&codes, 200), Reason::NoTexture.code());
}

#[test]
fn single_view_reports_each_cause() {
    let fixed = [
        ("noiseMean", "0"),
        ("noiseSigma", "0"),
        ("confidenceThreshold", "0"),
        ("minDistance", "0.3"),
        ("maxDistance", "6"),
    ];
    let name = |depth: &Image<f32>, more: &[(&str, &str)], x: u32| {
        let picture = texture();
        let shot = DepthShot::new(depth.into()).with_rgb((&picture).into()).unwrap();
        let parameters = [&fixed[..], more].concat();
        let codes = explained(&mut sensor(&SINGLE_VIEW, &parameters, &[]), shot);
        reason::legend()[&at(&codes, x)].name.clone()
    };
    for cut in ["before", "after"] {
        let cut = [("rangeCut", cut)];
        assert_eq!(name(&wall(2.0), &cut, 160), "measured");
        assert_eq!(name(&wall(f32::INFINITY), &cut, 160), "no_surface");
        assert_eq!(name(&wall(0.2), &cut, 160), "too_near");
        assert_eq!(name(&wall(7.0), &cut, 160), "too_far");
    }
    // Samples move by 15 px at 1 m and by 4 px at 4 m.
    let names: Vec<String> = (0..WIDTH).map(|x| name(&post(), &[], x)).collect();
    assert!(
        names[..4]
            .iter()
            .chain(&names[316..])
            .any(|name| name == "outside_other_view"),
        "{names:?}"
    );
    assert!(names[100..220].iter().any(|name| name == "occluded"), "{names:?}");
    let mut lone = wall(f32::INFINITY);
    lone.pixels_mut()[(HEIGHT / 2 * WIDTH) as usize + 160] = 2.0;
    let outlier: Vec<String> = (140..180)
        .map(|x| name(&lone, &[("outlierRemovalEnabled", "1")], x))
        .collect();
    assert!(outlier.iter().any(|name| name == "outlier"), "{outlier:?}");

    let plain = Image::filled(WIDTH, HEIGHT, [90, 90, 90, 255]);
    let depth = wall(2.0);
    let shot = DepthShot::new((&depth).into()).with_rgb((&plain).into()).unwrap();
    let codes = explained(
        &mut sensor(
            &SINGLE_VIEW,
            &[("noiseSigma", "0"), ("confidenceThreshold", "0.9")],
            &[],
        ),
        shot,
    );
    assert_eq!(at(&codes, 160), Reason::NoTexture.code());
}

#[test]
fn time_of_flight_reports_each_cause() {
    let name = |metres: f32, parameters: &[(&str, &str)], filters: &[&str]| {
        let depth = wall(metres);
        let codes = explained(
            &mut sensor(&TIME_OF_FLIGHT, parameters, filters),
            DepthShot::new((&depth).into()),
        );
        reason::legend()[&at(&codes, 160)].name.clone()
    };
    assert_eq!(name(1.0, &[], &[]), "measured");
    assert_eq!(name(f32::INFINITY, &[], &[]), "no_surface");
    assert_eq!(name(0.02, &[], &[]), "saturated");
    assert_eq!(name(1.0, &[("minAmplitude", "65000")], &[]), "low_amplitude");
    assert_eq!(name(1.0, &[], &["threshold:max=500"]), "filter_threshold");
    let depth = wall(6.0);
    let strict = [
        ("phaseUnwrapErrorThreshold", "1"),
        ("minAmplitude", "0"),
        ("confidenceThreshold", "0"),
    ];
    let codes = explained(
        &mut sensor(&TIME_OF_FLIGHT, &strict, &[]),
        DepthShot::new((&depth).into()),
    );
    assert!(codes.pixels().contains(&Reason::WrappedPhase.code()));
}

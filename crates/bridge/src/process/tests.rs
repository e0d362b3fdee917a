use super::*;
use std::time::Instant;

use oaktwin::catalog::Catalog;
use oaktwin::sense::{ImageSensor, SenseOptions};
use oaktwin::sensor::SensorOptions;

use crate::message::Time;

const WIDTH: u32 = 64;
const HEIGHT: u32 = 40;

/// Everything that can be requested.
const ALL: Requests = Requests {
    compressed: true,
    points: true,
    rgb: true,
};

fn options() -> BridgeOptions {
    BridgeOptions {
        depth: "/depth".to_owned(),
        info: Some("/info".to_owned()),
        rgb: Some("/rgb".to_owned()),
        out: "/oak".to_owned(),
        sensor: "stereo".to_owned(),
        node: "bridge".to_owned(),
        encoding: Encoding::Metres,
        points: true,
        points_step: NonZeroU32::MIN,
        compressed: false,
        frames: None,
        is_reliable: false,
        is_input_reliable: false,
        delivery: crate::Delivery::default(),
    }
}

fn filter(sensor: SensorOptions) -> DepthFilter {
    let catalog = Catalog::builtin();
    let twin = catalog.nominal(catalog.device("OAK-D Pro PoE").unwrap());
    let options = SenseOptions {
        sensor,
        ..SenseOptions::default()
    };
    DepthFilter::new(twin, options).unwrap()
}

fn processor() -> Processor {
    let options = options();
    let topics = options.topics().unwrap();
    Processor::new(filter(SensorOptions::default()), &options, topics)
}

fn header(sec: i32) -> Header {
    Header {
        stamp: Time { sec, nanosec: 5 },
        frame_id: "sim_depth_optical".to_owned(),
    }
}

/// A plane that recedes to the right, and its camera.
fn depth(sec: i32) -> Image {
    let metres = (0..HEIGHT).flat_map(|_| (0..WIDTH).map(|x| 1.0 + 0.02 * x as f32));
    Image {
        header: header(sec),
        height: HEIGHT,
        width: WIDTH,
        encoding: "32FC1".to_owned(),
        is_bigendian: 0,
        step: 4 * WIDTH,
        data: metres.flat_map(f32::to_le_bytes).collect(),
    }
}

fn info(width: u32) -> CameraInfo {
    let mut info = CameraInfo {
        header: header(0),
        height: HEIGHT,
        width,
        distortion_model: "plumb_bob".to_owned(),
        d: vec![0.0; 5],
        ..CameraInfo::default()
    };
    info.k = [40.0, 0.0, 31.5, 0.0, 40.0, 19.5, 0.0, 0.0, 1.0];
    info
}

fn arrived(depth: Image, info: Option<CameraInfo>) -> Arrived {
    Arrived {
        depth,
        rgb: None,
        new_info: info,
        at: Instant::now(),
    }
}

fn frame(processor: &mut Processor, arrived: Arrived) -> Result<Outgoing, Vec<String>> {
    let mut findings = Vec::new();
    let outgoing = processor.frame(arrived, ALL, &mut findings);
    outgoing.ok_or_else(|| findings.iter().map(ToString::to_string).collect())
}

fn floats(bytes: &[u8]) -> Vec<f32> {
    bytes
        .as_chunks()
        .0
        .iter()
        .map(|bytes| f32::from_le_bytes(*bytes))
        .collect()
}

#[test]
fn the_output_is_that_of_sense() {
    let mut processor = processor();
    let outgoing = frame(&mut processor, arrived(depth(3), Some(info(WIDTH)))).unwrap();
    assert_eq!(outgoing.image.header, header(3));
    assert_eq!((outgoing.image.width, outgoing.image.step), (WIDTH, 4 * WIDTH));
    assert_eq!(
        (outgoing.info.header, outgoing.info.k),
        (header(3), info(WIDTH).k)
    );

    let same = filter(SensorOptions::default());
    let options = SenseOptions {
        field_of_view: oaktwin::sense::FieldOfView::Camera(convert::camera(&info(WIDTH)).unwrap()),
        ..same.options().clone()
    };
    let (mut sensor, _) = ImageSensor::new(same.twin(), ImageSize::new(WIDTH, HEIGHT), &options).unwrap();
    let exact = convert::depth(&depth(3)).unwrap().metres;
    let expected = sensor.measure(exact, None, 3_000_000_005).unwrap();
    let measured = floats(&outgoing.image.data);
    assert!(measured.iter().filter(|z| z.is_finite()).count() > 1000);
    for (measured, expected) in measured.iter().zip(expected.distance.pixels()) {
        assert!(measured == expected || (measured.is_nan() && *expected == 0.0));
    }
    let cloud = outgoing.points.unwrap();
    assert_eq!((cloud.width, cloud.height, cloud.point_step), (WIDTH, HEIGHT, 12));
    for (at, point) in floats(&cloud.data).as_chunks::<3>().0.iter().enumerate() {
        let z = measured[at];
        assert!(point[2] == z || (point[2].is_nan() && z.is_nan()));
        if z.is_finite() {
            let x = ((at % WIDTH as usize) as f32 - 31.5) / 40.0 * z;
            assert!((point[0] - x).abs() < 1e-5, "{point:?} {x}");
        }
    }
}

#[test]
fn equal_stamps_give_equal_noise_and_others_do_not() {
    let mut processor = processor();
    let first = frame(&mut processor, arrived(depth(1), Some(info(WIDTH)))).unwrap();
    let other = frame(&mut processor, arrived(depth(2), None)).unwrap();
    let mut findings = Vec::new();
    let again = processor
        .frame(arrived(depth(1), None), Requests::default(), &mut findings)
        .unwrap();
    assert_eq!(findings[0].code, "time-went-back");
    assert!(again.points.is_none());
    let bits = |outgoing: &Outgoing| outgoing.image.data.clone();
    assert_eq!(bits(&first), bits(&again));
    assert_ne!(bits(&first), bits(&other));
    findings.clear();
    let repeated = processor
        .frame(arrived(depth(1), None), Requests::default(), &mut findings)
        .unwrap();
    assert_eq!(findings[0].code, "same-stamp");
    assert_ne!(bits(&repeated), bits(&again));
}

#[test]
fn parameters_change_while_images_arrive() {
    let mut processor = processor();
    let before = frame(&mut processor, arrived(depth(1), Some(info(WIDTH)))).unwrap();
    let seeded = SensorOptions {
        seed: 7,
        ..SensorOptions::default()
    };
    processor.filter().set_sensor(seeded).unwrap();
    let after = frame(&mut processor, arrived(depth(1), None)).unwrap();
    assert_ne!(before.image.data, after.image.data);
    let unknown = SensorOptions {
        preset: Some("robotcs".to_owned()),
        ..SensorOptions::default()
    };
    let error = processor.filter().set_sensor(unknown).unwrap_err().to_string();
    assert!(error.contains("ROBOTICS"), "{error}");
    assert_eq!(processor.filter().options().sensor.seed, 7);
}

#[test]
fn unusable_frames_are_reported_with_their_topic() {
    let mut processor = processor();
    let other_size = frame(&mut processor, arrived(depth(1), Some(info(WIDTH + 1))))
        .err()
        .unwrap();
    assert_eq!(
        other_size,
        [
            "error[camera-info-size]: /info: describes images of 65x40, but the depth image is 64x40; publish the camera info of the \
          depth image"
        ]
    );
    let mut uncalibrated = info(WIDTH);
    uncalibrated.k = [0.0; 9];
    let errors = frame(&mut processor, arrived(depth(1), Some(uncalibrated)))
        .err()
        .unwrap();
    assert!(
        errors[0].starts_with("error[invalid-message]: /info: k: the focal lengths must be > 0 px"),
        "{errors:?}"
    );
    let mut negative = depth(-1);
    negative.header.stamp.sec = -1;
    let errors = frame(&mut processor, arrived(negative, Some(info(WIDTH))))
        .err()
        .unwrap();
    assert!(
        errors[0].starts_with("error[invalid-message]: /depth: header.stamp: -1 s"),
        "{errors:?}"
    );
    let rgb = Arrived {
        rgb: Some(depth(1)),
        ..arrived(depth(1), None)
    };
    let errors = frame(&mut processor, rgb).err().unwrap();
    assert!(
        errors[0].contains("/rgb: encoding: '32FC1' is not an encoding of 8-bit colours"),
        "{errors:?}"
    );
    assert!(frame(&mut processor, arrived(depth(1), None)).is_ok());
}

#[test]
fn colours_are_passed_on_with_their_camera_if_somebody_wants_them() {
    let mut processor = processor();
    let colours = Image {
        encoding: "mono8".to_owned(),
        step: WIDTH,
        data: vec![100; (WIDTH * HEIGHT) as usize],
        ..depth(1)
    };
    let with = |info| Arrived {
        rgb: Some(colours.clone()),
        ..arrived(depth(1), info)
    };
    let outgoing = frame(&mut processor, with(Some(info(WIDTH)))).unwrap();
    assert_eq!(outgoing.rgb.as_ref(), Some(&colours));
    let camera = outgoing.rgb_info.unwrap();
    assert_eq!((camera.header, camera.k), (header(1), info(WIDTH).k));
    assert!(outgoing.compressed.is_some() && outgoing.points.is_some());

    let mut findings = Vec::new();
    let outgoing = processor.frame(with(None), Requests::default(), &mut findings);
    let outgoing = outgoing.unwrap();
    assert!(outgoing.rgb.is_none() && outgoing.compressed.is_none() && outgoing.points.is_none());
    assert!(outgoing.rgb_info.is_some());
}

#[test]
fn a_new_size_is_reported() {
    let mut processor = processor();
    frame(&mut processor, arrived(depth(1), Some(info(WIDTH)))).unwrap();
    let mut narrow = depth(2);
    narrow.width = 32;
    let mut findings = Vec::new();
    let outgoing = processor
        .frame(
            arrived(narrow, Some(info(32))),
            Requests::default(),
            &mut findings,
        )
        .unwrap();
    assert_eq!((outgoing.image.width, outgoing.image.height), (32, HEIGHT));
    assert!(
        findings.iter().any(|finding| finding.code == "size-changed"),
        "{findings:?}"
    );
}

#[test]
fn millimetres_that_are_metres_are_reported() {
    let mut processor = processor();
    let mut wrong = depth(1);
    wrong.data = std::iter::repeat_n(2500f32.to_le_bytes(), (WIDTH * HEIGHT) as usize)
        .flatten()
        .collect();
    let mut findings = Vec::new();
    processor
        .frame(
            arrived(wrong, Some(info(WIDTH))),
            Requests::default(),
            &mut findings,
        )
        .unwrap();
    let codes: Vec<&str> = findings.iter().map(|finding| finding.code).collect();
    assert!(
        codes.contains(&"depth-unit") && codes.contains(&"nothing-measured"),
        "{codes:?}"
    );
}

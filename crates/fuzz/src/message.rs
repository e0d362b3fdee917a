//! Messages of ROS 2: their bytes, their conversion to images and cameras, and the filter between topics.

use std::num::NonZeroU32;
use std::sync::LazyLock;

use byteorder::{BigEndian, ByteOrder, LittleEndian};
use cdr_encoding::{from_bytes, to_vec};
use oaktwin::catalog::{Catalog, Twin};
use oaktwin::sense::SenseOptions;
use oaktwin_bridge::convert::{Encoding, Frames, camera, camera_info, color, depth, depth_message};
use oaktwin_bridge::message::{CameraInfo, Header, Image, Time};
use oaktwin_bridge::{DepthFilter, FilterInput};
use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::random::Random;

static TWIN: LazyLock<Twin> = LazyLock::new(|| {
    let catalog = Catalog::builtin();
    let device = catalog.device("OAK-D Pro PoE");
    catalog.nominal(device.unwrap_or_else(|error| panic!("{error}")))
});

/// The encodings of messages.
const ENCODINGS: [&str; 11] = [
    "16UC1", "32FC1", "mono16", "rgb8", "bgr8", "rgba8", "bgra8", "mono8", "8UC1", "8UC3", "64FC1",
];

/// The first byte selects: serialized bytes of a message, or a drawn frame.
pub(crate) fn check(bytes: &[u8]) {
    let Some((&first, rest)) = bytes.split_first() else {
        return;
    };
    match first % 5 {
        0 => serialized::<Image, LittleEndian>(rest, image),
        1 => serialized::<Image, BigEndian>(rest, image),
        2 => serialized::<CameraInfo, LittleEndian>(rest, info),
        3 => serialized::<CameraInfo, BigEndian>(rest, info),
        _ => frame(&mut Random::new(rest)),
    }
}

/// Reads a message from its bytes, which must come back from what is read.
fn serialized<T: Serialize + DeserializeOwned, Order: ByteOrder>(bytes: &[u8], check: fn(&T)) {
    let Ok((message, read)) = from_bytes::<T, Order>(bytes) else {
        return;
    };
    assert!(read <= bytes.len());
    let write = |message: &T| to_vec::<T, Order>(message).unwrap_or_else(|error| panic!("{error}"));
    let written = write(&message);
    let (again, _) = from_bytes::<T, Order>(&written).unwrap_or_else(|error| panic!("{error}"));
    assert!(write(&again) == written, "the message does not round-trip");
    check(&message);
}

fn image(message: &Image) {
    let size = (message.width, message.height);
    if let Ok(found) = depth(message) {
        let metres = &found.metres;
        assert_eq!((metres.width(), metres.height()), size);
        assert!(2 * metres.pixels().len() <= message.data.len());
        for &encoding in Encoding::ALL {
            let out = depth_message(message.header.clone(), metres, encoding);
            assert_eq!(out.data.len(), out.step as usize * out.height as usize);
            let again = depth(&out).unwrap_or_else(|error| panic!("{error}"));
            let pairs = metres.pixels().iter().zip(again.metres.pixels());
            for (before, after) in pairs {
                let is_same = match encoding {
                    Encoding::Metres if *before > 0.0 => before.to_bits() == after.to_bits(),
                    Encoding::Metres => after.is_nan(),
                    Encoding::Millimetres if *after > 0.0 => (before - after).abs() <= 0.000_51,
                    // Nothing, less than half a millimetre, or beyond the range.
                    Encoding::Millimetres => !(0.000_51..65.535).contains(before),
                };
                assert!(is_same, "{before} m became {after} m in {}", encoding.name());
            }
        }
    }
    if let Ok(found) = color(message) {
        assert_eq!((found.width(), found.height()), size);
        assert!(found.pixels().len() <= message.data.len());
        assert!(found.pixels().iter().all(|pixel| pixel[3] == 255));
    }
    stamps(message.header.stamp);
}

/// A stamp twice and a later one: the numbers of frames differ.
fn stamps(stamp: Time) {
    let mut frames = Frames::default();
    let Ok(first) = frames.next(stamp) else {
        return;
    };
    assert!(!first.is_repeated && !first.is_earlier);
    let second = frames.next(stamp).unwrap_or_else(|error| panic!("{error}"));
    assert!(second.is_repeated && second.number != first.number);
}

fn info(message: &CameraInfo) {
    let Ok(found) = camera(message) else {
        return;
    };
    let intrinsics = &found.intrinsics;
    assert_eq!(
        (intrinsics.size.width, intrinsics.size.height),
        (message.width, message.height)
    );
    assert!(intrinsics.has_finite_rays(), "{intrinsics:?}");
    let again = camera_info(message.header.clone(), intrinsics);
    let again = camera(&again).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(again.intrinsics.opencv_matrix(), intrinsics.opencv_matrix());
}

/// A small image and the camera info that describes it, more or less.
fn frame(random: &mut Random<'_>) {
    let (width, height) = (1 + random.up_to(31), 1 + random.up_to(23));
    let encoding = random.pick(&ENCODINGS);
    let step = random.up_to(8 * width);
    let length = match random.up_to(3) {
        0 => random.up_to(8 * width * height),
        _ => step * height,
    };
    let drawn: Vec<u8> = (0..length.min(512)).map(|_| random.byte()).collect();
    let data = drawn.iter().copied().cycle().take(length as usize).collect();
    let message = Image {
        header: header(random),
        height,
        width,
        encoding: encoding.to_owned(),
        is_bigendian: random.byte() % 2,
        step,
        data,
    };
    image(&message);
    let own = CameraInfo {
        header: message.header.clone(),
        height: height + random.up_to(1),
        width,
        distortion_model: random
            .pick(&["plumb_bob", "rational_polynomial", "equidistant", ""])
            .to_owned(),
        d: (0..random.up_to(15)).map(|_| random.number()).collect(),
        k: [
            focal_length(random),
            0.0,
            random.number(),
            0.0,
            focal_length(random),
            random.number(),
            0.0,
            0.0,
            1.0,
        ],
        binning_x: random.up_to(1),
        ..CameraInfo::default()
    };
    info(&own);
    if let (Ok(depth), Ok(camera)) = (depth(&message), camera(&own)) {
        let rgb = random.image(width, height, |random| [random.byte(), random.byte(), 3, 255]);
        measure(FilterInput {
            depth,
            camera: Some(camera),
            rgb: (random.up_to(1) == 1).then_some(rgb),
            frame: 3,
        });
    }
}

fn header(random: &mut Random<'_>) -> Header {
    #[expect(clippy::cast_possible_wrap, reason = "any stamp")]
    let sec = random.up_to(u32::MAX) as i32;
    Header {
        stamp: Time {
            sec,
            nanosec: random.up_to(1_000_000_001),
        },
        frame_id: random.text(),
    }
}

/// A focal length that a camera might have, or any number.
fn focal_length(random: &mut Random<'_>) -> f64 {
    match random.up_to(2) {
        0 => random.number(),
        _ => f64::from(1 + random.up_to(200)),
    }
}

/// Measures a frame as the bridge does, unless the sensor rejects its camera.
fn measure(input: FilterInput) {
    let options = SenseOptions::default();
    let mut filter = DepthFilter::new(TWIN.clone(), options).unwrap_or_else(|error| panic!("{error}"));
    let Ok(mut output) = filter.apply(input) else {
        return;
    };
    let distance = &output.measured.distance;
    let strange = distance.pixels().iter().find(|z| !(z.is_finite() && **z >= 0.0));
    assert!(strange.is_none(), "{strange:?}");
    let count = distance.pixels().len();
    let cloud = output.point_cloud(Header::default(), NonZeroU32::MIN);
    assert_eq!(cloud.data.len(), cloud.point_step as usize * count);
}

pub(crate) fn seeds() -> Vec<Vec<u8>> {
    let header = Header {
        stamp: Time { sec: 7, nanosec: 5 },
        frame_id: "optical".to_owned(),
    };
    let image = |encoding: &str, step: u32| Image {
        header: header.clone(),
        height: 2,
        width: 3,
        encoding: encoding.to_owned(),
        is_bigendian: 0,
        step,
        data: (0..2 * step).map(|byte| (byte * 37).to_le_bytes()[0]).collect(),
    };
    let info = CameraInfo {
        header: header.clone(),
        height: 2,
        width: 3,
        distortion_model: "plumb_bob".to_owned(),
        d: vec![0.1, -0.01, 0.0, 0.0, 0.001],
        k: [2.0, 0.0, 1.0, 0.0, 2.0, 0.5, 0.0, 0.0, 1.0],
        ..CameraInfo::default()
    };
    let mut all = Vec::new();
    for (encoding, step) in [("16UC1", 6), ("32FC1", 16), ("rgb8", 9), ("bgra8", 12)] {
        all.push(seed(0, to_vec::<_, LittleEndian>(&image(encoding, step))));
        all.push(seed(1, to_vec::<_, BigEndian>(&image(encoding, step))));
    }
    all.push(seed(2, to_vec::<_, LittleEndian>(&info)));
    all.push(seed(3, to_vec::<_, BigEndian>(&info)));
    all.push(vec![4]);
    all
}

fn seed(first: u8, serialized: Result<Vec<u8>, cdr_encoding::Error>) -> Vec<u8> {
    let bytes = serialized.unwrap_or_else(|error| panic!("{error}"));
    [&[first], bytes.as_slice()].concat()
}

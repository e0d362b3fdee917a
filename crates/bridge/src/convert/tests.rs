use super::*;
use std::num::NonZeroU32;

use crate::message::{CameraInfo, Image, Time};

use oaktwin::camera::{Camera, ImageSize, Intrinsics, LensModel, OpenCv, PixelPoint};
use oaktwin::depth::OutputCamera;
use oaktwin::sense::DepthUnit;

/// An image of 2×2 pixels with this many bytes per row.
fn image(encoding: &str, step: u32, data: Vec<u8>) -> Image {
    Image {
        width: 2,
        height: 2,
        encoding: encoding.to_owned(),
        step,
        data,
        ..Image::default()
    }
}

fn error(message: &Image) -> String {
    depth(message).unwrap_err().to_string()
}

#[test]
fn both_encodings_are_read_in_both_byte_orders() {
    let metres = [1.5f32, f32::INFINITY, 0.25, 0.0];
    for (order, bytes) in [
        (0, metres.map(f32::to_le_bytes)),
        (1, metres.map(f32::to_be_bytes)),
    ] {
        let mut message = image("32FC1", 8, bytes.concat());
        message.is_bigendian = order;
        let found = depth(&message).unwrap();
        assert_eq!(
            (found.metres.pixels(), found.unit),
            (&metres[..], DepthUnit::Metres)
        );
    }
    let millimetres = [1500u16, 0, 65535, 1];
    for (order, bytes) in [
        (0, millimetres.map(u16::to_le_bytes)),
        (1, millimetres.map(u16::to_be_bytes)),
    ] {
        for encoding in ["16UC1", "mono16"] {
            let mut message = image(encoding, 4, bytes.concat());
            message.is_bigendian = order;
            let found = depth(&message).unwrap();
            assert_eq!(found.metres.pixels(), [1.5, 0.0, 65.535, 0.001]);
            assert_eq!(found.unit, DepthUnit::Millimetres);
        }
    }
}

#[test]
fn bytes_between_rows_are_skipped() {
    let data = [1000u16, 2000, 9, 3000, 4000, 9].map(u16::to_le_bytes).concat();
    let padded = image("16UC1", 6, data.clone());
    assert_eq!(depth(&padded).unwrap().metres.pixels(), [1.0, 2.0, 3.0, 4.0]);
    // The last row may end with its pixels.
    assert!(depth(&image("16UC1", 6, data[..10].to_vec())).is_ok());
    assert_eq!(
        error(&image("16UC1", 6, data[..9].to_vec())),
        "data: 9 bytes instead of 10 for 2x2 with a step of 6; publish whole images"
    );
}

#[test]
fn unusable_images_are_rejected() {
    assert_eq!(
        error(&image("32FC1", 4, vec![0; 16])),
        "step: 4 bytes for rows of 8 (2 pixels, 32FC1); set step to the number of bytes from one row to the next"
    );
    assert_eq!(
        error(&image("rgb8", 6, vec![0; 12])),
        "encoding: 'rgb8' is not an encoding of depth; publish 32FC1 (metres) or 16UC1 (millimetres)"
    );
    assert!(error(&image(&"x".repeat(1 << 20), 6, vec![0; 12])).len() < 200);
    let mut empty = image("32FC1", 0, Vec::new());
    empty.width = 0;
    assert!(error(&empty).contains("0x2 has no pixels"));
    let mut long = image("32FC1", 8, vec![0; 16]);
    long.header.frame_id = "f".repeat(1 << 20);
    assert!(error(&long).starts_with("header.frame_id: is longer than 1024 bytes"));
}

#[test]
fn huge_announced_sizes_allocate_nothing() {
    for (width, height, step) in [
        (u32::MAX, u32::MAX, u32::MAX),
        (1 << 30, 1, u32::MAX),
        (1, u32::MAX, 4),
        (1 << 15, 1 << 15, 1 << 17),
    ] {
        let message = Image {
            width,
            height,
            step,
            ..image("32FC1", 0, vec![0; 64])
        };
        let what = error(&message);
        assert!(
            what.starts_with("data: 64 bytes") || what.starts_with("step: "),
            "{what}"
        );
        assert!(
            color(&Image {
                encoding: "mono8".to_owned(),
                ..message
            })
            .is_err()
        );
    }
}

#[test]
fn colours_are_read_in_every_order() {
    let of = |encoding: &str, bytes: &[u8]| {
        let message = Image {
            width: 1,
            height: 1,
            ..image(encoding, u32::try_from(bytes.len()).unwrap(), bytes.to_vec())
        };
        color(&message)
            .map(|image| image.pixels()[0])
            .map_err(|error| error.to_string())
    };
    assert_eq!(of("rgb8", &[1, 2, 3]), Ok([1, 2, 3, 255]));
    assert_eq!(of("bgr8", &[3, 2, 1]), Ok([1, 2, 3, 255]));
    assert_eq!(of("rgba8", &[1, 2, 3, 9]), Ok([1, 2, 3, 255]));
    assert_eq!(of("bgra8", &[3, 2, 1, 9]), Ok([1, 2, 3, 255]));
    assert_eq!(of("mono8", &[7]), Ok([7, 7, 7, 255]));
    assert!(
        of("bayer_rggb8", &[7])
            .unwrap_err()
            .contains("not an encoding of 8-bit colours")
    );
}

#[test]
fn stamps_number_the_frames() {
    let at = |sec, nanosec| Time { sec, nanosec };
    assert_eq!(nanoseconds(at(1, 2)), Ok(1_000_000_002));
    assert_eq!(
        nanoseconds(at(i32::MAX, 999_999_999)),
        Ok(2_147_483_647_999_999_999)
    );
    let text = |stamp| nanoseconds(stamp).unwrap_err().to_string();
    assert!(text(at(-1, 0)).starts_with("header.stamp: -1 s is negative; "));
    assert!(text(at(i32::MIN, u32::MAX)).contains("negative"));
    assert!(text(at(0, 1_000_000_000)).contains("1000000000 ns is a second or more"));

    let mut frames = Frames::default();
    let mut next = |sec, nanosec| {
        let found = frames.next(at(sec, nanosec)).unwrap();
        (found.number, found.is_repeated, found.is_earlier)
    };
    assert_eq!(next(2, 0), (2_000_000_000, false, false));
    assert_eq!(next(2, 0), (2_000_000_001, true, false));
    assert_eq!(next(2, 0), (2_000_000_002, true, false));
    assert_eq!(next(3, 0), (3_000_000_000, false, false));
    assert_eq!(next(1, 0), (1_000_000_000, false, true));
}

fn info() -> CameraInfo {
    CameraInfo {
        width: 640,
        height: 480,
        distortion_model: "plumb_bob".to_owned(),
        d: vec![0.0; 5],
        k: [400.0, 0.0, 319.5, 0.0, 401.0, 239.5, 0.0, 0.0, 1.0],
        ..CameraInfo::default()
    }
}

#[test]
fn camera_info_round_trips() {
    let found = camera(&info()).unwrap();
    assert_eq!(found.lens, LensModel::Pinhole);
    assert_eq!(
        found.intrinsics.principal_point::<OpenCv>(),
        PixelPoint::new(319.5, 239.5)
    );
    let again = camera_info(message_header(), &found.intrinsics);
    assert_eq!(
        (again.k, again.width, again.height, again.d),
        (info().k, 640, 480, vec![0.0; 5])
    );
    assert_eq!(
        again.p,
        [400.0, 0.0, 319.5, 0.0, 0.0, 401.0, 239.5, 0.0, 0.0, 0.0, 1.0, 0.0]
    );
    // No coefficients, and no name of a model, as some simulators publish it.
    let bare = CameraInfo {
        d: Vec::new(),
        distortion_model: String::new(),
        ..info()
    };
    assert_eq!(camera(&bare).unwrap(), found);
}

fn message_header() -> Header {
    Header {
        stamp: Time { sec: 1, nanosec: 0 },
        frame_id: "optical".to_owned(),
    }
}

#[test]
fn unusable_cameras_are_rejected() {
    let of = |change: fn(&mut CameraInfo)| {
        let mut info = info();
        change(&mut info);
        camera(&info).unwrap_err().to_string()
    };
    assert!(of(|info| info.width = 0).starts_with("width, height: "));
    assert!(of(|info| info.k = [0.0; 9]).contains("must be > 0 px (got 0 and 0)"));
    assert!(of(|info| info.k[0] = f64::NAN).contains("got NaN"));
    assert!(of(|info| info.k[4] = -1.0).starts_with("k: "));
    assert!(of(|info| info.k[2] = f64::INFINITY).contains("principal point"));
    assert!(of(|info| info.k[1] = 0.5).contains("skew"));
    assert!(of(|info| info.k[0] = 1e-320).starts_with("k: "));
    assert!(of(|info| info.binning_x = 2).starts_with("binning_x, binning_y, roi: "));
    assert!(of(|info| info.roi.x_offset = 1).contains("without binning and region"));
    assert!(of(|info| (info.roi.width, info.roi.height) = (320, 480)).contains("another image"));
    assert!(of(|info| info.d = vec![f64::NAN; 5]).starts_with("d: "));
    assert!(of(|info| info.d = vec![0.1; 15]).starts_with("d: "));
    let other = |info: &mut CameraInfo| {
        info.distortion_model = "ftheta".to_owned();
        info.d = vec![0.1];
    };
    assert!(of(other).contains("'ftheta' is unknown; expected plumb_bob"));
    let mut whole = info();
    (whole.roi.width, whole.roi.height) = (640, 480);
    assert!(camera(&whole).is_ok());
}

#[test]
fn distortion_is_read() {
    let of = |model: &str, d: &[f64]| {
        let info = CameraInfo {
            distortion_model: model.to_owned(),
            d: d.to_vec(),
            ..info()
        };
        camera(&info).unwrap().lens
    };
    assert!(matches!(
        of("plumb_bob", &[0.1, 0.0, 0.0, 0.0, 0.0]),
        LensModel::OpenCvPinhole(_)
    ));
    assert!(matches!(
        of("rational_polynomial", &[0.1; 8]),
        LensModel::OpenCvPinhole(_)
    ));
    assert!(matches!(
        of("equidistant", &[0.1; 4]),
        LensModel::OpenCvFisheye(_)
    ));
}

#[test]
fn measured_depth_is_written_with_the_invalid_values_of_rep_118() {
    let metres = oaktwin::image::Image::new(2, 1, vec![1.2345, 0.0]).unwrap();
    let message = depth_message(message_header(), &metres, Encoding::Millimetres);
    assert_eq!((message.encoding.as_str(), message.step), ("16UC1", 4));
    assert_eq!(message.data, [1234u16, 0].map(u16::to_le_bytes).concat());
    let message = depth_message(message_header(), &metres, Encoding::Metres);
    assert_eq!(
        (message.encoding.as_str(), message.step, message.is_bigendian),
        ("32FC1", 8, 0)
    );
    assert_eq!(message.data, [1.2345, f32::NAN].map(f32::to_le_bytes).concat());
}

#[test]
fn points_have_the_colours_and_the_frame_of_the_input() {
    let intrinsics = Intrinsics::new(
        ImageSize::new(2, 1),
        1.0,
        1.0,
        PixelPoint::<OpenCv>::new(0.0, 0.0),
    );
    let camera = OutputCamera {
        camera: Camera::new(intrinsics, LensModel::Pinhole),
        shift_m: 0.5,
    };
    let metres = oaktwin::image::Image::new(2, 1, vec![2.0, 0.0]).unwrap();
    let colors = oaktwin::image::Image::new(2, 1, vec![[1, 2, 3, 255], [0; 4]]).unwrap();
    let cloud = Points::new(&camera, NonZeroU32::MIN).message(message_header(), &metres, Some(&colors));
    let names: Vec<&str> = cloud.fields.iter().map(|field| field.name.as_str()).collect();
    assert_eq!(names, ["x", "y", "z", "rgb"]);
    assert_eq!(
        (cloud.point_step, cloud.row_step, cloud.is_dense),
        (16, 32, false)
    );
    let number = |at: usize| f32::from_le_bytes(cloud.data[at..at + 4].try_into().unwrap());
    assert_eq!([number(0), number(4), number(8)], [-0.5, 0.0, 2.0]);
    assert_eq!(cloud.data[12..16], [3, 2, 1, 0]);
    assert!(number(24).is_nan());
}

#[test]
fn points_of_every_second_pixel_are_a_smaller_cloud() {
    let size = ImageSize::new(5, 3);
    let intrinsics = Intrinsics::new(size, 1.0, 1.0, PixelPoint::<OpenCv>::new(0.0, 0.0));
    let camera = OutputCamera {
        camera: Camera::new(intrinsics, LensModel::Pinhole),
        shift_m: 0.0,
    };
    let metres = oaktwin::image::Image::filled(5, 3, 1.0f32);
    let cloud = Points::new(&camera, NonZeroU32::new(2).unwrap()).message(message_header(), &metres, None);
    assert_eq!((cloud.width, cloud.height, cloud.row_step), (3, 2, 36));
    let points = cloud.data.as_chunks::<4>().0.as_chunks::<3>().0;
    let points: Vec<[f32; 3]> = points.iter().map(|point| point.map(f32::from_le_bytes)).collect();
    let expected = [0.0, 2.0].map(|y| [0.0, 2.0, 4.0].map(|x| [x, y, 1.0]));
    assert_eq!(points, expected.concat());
}

#[test]
fn messages_round_trip_through_cdr() {
    use cdr_encoding::{from_bytes, to_vec};
    type Order = byteorder::LittleEndian;
    let mut message = image("16UC1", 4, vec![1, 2, 3, 4, 5, 6, 7, 8]);
    message.header = message_header();
    let bytes = to_vec::<_, Order>(&message).unwrap();
    // The header (4 + 4 + 4 + 8), the size (8), the encoding (4 + 6), the order (1 + 1), the step (4) and the data (4 + 8).
    assert_eq!(bytes.len(), 20 + 8 + 10 + 2 + 4 + 12);
    assert_eq!(from_bytes::<Image, Order>(&bytes).unwrap().0, message);
    for end in 0..bytes.len() {
        assert!(
            from_bytes::<Image, Order>(&bytes[..end]).is_err(),
            "{end} of {} bytes",
            bytes.len()
        );
    }
    let bytes = to_vec::<_, Order>(&info()).unwrap();
    assert_eq!(from_bytes::<CameraInfo, Order>(&bytes).unwrap().0, info());
    // A length of 4 GB in front of a few bytes.
    let mut huge = to_vec::<_, Order>(&message).unwrap();
    let at = huge.len() - 12;
    huge[at..at + 4].copy_from_slice(&u32::MAX.to_le_bytes());
    assert!(from_bytes::<Image, Order>(&huge).is_err());
}

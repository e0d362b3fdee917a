//! The fields of ROS 2 messages.

use oaktwin_camera::{ImageSize, Intrinsics, RigidTransform};
use oaktwin_image::{Image, ImageView};

use super::cdr::Cdr;
use super::lens::Distortion;
use super::{DepthView, RecordedImu, Time, cloud};
use crate::ImuSample;

/// `sensor_msgs/PointField.FLOAT32`.
const FLOAT32: u8 = 7;

/// The time and frame of a message.
#[derive(Clone, Copy)]
pub(super) struct Header<'a> {
    pub(super) time: Time,
    pub(super) frame: &'a str,
}

/// A transform between frames.
pub(super) struct Transform<'a> {
    pub(super) header: Header<'a>,
    pub(super) child: &'a str,
    /// The transform to `header.frame` from `child`.
    pub(super) parent_from_child: RigidTransform,
}

fn header(cdr: &mut Cdr, header: Header<'_>) {
    let (seconds, nanoseconds) = header.time.stamp();
    cdr.i32(seconds).u32(nanoseconds).string(header.frame);
}

/// Writes the fields before the bytes of an image.
fn image_head(cdr: &mut Cdr, head: Header<'_>, size: ImageSize, encoding: &str, bytes_per_pixel: u32) {
    header(cdr.begin(), head);
    cdr.u32(size.height).u32(size.width).string(encoding);
    // is_bigendian
    cdr.u8(0).u32(size.width * bytes_per_pixel);
}

/// Writes a `sensor_msgs/Image` with `rgb8`.
pub(super) fn rgb(cdr: &mut Cdr, head: Header<'_>, image: ImageView<'_, [u8; 4]>) {
    let size = ImageSize::new(image.width(), image.height());
    image_head(cdr, head, size, "rgb8", 3);
    let pixels = image.pixels();
    cdr.byte_sequence(3 * pixels.len(), |bytes| {
        bytes.extend(pixels.iter().flat_map(|&[r, g, b, _]| [r, g, b]));
    });
}

/// Writes a `sensor_msgs/Image` with `32FC1` or `16UC1` and the invalid values of REP-117 and REP-118.
pub(super) fn depth(cdr: &mut Cdr, head: Header<'_>, depth: DepthView<'_>) {
    let size = depth.size();
    match depth {
        DepthView::Metres(image) => {
            image_head(cdr, head, size, "32FC1", 4);
            let pixels = image.pixels();
            cdr.byte_sequence(4 * pixels.len(), |bytes| {
                let valid = |z: f32| if z > 0.0 { z } else { f32::NAN };
                bytes.extend(pixels.iter().flat_map(|&z| valid(z).to_le_bytes()));
            });
        }
        DepthView::Millimetres(image) => {
            image_head(cdr, head, size, "16UC1", 2);
            let pixels = image.pixels();
            cdr.byte_sequence(2 * pixels.len(), |bytes| {
                bytes.extend(pixels.iter().flat_map(|mm| mm.to_le_bytes()));
            });
        }
    }
}

/// Writes a `sensor_msgs/CameraInfo`: K and D of the raw image, P of the undistorted one.
pub(super) fn camera_info(cdr: &mut Cdr, head: Header<'_>, intrinsics: &Intrinsics, distortion: &Distortion) {
    let k = intrinsics.opencv_matrix();
    header(cdr.begin(), head);
    cdr.u32(intrinsics.size.height).u32(intrinsics.size.width);
    cdr.string(distortion.model)
        .length(distortion.d.len())
        .f64s(&distortion.d);
    cdr.f64s(k.as_flattened())
        .f64s(&[1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0])
        .f64s(k.map(|[a, b, c]| [a, b, c, 0.0]).as_flattened());
    // No binning, no region of interest.
    cdr.u32(0).u32(0);
    cdr.u32(0).u32(0).u32(0).u32(0).bool(false);
}

/// Writes a `sensor_msgs/PointCloud2`: one point per pixel, row by row, NaN if invalid, with colours packed into a number like
/// PCL's if there is a colour image.
pub(super) fn points(
    cdr: &mut Cdr,
    head: Header<'_>,
    rays: &Image<[f32; 2]>,
    depth: DepthView<'_>,
    rgb: Option<ImageView<'_, [u8; 4]>>,
) {
    let (height, width) = (rays.height(), rays.width());
    let names = ["x", "y", "z", "rgb"];
    let names = if rgb.is_some() { &names[..] } else { &names[..3] };
    header(cdr.begin(), head);
    cdr.u32(height).u32(width).length(names.len());
    for (offset, name) in (0u32..).step_by(4).zip(names) {
        cdr.string(name).u32(offset).u8(FLOAT32).u32(1);
    }
    let step = 4 * u32::try_from(names.len()).unwrap_or(4);
    cdr.bool(false).u32(step).u32(step * width);
    let mut is_dense = true;
    cdr.byte_sequence(step as usize * rays.pixels().len(), |bytes| {
        let mut colors = rgb.map(|image| image.pixels().iter());
        for point in cloud::points(rays, depth) {
            is_dense &= !point[2].is_nan();
            bytes.extend(point.iter().flat_map(|number| number.to_le_bytes()));
            if let Some(colors) = &mut colors {
                let [r, g, b, _] = colors.next().copied().unwrap_or_default();
                bytes.extend([b, g, r, 0]);
            }
        }
    });
    cdr.bool(is_dense);
}

/// Writes a `sensor_msgs/Imu` without orientation, which REP-145 marks with a covariance of -1, with the variances of the axes.
pub(super) fn imu(cdr: &mut Cdr, head: Header<'_>, sample: &ImuSample, imu: &RecordedImu) {
    header(cdr.begin(), head);
    cdr.f64s(&[0.0, 0.0, 0.0, 1.0]);
    cdr.f64s(&[-1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
    let channels = [
        (sample.angular_velocity, imu.angular_velocity_deviation),
        (sample.linear_acceleration, imu.linear_acceleration_deviation),
    ];
    for (value, deviation) in channels {
        let [x, y, z] = (deviation * deviation).to_array();
        cdr.f64s(&value.to_array());
        cdr.f64s(&[x, 0.0, 0.0, 0.0, y, 0.0, 0.0, 0.0, z]);
    }
}

/// Writes a `tf2_msgs/TFMessage`.
pub(super) fn transforms<'a>(cdr: &mut Cdr, transforms: impl ExactSizeIterator<Item = Transform<'a>>) {
    cdr.begin().length(transforms.len());
    for transform in transforms {
        header(cdr, transform.header);
        cdr.string(transform.child);
        let q = transform.parent_from_child.quaternion();
        cdr.f64s(&transform.parent_from_child.translation.to_array());
        cdr.f64s(&[q.x, q.y, q.z, q.w]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use oaktwin_camera::math::{DMat3, DVec3};
    use oaktwin_camera::{OpenCv, PixelPoint};

    fn head() -> Header<'static> {
        Header {
            time: Time::from_seconds(1.000_000_002).unwrap(),
            frame: "c",
        }
    }

    /// The 14 bytes of the time and the frame of [`head`].
    const HEAD: &[u8] = &[0, 1, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0, b'c', 0];

    #[test]
    fn bytes_of_an_image() {
        let mut cdr = Cdr::default();
        let metres = [1.0f32, 0.0, f32::INFINITY];
        let view = ImageView::new(3, 1, &metres).unwrap();
        depth(&mut cdr, head(), DepthView::Metres(view));
        let expected = [
            HEAD,
            &[0, 0],                   // to 16
            &[1, 0, 0, 0, 3, 0, 0, 0], // height, width
            &[6, 0, 0, 0, b'3', b'2', b'F', b'C', b'1', 0],
            &[0, 0],                     // little-endian at 34; to 36
            &[12, 0, 0, 0, 12, 0, 0, 0], // a row's bytes, all bytes
            &[0, 0, 0x80, 0x3f],
            &f32::NAN.to_le_bytes(),
            &[0, 0, 0x80, 0x7f],
        ];
        assert_eq!(cdr.bytes(), expected.concat());

        let picture = [[1u8, 2, 3, 255], [4, 5, 6, 0]];
        rgb(&mut cdr, head(), ImageView::new(2, 1, &picture).unwrap());
        let expected = [
            HEAD,
            &[0, 0, 1, 0, 0, 0, 2, 0, 0, 0],
            &[5, 0, 0, 0, b'r', b'g', b'b', b'8', 0, 0], // and the byte order, at 33
            &[0, 0, 6, 0, 0, 0, 6, 0, 0, 0, 1, 2, 3, 4, 5, 6],
        ];
        assert_eq!(cdr.bytes(), expected.concat());
    }

    #[test]
    fn bytes_of_a_camera_info() {
        let intrinsics = Intrinsics::new(
            ImageSize::new(4, 2),
            1.0,
            1.0,
            PixelPoint::<OpenCv>::new(1.0, 1.0),
        );
        let distortion = Distortion {
            model: "m",
            d: vec![1.0],
        };
        let mut cdr = Cdr::default();
        camera_info(&mut cdr, head(), &intrinsics, &distortion);
        let (i, o) = (1f64.to_le_bytes(), 0f64.to_le_bytes());
        let expected = [
            HEAD,
            &[0, 0, 2, 0, 0, 0, 4, 0, 0, 0],
            &[2, 0, 0, 0, b'm', 0, 0, 0], // to 32
            &[1, 0, 0, 0, 0, 0, 0, 0],    // one coefficient, aligned to 40
            &i,
            &[i, o, i, o, i, i, o, o, i].concat(),
            &[i, o, o, o, i, o, o, o, i].concat(),
            &[i, o, i, o, o, i, i, o, o, o, i, o].concat(),
            &[0; 25],
        ];
        assert_eq!(cdr.bytes(), expected.concat());
    }

    #[test]
    fn bytes_of_a_transform() {
        let mut cdr = Cdr::default();
        let turn = DMat3::from_cols(DVec3::NEG_X, DVec3::NEG_Y, DVec3::Z);
        let one = Transform {
            header: head(),
            child: "d",
            parent_from_child: RigidTransform::new(turn, DVec3::new(1.0, 0.0, 0.0)),
        };
        transforms(&mut cdr, [one].into_iter());
        let (i, o) = (1f64.to_le_bytes(), 0f64.to_le_bytes());
        let expected = [
            &[0, 1, 0, 0, 1, 0, 0, 0][..], // one of them
            &HEAD[4..],
            &[0, 0], // at 18, to 20
            &[2, 0, 0, 0, b'd', 0],
            &[0, 0], // at 26, to 32, from behind the header
            &[0, 0, 0, 0],
            &[i, o, o].concat(),
            &[o, o, i, o].concat(),
        ];
        assert_eq!(cdr.bytes(), expected.concat());
    }

    #[test]
    fn bytes_of_an_inertial_sample() {
        let imu = RecordedImu {
            name: "imu".to_owned(),
            body: "b".to_owned(),
            body_from_imu: RigidTransform::IDENTITY,
            angular_velocity_deviation: DVec3::new(2.0, 0.0, 0.0),
            linear_acceleration_deviation: DVec3::new(0.0, 0.0, 0.5),
        };
        let sample = ImuSample {
            time: head().time,
            angular_velocity: DVec3::new(1.0, 0.0, 0.0),
            linear_acceleration: DVec3::new(0.0, 1.0, 0.0),
        };
        let mut cdr = Cdr::default();
        super::imu(&mut cdr, head(), &sample, &imu);
        let [i, o, none, four, quarter] = [1.0, 0.0, -1.0, 4.0, 0.25].map(f64::to_le_bytes);
        let expected = [
            HEAD,
            &[0, 0], // at 18, to 16 behind the header
            &[o, o, o, i].concat(),
            &[none, o, o, o, o, o, o, o, o].concat(),
            &[i, o, o].concat(),
            &[four, o, o, o, o, o, o, o, o].concat(),
            &[o, i, o].concat(),
            &[o, o, o, o, o, o, o, o, quarter].concat(),
        ];
        assert_eq!(cdr.bytes(), expected.concat());
    }

    #[test]
    fn bytes_of_a_point_cloud() {
        let rays = Image::new(2, 1, vec![[0.5, -0.5], [1.0, 1.0]]).unwrap();
        let (metres, picture) = ([2.0f32, 0.0], [[1u8, 2, 3, 255]; 2]);
        let view = DepthView::Metres(ImageView::new(2, 1, &metres).unwrap());
        let mut cdr = Cdr::default();
        points(&mut cdr, head(), &rays, view, ImageView::new(2, 1, &picture));
        let bytes = cdr.bytes();
        let data = &bytes[bytes.len() - 33..];
        let numbers = [1.0f32, -1.0, 2.0].map(f32::to_le_bytes).concat();
        assert_eq!(data[..12], numbers);
        assert_eq!(data[12..16], [3, 2, 1, 0]);
        assert!(f32::from_le_bytes([data[16], data[17], data[18], data[19]]).is_nan());
        assert_eq!(data[32], 0, "not dense");
        let field =
            |name: u8, offset: u8| [2, 0, 0, 0, name, 0, 0, 0, offset, 0, 0, 0, 7, 0, 0, 0, 1, 0, 0, 0];
        let expected = [
            HEAD,
            &[0, 0, 1, 0, 0, 0, 2, 0, 0, 0],
            &[4, 0, 0, 0],
            &field(b'x', 0),
            &field(b'y', 4),
            &field(b'z', 8),
            &[
                4, 0, 0, 0, b'r', b'g', b'b', 0, 12, 0, 0, 0, 7, 0, 0, 0, 1, 0, 0, 0,
            ],
            &[0, 0, 0, 0, 16, 0, 0, 0, 32, 0, 0, 0, 32, 0, 0, 0],
        ];
        assert_eq!(bytes[..bytes.len() - 33], expected.concat());

        let view = DepthView::Millimetres(ImageView::new(2, 1, &[2000u16, 1000]).unwrap());
        points(&mut cdr, head(), &rays, view, None);
        let bytes = cdr.bytes();
        assert_eq!(bytes[bytes.len() - 25..bytes.len() - 13], numbers);
        assert_eq!(bytes[bytes.len() - 1], 1, "dense");
    }
}

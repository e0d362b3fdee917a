use std::io;

use super::*;
use crate::recording::{DepthView, MovingBody};
use oaktwin_camera::math::{DMat3, DVec3};
use oaktwin_camera::{Camera, FTheta, ImageSize, Intrinsics, LensModel, PixelPoint};

fn camera(name: &str, body: Option<&str>) -> RecordedCamera {
    let intrinsics = Intrinsics::from_hfov(ImageSize::new(4, 3), 1.2);
    RecordedCamera {
        name: name.to_owned(),
        frame: None,
        camera: Camera::new(intrinsics, LensModel::Pinhole),
        measured: None,
        body: body.map(|name| MovingBody {
            name: name.to_owned(),
            body_from_camera: RigidTransform::new(
                Axes::Ros.rotation_from(Axes::OpenCv),
                DVec3::new(0.1, 0.2, 0.3),
            ),
        }),
    }
}

fn at(seconds: f64) -> Moment<'static> {
    let turn = DMat3::from_rotation_z(seconds);
    let pose = RigidTransform::new(turn, DVec3::new(seconds, 0.0, 1.0));
    Moment::new(Time::from_seconds(seconds).unwrap(), pose)
}

/// Two cameras on a body, one without a body, two frames.
fn recording() -> Vec<u8> {
    let mut recorder = Mcap::new(Vec::new()).unwrap();
    let cameras = [
        camera("left", Some("OAK 1")),
        camera("right", Some("OAK 1")),
        camera("left", None),
    ]
    .map(|camera| recorder.add_camera(&camera).unwrap());
    let (metres, picture) = (Image::filled(4, 3, 1.5f32), Image::filled(4, 3, [1u8, 2, 3, 255]));
    for seconds in [0.5, 0.75] {
        for camera in cameras {
            let moment = Moment {
                rgb: Some((&picture).into()),
                depth: Some(DepthView::Metres((&metres).into())),
                measured: Some(DepthView::Metres((&metres).into())),
                measured_points: true,
                ..at(seconds)
            };
            recorder.record(camera, &moment).unwrap();
        }
    }
    recorder.finish().unwrap()
}

#[test]
fn the_reference_library_reads_recordings() {
    let file = recording();
    let messages: Vec<_> = ::mcap::MessageStream::new(&file)
        .unwrap()
        .collect::<Result<_, _>>()
        .unwrap();
    let mut counts: BTreeMap<(&str, &str), usize> = BTreeMap::new();
    for message in &messages {
        let schema = message.channel.schema.as_ref().unwrap();
        assert_eq!(
            (&*schema.encoding, &*message.channel.message_encoding),
            ("ros2msg", "cdr")
        );
        *counts.entry((&message.channel.topic, &schema.name)).or_default() += 1;
    }
    let (image, info, cloud, tf) = (
        Schema::Image.name(),
        Schema::CameraInfo.name(),
        Schema::PointCloud2.name(),
        Schema::Tf.name(),
    );
    let mut expected = BTreeMap::from([(("/tf", tf), 4), (("/tf_static", tf), 1)]);
    for (topic, schema) in [
        ("/left/camera_info", info),
        ("/left/depth", image),
        ("/left/measured", image),
        ("/left/measured_points", cloud),
        ("/left/rgb", image),
        ("/left_2/camera_info", info),
        ("/left_2/depth", image),
        ("/left_2/measured", image),
        ("/left_2/measured_points", cloud),
        ("/left_2/rgb", image),
        ("/right/camera_info", info),
        ("/right/depth", image),
        ("/right/measured", image),
        ("/right/measured_points", cloud),
        ("/right/rgb", image),
    ] {
        expected.insert((topic, schema), 2);
    }
    assert_eq!(counts, expected);
    assert_eq!(messages[0].channel.topic, "/tf_static");
    assert!(messages[0].channel.metadata["offered_qos_profiles"].contains("durability: 1"));
    let times: Vec<u64> = messages.iter().map(|message| message.log_time).collect();
    assert!(times.is_sorted() && times[0] == 500_000_000 && times.last() == Some(&750_000_000));
    let seconds: Vec<u32> = messages
        .iter()
        .filter(|message| message.channel.topic == "/right/rgb")
        .map(|message| message.sequence)
        .collect();
    assert_eq!(seconds, [0, 1]);
    let summary = ::mcap::Summary::read(&file).unwrap().unwrap();
    assert_eq!(summary.stats.unwrap().message_count, 35);
}

#[test]
fn recordings_are_reproducible() {
    assert_eq!(recording(), recording());
}

#[test]
fn unsupported_lenses_have_no_camera_info() {
    let mut recorder = Mcap::new(Vec::new()).unwrap();
    let mut fisheye = camera("left", None);
    let lens = FTheta::new(&[0.0, 0.3], ImageSize::new(4, 3), PixelPoint::new(2.0, 1.5), 3.0);
    fisheye.camera = Camera::from_ftheta(lens.unwrap(), ImageSize::new(4, 3));
    let id = recorder.add_camera(&fisheye).unwrap();
    let metres = Image::filled(4, 3, 1.5f32);
    let moment = Moment {
        measured: Some(DepthView::Metres((&metres).into())),
        measured_points: true,
        ..at(0.5)
    };
    recorder.record(id, &moment).unwrap();
    let file = recorder.finish().unwrap();
    let topics: BTreeSet<String> = ::mcap::MessageStream::new(&file)
        .unwrap()
        .map(|message| message.unwrap().channel.topic.clone())
        .collect();
    let expected = ["/left/measured", "/left/measured_points", "/tf", "/tf_static"];
    assert_eq!(topics, BTreeSet::from(expected.map(str::to_owned)));
}

#[test]
fn rejects_invalid_moments() {
    let mut recorder = Mcap::new(Vec::new()).unwrap();
    let id = recorder.add_camera(&camera("left", None)).unwrap();
    let other = Image::filled(3, 4, 1.5f32);
    let moment = Moment {
        depth: Some(DepthView::Metres((&other).into())),
        ..at(0.5)
    };
    assert_eq!(
        recorder.record(id, &moment).unwrap_err().to_string(),
        "left: depth is 3x4, the camera's images are 4x3; give the camera of the images"
    );
    assert!(matches!(
        recorder.record(CameraId(1), &at(0.5)),
        Err(RecordingError::NoCamera)
    ));
    let mut large = camera("large", None);
    large.camera.intrinsics = Intrinsics::from_hfov(ImageSize::new(1 << 14, 1 << 14), 1.2);
    assert!(matches!(
        recorder.add_camera(&large),
        Err(RecordingError::TooLarge { .. })
    ));
}

/// A disk with limited capacity.
struct Disk(usize);

impl Write for Disk {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0 = self
            .0
            .checked_sub(bytes.len())
            .ok_or(io::ErrorKind::StorageFull)?;
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[test]
fn reports_full_disks_at_any_position() {
    let whole = recording().len();
    for room in [0, 5, 40, 3000, whole, 200_000] {
        let filled = || -> Result<(), RecordingError> {
            let mut recorder = Mcap::new(Disk(room))?;
            let mut large = camera("left", None);
            large.camera.intrinsics = Intrinsics::from_hfov(ImageSize::new(128, 128), 1.2);
            let id = recorder.add_camera(&large)?;
            // More than one chunk.
            for frame in 0u8..100 {
                let random: Vec<[u8; 4]> = (0..128u32 * 128)
                    .map(|at| {
                        (at + u32::from(frame) * 128 * 128)
                            .wrapping_mul(2_654_435_761)
                            .to_be_bytes()
                    })
                    .collect();
                let moment = Moment {
                    rgb: oaktwin_image::ImageView::new(128, 128, &random),
                    ..at(f64::from(frame))
                };
                recorder.record(id, &moment)?;
            }
            recorder.finish().map(drop)
        };
        match filled() {
            Err(RecordingError::Io(error)) => assert_eq!(error.kind(), io::ErrorKind::StorageFull),
            other => panic!("{room}: {other:?}"),
        }
    }
}

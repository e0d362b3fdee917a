//! `SDFormat` 1.9, the newest version that Debian's parser reads, for Gazebo and Drake.
//!
//! Gazebo names the frames of a sensor's messages with the element `gz_frame_id`. Drake refuses it, as all that `SDFormat` does not define, and
//! has no such messages.
//!
//! A principal point counts from the border of the image, so the centre of the first pixel is at 0.5. Depth has no noise: Gazebo's is
//! constant over distance, unlike a stereo camera's.

use oaktwin_camera::math::DMat3;
use oaktwin_camera::{RigidTransform, frame_names};
use oaktwin_imu::ChannelNoise;

use crate::description::{CameraFrame, DepthFrame, Description, IMU_RATE, ImuFrame, roll_pitch_yaw};
use crate::frame::DeviceFrame;
use crate::xml::{XmlElement, number, numbers};
use crate::{Housing, RobotFiles};

/// The rate of images, Hz.
const FRAME_RATE: f64 = 30.0;

/// The correlation time with which Gazebo's bias is a random walk for any usual run, s.
const CORRELATION_TIME: f64 = 1e6;

/// The program that reads a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Reader {
    Gazebo,
    Drake,
}

impl Reader {
    /// Returns the element that names the frame of a sensor's messages.
    fn frame_id(self, frame: String) -> Option<XmlElement> {
        (self == Self::Gazebo).then(|| XmlElement::text("gz_frame_id", frame))
    }
}

pub(crate) fn export(of: &Description, reader: Reader) -> RobotFiles {
    let mut export = RobotFiles::with_visuals(of).with_collider(of);
    export.without_parent(
        of,
        "SDF",
        "include the model in the robot's, and add a fixed joint from its link",
    );
    export.text("model.sdf", sdf(of, reader).document());
    if reader == Reader::Gazebo {
        export.text("model.config", config(of).document());
    }
    export
}

fn config(of: &Description) -> XmlElement {
    XmlElement::new("model")
        .with(XmlElement::text("name", &of.title))
        .with(XmlElement::text("version", "1.0"))
        .with(XmlElement::text("sdf", "model.sdf").set("version", "1.9"))
        .with(XmlElement::text(
            "description",
            format!("{}, written by oaktwin", of.title),
        ))
}

fn sdf(of: &Description, reader: Reader) -> XmlElement {
    let frames = of.frames();
    let frames = frames.iter().map(frame);
    let mut link = housing(of)
        .with_all(
            of.cameras
                .iter()
                .map(|camera| sensor(of, reader, camera, "camera", None)),
        )
        .with_all(of.depth_sensors.iter().map(|depth| {
            let DepthFrame { camera, range } = depth;
            sensor(of, reader, camera, "rgbd_camera", Some(*range))
        }));
    if let Some(imu) = &of.imu {
        link = link.with(imu_sensor(of, reader, imu));
    }
    XmlElement::new("sdf").set("version", "1.9").with(
        XmlElement::new("model")
            .set("name", &of.name)
            .with(pose(&of.parent_from_body))
            .with(link)
            .with_all(frames),
    )
}

fn frame(of: &DeviceFrame) -> XmlElement {
    XmlElement::new("frame")
        .set("name", &of.name)
        .set("attached_to", &of.parent)
        .with(pose(&of.parent_from_frame))
}

fn housing(of: &Description) -> XmlElement {
    let Housing {
        visuals,
        centre,
        mass,
        inertia,
        ..
    } = &of.housing;
    let mesh = |file: String| {
        let uri = XmlElement::text("uri", format!("meshes/{file}"));
        XmlElement::new("geometry").with(XmlElement::new("mesh").with(uri))
    };
    let inertial = XmlElement::new("inertial")
        .commented("A solid cuboid with the dimensions and the mass of the device.")
        .with(pose(&RigidTransform::new(DMat3::IDENTITY, *centre)))
        .with(XmlElement::text("mass", number(*mass)))
        .with(
            XmlElement::new("inertia")
                .with(XmlElement::text("ixx", format!("{:e}", inertia.x)))
                .with(XmlElement::text("ixy", "0"))
                .with(XmlElement::text("ixz", "0"))
                .with(XmlElement::text("iyy", format!("{:e}", inertia.y)))
                .with(XmlElement::text("iyz", "0"))
                .with(XmlElement::text("izz", format!("{:e}", inertia.z))),
        );
    let visuals = visuals.iter().map(|visual| {
        let [r, g, b] = visual.color.map(f64::from);
        XmlElement::new("visual")
            .set("name", visual.name)
            .with(mesh(of.visual_file(visual)))
            .with(
                XmlElement::new("material")
                    .with(XmlElement::text("ambient", numbers([r, g, b, 1.0])))
                    .with(XmlElement::text("diffuse", numbers([r, g, b, 1.0]))),
            )
    });
    let collision = XmlElement::new("collision")
        .set("name", "housing")
        .with(mesh(of.collider_file()));
    XmlElement::new("link")
        .set("name", &of.name)
        .with(inertial)
        .with_all(visuals)
        .with(collision)
}

/// Returns the sensor of a camera, which sees along the x axis of its frame.
fn sensor(
    of: &Description,
    reader: Reader,
    camera: &CameraFrame,
    kind: &str,
    range: Option<(f64, f64)>,
) -> XmlElement {
    let name = format!("{}_{}", of.name, camera.role);
    let (width, height) = (camera.intrinsics.size.width, camera.intrinsics.size.height);
    let (cx, cy) = camera.centre();
    let clip = |(near, far): (f64, f64)| {
        XmlElement::new("clip")
            .with(XmlElement::text("near", number(near)))
            .with(XmlElement::text("far", number(far)))
    };
    let intrinsics = XmlElement::new("intrinsics")
        .with(XmlElement::text("fx", number(camera.intrinsics.fx)))
        .with(XmlElement::text("fy", number(camera.intrinsics.fy)))
        .with(XmlElement::text("cx", number(cx)))
        .with(XmlElement::text("cy", number(cy)))
        .with(XmlElement::text("s", "0"));
    let mut optics = XmlElement::new("camera")
        .with(XmlElement::text("horizontal_fov", number(camera.hfov())))
        .with(
            XmlElement::new("image")
                .with(XmlElement::text("width", width.to_string()))
                .with(XmlElement::text("height", height.to_string()))
                .with(XmlElement::text("format", "R8G8B8")),
        )
        .with(clip(camera.clip));
    if let Some(range) = range {
        optics = optics.with(XmlElement::new("depth_camera").with(clip(range)));
    }
    let optics = optics.with(XmlElement::new("lens").with(intrinsics));
    XmlElement::new("sensor")
        .set("name", &name)
        .set("type", kind)
        .with(pose(&camera.body_from_camera()))
        .with(XmlElement::text("always_on", "true"))
        .with(XmlElement::text("update_rate", number(FRAME_RATE)))
        .with(XmlElement::text("topic", format!("{}/{}", of.name, camera.role)))
        .with_all(reader.frame_id(frame_names::optical(&frame_names::camera(&of.name, &camera.role))))
        .with(optics)
}

fn imu_sensor(of: &Description, reader: Reader, imu: &ImuFrame) -> XmlElement {
    let axes = |name, noise: &Option<ChannelNoise>| {
        let axis = |axis, deviation: f64, walk: f64| {
            let mut model = XmlElement::new("noise")
                .set("type", "gaussian")
                .with(XmlElement::text("mean", "0"))
                .with(XmlElement::text("stddev", format!("{deviation:e}")));
            if walk > 0.0 {
                model = model
                    .with(XmlElement::text("dynamic_bias_stddev", format!("{walk:e}")))
                    .with(XmlElement::text(
                        "dynamic_bias_correlation_time",
                        number(CORRELATION_TIME),
                    ));
            }
            XmlElement::new(axis).with(model)
        };
        noise.as_ref().map(|noise| {
            let (deviation, walk) = (noise.sample_deviation(IMU_RATE), noise.random_walk);
            XmlElement::new(name)
                .with(axis("x", deviation.x, walk.x))
                .with(axis("y", deviation.y, walk.y))
                .with(axis("z", deviation.z, walk.z))
        })
    };
    let model = XmlElement::new("imu")
        .with_all(axes("angular_velocity", &imu.gyroscope))
        .with_all(axes("linear_acceleration", &imu.accelerometer));
    XmlElement::new("sensor")
        .set("name", format!("{}_imu", of.name))
        .set("type", "imu")
        .commented("Standard deviations of single samples: noise density times the square root of the rate.")
        .with(pose(&imu.body_from_imu))
        .with(XmlElement::text("always_on", "true"))
        .with(XmlElement::text("update_rate", number(IMU_RATE)))
        .with(XmlElement::text("topic", format!("{}/imu/data", of.name)))
        .with_all(reader.frame_id(frame_names::imu(&of.name)))
        .with(model)
}

fn pose(pose: &RigidTransform) -> XmlElement {
    let angles = roll_pitch_yaw(&pose.rotation);
    let values = pose.translation.to_array().into_iter().chain(angles.to_array());
    XmlElement::text("pose", numbers(values))
}

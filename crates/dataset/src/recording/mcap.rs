//! Recordings as MCAP files of ROS 2 messages.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::io::Write;

use mcap::records::MessageHeader;
use mcap::write::NoSeek;
use mcap::{Compression, McapError, WriteOptions, Writer};
use oaktwin_camera::math::DVec3;
use oaktwin_camera::{Axes, RigidTransform, frame_names};
use oaktwin_image::Image;

use super::cdr::Cdr;
use super::lens::distortion;
use super::message::{self, Header, Transform};
use super::schema::Schema;
use super::{
    CameraId, Moment, RecordedCamera, RecordedImu, Recorder, RecordingError, Time, cloud, unique_name,
};
use crate::ImuSample;

/// The size of a chunk of messages, which are compressed together, bytes. A longer message has its own chunk.
const CHUNK: u64 = 4 << 20;

/// The root of all frames.
const WORLD: &str = "world";

/// Writes MCAP with the profile `ros2`. The same moments result in the same bytes.
///
/// | topic | message |
/// |---|---|
/// | `/NAME/rgb` | `sensor_msgs/msg/Image`, `rgb8` |
/// | `/NAME/depth`, `/NAME/measured` | `sensor_msgs/msg/Image`, `32FC1` metres or `16UC1` millimetres |
/// | `/NAME/camera_info` | `sensor_msgs/msg/CameraInfo` |
/// | `/NAME/measured_camera_info` | `sensor_msgs/msg/CameraInfo` of the depth sensor's output, if it is an image of another camera |
/// | `/NAME/depth_points`, `/NAME/measured_points` | `sensor_msgs/msg/PointCloud2`, one point per pixel, NaN if invalid |
/// | `/NAME/data_raw` | `sensor_msgs/msg/Imu` of an inertial sensor, in the frame `BODY_imu_frame` |
/// | `/tf`, `/tf_static` | `tf2_msgs/msg/TFMessage` |
///
/// Frames are `world` → the body → `NAME` → `NAME_optical_frame`, the frame of images and point clouds. A depth
/// sensor's output that is seen from elsewhere has the frame `NAME_measured_optical_frame`. A camera without a body has
/// `world` → `NAME`. The frames of an OAK's cameras have the names of its robot description instead, such as `oak_left_camera_frame`
/// and `oak_left_camera_optical_frame`. Chunks are compressed with zstd, on one thread.
pub struct Mcap<W: Write> {
    writer: Writer<NoSeek<W>>,
    /// The current message, whose memory is reused.
    cdr: Cdr,
    names: BTreeSet<String>,
    cameras: Vec<CameraTopics>,
    bodies: Vec<Carrier>,
    imu: Option<InertialStation>,
    channels: BTreeMap<String, Channel>,
    /// Whether a camera was added since the static transforms were last written.
    statics_are_due: bool,
}

/// A camera and the state of its messages.
struct CameraTopics {
    camera: RecordedCamera,
    /// The first part of the names of its topics.
    name: String,
    optical_frame: String,
    /// The frame of measured images.
    measured_frame: String,
    /// The name of the camera's frame.
    frame: String,
    /// The index of its body; `None` if it has none.
    carrier: Option<usize>,
    /// The rays of the pixels of exact and measured depth, computed for the first point cloud.
    rays: [Option<Image<[f32; 2]>>; 2],
    last: Option<(Time, RigidTransform)>,
}

/// The inertial sensor and its messages' names.
struct InertialStation {
    imu: RecordedImu,
    frame: String,
    topic: String,
    carrier: usize,
}

/// A body with cameras.
struct Carrier {
    name: String,
    frame: String,
    last: Option<(Time, RigidTransform)>,
}

#[derive(Clone, Copy)]
struct Channel {
    id: u16,
    sequence: u32,
}

impl<W: Write> Mcap<W> {
    /// Starts a recording.
    ///
    /// # Errors
    /// Returns an error if the output cannot be written.
    pub fn new(output: W) -> Result<Self, RecordingError> {
        let options = WriteOptions::new()
            .profile("ros2")
            .library(concat!("oaktwin ", env!("CARGO_PKG_VERSION")))
            .chunk_size(Some(CHUNK))
            // The fastest level, since noise does not compress at any level.
            .compression(Some(Compression::Zstd))
            .compression_level(1)
            // With several threads, the bytes depend on their number.
            .compression_threads(0)
            .disable_seeking(true);
        Ok(Self {
            writer: options.create(NoSeek::new(output)).map_err(failed)?,
            cdr: Cdr::default(),
            names: BTreeSet::from([WORLD.to_owned()]),
            cameras: Vec::new(),
            bodies: Vec::new(),
            imu: None,
            channels: BTreeMap::new(),
            statics_are_due: false,
        })
    }

    /// Sets the inertial sensor of the recording, before its first sample. There is one at most; a second replaces it.
    pub fn set_imu(&mut self, imu: &RecordedImu) {
        let carrier = self.carrier(&imu.body);
        let name = unique_name(&imu.name, &mut self.names);
        self.imu = Some(InertialStation {
            imu: imu.clone(),
            frame: unique_name(&frame_names::imu(&imu.body), &mut self.names),
            topic: format!("/{name}/data_raw"),
            carrier,
        });
        self.statics_are_due = true;
    }

    /// Records a sample of the inertial sensor.
    ///
    /// # Errors
    /// Returns an error if the output cannot be written, or if there is no inertial sensor.
    pub fn record_imu(&mut self, sample: &ImuSample) -> Result<(), RecordingError> {
        if std::mem::take(&mut self.statics_are_due) {
            self.put_statics(sample.time)?;
        }
        let station = self.imu.take().ok_or(RecordingError::NoImu)?;
        let head = Header {
            time: sample.time,
            frame: &station.frame,
        };
        message::imu(&mut self.cdr, head, sample, &station.imu);
        let written = self.put(&station.topic, Schema::Imu, sample.time);
        self.imu = Some(station);
        written
    }

    /// Returns the index of the body with a name, which is added if it is new.
    fn carrier(&mut self, name: &str) -> usize {
        let known = self.bodies.iter().position(|carrier| carrier.name == name);
        known.unwrap_or_else(|| {
            self.bodies.push(Carrier {
                name: name.to_owned(),
                frame: unique_name(name, &mut self.names),
                last: None,
            });
            self.bodies.len() - 1
        })
    }

    /// Writes the message in `self.cdr`.
    fn put(&mut self, topic: &str, schema: Schema, time: Time) -> Result<(), RecordingError> {
        let channel = match self.channels.get_mut(topic) {
            Some(channel) => channel,
            None => {
                let made = self
                    .writer
                    .add_schema(schema.name(), "ros2msg", schema.text().as_bytes());
                let made =
                    made.and_then(|schema| self.writer.add_channel(schema, topic, "cdr", &metadata(topic)));
                let channel = Channel {
                    id: made.map_err(failed)?,
                    sequence: 0,
                };
                self.channels.entry(topic.to_owned()).or_insert(channel)
            }
        };
        let header = MessageHeader {
            channel_id: channel.id,
            sequence: channel.sequence,
            log_time: time.nanoseconds(),
            publish_time: time.nanoseconds(),
        };
        channel.sequence = channel.sequence.wrapping_add(1);
        self.writer
            .write_to_known_channel(&header, self.cdr.bytes())
            .map_err(failed)
    }

    /// Writes all static transforms in one message, since late subscribers receive only the last one.
    fn put_statics(&mut self, time: Time) -> Result<(), RecordingError> {
        let header = |frame| Header { time, frame };
        let mut all = Vec::new();
        for station in &self.cameras {
            let carrier = station.carrier.and_then(|at| self.bodies.get(at));
            if let (Some(carrier), Some(body)) = (carrier, &station.camera.body) {
                all.push(Transform {
                    header: header(&carrier.frame),
                    child: &station.frame,
                    parent_from_child: body.body_from_camera * optical_from_camera(),
                });
            }
            all.push(Transform {
                header: header(&station.frame),
                child: &station.optical_frame,
                parent_from_child: optical_from_camera().inverse(),
            });
            if station.measured_frame != station.optical_frame {
                all.push(Transform {
                    header: header(&station.optical_frame),
                    child: &station.measured_frame,
                    parent_from_child: station.camera.measured().camera_from_measured,
                });
            }
        }
        if let Some(station) = &self.imu
            && let Some(carrier) = self.bodies.get(station.carrier)
        {
            all.push(Transform {
                header: header(&carrier.frame),
                child: &station.frame,
                parent_from_child: station.imu.body_from_imu,
            });
        }
        message::transforms(&mut self.cdr, all.into_iter());
        self.put("/tf_static", Schema::Tf, time)
    }

    /// Writes the pose of the camera or its body, unless another camera of the body has written it.
    fn put_pose(&mut self, at: usize, moment: &Moment<'_>) -> Result<(), RecordingError> {
        let Some(station) = self.cameras.get_mut(at) else {
            return Err(RecordingError::NoCamera);
        };
        let pose = moment.world_from_mount;
        let (last, child, pose) = match station.carrier.and_then(|at| self.bodies.get_mut(at)) {
            Some(carrier) => (&mut carrier.last, &carrier.frame, pose),
            None => (&mut station.last, &station.frame, pose * optical_from_camera()),
        };
        if last.replace((moment.time, pose)) == Some((moment.time, pose)) {
            return Ok(());
        }
        let transform = Transform {
            header: Header {
                time: moment.time,
                frame: WORLD,
            },
            child,
            parent_from_child: pose,
        };
        message::transforms(&mut self.cdr, [transform].into_iter());
        self.put("/tf", Schema::Tf, moment.time)
    }

    /// Writes the images; `station` is borrowed from `self.cameras`.
    fn put_images(&mut self, station: &mut CameraTopics, moment: &Moment<'_>) -> Result<(), RecordingError> {
        let time = moment.time;
        let head = Header {
            time,
            frame: &station.optical_frame,
        };
        let topic = |what: &str| format!("/{}/{what}", station.name);
        let camera = &station.camera.camera;
        if let Some(distortion) = distortion(&camera.lens) {
            message::camera_info(&mut self.cdr, head, &camera.intrinsics, &distortion);
            self.put(&topic("camera_info"), Schema::CameraInfo, time)?;
        }
        let measured = station.camera.measured();
        let measured_head = Header {
            time,
            frame: &station.measured_frame,
        };
        let is_other = station.camera.measured.is_some();
        if is_other
            && moment.measured.is_some()
            && let Some(distortion) = distortion(&measured.camera.lens)
        {
            let intrinsics = &measured.camera.intrinsics;
            message::camera_info(&mut self.cdr, measured_head, intrinsics, &distortion);
            self.put(&topic("measured_camera_info"), Schema::CameraInfo, time)?;
        }
        if let Some(rgb) = moment.rgb {
            message::rgb(&mut self.cdr, head, rgb);
            self.put(&topic("rgb"), Schema::Image, time)?;
        }
        let images = [
            ("depth", moment.depth, head),
            ("measured", moment.measured, measured_head),
        ];
        for (name, depth, head) in images {
            if let Some(depth) = depth {
                message::depth(&mut self.cdr, head, depth);
                self.put(&topic(name), Schema::Image, time)?;
            }
        }
        let [rays, measured_rays] = &mut station.rays;
        if let Some(depth) = moment.depth.filter(|_| moment.depth_points) {
            let rays = rays.get_or_insert_with(|| cloud::rays(camera));
            message::points(&mut self.cdr, head, rays, depth, moment.rgb);
            self.put(&topic("depth_points"), Schema::PointCloud2, time)?;
        }
        if let Some(depth) = moment.measured.filter(|_| moment.measured_points) {
            let rays = measured_rays.get_or_insert_with(|| cloud::rays(&measured.camera));
            let colors = cloud::measured_colors(rays, depth, &station.camera, moment.rgb);
            let rgb = colors.as_ref().map(Into::into).or(moment.rgb);
            message::points(&mut self.cdr, measured_head, rays, depth, rgb);
            self.put(&topic("measured_points"), Schema::PointCloud2, time)?;
        }
        Ok(())
    }
}

impl<W: Write> Recorder for Mcap<W> {
    type Output = W;

    fn add_camera(&mut self, camera: &RecordedCamera) -> Result<CameraId, RecordingError> {
        camera.check()?;
        let carrier = camera.body.as_ref().map(|body| self.carrier(&body.name));
        let name = unique_name(&camera.name, &mut self.names);
        let frame = match &camera.frame {
            Some(frame) => unique_name(frame, &mut self.names),
            None => name.clone(),
        };
        let optical_frame = unique_name(&frame_names::optical(&frame), &mut self.names);
        let is_moved = camera.measured().camera_from_measured != RigidTransform::IDENTITY;
        self.cameras.push(CameraTopics {
            camera: camera.clone(),
            measured_frame: match is_moved {
                true => unique_name(&format!("{frame}_measured_optical_frame"), &mut self.names),
                false => optical_frame.clone(),
            },
            name,
            optical_frame,
            frame,
            carrier,
            rays: [None, None],
            last: None,
        });
        self.statics_are_due = true;
        Ok(CameraId(self.cameras.len() - 1))
    }

    fn record(&mut self, camera: CameraId, moment: &Moment<'_>) -> Result<(), RecordingError> {
        let station = self.cameras.get(camera.0).ok_or(RecordingError::NoCamera)?;
        moment.check(&station.camera)?;
        if std::mem::take(&mut self.statics_are_due) {
            self.put_statics(moment.time)?;
        }
        self.put_pose(camera.0, moment)?;
        // Taken out of the list while its images are written.
        let mut cameras = std::mem::take(&mut self.cameras);
        let written = match cameras.get_mut(camera.0) {
            Some(station) => self.put_images(station, moment),
            None => Err(RecordingError::NoCamera),
        };
        self.cameras = cameras;
        written
    }

    fn finish(mut self) -> Result<W, RecordingError> {
        self.writer.finish().map_err(failed)?;
        Ok(self.writer.into_inner().into_inner())
    }
}

impl<W: Write> fmt::Debug for Mcap<W> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let cameras = self.cameras.iter().map(|station| &station.frame);
        f.debug_struct("Mcap")
            .field("cameras", &cameras.collect::<Vec<_>>())
            .finish_non_exhaustive()
    }
}

/// Returns the transform from a camera's frame, with the axes of a body, to its optical frame.
fn optical_from_camera() -> RigidTransform {
    RigidTransform::new(Axes::OpenCv.rotation_from(Axes::Ros), DVec3::ZERO)
}

/// Returns the quality-of-service profile of a topic for players, by which static transforms are kept for late subscribers (with the numbers of
/// `rmw`: keep last one, reliable, transient local, automatic, no limits).
fn metadata(topic: &str) -> BTreeMap<String, String> {
    let forever = "{sec: 9223372036, nsec: 854775807}";
    let qos = format!(
        "- history: 1\n  depth: 1\n  reliability: 1\n  durability: 1\n  deadline: {forever}\n  lifespan: {forever}\n  \
         liveliness: 1\n  liveliness_lease_duration: {forever}\n  avoid_ros_namespace_conventions: false"
    );
    if topic == "/tf_static" {
        BTreeMap::from([("offered_qos_profiles".to_owned(), qos)])
    } else {
        BTreeMap::new()
    }
}

fn failed(error: McapError) -> RecordingError {
    match error {
        McapError::Io(error) => RecordingError::Io(error),
        other => RecordingError::Format(other.to_string()),
    }
}

#[cfg(test)]
mod tests;

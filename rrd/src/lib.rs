//! Recordings of oaktwin in Rerun's format.
//!
//! [`Rrd`] takes what [`Mcap`](oaktwin::dataset::recording::Mcap) takes. It is a crate outside oaktwin's workspace because Rerun's
//! libraries have several hundred dependencies; Rerun's viewer opens MCAP files as well.

use std::collections::BTreeSet;
use std::fmt;
use std::io::Write;
use std::time::Duration;

use oaktwin::camera::math::DVec3;
use oaktwin::camera::{Camera, OpenCv, RigidTransform};
use oaktwin::dataset::recording::{
    self, CameraId, DepthView, Moment, RecordedCamera, Recorder, RecordingError, unique_name,
};
use oaktwin::image::{Image, ImageView};
use rerun::external::re_log_encoding::{EncodeError, Encoder, EncodingOptions};
use rerun::sink::MemorySinkStorage;
use rerun::{RecordingStream, RecordingStreamBuilder};


/// The name of the timeline.
const TIMELINE: &str = "time";

/// Writes Rerun's format.
///
/// | entity | content |
/// |---|---|
/// | `world` | `ViewCoordinates`: the up axis |
/// | `world/BODY`, `world/BODY/NAME` | `Transform3D`; an entity's axes are the camera's optical frame |
/// | `world/BODY/NAME/image` | `Pinhole`: the frustum |
/// | `world/BODY/NAME/image/rgb` | `Image` |
/// | `world/BODY/NAME/image/depth`, `…/measured` | `DepthImage`, with its `meter` |
/// | `world/BODY/NAME/depth_points`, `…/measured_points` | `Points3D` |
///
/// A depth sensor's output that is an image of another camera is in `measured_image` beside `image`. A camera without a body
/// is `world/NAME`. Time is the timeline `time`, a duration. Depth is not changed: the viewer
/// ignores 0 and infinity. The file contains ids and clock times of Rerun, so that its bytes are not reproducible.
pub struct Rrd<W: Write> {
    stream: RecordingStream,
    /// The messages of the stream that are not written yet.
    said: MemorySinkStorage,
    encoder: Encoder<W>,
    names: BTreeSet<String>,
    cameras: Vec<LoggedCamera>,
    /// The names of entities in use.
    bodies: Vec<(String, String)>,
}

struct LoggedCamera {
    camera: RecordedCamera,
    entity: String,
    /// The entity that moves.
    mount: String,
    /// The rays of the pixels of exact and measured depth, computed for the first point cloud.
    rays: [Option<Image<[f32; 2]>>; 2],
}

impl<W: Write> Rrd<W> {
    /// Starts a recording in a world whose z axis is up, otherwise its y axis.
    ///
    /// # Errors
    /// Returns an error if the output cannot be written.
    pub fn new(output: W, is_z_up: bool) -> Result<Self, RecordingError> {
        let (stream, said) = RecordingStreamBuilder::new("oaktwin").memory().map_err(failed)?;
        let version = rerun::build_info().version;
        let options = EncodingOptions::PROTOBUF_COMPRESSED;
        let up = if is_z_up {
            rerun::ViewCoordinates::RIGHT_HAND_Z_UP()
        } else {
            rerun::ViewCoordinates::RIGHT_HAND_Y_UP()
        };
        stream.log_static("world", &up).map_err(failed)?;
        Ok(Self {
            stream,
            said,
            encoder: Encoder::new_eager(version, options, output).map_err(not_written)?,
            names: BTreeSet::new(),
            cameras: Vec::new(),
            bodies: Vec::new(),
        })
    }

    /// Writes the messages since the last call.
    fn write(&mut self) -> Result<(), RecordingError> {
        for message in self.said.take() {
            self.encoder.append(&message).map_err(not_written)?;
        }
        Ok(())
    }
}

impl<W: Write> Recorder for Rrd<W> {
    type Output = W;

    fn add_camera(&mut self, camera: &RecordedCamera) -> Result<CameraId, RecordingError> {
        camera.check()?;
        let parent = match &camera.body {
            None => "world".to_owned(),
            Some(body) => match self.bodies.iter().find(|(name, _)| *name == body.name) {
                Some((_, entity)) => entity.clone(),
                None => {
                    let entity = format!("world/{}", unique_name(&body.name, &mut self.names));
                    self.bodies.push((body.name.clone(), entity.clone()));
                    entity
                }
            },
        };
        let entity = format!("{parent}/{}", unique_name(&camera.name, &mut self.names));
        if let Some(body) = &camera.body {
            self.stream
                .log_static(entity.as_str(), &transform(&body.body_from_camera))
                .map_err(failed)?;
        }
        self.stream
            .log_static(format!("{entity}/image"), &pinhole(&camera.camera))
            .map_err(failed)?;
        if let Some(measured) = &camera.measured {
            let entity = format!("{entity}/measured_image");
            let pose = transform(&measured.camera_from_measured);
            self.stream.log_static(entity.as_str(), &pose).map_err(failed)?;
            self.stream
                .log_static(entity, &pinhole(&measured.camera))
                .map_err(failed)?;
        }
        let mount = if camera.body.is_some() {
            parent
        } else {
            entity.clone()
        };
        self.cameras.push(LoggedCamera {
            camera: camera.clone(),
            entity,
            mount,
            rays: [None, None],
        });
        self.write()?;
        Ok(CameraId::new(self.cameras.len() - 1))
    }

    fn record(&mut self, camera: CameraId, moment: &Moment<'_>) -> Result<(), RecordingError> {
        let station = self.cameras.get_mut(camera.index()).ok_or(RecordingError::NoCamera)?;
        moment.check(&station.camera)?;
        let stream = &self.stream;
        // The time belongs to the calling thread, which may differ between calls.
        stream.set_time(TIMELINE, Duration::from_nanos(moment.time.nanoseconds()));
        stream
            .log(station.mount.as_str(), &transform(&moment.world_from_mount))
            .map_err(failed)?;
        let entity = &station.entity;
        let size = station.camera.camera.intrinsics.size;
        let size = [size.width, size.height];
        if let Some(rgb) = moment.rgb {
            let bytes: Vec<u8> = rgb.pixels().iter().flat_map(|&[r, g, b, _]| [r, g, b]).collect();
            let image = rerun::Image::from_rgb24(bytes, size);
            stream
                .log(format!("{entity}/image/rgb"), &image)
                .map_err(failed)?;
        }
        let (camera, measured) = (&station.camera.camera, station.camera.measured());
        let is_other = station.camera.measured.is_some();
        let image = if is_other { "measured_image" } else { "image" };
        let [rays, measured_rays] = &mut station.rays;
        if let Some(depth) = moment.depth {
            stream
                .log(format!("{entity}/image/depth"), &depth_image(depth))
                .map_err(failed)?;
            if moment.depth_points {
                let rays = rays.get_or_insert_with(|| recording::rays(camera));
                let points = points(rays, depth, &RigidTransform::IDENTITY, moment.rgb);
                stream
                    .log(format!("{entity}/depth_points"), &points)
                    .map_err(failed)?;
            }
        }
        if let Some(depth) = moment.measured {
            stream
                .log(format!("{entity}/{image}/measured"), &depth_image(depth))
                .map_err(failed)?;
            if moment.measured_points {
                let rays = measured_rays.get_or_insert_with(|| recording::rays(&measured.camera));
                let colors = recording::measured_colors(rays, depth, &station.camera, moment.rgb);
                let rgb = colors.as_ref().map(Into::into).or(moment.rgb);
                let points = points(rays, depth, &measured.camera_from_measured, rgb);
                stream
                    .log(format!("{entity}/measured_points"), &points)
                    .map_err(failed)?;
            }
        }
        self.write()
    }

    fn finish(mut self) -> Result<W, RecordingError> {
        self.write()?;
        self.encoder.finish().map_err(not_written)?;
        self.encoder.into_inner().map_err(not_written)
    }
}

impl<W: Write> fmt::Debug for Rrd<W> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let cameras = self.cameras.iter().map(|station| &station.entity);
        f.debug_struct("Rrd")
            .field("cameras", &cameras.collect::<Vec<_>>())
            .finish_non_exhaustive()
    }
}

#[expect(
    clippy::cast_possible_truncation,
    reason = "Rerun's numbers are in single precision"
)]
fn transform(parent_from_child: &RigidTransform) -> rerun::Transform3D {
    let q = parent_from_child.quaternion();
    let rotation = rerun::Quaternion::from_xyzw([q.x, q.y, q.z, q.w].map(|part| part as f32));
    let translation = parent_from_child.translation.to_array().map(|part| part as f32);
    rerun::Transform3D::from_translation_rotation(translation, rotation)
}

/// Rerun's depth clouds use OpenCV's pixel convention, with pixel (0, 0) at 0.
#[expect(
    clippy::cast_possible_truncation,
    reason = "Rerun's numbers are in single precision"
)]
fn pinhole(camera: &Camera) -> rerun::Pinhole {
    let intrinsics = camera.intrinsics;
    let centre = intrinsics.principal_point::<OpenCv>();
    rerun::Pinhole::from_focal_length_and_resolution(
        [intrinsics.fx as f32, intrinsics.fy as f32],
        [intrinsics.size.width as f32, intrinsics.size.height as f32],
    )
    .with_principal_point([centre.x as f32, centre.y as f32])
}

fn depth_image(depth: DepthView<'_>) -> rerun::DepthImage {
    let size = depth.size();
    let (bytes, kind, meter): (Vec<u8>, _, f32) = match depth {
        DepthView::Metres(image) => (
            image.pixels().iter().flat_map(|z| z.to_le_bytes()).collect(),
            rerun::ChannelDatatype::F32,
            1.0,
        ),
        DepthView::Millimetres(image) => (
            image.pixels().iter().flat_map(|mm| mm.to_le_bytes()).collect(),
            rerun::ChannelDatatype::U16,
            1000.0,
        ),
    };
    rerun::DepthImage::from_data_type_and_bytes(bytes, [size.width, size.height], kind).with_meter(meter)
}

/// The points in the frame of the recorded camera.
#[expect(clippy::cast_possible_truncation, reason = "points are float32")]
fn points(
    rays: &Image<[f32; 2]>,
    depth: DepthView<'_>,
    camera_from_depth: &RigidTransform,
    rgb: Option<ImageView<'_, [u8; 4]>>,
) -> rerun::Points3D {
    let all = recording::points(rays, depth);
    let colors = rgb.map(|rgb| rgb.pixels());
    let (mut places, mut painted) = (Vec::new(), Vec::new());
    for (at, point) in all.enumerate().filter(|(_, point)| !point[2].is_nan()) {
        let point = camera_from_depth.apply(DVec3::from(point.map(f64::from)));
        places.push(point.to_array().map(|part| part as f32));
        if let Some(&[r, g, b, _]) = colors.and_then(|colors| colors.get(at)) {
            painted.push(rerun::Color::from_rgb(r, g, b));
        }
    }
    let points = rerun::Points3D::new(places);
    if painted.is_empty() {
        points
    } else {
        points.with_colors(painted)
    }
}

fn failed(error: impl fmt::Display) -> RecordingError {
    RecordingError::Format(format!("Rerun: {error}"))
}

fn not_written(error: EncodeError) -> RecordingError {
    match error {
        EncodeError::Write(error) => RecordingError::Io(error),
        other => failed(other),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use oaktwin::camera::{ImageSize, Intrinsics, LensModel};
    use oaktwin::dataset::recording::{MovingBody, Time};

    fn recorded<W: Write>(output: W) -> Result<W, RecordingError> {
        let mut recorder = Rrd::new(output, true)?;
        let id = recorder.add_camera(&RecordedCamera {
            name: "left".to_owned(),
            frame: None,
            camera: Camera::new(
                Intrinsics::from_hfov(ImageSize::new(4, 3), 1.2),
                LensModel::Pinhole,
            ),
            measured: None,
            body: Some(MovingBody {
                name: "OAK".to_owned(),
                body_from_camera: RigidTransform::IDENTITY,
            }),
        })?;
        let depth = Image::filled(4, 3, 1.5f32);
        for frame in 0..3 {
            let time = Time::of_frame(frame, 30.0)?;
            let moment = Moment {
                measured: Some(DepthView::Metres((&depth).into())),
                measured_points: true,
                ..Moment::new(time, RigidTransform::IDENTITY)
            };
            recorder.record(id, &moment)?;
        }
        recorder.finish()
    }

    #[test]
    fn writes_a_recording() {
        let file = recorded(Vec::new()).unwrap();
        assert!(file.starts_with(b"RRF2"));
        let text = String::from_utf8_lossy(&file);
        assert!(text.contains("/world/OAK/left/image/measured"));
    }

    #[test]
    fn reports_full_disks() {
        struct Full;
        impl Write for Full {
            fn write(&mut self, _: &[u8]) -> std::io::Result<usize> {
                Err(std::io::ErrorKind::StorageFull.into())
            }
            fn flush(&mut self) -> std::io::Result<()> {
                Ok(())
            }
        }
        assert!(matches!(recorded(Full), Err(RecordingError::Io(_))));
    }
}

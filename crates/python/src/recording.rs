use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::{Mutex, PoisonError};

use oaktwin::camera;
use oaktwin::diagnostic::{Finding, Level};
use oaktwin::image::ImageView;
use oaktwin::recording::{
    CameraId, DepthView, MeasuredCamera, Moment, RecordedCamera, RecordingFile, RecordingFileError, Time,
    check_path, ros_lens_loss,
};
use pyo3::prelude::*;

use crate::arguments::FrameNumber;
use crate::camera::Camera;
use crate::error::{error, writing, wrong};
use crate::finding;
use crate::images::{Depth, DepthSlice, ImageShape, Pictures};
use crate::pose::Of;

/// A recording of moving cameras: `with oaktwin.Recording("path.mcap") as recording: recording.log(...)`.
///
/// An .mcap contains ROS 2 messages: for each camera NAME the topics /NAME/rgb, /NAME/depth, /NAME/measured (sensor_msgs/Image:
/// rgb8, 32FC1 metres or 16UC1 millimetres), /NAME/camera_info, /NAME/depth_points or /NAME/measured_points
/// (sensor_msgs/PointCloud2), and its pose on /tf and /tf_static: world, NAME (x forward, y left, z up),
/// NAME_optical_frame (x right, y down, z forward), which is the frame of images and clouds. Invalid depth is NaN (0 in
/// millimetres); ground-truth depth without a surface is inf (REP-117, REP-118). The same calls give the same bytes.
///
/// path: the file, .mcap, which Rerun and Foxglove open, too. It is created when the recording is closed, and not at all if the `with` block ends in
///     an exception or the object is dropped.
///
/// Raises oaktwin.Error for another extension, OSError if the file cannot be written. Thread-safe.
#[pyclass(frozen, module = "oaktwin")]
pub(crate) struct Recording {
    path: PathBuf,
    state: Mutex<Option<OpenRecording>>,
}

struct OpenRecording {
    file: RecordingFile,
    /// The cameras by name.
    cameras: BTreeMap<String, (CameraId, Known)>,
    moments: usize,
}

/// A camera, and the camera of its measured images if it is another one.
type Known = (camera::Camera, Option<MeasuredCamera>);

#[pymethods]
impl Recording {
    #[new]
    fn new(py: Python<'_>, path: PathBuf) -> PyResult<Self> {
        check_path(&path).map_err(error)?;
        let file = py
            .detach(|| RecordingFile::create(&path))
            .map_err(|error| writing(&path, &error))?;
        Ok(Self {
            path,
            state: Mutex::new(Some(OpenRecording {
                file,
                cameras: BTreeMap::new(),
                moments: 0,
            })),
        })
    }

    /// Records the images of a camera at a pose.
    ///
    /// camera: the camera of the images; all calls with the same name must use the same camera.
    /// world_from_camera: the camera's pose, (4, 4), with OpenCV's axes, metres.
    /// time: the time in seconds, from 0 to 2^31; by default frame / 30.
    /// frame: the frame number, used if time is None.
    /// depth: ground-truth depth, (H, W) float32 metres or uint16 millimetres.
    /// measured: the depth sensor's output, in the same format.
    /// measured_camera: the camera of the depth sensor's output, `DepthSensor.camera`, if it is not the camera itself: a
    ///     filter decimates, or the engine is "single-view". Its topic is /NAME/measured_camera_info.
    /// rgb: the colour image, (H, W, 3) or (H, W, 4) uint8, sRGB.
    /// points: whether to record a point cloud, too: of measured depth, or otherwise of ground-truth depth.
    /// name: the name of the camera; by default its own. Characters other than letters, digits and _ are replaced by _.
    ///
    /// Raises oaktwin.Error for images whose size differs from the camera's, a different camera with the same name, an invalid
    /// time, or a closed recording; OSError if the file cannot be written.
    #[pyo3(signature = (camera, world_from_camera, *, time = None, frame = None, depth = None, measured = None,
        measured_camera = None, rgb = None, points = true, name = None))]
    #[expect(clippy::too_many_arguments, reason = "keyword arguments of Python")]
    fn log(
        &self,
        py: Python<'_>,
        camera: &Camera,
        world_from_camera: &Bound<'_, PyAny>,
        time: Option<f64>,
        frame: Option<FrameNumber>,
        depth: Option<Bound<'_, PyAny>>,
        measured: Option<Bound<'_, PyAny>>,
        measured_camera: Option<Bound<'_, Camera>>,
        rgb: Option<Bound<'_, PyAny>>,
        points: bool,
        name: Option<String>,
    ) -> PyResult<()> {
        py.check_signals()?;
        let world_from_mount = Of::Camera.one("world_from_camera", world_from_camera)?;
        let time = match time {
            Some(seconds) => Time::from_seconds(seconds),
            None => Time::of_frame(frame.map_or(0, |frame| frame.0), 30.0),
        };
        let time = time.map_err(error)?;
        let depth = depth.map(|depth| image("depth", &depth, camera)).transpose()?;
        let measured_camera = measured_camera.map(|camera| camera.get().clone());
        let of_measured = measured_camera.as_ref().unwrap_or(camera);
        let measured = measured
            .map(|depth| image("measured", &depth, of_measured))
            .transpose()?;
        let measured_shape = ImageShape {
            batch: None,
            size: of_measured.camera.intrinsics.size,
            has_channel: false,
        };
        let shape = ImageShape {
            batch: None,
            size: camera.camera.intrinsics.size,
            has_channel: false,
        };
        let rgb = rgb.map(|rgb| Pictures::read(&rgb, shape)).transpose()?;
        let rgb = rgb.as_ref().map(Pictures::rgba).transpose()?;
        let moment = Moment {
            rgb: rgb
                .as_deref()
                .and_then(|pixels| ImageView::new(shape.size.width, shape.size.height, pixels)),
            depth: depth.as_ref().map(|depth| view(depth, shape)).transpose()?,
            measured: measured
                .as_ref()
                .map(|depth| view(depth, measured_shape))
                .transpose()?,
            depth_points: points && measured.is_none(),
            measured_points: points,
            ..Moment::new(time, world_from_mount)
        };
        let name = name.unwrap_or_else(|| camera.name.clone());
        let is_new = py.detach(|| self.record(camera, measured_camera.as_ref(), name.clone(), &moment))?;
        let loss = ros_lens_loss(&camera.camera.lens).filter(|_| is_new);
        let finding = loss.map(|loss| Finding::new("lens-not-recorded", Level::Warning, name, loss, ""));
        finding::warn(py, finding.as_slice())
    }

    /// Completes the file. Does nothing if the recording is closed.
    ///
    /// Raises OSError if the file cannot be written.
    fn close(&self, py: Python<'_>) -> PyResult<()> {
        let finished = py.detach(|| self.take().map(|state| state.file.finish()));
        match finished {
            Some(Err(error)) => Err(self.exception(&error)),
            Some(Ok(_)) | None => Ok(()),
        }
    }

    /// The path of the file.
    #[getter]
    fn path(&self) -> PathBuf {
        self.path.clone()
    }

    fn __enter__(slf: Py<Self>) -> Py<Self> {
        slf
    }

    /// Closes the recording, or discards it if the block ends in an exception.
    #[pyo3(signature = (kind, value, traceback, /))]
    fn __exit__(
        &self,
        py: Python<'_>,
        kind: Option<&Bound<'_, PyAny>>,
        value: Option<&Bound<'_, PyAny>>,
        traceback: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<()> {
        let _ = (value, traceback);
        if kind.is_none() {
            return self.close(py);
        }
        py.detach(|| drop(self.take()));
        Ok(())
    }

    fn __repr__(&self) -> String {
        let state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        let path = self.path.display();
        match &*state {
            None => format!("<oaktwin.Recording {path}: closed>"),
            Some(state) => format!(
                "<oaktwin.Recording {path}: {} cameras, {} images logged>",
                state.cameras.len(),
                state.moments
            ),
        }
    }
}

impl Recording {
    fn take(&self) -> Option<OpenRecording> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner).take()
    }

    fn exception(&self, error: &RecordingFileError) -> PyErr {
        match error {
            RecordingFileError::File(error) => writing(&self.path, error),
            error @ RecordingFileError::Recording { .. } => crate::error::error(error),
        }
    }

    /// Returns whether the camera is new.
    fn record(
        &self,
        camera: &Camera,
        measured: Option<&Camera>,
        name: String,
        moment: &Moment<'_>,
    ) -> PyResult<bool> {
        let measured = measured.map(|measured| MeasuredCamera {
            camera: measured.camera,
            camera_from_measured: camera.body_from_camera.inverse() * measured.body_from_camera,
        });
        let own: Known = (camera.camera, measured);
        let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        let Some(state) = &mut *state else {
            return Err(wrong(self.path.display(), "is closed", "create a new recording"));
        };
        let (id, is_new) = match state.cameras.get(&name) {
            Some((id, known)) if *known == own => (*id, false),
            Some(_) => {
                return Err(wrong(
                    name,
                    "is already the name of a different camera in this recording",
                    "use a unique name for each camera, and the same measured_camera in all calls",
                ));
            }
            None => {
                let recorded = RecordedCamera {
                    name: name.clone(),
                    frame: None,
                    camera: camera.camera,
                    measured,
                    body: None,
                };
                let id = state
                    .file
                    .add_camera(&recorded)
                    .map_err(|error| self.exception(&error))?;
                state.cameras.insert(name, (id, own));
                (id, true)
            }
        };
        state
            .file
            .record(id, moment)
            .map_err(|error| self.exception(&error))?;
        state.moments += 1;
        Ok(is_new)
    }
}

/// Reads an image of the camera's size.
fn image<'py>(name: &str, object: &Bound<'py, PyAny>, camera: &Camera) -> PyResult<Depth<'py>> {
    let (depth, shape) = Depth::read(name, object)?;
    let size = camera.camera.intrinsics.size;
    if shape.batch.is_some() || shape.size != size {
        let is = format!("has shape {:?}", shape.dims());
        let or = match name {
            "measured" => ", or its camera as measured_camera",
            _ => "",
        };
        let remedy = format!(
            "pass an image of the camera's size, ({}, {}){or}",
            size.height, size.width
        );
        return Err(wrong(name, is, remedy));
    }
    Ok(depth)
}

fn view<'a>(depth: &'a Depth<'_>, shape: ImageShape) -> PyResult<DepthView<'a>> {
    let (width, height) = (shape.size.width, shape.size.height);
    let view = match depth.slice()? {
        DepthSlice::Metres(pixels) => ImageView::new(width, height, pixels).map(DepthView::Metres),
        DepthSlice::Millimetres(pixels) => ImageView::new(width, height, pixels).map(DepthView::Millimetres),
    };
    view.ok_or_else(|| {
        wrong(
            "depth",
            "does not have the camera's size",
            "pass an image of the camera's size",
        )
    })
}

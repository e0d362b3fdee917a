//! Recordings of rendered frames.

use std::iter::Peekable;
use std::path::{Path, PathBuf};

use super::camera::PlacedCamera;
use super::rig::Rig;
use crate::imu::ImuSimulation;
use crate::recording::{
    CameraId, DepthView, MeasuredCamera, Moment, MovingBody, RecordedCamera, RecordingError, RecordingFile,
    RecordingFileError, Time, check_path, ros_lens_loss,
};
use crate::sensor::Sensor;
use oaktwin_base::diagnostic::{Finding, Level, Message, message, opt};
use oaktwin_camera::{RigidTransform, frame_names};
use oaktwin_dataset::{Shot, WriteError, Writer};
use oaktwin_files::{OutputFiles, WrittenFile};
use oaktwin_image::ZDepth;
use oaktwin_image::annotation::Annotator;

/// The frame rate of trajectories without times.
pub(super) const FRAME_RATE: f64 = 30.0;

/// Returns the annotators that must be rendered to record these: a point cloud requires depth.
#[must_use]
pub fn record_annotators(annotators: &[Annotator]) -> Vec<Annotator> {
    let mut needed = annotators.to_vec();
    if needed.contains(&Annotator::Pointcloud) {
        needed.push(Annotator::DistanceToImagePlane);
    }
    needed.sort_unstable();
    needed.dedup();
    needed
}

/// Writes frames into a recording: `rgb`, `distance_to_image_plane` as `depth`, `depth_sensor_distance` as `measured` with
/// its point cloud, and for `pointcloud` a point cloud of the depth.
#[derive(Debug)]
pub struct FrameRecorder {
    /// Until it is complete.
    file: Option<RecordingFile>,
    cameras: Vec<CameraId>,
    times: Vec<Time>,
    /// How long after the time of a frame each camera takes it, s.
    offsets_s: Vec<f64>,
    depth_points: bool,
    /// The samples of the inertial sensor that are not recorded yet.
    imu: Option<Peekable<ImuSimulation>>,
    written: Option<WrittenFile>,
}

impl FrameRecorder {
    /// Begins a recording of a rig, with the time of each frame, s; of one frame if there are none. Annotators that a
    /// recording cannot hold are a warning if it is the only output (`is_alone`).
    ///
    /// If a frame has no time, there are 30 frames per second from 0.
    ///
    /// # Errors
    /// Returns an error if the file cannot be written or a time is out of range.
    pub fn create(
        path: &Path,
        rig: &Rig,
        times_s: &[Option<f64>],
        is_alone: bool,
    ) -> Result<(Self, Vec<Finding>), RecordingFileError> {
        check_path(path)?;
        let in_file = |error| RecordingFileError::Recording {
            path: PathBuf::from(path),
            error,
        };
        let (times, mut findings) = times(times_s).map_err(in_file)?;
        let annotators = rig.annotators();
        findings.extend(not_recorded(annotators, is_alone));
        let lost = rig.cameras().iter().filter_map(|camera| {
            let loss = ros_lens_loss(&camera.camera.lens)?;
            Some(Finding::new(
                "lens-not-recorded",
                Level::Warning,
                &camera.path,
                loss,
                "",
            ))
        });
        findings.extend(lost);
        let mut file = RecordingFile::create(path)?;
        let cameras = rig.cameras().iter().zip(rig.sensors());
        let cameras = cameras
            .map(|(camera, sensor)| file.add_camera(&recorded(camera, sensor.as_ref())))
            .collect::<Result<_, _>>()?;
        let cameras_count = rig.cameras().len();
        let recorder = Self {
            file: Some(file),
            cameras,
            times,
            offsets_s: (0..cameras_count).map(|camera| rig.offset_s(camera)).collect(),
            depth_points: annotators.contains(&Annotator::Pointcloud),
            imu: None,
            written: None,
        };
        Ok((recorder, findings))
    }

    /// Adds the samples of the OAK's inertial sensor, each before the frames that follow it.
    pub fn add_imu(&mut self, samples: &ImuSimulation) {
        if let Some(file) = &mut self.file {
            file.set_imu(&samples.recorded("imu", frame_names::DEVICE));
            self.imu = Some(samples.clone().peekable());
        }
    }

    /// Records the inertial samples until a time, or all that are left.
    fn record_imu(&mut self, until: Option<Time>) -> Result<(), WriteError> {
        let (Some(file), Some(samples)) = (&mut self.file, &mut self.imu) else {
            return Ok(());
        };
        while let Some(sample) = samples.next_if(|sample| until.is_none_or(|time| sample.time <= time)) {
            file.record_imu(&sample).map_err(other)?;
        }
        Ok(())
    }

    /// The recording, if it is complete.
    pub(super) fn into_written(self) -> Option<WrittenFile> {
        self.written
    }
}

impl Writer for FrameRecorder {
    fn write(&mut self, shot: &Shot, _output: &mut OutputFiles) -> Result<(), WriteError> {
        let time = usize::try_from(shot.number)
            .ok()
            .and_then(|number| self.times.get(number).copied());
        let offset_s = self.offsets_s.get(shot.camera).copied().unwrap_or(0.0);
        let time = time.map(|time| time.plus(offset_s).unwrap_or(time));
        if let Some(time) = time {
            self.record_imu(Some(time))?;
        }
        let (Some(file), Some(&camera), Some(time)) = (&mut self.file, self.cameras.get(shot.camera), time)
        else {
            return Ok(());
        };
        let frame = &shot.frame;
        let moment = Moment {
            rgb: frame.rgb.as_ref().map(Into::into),
            depth: frame.distance_to_image_plane.as_ref().map(metres),
            measured: frame.depth_sensor_distance.as_ref().map(metres),
            depth_points: self.depth_points,
            measured_points: true,
            ..Moment::new(time, shot.world_from_mount)
        };
        file.record(camera, &moment).map_err(other)
    }

    fn finish(&mut self, _output: &mut OutputFiles) -> Result<(), WriteError> {
        self.record_imu(None)?;
        if let Some(file) = self.file.take() {
            let (path, bytes) = file.finish().map_err(other)?;
            self.written = Some(WrittenFile { path, bytes });
        }
        Ok(())
    }
}

fn metres(z: &ZDepth) -> DepthView<'_> {
    DepthView::Metres((&z.0).into())
}

fn other(error: RecordingFileError) -> WriteError {
    WriteError::Other(Box::new(error))
}

fn recorded(placed: &PlacedCamera, sensor: Option<&Sensor>) -> RecordedCamera {
    let measured = sensor.map(|sensor| {
        let output = sensor.output_camera(&placed.camera);
        MeasuredCamera {
            camera: output.camera,
            camera_from_measured: output.input_from_output(),
        }
    });
    let is_other = |measured: &MeasuredCamera| {
        measured.camera != placed.camera || measured.camera_from_measured != RigidTransform::IDENTITY
    };
    let measured = measured.filter(is_other);
    // A camera of the scene is moved itself.
    let is_carried = placed.mount_from_camera != RigidTransform::IDENTITY;
    RecordedCamera {
        name: placed.folder.clone(),
        frame: (placed.role.as_deref()).map(|role| frame_names::camera(frame_names::DEVICE, role)),
        camera: placed.camera,
        measured,
        body: is_carried.then(|| MovingBody {
            name: frame_names::DEVICE.to_owned(),
            body_from_camera: placed.mount_from_camera,
        }),
    }
}

/// The time of each frame.
fn times(times_s: &[Option<f64>]) -> Result<(Vec<Time>, Vec<Finding>), RecordingError> {
    let known: Option<Vec<f64>> = times_s.iter().copied().collect();
    let mut findings = Vec::new();
    let mut warn = |code, message: &str, remedy: &str| {
        findings.push(Finding::new(code, Level::Warning, "trajectory", message, remedy));
    };
    let times = match known {
        Some(seconds) if !seconds.is_empty() => seconds
            .into_iter()
            .map(Time::from_seconds)
            .collect::<Result<Vec<Time>, _>>()?,
        _ => {
            if times_s.iter().any(Option::is_some) {
                let message = "some poses have no time; the recording has 30 frames per second";
                warn("times-missing", message, "give every pose a time");
            }
            (0..times_s.len().max(1) as u64)
                .map(|frame| Time::of_frame(frame, FRAME_RATE))
                .collect::<Result<_, _>>()?
        }
    };
    if !times.is_sorted_by(|a, b| a < b) {
        let message = "the times do not increase; transforms at the same time are ambiguous";
        warn("times-not-increasing", message, "sort the poses by time");
    }
    Ok((times, findings))
}

fn not_recorded(annotators: &[Annotator], is_alone: bool) -> Option<Finding> {
    let has_place = |one: &&Annotator| {
        matches!(
            one,
            Annotator::Rgb
                | Annotator::DistanceToImagePlane
                | Annotator::DepthSensorDistance
                | Annotator::Pointcloud
                | Annotator::CameraParams
        )
    };
    let left_out: Vec<&str> = annotators
        .iter()
        .filter(|one| !has_place(one))
        .map(|one| one.name())
        .collect();
    if left_out.is_empty() {
        return None;
    }
    let (level, remedy) = if is_alone {
        (
            Level::Warning,
            message!["write them into a folder, ", opt("output").with("DIR")],
        )
    } else {
        (Level::Note, Message::default())
    };
    let message = format!("not recorded: {}", left_out.join(", "));
    Some(Finding::new("not-recorded", level, "recording", message, remedy))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_frames_by_the_trajectory() {
        let of = |said: &[Option<f64>]| {
            let (times, findings) = times(said).unwrap();
            let nanoseconds: Vec<u64> = times.into_iter().map(Time::nanoseconds).collect();
            let codes: Vec<&str> = findings.iter().map(|finding| finding.code).collect();
            (nanoseconds, codes)
        };
        assert_eq!(of(&[]), (vec![0], vec![]));
        assert_eq!(of(&[None, None]), (vec![0, 33_333_333], vec![]));
        assert_eq!(
            of(&[Some(1.0), Some(1.5)]),
            (vec![1_000_000_000, 1_500_000_000], vec![])
        );
        assert_eq!(
            of(&[Some(1.0), None]),
            (vec![0, 33_333_333], vec!["times-missing"])
        );
        assert_eq!(
            of(&[Some(1.0), Some(1.0)]),
            (vec![1_000_000_000; 2], vec!["times-not-increasing"])
        );
        assert!(times(&[Some(-1.0)]).is_err());
    }

    #[test]
    fn reports_annotators_that_are_not_recorded() {
        use Annotator as A;
        assert!(not_recorded(&[A::Rgb, A::Pointcloud, A::CameraParams], true).is_none());
        let found = not_recorded(&[A::Normals, A::Rgb, A::DistanceToCamera], true).unwrap();
        assert_eq!(found.level, Level::Warning);
        assert_eq!(found.message, "not recorded: normals, distance_to_camera");
        assert_eq!(
            record_annotators(&[A::Pointcloud]),
            [A::DistanceToImagePlane, A::Pointcloud]
        );
    }
}

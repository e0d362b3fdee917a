//! Recordings as files: `.mcap` with ROS 2 messages, which Rerun and Foxglove open, too.
//!
//! [`dataset::recording`](oaktwin_dataset::recording) describes their contents.

use std::ffi::OsStr;
use std::io::BufWriter;
use std::path::{Path, PathBuf};

use oaktwin_dataset::ImuSample;
pub use oaktwin_dataset::recording::ros_lens_loss;
pub use oaktwin_dataset::recording::{
    CameraId, DepthView, MeasuredCamera, Moment, MovingBody, RecordedCamera, RecordedImu, RecordingError,
    Time,
};
use oaktwin_dataset::recording::{Mcap, Recorder};
use oaktwin_files::{AtomicFile, FileError};

/// Checks that a path has the extension of a recording.
///
/// # Errors
/// Returns an error if it has another one.
pub fn check_path(path: &Path) -> Result<(), FileError> {
    let extension = path.extension().map(OsStr::to_ascii_lowercase);
    match extension.as_deref().and_then(|extension| extension.to_str()) {
        Some("mcap") => Ok(()),
        Some("rrd") => Err(FileError::new(
            path,
            "the format of Rerun is not written",
            "name an .mcap file, which Rerun opens too",
        )),
        _ => Err(FileError::new(
            path,
            "unknown recording format",
            "name an .mcap file",
        )),
    }
}

/// An error while a recording is written.
#[derive(Debug, thiserror::Error)]
pub enum RecordingFileError {
    /// The file cannot be written.
    #[error(transparent)]
    File(#[from] FileError),
    /// The contents are invalid.
    #[error("{}: {error}", path.display())]
    Recording {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        error: RecordingError,
    },
}

/// A recording in progress. The file appears with [`finish`](Self::finish), or not at all.
#[derive(Debug)]
pub struct RecordingFile {
    path: PathBuf,
    recorder: Mcap<BufWriter<AtomicFile>>,
}

impl RecordingFile {
    /// Begins a recording.
    ///
    /// # Errors
    /// Returns an error if the file cannot be written or its extension is unknown.
    pub fn create(path: &Path) -> Result<Self, RecordingFileError> {
        check_path(path)?;
        let output = BufWriter::new(AtomicFile::create(path)?);
        Ok(Self {
            recorder: Mcap::new(output).map_err(|error| failed(path, error))?,
            path: path.to_owned(),
        })
    }

    /// Adds a camera, before its first moment.
    ///
    /// # Errors
    /// Returns an error if the file cannot be written or the camera's images are too large.
    pub fn add_camera(&mut self, camera: &RecordedCamera) -> Result<CameraId, RecordingFileError> {
        let added = self.recorder.add_camera(camera);
        added.map_err(|error| failed(&self.path, error))
    }

    /// Records a camera at a moment.
    ///
    /// # Errors
    /// Returns an error if the file cannot be written or an image does not fit the camera.
    pub fn record(&mut self, camera: CameraId, moment: &Moment<'_>) -> Result<(), RecordingFileError> {
        let recorded = self.recorder.record(camera, moment);
        recorded.map_err(|error| failed(&self.path, error))
    }

    /// Sets the inertial sensor.
    pub fn set_imu(&mut self, imu: &RecordedImu) {
        self.recorder.set_imu(imu);
    }

    /// Records a sample of the inertial sensor.
    ///
    /// # Errors
    /// Returns an error if the file cannot be written.
    pub fn record_imu(&mut self, sample: &ImuSample) -> Result<(), RecordingFileError> {
        let recorded = self.recorder.record_imu(sample);
        recorded.map_err(|error| failed(&self.path, error))
    }

    /// Completes the file; returns its path and length.
    ///
    /// # Errors
    /// Returns an error if the file cannot be written.
    pub fn finish(self) -> Result<(PathBuf, u64), RecordingFileError> {
        let output = self.recorder.finish();
        let output = output.map_err(|error| failed(&self.path, error))?;
        let parts = output
            .into_inner()
            .map_err(|error| failed(&self.path, RecordingError::Io(error.into_error())))?;
        Ok(parts.finish()?)
    }
}

fn failed(path: &Path, error: RecordingError) -> RecordingFileError {
    match error {
        RecordingError::Io(error) => FileError::writing(path, &error).into(),
        error => RecordingFileError::Recording {
            path: path.to_owned(),
            error,
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use oaktwin_camera::{Camera, ImageSize, Intrinsics, LensModel, RigidTransform};
    use oaktwin_image::Image;

    fn record(path: &Path, is_finished: bool) -> Result<(), RecordingFileError> {
        let mut file = RecordingFile::create(path)?;
        let intrinsics = Intrinsics::from_hfov(ImageSize::new(64, 48), 1.2);
        let id = file.add_camera(&RecordedCamera {
            name: "left".to_owned(),
            frame: None,
            camera: Camera::new(intrinsics, LensModel::Pinhole),
            measured: None,
            body: None,
        })?;
        let depth = Image::filled(64, 48, 1.5f32);
        for frame in 0..3 {
            let time = Time::of_frame(frame, 30.0).map_err(|error| failed(path, error))?;
            let moment = Moment {
                depth: Some(DepthView::Metres((&depth).into())),
                ..Moment::new(time, RigidTransform::IDENTITY)
            };
            file.record(id, &moment)?;
        }
        if is_finished {
            let (_, bytes) = file.finish()?;
            assert_eq!(bytes, std::fs::metadata(path).unwrap().len());
        }
        Ok(())
    }

    #[test]
    fn appears_when_finished() {
        let folder = tempfile::tempdir().unwrap();
        for name in ["a.mcap", "a.MCAP"] {
            let path = folder.path().join(name);
            record(&path, false).unwrap();
            assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0, "{name}");
            record(&path, true).unwrap();
            std::fs::remove_file(path).unwrap();
        }
    }

    #[test]
    fn rejects_invalid_paths() {
        let folder = tempfile::tempdir().unwrap();
        let error_of = |name: &str| {
            let error = record(&folder.path().join(name), true).unwrap_err().to_string();
            error.replace(&folder.path().display().to_string(), "DIR")
        };
        assert_eq!(
            error_of("no/a.mcap"),
            "DIR/no/a.mcap: its folder does not exist; make the folder first"
        );
        for name in ["a", "a.bag"] {
            let expected = format!("DIR/{name}: unknown recording format; name an .mcap file");
            assert_eq!(error_of(name), expected);
        }
        assert!(error_of("a.rrd").ends_with("name an .mcap file, which Rerun opens too"));
        std::fs::create_dir(folder.path().join("b.mcap")).unwrap();
        assert_eq!(
            error_of("b.mcap"),
            "DIR/b.mcap: is a directory; name a file in it"
        );
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn reports_full_disks() {
        let folder = tempfile::tempdir().unwrap();
        let link = folder.path().join("a.mcap");
        std::os::unix::fs::symlink("/dev/full", &link).unwrap();
        let error = record(&link, true).unwrap_err().to_string();
        assert!(
            error.ends_with("there is no space left; free some, or choose another place"),
            "{error}"
        );
    }
}

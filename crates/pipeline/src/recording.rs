//! Recordings as files: `.mcap` for ROS 2, and `.rrd` for Rerun with the feature `rerun`.
//!
//! [`dataset::recording`](oaktwin_dataset::recording) describes their contents.

use std::ffi::OsStr;
use std::io::BufWriter;
use std::path::{Path, PathBuf};

#[cfg(feature = "rerun")]
use oaktwin_dataset::recording::Rrd;
pub use oaktwin_dataset::recording::{
    Body, CameraId, DepthView, MeasuredCamera, Moment, RecordedCamera, RecordedImu, RecordingError, Time,
};
use oaktwin_dataset::recording::{Mcap, Recorder, ros_lens_loss};

use oaktwin_camera::LensModel;
use oaktwin_dataset::ImuSample;
use oaktwin_files::{AtomicFile, FileError};
use oaktwin_scene::Up;

/// The format of a recording.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// MCAP with ROS 2 messages.
    Mcap,
    /// Rerun's format.
    Rrd,
}

/// Whether `.rrd` can be written: with the feature `rerun`.
pub const HAS_RRD: bool = cfg!(feature = "rerun");

impl Format {
    /// Returns the format of a file's extension.
    ///
    /// # Errors
    /// Returns an error if the extension is unknown or its format is not built in.
    pub fn of(path: &Path) -> Result<Self, FileError> {
        let extension = path.extension().map(OsStr::to_ascii_lowercase);
        let wrong = |message: &str, remedy: &str| Err(FileError::new(path, message, remedy));
        match extension.as_deref().and_then(|extension| extension.to_str()) {
            Some("mcap") => Ok(Self::Mcap),
            Some("rrd") if HAS_RRD => Ok(Self::Rrd),
            Some("rrd") => wrong(
                "this build of oaktwin cannot write .rrd, the format of Rerun",
                "name an .mcap file, which Rerun opens too, or build with support for .rrd as the manual describes",
            ),
            _ => wrong("unknown recording format", "name a .mcap or an .rrd file"),
        }
    }

    /// Returns what a recording of this format does not store of a lens; its images and point clouds are correct nevertheless.
    #[must_use]
    pub fn lens_loss(self, lens: &LensModel) -> Option<&'static str> {
        match (self, lens) {
            (_, LensModel::Pinhole) => None,
            (Self::Mcap, lens) => ros_lens_loss(lens),
            (Self::Rrd, _) => Some("Rerun supports only pinholes; the frustum ignores the lens's distortion"),
        }
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
    recorder: Kind,
}

#[derive(Debug)]
enum Kind {
    Mcap(Box<Mcap<BufWriter<AtomicFile>>>),
    #[cfg(feature = "rerun")]
    Rrd(Box<Rrd<BufWriter<AtomicFile>>>),
}

impl RecordingFile {
    /// Begins a recording in the format of the file's extension, of a world with this up axis.
    ///
    /// # Errors
    /// Returns an error if the file cannot be written or its extension is unknown.
    pub fn create(path: &Path, up: Up) -> Result<Self, RecordingFileError> {
        let format = Format::of(path)?;
        let output = BufWriter::new(AtomicFile::create(path)?);
        let recorder = match format {
            Format::Mcap => Mcap::new(output).map(|mcap| Kind::Mcap(Box::new(mcap))),
            #[cfg(feature = "rerun")]
            Format::Rrd => Rrd::new(output, up == Up::Z).map(|rrd| Kind::Rrd(Box::new(rrd))),
            #[cfg(not(feature = "rerun"))]
            Format::Rrd => {
                let _ = up;
                Err(RecordingError::Format(
                    "the feature `rerun` is disabled".to_owned(),
                ))
            }
        };
        Ok(Self {
            recorder: recorder.map_err(|error| failed(path, error))?,
            path: path.to_owned(),
        })
    }

    /// Returns the format.
    #[must_use]
    pub const fn format(&self) -> Format {
        match &self.recorder {
            Kind::Mcap(_) => Format::Mcap,
            #[cfg(feature = "rerun")]
            Kind::Rrd(_) => Format::Rrd,
        }
    }

    /// Adds a camera, before its first moment.
    ///
    /// # Errors
    /// Returns an error if the file cannot be written or the camera's images are too large.
    pub fn add_camera(&mut self, camera: &RecordedCamera) -> Result<CameraId, RecordingFileError> {
        let added = match &mut self.recorder {
            Kind::Mcap(mcap) => mcap.add_camera(camera),
            #[cfg(feature = "rerun")]
            Kind::Rrd(rrd) => rrd.add_camera(camera),
        };
        added.map_err(|error| failed(&self.path, error))
    }

    /// Records a camera at a moment.
    ///
    /// # Errors
    /// Returns an error if the file cannot be written or an image does not fit the camera.
    pub fn record(&mut self, camera: CameraId, moment: &Moment<'_>) -> Result<(), RecordingFileError> {
        let recorded = match &mut self.recorder {
            Kind::Mcap(mcap) => mcap.record(camera, moment),
            #[cfg(feature = "rerun")]
            Kind::Rrd(rrd) => rrd.record(camera, moment),
        };
        recorded.map_err(|error| failed(&self.path, error))
    }

    /// Sets the inertial sensor, whose samples only [`Format::Mcap`] can hold.
    pub fn set_imu(&mut self, imu: &RecordedImu) {
        match &mut self.recorder {
            Kind::Mcap(mcap) => mcap.set_imu(imu),
            #[cfg(feature = "rerun")]
            Kind::Rrd(_) => {}
        }
    }

    /// Records a sample of the inertial sensor.
    ///
    /// # Errors
    /// Returns an error if the file cannot be written.
    pub fn record_imu(&mut self, sample: &ImuSample) -> Result<(), RecordingFileError> {
        let recorded = match &mut self.recorder {
            Kind::Mcap(mcap) => mcap.record_imu(sample),
            #[cfg(feature = "rerun")]
            Kind::Rrd(_) => Ok(()),
        };
        recorded.map_err(|error| failed(&self.path, error))
    }

    /// Completes the file; returns its path and length.
    ///
    /// # Errors
    /// Returns an error if the file cannot be written.
    pub fn finish(self) -> Result<(PathBuf, u64), RecordingFileError> {
        let output = match self.recorder {
            Kind::Mcap(mcap) => mcap.finish(),
            #[cfg(feature = "rerun")]
            Kind::Rrd(rrd) => rrd.finish(),
        };
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
    use oaktwin_camera::{Camera, ImageSize, Intrinsics, RigidTransform};
    use oaktwin_image::Image;

    fn record(path: &Path, is_finished: bool) -> Result<(), RecordingFileError> {
        let mut file = RecordingFile::create(path, Up::Z)?;
        let intrinsics = Intrinsics::from_hfov(ImageSize::new(64, 48), 1.2);
        let id = file.add_camera(&RecordedCamera {
            name: "left".to_owned(),
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
        let formats = if HAS_RRD {
            &["a.mcap", "a.rrd"][..]
        } else {
            &["a.MCAP"]
        };
        for name in formats {
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
            let expected = format!("DIR/{name}: unknown recording format; name a .mcap or an .rrd file");
            assert_eq!(error_of(name), expected);
        }
        if !HAS_RRD {
            assert!(error_of("a.rrd").contains("cannot write .rrd, the format of Rerun"));
        }
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

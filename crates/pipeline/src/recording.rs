//! Recordings as files: `.mcap` for ROS 2, and `.rrd` for Rerun where the feature `rerun` is on.
//!
//! What they hold is described by [`dataset::recording`](oaktwin_dataset::recording), whose types are here too.

use std::ffi::OsStr;
use std::io::BufWriter;
use std::path::{Path, PathBuf};

#[cfg(feature = "rerun")]
use oaktwin_dataset::recording::Rrd;
pub use oaktwin_dataset::recording::{
    Body, CameraId, DepthView, Moment, RecordedCamera, RecordingError, Time,
};
use oaktwin_dataset::recording::{Mcap, Recorder, ros_lens_loss};

use oaktwin_camera::LensModel;
use oaktwin_files::{AtomicFile, FileError};
use oaktwin_scene::Up;

/// What a recording is written as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// MCAP of ROS 2's messages.
    Mcap,
    /// Rerun's.
    Rrd,
}

/// Whether `.rrd` can be written: the feature `rerun`.
pub const HAS_RRD: bool = cfg!(feature = "rerun");

impl Format {
    /// The format of a file's extension.
    ///
    /// # Errors
    /// There is none of that name, or this build has it not.
    pub fn of(path: &Path) -> Result<Self, FileError> {
        let extension = path.extension().map(OsStr::to_ascii_lowercase);
        let wrong = |message: &str, remedy: &str| Err(FileError::new(path, message, remedy));
        match extension.as_deref().and_then(|extension| extension.to_str()) {
            Some("mcap") => Ok(Self::Mcap),
            Some("rrd") if HAS_RRD => Ok(Self::Rrd),
            Some("rrd") => wrong(
                "this build cannot write .rrd, which needs the feature `rerun`",
                "name a .mcap file, or build with the feature `rerun`",
            ),
            _ => wrong("is no recording's name", "name a .mcap or an .rrd file"),
        }
    }

    /// What a recording of this format cannot say of a lens; its images and clouds of points are right all the same.
    #[must_use]
    pub fn lens_loss(self, lens: &LensModel) -> Option<&'static str> {
        match (self, lens) {
            (_, LensModel::Pinhole) => None,
            (Self::Mcap, lens) => ros_lens_loss(lens),
            (Self::Rrd, _) => {
                Some("Rerun has pinholes only: the frustum is that of the lens without its distortion")
            }
        }
    }
}

/// Why there is no recording: `FILE: what is wrong; what to do`.
#[derive(Debug, thiserror::Error)]
pub enum RecordingFileError {
    /// The file cannot be written.
    #[error(transparent)]
    File(#[from] FileError),
    /// Something cannot be in it.
    #[error("{}: {error}", path.display())]
    Recording {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        error: RecordingError,
    },
}

/// A recording on its way to a file, which is there whole after [`finish`](Self::finish), or not at all.
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
    /// Begins a recording in the format of the file's extension, of a world with this axis up.
    ///
    /// # Errors
    /// The file cannot be written, or its extension is no format's.
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
                Err(RecordingError::Format("the feature `rerun` is off".to_owned()))
            }
        };
        Ok(Self {
            recorder: recorder.map_err(|error| failed(path, error))?,
            path: path.to_owned(),
        })
    }

    /// Adds a camera, any time before its first moment.
    ///
    /// # Errors
    /// The file cannot be written, or the camera's images are too large for it.
    pub fn add_camera(&mut self, camera: &RecordedCamera) -> Result<CameraId, RecordingFileError> {
        let added = match &mut self.recorder {
            Kind::Mcap(mcap) => mcap.add_camera(camera),
            #[cfg(feature = "rerun")]
            Kind::Rrd(rrd) => rrd.add_camera(camera),
        };
        added.map_err(|error| failed(&self.path, error))
    }

    /// Records what there is of a camera at a moment.
    ///
    /// # Errors
    /// The file cannot be written, or an image is not of the camera.
    pub fn record(&mut self, camera: CameraId, moment: &Moment<'_>) -> Result<(), RecordingFileError> {
        let recorded = match &mut self.recorder {
            Kind::Mcap(mcap) => mcap.record(camera, moment),
            #[cfg(feature = "rerun")]
            Kind::Rrd(rrd) => rrd.record(camera, moment),
        };
        recorded.map_err(|error| failed(&self.path, error))
    }

    /// Gives the file its name; its path and length.
    ///
    /// # Errors
    /// What is left cannot be written.
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
    fn a_recording_is_whole_or_not_there() {
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
    fn what_cannot_be_written() {
        let folder = tempfile::tempdir().unwrap();
        let said = |name: &str| {
            let error = record(&folder.path().join(name), true).unwrap_err().to_string();
            error.replace(&folder.path().display().to_string(), "DIR")
        };
        assert_eq!(
            said("no/a.mcap"),
            "DIR/no/a.mcap: its folder does not exist; make the folder first"
        );
        for name in ["a", "a.bag"] {
            let expected = format!("DIR/{name}: is no recording's name; name a .mcap or an .rrd file");
            assert_eq!(said(name), expected);
        }
        if !HAS_RRD {
            assert!(said("a.rrd").contains("the feature `rerun`"));
        }
        std::fs::create_dir(folder.path().join("b.mcap")).unwrap();
        assert_eq!(said("b.mcap"), "DIR/b.mcap: is a directory; name a file in it");
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_full_disk_is_told() {
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

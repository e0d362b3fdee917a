//! Calibrations of other tools as `DepthAI`'s JSON: ROS's `camera_info`, Kalibr's `camchain.yaml` and OpenCV's `FileStorage`, in YAML.
//!
//! Each file is recognized by its keys. Its cameras get sockets by their names, and the extrinsics that the files contain connect them.

mod assemble;
mod field;
mod kalibr;
mod name;
mod opencv;
mod part;
mod ros;
mod yaml;

use oaktwin_base::diagnostic::{Finding, Level, message, opt};
use oaktwin_base::parameter::choice;
use oaktwin_camera::ImageSize;
use oaktwin_catalog::Twin;

pub use name::NamedCamera;

use crate::raw::Value;
use crate::{CalibrationError, Raw};
use field::Field;
use part::Parts;

choice! {
    /// A unit of length.
    LengthUnit {
        /// Metres.
        Metres = "m",
        /// Centimetres.
        Centimetres = "cm",
        /// Millimetres.
        Millimetres = "mm",
    }
}

impl LengthUnit {
    const fn in_metres(self) -> f64 {
        match self {
            Self::Metres => 1.0,
            Self::Centimetres => 1e-2,
            Self::Millimetres => 1e-3,
        }
    }
}

/// What the files do not state.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CalibrationImportOptions {
    /// The sockets of cameras whose names do not determine them.
    pub cameras: Vec<NamedCamera>,
    /// The unit of all lengths in the files. OpenCV's is that of the calibration board; the others' is the metre.
    pub unit: LengthUnit,
    /// The image size of files without one.
    pub size: Option<ImageSize>,
    /// Whether the coefficients of OpenCV files that do not state it are of the fisheye model.
    pub is_fisheye: bool,
}

/// A file to import.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct InputFile {
    /// The path, for messages and, if the file has no name for its camera, the name.
    pub name: String,
    /// The content.
    pub bytes: Vec<u8>,
}

/// A finding about one of several files.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FileFinding {
    /// The name of the file.
    pub file: String,
    /// The finding.
    pub finding: Finding,
}

/// The result of [`import`].
#[derive(Clone, Debug, PartialEq)]
pub struct ImportedCalibration {
    /// The `DepthAI` document, of version 7. Its name is that of the first file.
    pub raw: Raw,
    /// Suspicious content of the files. An implausible baseline and a pair of two image sizes are
    /// [errors](oaktwin_base::diagnostic::Level::Error), which [`crate::force`] downgrades to warnings.
    pub findings: Vec<FileFinding>,
    /// The file and the place of each camera of the document, in its order.
    cameras: Vec<(String, String)>,
}

impl ImportedCalibration {
    /// Returns a finding about the document as one about the files: one about the intrinsics of a camera is at the camera's place in its
    /// file, others are in the first file, at their place in the document.
    #[must_use]
    pub fn located(&self, finding: Finding) -> FileFinding {
        let of_camera = finding.place.strip_prefix("cameraData[").and_then(|rest| {
            let (number, key) = rest.split_once("].")?;
            let is_intrinsic = ["width", "intrinsicMatrix", "distortionCoeff"].contains(&key);
            self.cameras
                .get(number.parse::<usize>().ok().filter(|_| is_intrinsic)?)
        });
        match of_camera {
            Some((file, place)) => FileFinding {
                file: file.clone(),
                finding: Finding {
                    place: place.clone(),
                    ..finding
                },
            },
            None => FileFinding {
                file: self.raw.name.clone(),
                finding,
            },
        }
    }
}

/// Converts files to a `DepthAI` document of version 7, with findings. `nominal` is the model's [nominal
/// twin](oaktwin_catalog::Catalog::nominal): its design translations and fields of view are written with the calibration.
///
/// # Errors
/// Returns an error if a file is not of a known format, a field of it is missing or invalid, a camera has no socket, or two cameras have
/// the same.
pub fn import(
    files: &[InputFile],
    options: &CalibrationImportOptions,
    nominal: Option<&Twin>,
) -> Result<ImportedCalibration, CalibrationError> {
    let mut parts = Parts::default();
    for file in files {
        let root = yaml::parse(&file.bytes, &file.name)?;
        read(&Field::root(&root, &file.name), options, &mut parts)?;
    }
    if parts.cameras.is_empty() && parts.links.is_empty() {
        let file = files.first().map_or("", |file| file.name.as_str());
        let remedy = "give ROS's camera_info, Kalibr's camchain or OpenCV's FileStorage in YAML";
        return Err(field::error(
            file,
            "the document",
            "no-cameras",
            "has no camera",
            remedy,
        ));
    }
    for name in &options.cameras {
        if !parts.cameras.iter().any(|camera| name.is_any_of(&camera.names)) {
            return Err(unused_name(files, name, &parts));
        }
    }
    assemble::document(parts, nominal)
}

/// Recognizes a file and adds its cameras and extrinsics.
fn read(
    root: &Field<'_>,
    options: &CalibrationImportOptions,
    parts: &mut Parts,
) -> Result<(), CalibrationError> {
    if kalibr::recognizes(root) {
        return kalibr::read(root, options, parts);
    }
    if ros::recognizes(root) {
        return ros::read(root, options, parts);
    }
    if opencv::recognizes(root) {
        return opencv::read(root, options, parts);
    }
    if kalibr::is_imu_noise(root) {
        parts.findings.push(FileFinding {
            file: root.file.to_owned(),
            finding: Finding::new(
                "imu-noise",
                Level::Note,
                root.path(),
                "the noise of an inertial sensor has no place in a calibration; ignored",
                "",
            ),
        });
        return Ok(());
    }
    if root.get("cameraData").is_some() {
        return Err(root.error(
            "already-depthai",
            "is already a DepthAI calibration",
            "use it as it is; `calibration show` checks it",
        ));
    }
    let what = match &root.node.value {
        Value::Object(entries) => {
            let keys: Vec<&str> = entries.iter().take(4).map(|(key, _)| key.as_str()).collect();
            format!("of no known format; its first keys are {}", keys.join(", "))
        }
        other => format!(
            "of no known format; it is {} instead of keys and values",
            other.kind()
        ),
    };
    Err(root.error(
        "unknown-format",
        what,
        "give ROS's camera_info, Kalibr's camchain or OpenCV's FileStorage in YAML",
    ))
}

fn unused_name(files: &[InputFile], name: &NamedCamera, parts: &Parts) -> CalibrationError {
    let known: Vec<&str> = parts
        .cameras
        .iter()
        .filter_map(|camera| camera.names.first().map(String::as_str))
        .collect();
    let file = files.first().map_or_else(String::new, |file| file.name.clone());
    field::error(
        &file,
        "cameras",
        "unknown-camera",
        format!("no camera is named \"{}\"", name.name),
        message!["use one of ", known.join(", "), " in ", opt("camera")],
    )
}

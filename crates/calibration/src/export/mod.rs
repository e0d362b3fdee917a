//! Calibrations in the formats of other tools.
//!
//! Each exporter returns complete files as text, and findings about information that the format cannot represent. Models of the
//! catalog are exported through [`crate::nominal_calibration`].

mod imu;
mod kalibr;
mod opencv;
mod ros;
mod simplify;
mod text;

use oaktwin_base::diagnostic::{Finding, Level, fold_name};
use oaktwin_base::parameter::choice;

pub use imu::kalibr_imu;

use crate::{Calibration, CalibrationError, Raw, Socket, StereoPair};

choice! {
    /// A format to export to.
    Format {
        /// ROS's `camera_info` YAML, one file per camera.
        Ros = "ros",
        /// OpenCV's `FileStorage` YAML, one file per camera, and `stereo.yml` with the keys of OpenCV's stereo sample.
        OpenCv = "opencv",
        /// Kalibr's `camchain.yaml`, and `imu.yaml` of a known model.
        Kalibr = "kalibr",
        /// `DepthAI`'s JSON, in the layout that `DepthAI` writes.
        DepthAi = "depthai",
    }
}

/// Files and their findings.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CalibrationFiles {
    /// The names (without a folder) and texts.
    pub files: Vec<(String, String)>,
    /// The information that the format cannot represent. A lens that it approximates badly is an
    /// [error](oaktwin_base::diagnostic::Level::Error), which [`crate::force`] downgrades to a warning.
    pub findings: Vec<Finding>,
}

impl CalibrationFiles {
    /// Adds the files and findings of another export.
    pub fn extend(&mut self, other: Self) {
        self.files.extend(other.files);
        self.findings.extend(other.findings);
    }
}

/// Exports a calibration. `raw` is the document that `calibration` was read from.
///
/// # Errors
/// Returns an error if the format cannot approximate a lens, the baseline is zero, or a number of a file would not be finite.
pub fn export(
    raw: &Raw,
    calibration: &Calibration,
    format: Format,
) -> Result<CalibrationFiles, CalibrationError> {
    let export = match format {
        Format::Ros => ros::export(calibration)?,
        Format::OpenCv => opencv::export(calibration)?,
        Format::Kalibr => kalibr::export(calibration)?,
        Format::DepthAi => {
            return Ok(CalibrationFiles {
                files: vec![("calibration.json".to_owned(), raw.to_text())],
                findings: Vec::new(),
            });
        }
    };
    for (name, text) in &export.files {
        if let Some(field) = text::not_finite(text) {
            return Err(CalibrationError::Unsuited {
                file: calibration.file_name.clone(),
                place: format!("{name}: {field}"),
                what: "not finite, because a number of the calibration is far out of range".to_owned(),
                remedy: "calibrate the unit again",
            });
        }
    }
    Ok(export)
}

/// Returns the name of a camera in exports: `left`, `right`, `rgb` or `tof`, otherwise its socket, such as `cam_d`.
#[must_use]
pub fn camera_name(calibration: &Calibration, socket: Socket) -> String {
    let pair = calibration.stereo_pair();
    let product = fold_name(&calibration.board.product_name);
    if pair.is_some_and(|(left, _)| left == socket) {
        "left".to_owned()
    } else if pair.is_some_and(|(_, right)| right == socket) {
        "right".to_owned()
    } else if socket == Socket::CAM_A {
        let time_of_flight = product.contains("tof") || product.contains("srpoe");
        if time_of_flight { "tof" } else { "rgb" }.to_owned()
    } else {
        socket.to_string().to_lowercase()
    }
}

/// Returns the error of a lens that no simpler model approximates.
fn no_fit(calibration: &Calibration, place: &str) -> CalibrationError {
    CalibrationError::Unsuited {
        file: calibration.file_name.clone(),
        place: place.to_owned(),
        what: "too few pixels have a ray by the lens model to fit a simpler one".to_owned(),
        remedy: "calibrate again",
    }
}

/// Returns the rectified pair. Different image sizes cause a warning.
fn pair(
    calibration: &Calibration,
    findings: &mut Vec<Finding>,
) -> Result<Option<StereoPair>, CalibrationError> {
    let pair = calibration.rectified_pair()?;
    if let Some(pair) = &pair {
        let (left, right) = (calibration.camera(pair.left)?, calibration.camera(pair.right)?);
        if left.size() != right.size() {
            findings.push(Finding::new(
                "pair-sizes",
                Level::Warning,
                format!("{}.width", right.place),
                format!(
                    "the cameras were calibrated at {} and {}; the rectification is for two {} images",
                    left.size(),
                    right.size(),
                    left.size()
                ),
                "scale the right images, or calibrate both at one size",
            ));
        }
    } else {
        findings.push(Finding::new(
            "no-pair",
            Level::Note,
            "cameraData",
            "no connected stereo pair; the rectification is omitted",
            "",
        ));
    }
    Ok(pair)
}

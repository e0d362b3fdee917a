//! Calibrations in the formats of other tools.
//!
//! Every exporter returns whole files as text and what got lost on the way. A model of the catalog exports through the
//! same path, by [`crate::nominal_calibration`].

mod kalibr;
mod opencv;
mod ros;
mod simplify;
mod text;

use oaktwin_diagnostic::{Finding, Level, fold_name};

use crate::{Calibration, CalibrationError, Raw, Socket, StereoPair};

/// A format to export to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// `camera_info` YAML, a file a camera.
    Ros,
    /// OpenCV `FileStorage` YAML: a file a camera, and `stereo.yml` in the names of OpenCV's stereo sample.
    OpenCv,
    /// Kalibr's `camchain.yaml`.
    Kalibr,
    /// `DepthAI`'s JSON, as its own writer lays it out.
    DepthAi,
}

/// Files to be written, and what a reader of them must know.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Export {
    /// Names (no folder) and texts.
    pub files: Vec<(String, String)>,
    /// What the format cannot say.
    pub findings: Vec<Finding>,
}

/// Exports a calibration. `raw` is the document that `calibration` was read from.
///
/// # Errors
/// A lens that the format cannot come near, or a stereo pair in one place.
pub fn export(raw: &Raw, calibration: &Calibration, format: Format) -> Result<Export, CalibrationError> {
    match format {
        Format::Ros => ros::export(calibration),
        Format::OpenCv => opencv::export(calibration),
        Format::Kalibr => kalibr::export(calibration),
        Format::DepthAi => Ok(Export {
            files: vec![("calibration.json".to_owned(), raw.to_text())],
            findings: Vec::new(),
        }),
    }
}

/// What a camera is called in exports: `left`, `right`, `rgb` or `tof`, else its socket, `cam_d`.
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

/// The rectified pair, with a warning where its images differ in size.
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
                    "the pair was calibrated at {} and {}; its rectification is for {} images of both",
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
            "no two cameras make a joined stereo pair; no rectification is written",
            "",
        ));
    }
    Ok(pair)
}

use std::path::PathBuf;

use oaktwin::camera::OpenCv;
use oaktwin::catalog::Twin;
use oaktwin::diagnostic::{self, Finding};
use oaktwin::files::WrittenFile;
use oaktwin::stereo::MatchingResult;
use serde::Serialize;

use crate::args::StereoArgs;
use crate::context::Result;
use crate::output;

/// The result of the command.
#[derive(Debug, Serialize)]
pub(super) struct StereoReport {
    /// The model, if one is given.
    model: Option<String>,
    output: PathBuf,
    resolution: [u32; 2],
    focal_length_px: f64,
    /// The principal point in OpenCV's convention, px.
    principal_point_px: [f64; 2],
    baseline_m: f64,
    /// The rectification of raw images.
    rectification: Option<&'static str>,
    pairs: usize,
    #[serde(rename = "fill_rates")]
    fill: Vec<f64>,
    #[serde(rename = "interrupted")]
    is_interrupted: bool,
    files: Vec<WrittenFile>,
    findings: Vec<Finding>,
    /// The findings about the calibration.
    calibration_findings: Vec<Finding>,
}

impl StereoReport {
    pub(super) fn new(
        args: &StereoArgs,
        unit: Option<(Twin, Vec<Finding>)>,
        matched: MatchingResult,
    ) -> Self {
        let (model, calibration_findings) = match unit {
            Some((twin, findings)) => (Some(twin.device.name), findings),
            None => (None, Vec::new()),
        };
        let intrinsics = matched.camera.intrinsics;
        let centre = intrinsics.principal_point::<OpenCv>();
        Self {
            model,
            output: args.output.clone(),
            resolution: [intrinsics.size.width, intrinsics.size.height],
            focal_length_px: intrinsics.fx,
            principal_point_px: [centre.x, centre.y],
            baseline_m: matched.baseline_m,
            rectification: matched.method,
            pairs: matched.fill.len(),
            fill: matched.fill,
            is_interrupted: matched.is_interrupted,
            files: matched.files,
            findings: matched.findings,
            calibration_findings,
        }
    }

    pub(super) fn print(&self, args: &StereoArgs) -> Result<()> {
        if self.is_interrupted {
            output::say(&format!("interrupted: {} pairs are complete", self.pairs));
        }
        if args.json {
            return output::print_json(self);
        }
        if let Some(calibration) = &args.unit.calibration {
            output::say_findings(calibration, &self.calibration_findings);
        }
        for group in diagnostic::group(&self.findings) {
            output::say(&group.to_string());
        }
        output::print(&self.text())
    }

    fn text(&self) -> String {
        let [width, height] = self.resolution;
        let pairs = if self.pairs == 1 { "pair" } else { "pairs" };
        let rectification = match self.rectification {
            Some(method) => format!("rectified ({method})"),
            None => "already rectified".to_owned(),
        };
        let fill = self.fill.iter().sum::<f64>() / self.fill.len().max(1) as f64;
        let mut text = format!(
            "{}: {} {pairs} of {width}x{height}, {rectification}, focal length {:.1} px, principal point ({:.2}, {:.2}) px, \
             baseline {:.1} mm, {:.1} % measured\n",
            self.model.as_deref().unwrap_or("stereo-matching"),
            self.pairs,
            self.focal_length_px,
            self.principal_point_px[0],
            self.principal_point_px[1],
            self.baseline_m * 1000.0,
            fill * 100.0
        );
        for file in &self.files {
            text += &format!("{}\n", file.path.display());
        }
        text
    }
}

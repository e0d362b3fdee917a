mod camera;

use std::path::Path;

use oaktwin::diagnostic::Finding;
use oaktwin::files::WrittenFile;
use oaktwin::render::{Rig, Written};
use serde::Serialize;

use camera::RenderedCameraReport;

use super::imu::ImuReport;
use crate::args::RenderArgs;
use crate::context::Result;
use crate::output;

/// The result of the command.
#[derive(Debug, Serialize)]
pub(super) struct RenderReport<'a> {
    scene: &'a Path,
    /// The output folder, if there is one.
    output: Option<&'a Path>,
    /// The recording, if it is complete.
    recording: Option<WrittenFile>,
    /// The samples of the inertial sensor, if they are requested.
    #[serde(skip_serializing_if = "Option::is_none")]
    imu: Option<ImuReport>,
    /// The number of complete frames.
    frames: usize,
    #[serde(skip)]
    wanted_frames: usize,
    #[serde(rename = "interrupted")]
    pub(super) is_interrupted: bool,
    annotators: Vec<&'static str>,
    cameras: Vec<RenderedCameraReport<'a>>,
    files: Vec<WrittenFile>,
    /// The findings about the scene, its cameras and the rendering.
    findings: Vec<Finding>,
    /// The findings about the calibration.
    calibration_findings: Vec<Finding>,
}

impl<'a> RenderReport<'a> {
    pub(super) fn new(
        (args, output): (&'a RenderArgs, Option<&'a Path>),
        rig: &'a Rig,
        (written, files, imu): (Written, Option<Vec<WrittenFile>>, Option<ImuReport>),
        wanted_frames: usize,
        findings: Vec<Finding>,
        calibration_findings: Vec<Finding>,
    ) -> Self {
        let cameras = rig.cameras().iter().zip(rig.sensors());
        let is_flat = cameras.len() == 1;
        Self {
            scene: &args.scene,
            output,
            recording: written.recording,
            imu,
            frames: written.frames,
            wanted_frames,
            is_interrupted: written.is_interrupted,
            annotators: rig
                .annotators()
                .iter()
                .map(|annotator| annotator.name())
                .collect(),
            cameras: cameras
                .map(|(camera, sensor)| RenderedCameraReport::new(camera, sensor.as_ref(), output, is_flat))
                .collect(),
            files: files.unwrap_or_default(),
            findings,
            calibration_findings,
        }
    }

    pub(super) fn print(&self, args: &RenderArgs) -> Result<()> {
        if self.is_interrupted {
            if let Some(folder) = self.output {
                output::say(&format!(
                    "interrupted: {} of {} frames are complete in {}",
                    self.frames,
                    self.wanted_frames,
                    folder.display()
                ));
            }
            if let Some(file) = &args.record {
                output::say(&format!("interrupted: {} was not written", file.display()));
            }
        }
        if args.json {
            return output::print_json(self);
        }
        if let Some(calibration) = &args.unit.calibration {
            output::say_findings(calibration, &self.calibration_findings);
        }
        output::say_findings(self.scene, &self.findings);
        let mut text = String::new();
        for camera in &self.cameras {
            let [width, height] = camera.resolution;
            if let Some(folder) = &camera.folder {
                text += &format!("{}  ", folder.display());
            }
            text += &format!(
                "{}, {width}x{height}, {} {}\n",
                camera.path,
                self.frames,
                if self.frames == 1 { "frame" } else { "frames" }
            );
        }
        if let Some(recording) = &self.recording {
            text += &format!("{}  {} bytes\n", recording.path.display(), recording.bytes);
        }
        if let Some(imu) = &self.imu {
            text += &format!(
                "{}  {} samples of the {} at {} Hz\n",
                imu.file.path.display(),
                imu.samples,
                imu.part,
                imu.rate_hz
            );
        }
        output::print(&text)
    }
}

use std::path::Path;

use oaktwin::catalog::Twin;
use oaktwin::diagnostic::Finding;
use oaktwin::files::WrittenFile;
use oaktwin::sense::Sensed;
use serde::Serialize;

use crate::context::Result;
use crate::output;

/// The result of the command.
#[derive(Debug, Serialize)]
pub(super) struct SenseReport {
    model: String,
    sensors: Vec<SensorReport>,
    images: u64,
    #[serde(rename = "interrupted")]
    is_interrupted: bool,
    files: Vec<WrittenFile>,
    findings: Vec<Finding>,
    /// The findings about the calibration.
    calibration_findings: Vec<Finding>,
}

#[derive(Debug, Serialize)]
struct SensorReport {
    prim: String,
    engine: String,
}

impl SenseReport {
    pub(super) fn new(twin: &Twin, sensed: Sensed, calibration_findings: Vec<Finding>) -> Self {
        Self {
            model: twin.device.name.clone(),
            sensors: sensed
                .sensors
                .into_iter()
                .map(|(prim, engine)| SensorReport { prim, engine })
                .collect(),
            images: sensed.images,
            is_interrupted: sensed.is_interrupted,
            files: sensed.files,
            findings: sensed.findings,
            calibration_findings,
        }
    }

    /// Prints to standard output, unless that is the stream of results.
    pub(super) fn print(&self, as_json: bool, is_stream: bool) -> Result<()> {
        if self.is_interrupted {
            output::say(&format!("interrupted: {} images are complete", self.images));
        }
        if as_json {
            return output::print_json(self);
        }
        output::say_findings(Path::new(&self.model), &self.findings);
        if is_stream {
            return Ok(());
        }
        let sensors: Vec<String> = self
            .sensors
            .iter()
            .map(|sensor| format!("{} ({})", sensor.prim, sensor.engine))
            .collect();
        let images = if self.images == 1 { "image" } else { "images" };
        let mut text = format!(
            "{}: {}, {} {images}\n",
            self.model,
            sensors.join(", "),
            self.images
        );
        for file in &self.files {
            text += &format!("{}\n", file.path.display());
        }
        output::print(&text)
    }
}

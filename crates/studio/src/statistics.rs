//! Statistics as a file: what was measured, by which OAK, from where.

use std::collections::{BTreeMap, BTreeSet};

use oaktwin::depth::reason;
use serde::Serialize;

use crate::file::File;
use crate::frame::statistics;
use crate::protocol::{ExportRequest, Failure, OakState, Pose, Statistics};
use crate::station::measured;
use crate::studio::Studio;

/// The maximum number of OAKs in a file.
const MAX_OAKS: usize = 8;

/// The statistics of OAKs.
#[derive(Debug, Serialize)]
struct StatisticsReport<'a> {
    scene: &'a str,
    /// The rectangle as fractions of the image: left, top, right, bottom.
    rectangle: [f64; 4],
    oaks: Vec<OakRow<'a>>,
}

/// The statistics of one OAK, with everything that they depend on.
#[derive(Debug, Serialize)]
#[serde(rename_all = "camelCase")]
struct OakRow<'a> {
    model: &'a str,
    sensor: &'a str,
    engine: &'a str,
    pose: Pose,
    /// The width and height of the measured image.
    size: [u32; 2],
    /// The effective parameters and filters.
    parameters: BTreeMap<&'static str, String>,
    filters: Vec<String>,
    state: &'a OakState,
    #[serde(flatten)]
    statistics: Statistics,
    /// The number of pixels without a value for each reason, by name.
    lost: BTreeMap<String, u64>,
}

/// Makes the file of a request, `json` or `csv`.
pub(crate) fn file(studio: &Studio, request: &ExportRequest, format: &str) -> Result<File, Failure> {
    let others = request.others.as_deref().unwrap_or_default();
    if others.len() >= MAX_OAKS {
        let error = format!(
            "{} OAKs are too many; choose at most {MAX_OAKS}",
            others.len() + 1
        );
        return Err(Failure::of("others", &error));
    }
    let scene = studio.scenes.get(&request.scene)?;
    let rectangle = request.region.unwrap_or([0.0, 0.0, 1.0, 1.0]);
    let own = (&request.state, request.size);
    let oaks = std::iter::once(own).chain(others.iter().map(|other| (&other.state, other.size)));
    let rows = oaks.map(|(state, size)| row(studio, &request.scene, state, size, rectangle));
    let report = StatisticsReport {
        scene: &scene.info.name,
        rectangle,
        oaks: rows.collect::<Result<_, _>>()?,
    };
    let text = match format {
        "json" => {
            let json = serde_json::to_string_pretty(&report);
            json.map_err(|error| Failure::from(error.to_string()))? + "\n"
        }
        "csv" => report.csv(),
        _ => {
            let error = format!("unknown format '{format}'; choose json or csv");
            return Err(Failure::of("format", &error));
        }
    };
    Ok(File::text(&format!("statistics.{format}"), text))
}

fn row<'a>(
    studio: &Studio,
    scene: &str,
    state: &'a OakState,
    size: Option<[u32; 2]>,
    rectangle: [f64; 4],
) -> Result<OakRow<'a>, Failure> {
    let seen = measured(studio, scene, state, size, Vec::new())?;
    let mut statistics = statistics(&seen, rectangle);
    let legend = reason::legend();
    let counts = std::mem::take(&mut statistics.reasons);
    let lost = (0u8..=u8::MAX).zip(counts).skip(1);
    let lost = lost.filter(|(_, count)| *count > 0).map(|(code, count)| {
        let name = legend.get(&code).map(|label| label.name.clone());
        (name.unwrap_or_else(|| code.to_string()), count)
    });
    let image = &seen.capture.distance.0;
    Ok(OakRow {
        model: &state.model,
        sensor: &state.sensor,
        engine: &state.engine,
        pose: state.pose,
        size: [image.width(), image.height()],
        parameters: seen.engine.parameters().into_iter().collect(),
        filters: seen.filters.clone(),
        state,
        lost: lost.collect(),
        statistics,
    })
}

impl StatisticsReport<'_> {
    /// A row for each OAK; the names of columns have the units.
    fn csv(&self) -> String {
        let reasons: BTreeSet<&String> = self.oaks.iter().flat_map(|row| row.lost.keys()).collect();
        let fixed = [
            "scene",
            "model",
            "sensor",
            "engine",
            "x_m",
            "y_m",
            "z_m",
            "qx",
            "qy",
            "qz",
            "qw",
            "width",
            "height",
            "left",
            "top",
            "right",
            "bottom",
            "pixels",
            "fill_rate",
            "median_error_m",
            "median_absolute_error_m",
            "median_absolute_error_percent",
            "p95_absolute_error_m",
        ];
        let mut table = csv::Writer::from_writer(Vec::new());
        let names = fixed.map(str::to_owned).into_iter();
        // Writing to memory does not fail.
        let _ = table.write_record(names.chain(reasons.iter().map(|name| format!("pixels_{name}"))));
        for row in &self.oaks {
            let _ = table.write_record(row.cells(self, &reasons));
        }
        let bytes = table.into_inner().unwrap_or_default();
        String::from_utf8_lossy(&bytes).into_owned()
    }
}

impl OakRow<'_> {
    /// The cells of a row of the table.
    fn cells(&self, report: &StatisticsReport<'_>, reasons: &BTreeSet<&String>) -> Vec<String> {
        let number = |value: f64| value.to_string();
        let maybe = |value: Option<f64>| value.map(number).unwrap_or_default();
        let known = &self.statistics;
        let mut cells = [report.scene, self.model, self.sensor, self.engine]
            .map(str::to_owned)
            .to_vec();
        cells.extend(self.pose.position.map(number));
        cells.extend(self.pose.quaternion.map(number));
        cells.extend(self.size.map(|pixels| pixels.to_string()));
        cells.extend(report.rectangle.map(number));
        cells.extend([known.pixels.to_string(), number(known.fill_rate)]);
        cells.extend(
            [
                known.median_error_m,
                known.median_absolute_error_m,
                known.median_absolute_error_percent,
                known.p95_absolute_error_m,
            ]
            .map(maybe),
        );
        let count = |name: &&String| self.lost.get(*name).copied().unwrap_or(0).to_string();
        cells.extend(reasons.iter().map(count));
        cells
    }
}

//! The latency of a device's depth: `data/latencies.toml`.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use oaktwin_base::diagnostic::fold_name;
use oaktwin_base::parameter::choice;
use serde::{Deserialize, Serialize};

use crate::{DepthKind, Device, Source};

choice! {
    /// The connection between a device and its host.
    Connection {
        /// USB 3.
        Usb = "usb",
        /// Power over Ethernet, 1 Gbit/s.
        Poe = "poe",
    }
}

/// The mode of a stereo matcher, on which the time to compute depth depends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MatchingMode {
    /// Whether disparities are larger than 95 px.
    pub is_extended: bool,
    /// Whether disparities have fractional bits.
    pub has_subpixels: bool,
    /// Whether matches are checked from right to left.
    pub checks_left_right: bool,
}

/// The mode in which the engines measure by default.
impl Default for MatchingMode {
    fn default() -> Self {
        Self {
            is_extended: false,
            has_subpixels: true,
            checks_left_right: true,
        }
    }
}

impl MatchingMode {
    /// Returns the name in the data, such as `subpixel+left-right`.
    #[must_use]
    pub fn name(self) -> String {
        let parts = [
            (self.is_extended, "extended"),
            (self.has_subpixels, "subpixel"),
            (self.checks_left_right, "left-right"),
        ];
        let named: Vec<&str> = parts.iter().filter(|part| part.0).map(|part| part.1).collect();
        match named.is_empty() {
            true => "standard".to_owned(),
            false => named.join("+"),
        }
    }
}

/// The time from the middle of an exposure until its depth image is at the host.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Latency {
    /// The connection.
    pub connection: &'static str,
    /// The mode of the matcher, or `time-of-flight`.
    pub mode: String,
    /// The width of the matched images, px.
    pub width_px: u32,
    /// The sum of the stages' shortest and longest times, ms.
    pub ms: (f64, f64),
    /// The standard deviation from frame to frame, ms.
    pub jitter_ms: f64,
    /// The stages, in the order of time.
    pub stages: Vec<LatencyStage>,
}

impl Latency {
    /// Returns the largest additional delay of a frame, ms, if delays are distributed uniformly from 0.
    #[must_use]
    pub fn largest_jitter_ms(&self) -> f64 {
        12.0_f64.sqrt() * self.jitter_ms
    }
}

/// A stage of a latency.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LatencyStage {
    /// `exposure` (from its middle to its end), `transfer` (readout, image processor and connection) or `depth`.
    pub stage: &'static str,
    /// The shortest and the longest time, ms.
    pub ms: (f64, f64),
    /// The source.
    pub source: Source,
    /// Its place, or the derivation.
    pub from: &'static str,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    connections: BTreeMap<String, Vec<String>>,
    #[serde(rename = "stage")]
    rows: Vec<LatencyRow>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct LatencyRow {
    stage: String,
    generation: Option<String>,
    connection: Option<String>,
    mode: Option<String>,
    width: Option<u32>,
    ms: (f64, f64),
    #[serde(default)]
    jitter_ms: f64,
    source: Source,
    from: String,
}

/// The name of the mode of time of flight.
const TIME_OF_FLIGHT: &str = "time-of-flight";

/// The stages in the order of time.
const STAGES: [&str; 3] = ["exposure", "depth", "transfer"];

static FILE: LazyLock<File> = LazyLock::new(|| {
    #[expect(
        clippy::expect_used,
        reason = "the file is part of the program, and a test loads it"
    )]
    toml::from_str(include_str!("../data/latencies.toml")).expect("the built-in latencies are valid")
});

impl Device {
    /// The connection to the host: what the data says, else USB.
    #[must_use]
    pub fn connection(&self) -> Connection {
        let has_id = |ids: &Vec<String>| ids.contains(&self.id);
        match FILE.connections.get(Connection::Poe.name()).is_some_and(has_id) {
            true => Connection::Poe,
            false => Connection::Usb,
        }
    }

    /// Returns the latency of a depth sensor, by default over the device's own [connection](Self::connection); `mode` is the matcher's, of
    /// stereo only. `None` where no source states a stage: of devices without one of `DepthAI`'s processors.
    #[must_use]
    pub fn latency(
        &self,
        kind: DepthKind,
        mode: MatchingMode,
        width_px: u32,
        connection: Option<Connection>,
    ) -> Option<Latency> {
        let connection = connection.unwrap_or_else(|| self.connection());
        let name = match kind {
            DepthKind::Tof => TIME_OF_FLIGHT.to_owned(),
            DepthKind::Stereo => mode.name(),
        };
        let generation = fold_name(&self.generation);
        let matches = |row: &&LatencyRow| {
            let same =
                |wanted: &Option<String>, own: &str| wanted.as_deref().is_none_or(|wanted| wanted == own);
            row.generation
                .as_deref()
                .is_none_or(|wanted| fold_name(wanted) == generation)
                && same(&row.connection, connection.name())
                && same(&row.mode, &name)
                && row.width.is_none_or(|width| width_px <= width)
        };
        let row = |stage: &str| FILE.rows.iter().filter(|row| row.stage == stage).find(matches);
        let rows = STAGES.iter().map(|stage| Some((*stage, row(stage)?)));
        let rows: Vec<(&'static str, &'static LatencyRow)> = rows.collect::<Option<_>>()?;
        let sum = |of: &dyn Fn(&LatencyRow) -> f64| rows.iter().map(|(_, row)| of(row)).sum::<f64>();
        Some(Latency {
            connection: connection.name(),
            mode: name,
            width_px,
            ms: (sum(&|row| row.ms.0), sum(&|row| row.ms.1)),
            jitter_ms: sum(&|row| row.jitter_ms),
            stages: rows
                .iter()
                .map(|(stage, row)| LatencyStage {
                    stage,
                    ms: row.ms,
                    source: row.source,
                    from: &row.from,
                })
                .collect(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Catalog;

    fn latency(model: &str, mode: MatchingMode, width_px: u32) -> Option<Latency> {
        let device = Catalog::builtin().device(model).unwrap();
        device.latency(DepthKind::Stereo, mode, width_px, None)
    }

    #[test]
    fn the_file_is_consistent() {
        for row in &FILE.rows {
            assert!(STAGES.contains(&row.stage.as_str()), "{row:?}");
            assert!(
                0.0 < row.ms.0 && row.ms.0 <= row.ms.1 && row.jitter_ms >= 0.0,
                "{row:?}"
            );
            let connection = row.connection.as_deref();
            assert!(
                connection.is_none_or(|name| Connection::from_name(name).is_some()),
                "{row:?}"
            );
        }
        for (connection, ids) in &FILE.connections {
            assert!(Connection::from_name(connection).is_some());
            for id in ids {
                assert_eq!(&Catalog::builtin().device(id).unwrap().id, id);
            }
        }
    }

    #[test]
    fn every_mode_of_a_stereo_device_has_a_latency() {
        for device in Catalog::builtin().devices() {
            let stereo = device
                .depth_sensors
                .iter()
                .any(|sensor| sensor.kind == DepthKind::Stereo);
            let expected = stereo && device.depthai_platform().is_some();
            if !stereo {
                continue;
            }
            for flags in 0..8 {
                let mode = MatchingMode {
                    is_extended: flags & 1 > 0,
                    has_subpixels: flags & 2 > 0,
                    checks_left_right: flags & 4 > 0,
                };
                for width_px in [300, 640, 1280] {
                    for connection in [Connection::Usb, Connection::Poe] {
                        let found = device.latency(DepthKind::Stereo, mode, width_px, Some(connection));
                        assert_eq!(found.is_some(), expected, "{} {mode:?}", device.id);
                    }
                }
            }
        }
    }

    /// An engineer of Luxonis measured 23.9 ms from the end of the exposure.
    #[test]
    fn a_measured_latency_is_within_the_sum_of_stages() {
        let lite = latency("OAK-D Lite", MatchingMode::default(), 640).unwrap();
        let exposure = lite.stages[0].ms;
        let (low, high) = (lite.ms.0 - exposure.0, lite.ms.1 - exposure.1);
        assert!(low < 23.9 && (high - 23.9).abs() < 0.05, "{low} {high}");
        assert_eq!(
            (lite.connection, lite.mode.as_str()),
            ("usb", "subpixel+left-right")
        );
    }

    #[test]
    fn ethernet_and_larger_images_take_longer() {
        let mode = MatchingMode::default();
        let of = |model, width| latency(model, mode, width).unwrap();
        assert!(of("OAK-D Pro PoE", 640).ms.0 > of("OAK-D Pro", 640).ms.0);
        assert!(of("OAK-D Pro PoE", 640).jitter_ms > of("OAK-D Pro", 640).jitter_ms);
        assert!(of("OAK-D Pro", 1280).ms.0 > of("OAK-D Pro", 640).ms.1);
    }

    /// A frame takes two intervals of 1/60 s, whose middle is one interval before their end, and the device decodes 30 frames a second.
    #[test]
    fn time_of_flight_has_a_latency_of_its_own() {
        let device = Catalog::builtin().device("OAK-D ToF").unwrap();
        assert_eq!(device.connection(), Connection::Poe);
        let found = device
            .latency(DepthKind::Tof, MatchingMode::default(), 640, None)
            .unwrap();
        let stage = |name: &str| found.stages.iter().find(|stage| stage.stage == name).unwrap();
        assert_eq!(found.mode, TIME_OF_FLIGHT);
        assert!((stage("exposure").ms.0 - 1000.0 / 60.0).abs() < 0.05);
        assert!(stage("depth").ms.1 <= 1000.0 / 30.0);
        assert_eq!(stage("depth").source, Source::Estimate);
        assert!(stage("transfer").ms.0 > 8.0);
    }
}

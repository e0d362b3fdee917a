use super::{AccuracyError, CAPTURES, MeasuredOptics, REGION, distances};
use oaktwin_pipeline::sensor::SensorOptions;

/// The most devices at once: each holds a table of a quarter of a megabyte.
const MAX_DEVICES: u32 = 5000;

/// How to measure.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// The depth sensor by prim or kind (`stereo`, `tof`); by default the last, the device's own.
    pub sensor: Option<String>,
    /// The engine and its settings.
    pub engine: SensorOptions,
    /// True distances, m; by default about twenty from the nearest that can be measured to the end of the bands.
    pub distances_m: Option<Vec<f64>>,
    /// How many devices, where they differ and none is chosen by its seed; by default
    /// [`DEVICES`](super::DEVICES) or [`MATCHING_DEVICES`](super::MATCHING_DEVICES).
    pub devices: Option<u32>,
    /// Images of each board.
    pub captures: u32,
    /// The side of the measured region as a share (0 to 1) of the image's.
    pub region: f64,
    /// A measured unit's optics.
    pub optics: MeasuredOptics,
    /// Of somebody's measurements, those nearer than this do not count, m.
    pub from_m: f64,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            sensor: None,
            engine: SensorOptions::default(),
            distances_m: None,
            devices: None,
            captures: CAPTURES,
            region: REGION,
            optics: MeasuredOptics::default(),
            from_m: 0.0,
        }
    }
}

impl Options {
    /// Refuses what cannot be measured.
    pub(super) fn check(&self) -> Result<(), AccuracyError> {
        let wrong = |option, what: String, remedy| Err(AccuracyError::Option { option, what, remedy });
        if self.captures == 0 || self.captures > 1000 {
            return wrong(
                "captures",
                format!("{} cannot be averaged", self.captures),
                "give 1 to 1000",
            );
        }
        if self
            .devices
            .is_some_and(|count| count == 0 || count > MAX_DEVICES)
        {
            return wrong(
                "devices",
                "there must be some, and not too many".to_owned(),
                "give 1 to 5000",
            );
        }
        if !(self.region > 0.0 && self.region <= 1.0) {
            return wrong(
                "region",
                format!("{} is no share of an image", self.region),
                "give a share above 0, up to 1",
            );
        }
        if !(self.from_m >= 0.0 && self.from_m.is_finite()) {
            return wrong("from", format!("{} is no distance", self.from_m), "give metres");
        }
        if let Some(distances) = &self.distances_m {
            for &distance in distances {
                distances::check(distance).map_err(|what| AccuracyError::Distances {
                    text: distance.to_string(),
                    what: what.to_owned(),
                })?;
            }
        }
        Ok(())
    }
}

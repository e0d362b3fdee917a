use super::{AccuracyError, CAPTURES, MeasuredOptics, REGION, distances};
use oaktwin_pipeline::sensor::SensorOptions;

/// The maximum number of devices: each holds a table of a quarter of a megabyte.
const MAX_DEVICES: u32 = 5000;

/// The settings of a measurement.
#[derive(Clone, Debug, PartialEq)]
pub struct AccuracyOptions {
    /// The depth sensor by prim or kind (`stereo`, `tof`); by default the last one, which is the device's own.
    pub sensor: Option<String>,
    /// The engine and its settings.
    pub engine: SensorOptions,
    /// The true distances in metres; by default about twenty from the minimum measurable distance to the end of the bands.
    pub distances_m: Option<Vec<f64>>,
    /// The number of devices, if they differ and none is selected by its seed; by default
    /// [`DEVICES`](super::DEVICES) or [`MATCHING_DEVICES`](super::MATCHING_DEVICES).
    pub devices: Option<u32>,
    /// Whether the devices are units of the factory population, which also differ in their cameras. The engine's drift then has the
    /// standard deviations of the units' drifts.
    pub population: bool,
    /// The number of captures of each board.
    pub captures: u32,
    /// The side of the measured region as a share (0 to 1) of the image's side.
    pub region: f64,
    /// The optics of a measured unit.
    pub optics: MeasuredOptics,
    /// The distance in metres below which measured points are ignored.
    pub from_m: f64,
}

impl Default for AccuracyOptions {
    fn default() -> Self {
        Self {
            sensor: None,
            engine: SensorOptions::default(),
            distances_m: None,
            devices: None,
            population: false,
            captures: CAPTURES,
            region: REGION,
            optics: MeasuredOptics::default(),
            from_m: 0.0,
        }
    }
}

impl AccuracyOptions {
    /// Returns an error if an option is out of range.
    pub(super) fn check(&self) -> Result<(), AccuracyError> {
        let wrong = |option, what: String, remedy| Err(AccuracyError::Option { option, what, remedy });
        if self.captures == 0 || self.captures > 1000 {
            return wrong(
                "captures",
                format!("{} is out of range", self.captures),
                "give 1 to 1000",
            );
        }
        if self
            .devices
            .is_some_and(|count| count == 0 || count > MAX_DEVICES)
        {
            return wrong(
                "devices",
                "the number is out of range".to_owned(),
                "give 1 to 5000",
            );
        }
        if !(self.region > 0.0 && self.region <= 1.0) {
            return wrong(
                "region",
                format!("{} is out of range", self.region),
                "give a share above 0, up to 1",
            );
        }
        if !(self.from_m >= 0.0 && self.from_m.is_finite()) {
            return wrong(
                "from",
                format!("{} is out of range", self.from_m),
                "give a distance in metres",
            );
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

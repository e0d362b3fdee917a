//! Sensors of a stereo pair with a baseline of 75 mm.

#![expect(clippy::unwrap_used, reason = "helpers of tests")]

use oaktwin_depth::filter::{Chain, parse};
use oaktwin_depth::random::Stream;
use oaktwin_depth::{EngineKind, Sensor, Setup};

/// The baseline, metres.
pub(crate) const BASELINE_M: f64 = 0.075;

/// The camera of a sensor.
pub(crate) struct Optics {
    pub(crate) focal_length_px: f64,
    pub(crate) width: u32,
}

impl Optics {
    /// Creates the sensor of an engine with parameters and filters in DepthAI's notation.
    pub(crate) fn sensor(&self, kind: &EngineKind, parameters: &[(&str, &str)], filters: &[&str]) -> Sensor {
        let mut setup = Setup::new(self.focal_length_px, self.width, BASELINE_M);
        setup.attributes.focal_length_px = self.focal_length_px;
        setup.attributes.sensor_size_px = f64::from(self.width);
        setup.attributes.baseline_mm = 1e3 * BASELINE_M;
        setup.parameters = (parameters.iter())
            .map(|(name, value)| ((*name).to_owned(), (*value).into()))
            .collect();
        let filters = filters.iter().map(|text| parse(text).unwrap()).collect();
        let engine = kind.create(&setup).unwrap();
        Sensor::new(engine, Chain::new(filters), Stream::new(1, "camera"))
    }
}

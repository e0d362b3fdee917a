//! The results of a measurement, with units in their names.

use crate::measure::{median, quantile};
use serde::Serialize;

use super::bands::{Band, Bands};
use super::test_rig::{Measured, MeasuredUnit};

/// The accuracy of a twin.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct AccuracyReport {
    /// The name of the model.
    pub model: String,
    /// The prim of the depth sensor.
    pub sensor: String,
    /// The name of the engine, such as `stereo-noise`.
    pub engine: String,
    /// Whether Isaac Sim's sensor carries the rendered depth along (in each row's own reading) instead of computing it from
    /// disparity; `None` for other engines.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub carries_depth: Option<bool>,
    /// The measured devices.
    pub devices: Devices,
    /// The focal length in pixels of an image that is [`AccuracyReport::image_width_px`] wide.
    pub focal_length_px: f64,
    /// The width of the whole depth image.
    pub image_width_px: u32,
    /// The height of the whole depth image.
    pub image_height_px: u32,
    /// Disparity times depth in px·m, in the pixels in which the engine counts disparity.
    pub disparity_times_depth_px_m: f64,
    /// The width of the measured region at the centre of the image.
    pub region_width_px: u32,
    /// The height of the measured region.
    pub region_height_px: u32,
    /// The number of captures of each board.
    pub captures: u32,
    /// The deviations from the vendor's protocol.
    pub protocol_deviations: Vec<String>,
    /// The published accuracy, if there is any.
    pub published: Option<Bands>,
    /// The results in order of distance.
    pub distances: Vec<AccuracyRow>,
    /// The comparison with a measured curve.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub measured: Option<Comparison>,
    /// Whether something was measured and no distance is outside its band.
    pub passed: bool,
}

impl AccuracyReport {
    /// Whether Isaac Sim's sensor carries the rendered depth along, as it does by default.
    #[must_use]
    pub fn is_carried(&self) -> bool {
        self.carries_depth == Some(true)
    }
}

/// The measured devices.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum Devices {
    /// Several devices with different biases; results are medians.
    Population {
        /// The number of devices; their seeds start at 0.
        count: u32,
    },
    /// Units of the factory population, which differ in their cameras, biases and drifts; results are medians.
    Factory {
        /// The number of units, from number 0.
        count: u32,
    },
    /// The device of a seed.
    One {
        /// The seed.
        device_seed: u64,
    },
    /// A device that is fully defined by its parameters.
    AsGiven,
}

/// The results at a distance.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct AccuracyRow {
    /// The true distance.
    pub distance_m: f64,
    /// The sensor's measurement; for several devices the medians.
    #[serde(flatten)]
    pub reading: Reading,
    /// For Isaac Sim's sensor, the measurement under the other documented reading: depth computed from the quantized and
    /// jittered disparity, or carried along.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub other_reading: Option<Reading>,
    /// For Isaac Sim's sensor, one sigma of the jitter of disparity in percent of the disparity: to first order the error of
    /// a pixel's depth.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub jitter_percent_of_disparity: Option<f64>,
    /// For Isaac Sim's sensor, the share (0 to 1) of the carried depths that would be invalid if they were computed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub invalid_if_recomputed: Option<f64>,
    /// The published bands at this distance, the strictest first.
    pub bands: Vec<Band>,
    /// Whether the error is within the strictest band.
    pub verdict: Verdict,
}

/// A measurement of the board; for several devices each figure is the median. `None` if too little was measured.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Reading {
    /// The vendor's error: of one device with its sign, positive if too far; of several the median of the absolute errors.
    pub error_percent: Option<f64>,
    /// The quartiles of the absolute errors of several devices.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub error_quartiles_percent: Option<[f64; 2]>,
    /// The range that contains all but the best and the worst 5 % of the absolute errors of a population's units.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub error_5_to_95_percent: Option<[f64; 2]>,
    /// The share of valid pixels, 0 to 1.
    pub fill_rate: f64,
    /// Spatial noise: the RMS distance from the fitted plane.
    pub plane_fit_rms_mm: Option<f64>,
    /// Spatial noise in pixels of disparity.
    pub subpixel_rms_px: Option<f64>,
    /// Temporal noise: the median over the pixels of the standard deviation over time.
    pub temporal_noise_mm: Option<f64>,
    /// The standard deviation over time of the mean of the region.
    pub precision_mm: Option<f64>,
    /// The signed median distance from the true distance, corrected for the tilt of the board.
    pub z_accuracy_mm: Option<f64>,
    /// The median absolute error of a pixel.
    pub pixel_error_percent: Option<f64>,
}

/// The comparison of a distance with the published accuracy.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// The error is within the band.
    Inside,
    /// The error exceeds the band.
    Outside,
    /// Nothing is published for this distance.
    NoBand,
    /// The sensor measures nothing at this distance.
    NothingMeasured,
}

impl Verdict {
    /// Returns the verdict in words.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Inside => "inside",
            Self::Outside => "OUTSIDE",
            Self::NoBand => "no band",
            Self::NothingMeasured => "nothing",
        }
    }
}

/// A measured curve and the errors of the twin at the same distances.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Comparison {
    /// The path of the file.
    pub file: String,
    /// Whether the measured errors are absolute; the twin's are then compared as absolute values.
    pub is_absolute: bool,
    /// The distance below which points are ignored.
    pub from_m: f64,
    /// The coefficient of determination of the error in percent; `None` if there are too few points.
    pub r_squared: Option<f64>,
    /// The root mean square of the difference of the errors.
    pub rms_difference_percent: Option<f64>,
    /// The number of compared points.
    pub compared_points: usize,
    /// The number of points at which the twin measures nothing.
    pub unmeasured_points: usize,
    /// All points in the order of the file.
    pub points: Vec<ComparedPoint>,
}

/// A point of a measured curve.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ComparedPoint {
    /// The true distance.
    pub distance_m: f64,
    /// The measured error.
    pub measured_error_percent: f64,
    /// The error of the twin.
    pub twin_error_percent: Option<f64>,
}

impl AccuracyRow {
    pub(super) fn new(distance_m: f64, units: &[MeasuredUnit], published: Option<&Bands>) -> Self {
        let own: Vec<Measured> = units.iter().map(|unit| unit.own).collect();
        let other: Vec<Measured> = units.iter().filter_map(|unit| unit.other).collect();
        let reading = Reading::new(&own, distance_m);
        let bands: Vec<Band> = published
            .map(|published| published.at(distance_m))
            .unwrap_or_default();
        Self {
            distance_m,
            verdict: verdict(&reading, &bands),
            reading,
            other_reading: (!other.is_empty()).then(|| Reading::new(&other, distance_m)),
            jitter_percent_of_disparity: None,
            invalid_if_recomputed: None,
            bands,
        }
    }

    /// Adds the range of the errors of a population's units.
    pub(super) fn with_band(mut self, units: &[MeasuredUnit]) -> Self {
        let own: Vec<Measured> = units.iter().map(|unit| unit.own).collect();
        let absolute = absolute_errors(&own, self.distance_m);
        let share = |share: f64| quantile(&absolute, share).filter(|error| error.is_finite());
        self.reading.error_5_to_95_percent = share(0.05).zip(share(0.95)).map(<[f64; 2]>::from);
        self
    }

    /// Adds the quantities of Isaac Sim's sensor.
    pub(super) fn with_single_view(
        mut self,
        jitter_times_depth: Option<f64>,
        carries_depth: Option<bool>,
    ) -> Self {
        self.jitter_percent_of_disparity = jitter_times_depth.map(|share| share * self.distance_m * 100.0);
        if let (Some(other), Some(carries)) = (&self.other_reading, carries_depth) {
            let (own, other) = (self.reading.fill_rate, other.fill_rate);
            let (carried, recomputed) = if carries { (own, other) } else { (other, own) };
            self.invalid_if_recomputed = (carried > 0.0).then(|| (1.0 - recomputed / carried).max(0.0));
        }
        self
    }

    /// Returns the verdict of the other reading.
    #[must_use]
    pub fn other_verdict(&self) -> Option<Verdict> {
        Some(verdict(self.other_reading.as_ref()?, &self.bands))
    }
}

impl Devices {
    /// Whether results are medians of several devices.
    #[must_use]
    pub const fn are_many(&self) -> bool {
        matches!(self, Self::Population { .. } | Self::Factory { .. })
    }
}

/// The vendor's error of a device with its sign, %.
fn error_percent(device: &Measured, truth_m: f64) -> Option<f64> {
    Some(device.vendor.error(truth_m)? * 100.0)
}

/// The absolute errors of devices, %. A device that measures nothing counts as worse than any other.
fn absolute_errors(devices: &[Measured], truth_m: f64) -> Vec<f64> {
    let errors = devices.iter().map(|device| error_percent(device, truth_m));
    errors
        .map(|error| error.map_or(f64::INFINITY, f64::abs))
        .collect()
}

/// Compares an error with the strictest band, which is the first.
fn verdict(reading: &Reading, bands: &[Band]) -> Verdict {
    match (reading.error_percent, bands.first()) {
        (None, _) => Verdict::NothingMeasured,
        (_, None) => Verdict::NoBand,
        (Some(error), Some(band)) if error.abs() < band.error_percent => Verdict::Inside,
        _ => Verdict::Outside,
    }
}

impl Reading {
    fn new(units: &[Measured], truth_m: f64) -> Self {
        let middle = |of: &dyn Fn(&Measured) -> Option<f64>| {
            let values: Vec<f64> = units.iter().filter_map(of).collect();
            median(&values)
        };
        let millimetres = |metres: Option<f64>| metres.map(|metres| metres * 1e3);
        let is_population = units.len() > 1;
        let percent = |unit: &Measured| error_percent(unit, truth_m);
        let absolute = absolute_errors(units, truth_m);
        let share = |share: f64| quantile(&absolute, share).filter(|error| error.is_finite());
        let quartiles = || Some([share(0.25)?, share(0.75)?]);
        Self {
            error_percent: if is_population {
                share(0.5)
            } else {
                middle(&percent)
            },
            error_quartiles_percent: if is_population { quartiles() } else { None },
            error_5_to_95_percent: None,
            fill_rate: middle(&|unit| Some(unit.quality.fill_rate)).unwrap_or(0.0),
            plane_fit_rms_mm: millimetres(middle(&|unit| unit.quality.plane_fit_rms_m)),
            subpixel_rms_px: middle(&|unit| unit.quality.subpixel_rms_px),
            temporal_noise_mm: millimetres(middle(&|unit| unit.quality.temporal_noise_m)),
            precision_mm: millimetres(middle(&|unit| unit.vendor.precision_m)),
            z_accuracy_mm: millimetres(middle(&|unit| unit.quality.z_accuracy_m)),
            pixel_error_percent: middle(&|unit| Some(unit.quality.pixel_error_m? / truth_m * 100.0)),
        }
    }
}

//! What a measurement says, units in its names.

use crate::measure::{median, quantile};
use serde::Serialize;

use super::bands::{Band, Bands};
use super::test_rig::{Measured, MeasuredUnit};

/// How accurate a twin is.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Report {
    /// The model's name.
    pub model: String,
    /// The prim of its depth sensor.
    pub sensor: String,
    /// The engine: `stereo-noise`.
    pub engine: &'static str,
    /// Whether Isaac Sim's sensor carries the rendered depth along (each row's own reading) instead of computing it from
    /// disparity; other engines have no such choice.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub carries_depth: Option<bool>,
    /// Which devices.
    pub devices: Devices,
    /// The focal length in pixels of an image that is [`Report::image_width_px`] wide.
    pub focal_length_px: f64,
    /// Of the whole depth image.
    pub image_width_px: u32,
    /// Of the whole depth image.
    pub image_height_px: u32,
    /// Disparity times depth, px·m, in the pixels that the engine counts disparity in.
    pub disparity_times_depth_px_m: f64,
    /// The measured region in the middle of the image.
    pub region_width_px: u32,
    /// The measured region in the middle of the image.
    pub region_height_px: u32,
    /// Images of each board.
    pub captures: u32,
    /// What is not as the vendor measures; empty where all is.
    pub protocol_deviations: Vec<String>,
    /// The published accuracy; `None` where there is none.
    pub published: Option<Bands>,
    /// What was measured, near to far.
    pub distances: Vec<Row>,
    /// Somebody's measurements beside it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub measured: Option<Comparison>,
    /// Whether no distance lies outside its band and something was measured.
    pub passed: bool,
}

impl Report {
    /// Whether Isaac Sim's sensor was told, as by default, to carry the rendered depth along.
    #[must_use]
    pub fn is_carried(&self) -> bool {
        self.carries_depth == Some(true)
    }
}

/// Which devices were measured.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum Devices {
    /// Many, each with a bias of its own: their median counts.
    Population {
        /// How many: those of the device seeds from 0 on.
        count: u32,
    },
    /// The device of a seed.
    One {
        /// The seed.
        device_seed: u64,
    },
    /// One that is as its parameters say: nothing about it is drawn.
    AsGiven,
}

/// What was measured at a distance.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Row {
    /// The true distance.
    pub distance_m: f64,
    /// What the sensor reports: of many devices the medians.
    #[serde(flatten)]
    pub reading: Reading,
    /// For Isaac Sim's sensor, which carries the rendered depth along: what it would report if it computed depth from the
    /// disparity that it quantizes and jitters. Or the other way round where it was told to compute.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub other_reading: Option<Reading>,
    /// For Isaac Sim's sensor, one sigma of the jitter of disparity in percent of the disparity: what a pixel's depth would
    /// be off to first order.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub jitter_percent_of_disparity: Option<f64>,
    /// For Isaac Sim's sensor, the share (0 to 1) of the carried depths that computing turns into no measurement.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub invalid_if_recomputed: Option<f64>,
    /// The published accuracy here, the strictest first.
    pub bands: Vec<Band>,
    /// Whether it is kept: the strictest decides.
    pub verdict: Verdict,
}

/// One reading of the board; of many devices each figure is the median. `None` where nothing, or too little, was
/// measured.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Reading {
    /// The vendor's error: of one device with its sign, above 0 too far; of many the median of the absolute errors.
    pub error_percent: Option<f64>,
    /// The quartiles of many devices' absolute errors.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub error_quartiles_percent: Option<[f64; 2]>,
    /// Pixels with a value, 0 to 1.
    pub fill_rate: f64,
    /// Spatial noise: RMS from the fitted plane.
    pub plane_fit_rms_mm: Option<f64>,
    /// The same in disparity.
    pub subpixel_rms_px: Option<f64>,
    /// Temporal noise: the median pixel's standard deviation over time.
    pub temporal_noise_mm: Option<f64>,
    /// The standard deviation over time of the region's mean.
    pub precision_mm: Option<f64>,
    /// The signed median distance from the truth, the board's tilt taken out.
    pub z_accuracy_mm: Option<f64>,
    /// What the median pixel is off, without its sign.
    pub pixel_error_percent: Option<f64>,
}

/// How a distance compares with what is published.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// Within the band.
    Inside,
    /// The error is larger.
    Outside,
    /// Nothing is published for this distance.
    NoBand,
    /// The sensor reports nothing at this distance.
    NothingMeasured,
}

impl Verdict {
    /// As people read it.
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

/// Somebody's measurements and the twin at the same distances.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Comparison {
    /// The file.
    pub file: String,
    /// Whether the measured errors have no sign: the twin's are then compared without theirs.
    pub is_absolute: bool,
    /// Nearer points do not count.
    pub from_m: f64,
    /// The coefficient of determination of the error in percent; `None` where too little can be compared.
    pub r_squared: Option<f64>,
    /// Root mean square of the difference of the errors.
    pub rms_difference_percent: Option<f64>,
    /// How many points count.
    pub compared_points: usize,
    /// How many of them were left out since the twin reports nothing there.
    pub unmeasured_points: usize,
    /// All, in the file's order.
    pub points: Vec<ComparedPoint>,
}

/// One of somebody's measurements.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ComparedPoint {
    /// The true distance.
    pub distance_m: f64,
    /// What the file says.
    pub measured_error_percent: f64,
    /// What the twin says.
    pub twin_error_percent: Option<f64>,
}

impl Row {
    pub(super) fn new(distance_m: f64, units: &[MeasuredUnit], published: Option<&Bands>) -> Self {
        let own: Vec<Measured> = units.iter().map(|unit| unit.own).collect();
        let other: Vec<Measured> = units.iter().filter_map(|unit| unit.other).collect();
        let reading = Reading::new(&own, distance_m);
        let bands: Vec<Band> = published
            .map(|published| published.at(distance_m).into_iter().cloned().collect())
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

    /// With what the parameters of Isaac Sim's sensor say of it.
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

    /// How the other reading compares.
    #[must_use]
    pub fn other_verdict(&self) -> Option<Verdict> {
        Some(verdict(self.other_reading.as_ref()?, &self.bands))
    }
}

/// Of bands the strictest comes first.
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
        let percent = |unit: &Measured| Some(unit.vendor.error(truth_m)? * 100.0);
        let is_population = units.len() > 1;
        // A device that reports nothing is worse than any that does.
        let absolute: Vec<f64> = units
            .iter()
            .map(|unit| percent(unit).map_or(f64::INFINITY, f64::abs))
            .collect();
        let share = |share: f64| quantile(&absolute, share).filter(|error| error.is_finite());
        let quartiles = || Some([share(0.25)?, share(0.75)?]);
        Self {
            error_percent: if is_population {
                share(0.5)
            } else {
                middle(&percent)
            },
            error_quartiles_percent: if is_population { quartiles() } else { None },
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

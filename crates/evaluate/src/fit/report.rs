//! What a fit says: units are in its names, or in [`Report::unit`].

use serde::Serialize;

use oaktwin_pipeline::sensor::EngineKind;

/// The parameters of an engine, and how well they are known.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Report {
    /// The model's name.
    pub model: String,
    /// The prim of its depth sensor.
    pub sensor: String,
    /// The engine: `stereo-noise`, `time-of-flight`.
    pub engine: &'static str,
    /// Of errors and noise: px of disparity, or m of depth along the axis.
    pub unit: &'static str,
    /// What was found.
    pub parameters: Vec<Parameter>,
    /// What was not, and why.
    pub not_found: Vec<NotFound>,
    /// With which focal length it was looked, px at [`Report::width_px`]: the fitted one where it was free.
    pub focal_length_px: f64,
    /// The width of its images, px.
    pub width_px: u32,
    /// The baseline, m, of stereo.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub baseline_m: Option<f64>,
    /// The step of disparity, px, of stereo.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub step_px: Option<f64>,
    /// Whether the errors had lost their sign.
    pub is_absolute: bool,
    /// Nearer than this nothing counts, m.
    pub from_m: f64,
    /// How well the curve fits; `None` without true distances.
    pub curve: Option<Curve>,
    /// The turn of the targets, as it was put into the truth; `None` where they are perpendicular, as far as can be told.
    pub tilt_deg: Option<f64>,
    /// The files and folders.
    pub sources: Vec<String>,
    /// Of each target; empty for a curve of errors.
    pub targets: Vec<Target>,
    /// Of each distance, or each step of disparity of a target that has many.
    pub points: Vec<FittedPoint>,
    /// Whether nothing was left out or odd.
    pub passed: bool,
}

/// A fitted parameter.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Parameter {
    /// As `--param` takes it.
    pub name: &'static str,
    /// In its own unit.
    pub value: f64,
    /// Where it lies in 95 of 100 such recordings; `None` where too little was recorded to say.
    #[serde(rename = "confidence_interval_95")]
    pub interval_95: Option<[f64; 2]>,
    /// Of the value.
    pub unit: &'static str,
    /// What it is.
    #[serde(rename = "description")]
    pub what: &'static str,
    /// Whether it was measured, or given.
    pub is_fitted: bool,
}

/// A parameter that the recording does not tell.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct NotFound {
    /// As `--param` takes it.
    pub name: &'static str,
    /// Why.
    #[serde(rename = "reason")]
    pub why: String,
}

/// How well a curve fits its points.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Curve {
    /// Points that counted.
    pub points: usize,
    /// The root mean square of their deviations.
    pub rms: f64,
    /// The same, percent of the distance.
    pub rms_percent: f64,
    /// Of the errors in percent; `None` where they do not vary.
    pub r_squared: Option<f64>,
    /// The scatter of the points over that which their noise explains, 1 where it explains all; `None` where their noise is
    /// not known.
    #[serde(rename = "reduced_chi")]
    pub scatter: Option<f64>,
}

/// What was seen of one target.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Target {
    /// Its file or folder.
    pub name: String,
    /// The true distance, where it was given.
    pub distance_m: Option<f64>,
    /// Images.
    pub frames: usize,
    /// The share of the region's pixels that have a value.
    pub fill_rate: f64,
    /// The share of those that are far from all others.
    #[serde(rename = "outlier_rate")]
    pub mismatch_rate: f64,
    /// How far it is turned, by the plane through its points.
    pub tilt_deg: Option<f64>,
    /// The standard deviation of a pixel over time, with what steps add.
    pub temporal_noise: Option<f64>,
    /// What is left over space of the mean over time, px: the same in every frame.
    pub fixed_pattern: Option<f64>,
}

/// A measured error, and the curve there.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct FittedPoint {
    /// Which of [`Report::targets`], from 0; `None` of a curve of errors.
    pub target: Option<usize>,
    /// True distance.
    pub distance_m: f64,
    /// Of the measured one, above 0 it is too far.
    pub error_percent: f64,
    /// The same in [`Report::unit`]: of disparity, below 0 it is too far.
    pub error: f64,
    /// The standard error.
    #[serde(rename = "standard_error")]
    pub sigma: Option<f64>,
    /// The curve's.
    pub fitted_percent: Option<f64>,
    /// The curve's.
    pub fitted: Option<f64>,
    /// Whether it counted.
    pub is_used: bool,
}

impl Report {
    /// A fitted parameter by name.
    #[must_use]
    pub fn parameter(&self, name: &str) -> Option<&Parameter> {
        self.parameters.iter().find(|parameter| parameter.name == name)
    }

    /// For people: the unit, and how many there are to one of [`Report::unit`].
    #[must_use]
    pub fn shown_unit(&self) -> (&'static str, f64) {
        match self.unit {
            "m" => ("mm", 1e3),
            unit => (unit, 1.0),
        }
    }

    /// The engine.
    #[must_use]
    pub fn engine_kind(&self) -> Option<&'static EngineKind> {
        EngineKind::parse(self.engine).ok()
    }

    /// As a file that `--params` reads.
    #[must_use]
    pub fn toml(&self) -> String {
        let text = |text: &str| toml::Value::String(text.to_owned()).to_string();
        let mut lines = vec![
            format!(
                "# Fitted to recordings of {}: load with `oaktwin … --params FILE`.",
                self.model
            ),
            format!("engine = {}", text(self.engine)),
            String::new(),
            "[parameters]".to_owned(),
        ];
        for parameter in &self.parameters {
            let interval = match parameter.interval_95 {
                Some([low, high]) => format!(", 95 %: {} to {}", number(low), number(high)),
                None if parameter.is_fitted => String::new(),
                None => ", given".to_owned(),
            };
            lines.push(format!(
                "{} = {}  # {}: {}{interval}",
                parameter.name,
                number(parameter.value),
                parameter.unit,
                parameter.what
            ));
        }
        for missing in &self.not_found {
            lines.push(format!(
                "# {}: not found, {}",
                missing.name,
                missing.why.replace(['\n', '\r'], " ")
            ));
        }
        lines.extend([
            String::new(),
            "# For people: nothing reads what follows.".to_owned(),
            "[fit]".to_owned(),
            format!("model = {}", text(&self.model)),
            format!("sensor = {}", text(&self.sensor)),
            format!("focal_length_px = {}", number(self.focal_length_px)),
            format!("width_px = {}", self.width_px),
        ]);
        if let Some(curve) = &self.curve {
            lines.push(format!("points = {}", curve.points));
            lines.push(format!("rms_{} = {}", self.unit, number(curve.rms)));
            lines.push(format!("rms_percent = {}", number(curve.rms_percent)));
            lines.extend(curve.r_squared.map(|r2| format!("r_squared = {}", number(r2))));
            lines.push(format!("from_m = {}", number(self.from_m)));
        }
        lines.extend(self.tilt_deg.map(|tilt| format!("tilt_deg = {}", number(tilt))));
        let sources: Vec<String> = self.sources.iter().map(|source| text(source)).collect();
        lines.push(format!("sources = [{}]", sources.join(", ")));
        let intervals = self.parameters.iter().filter_map(|parameter| {
            let [low, high] = parameter.interval_95?;
            Some(format!(
                "{} = [{}, {}]",
                parameter.name,
                number(low),
                number(high)
            ))
        });
        let intervals: Vec<String> = intervals.collect();
        if !intervals.is_empty() {
            lines.extend([String::new(), "[fit.interval_95]".to_owned()]);
            lines.extend(intervals);
        }
        lines.join("\n") + "\n"
    }
}

/// With as many digits as mean something.
pub(super) fn number(value: f64) -> String {
    let digits = match value.abs() {
        size if size >= 10.0 => 2,
        size if size >= 0.01 => 5,
        _ => 7,
    };
    let text = format!("{value:.digits$}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" {
        "0".to_owned()
    } else {
        text.to_owned()
    }
}

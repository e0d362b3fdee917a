//! The results of a fit. Units are in the names, or in [`FitReport::unit`].

use serde::Serialize;

use oaktwin_pipeline::sensor::EngineKind;

/// The fitted parameters of an engine and their uncertainty.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FitReport {
    /// The name of the model.
    pub model: String,
    /// The prim of the depth sensor.
    pub sensor: String,
    /// The name of the engine: `stereo-noise` or `time-of-flight`.
    pub engine: String,
    /// The unit of errors and noise: pixels of disparity, or metres of depth along the optical axis.
    pub unit: &'static str,
    /// The fitted parameters.
    pub parameters: Vec<Parameter>,
    /// The parameters that were not fitted, with the reasons.
    pub not_found: Vec<NotFound>,
    /// The focal length in pixels at [`FitReport::width_px`]: the fitted one if it was free.
    pub focal_length_px: f64,
    /// The width of the images in pixels.
    pub width_px: u32,
    /// The baseline of a stereo camera in metres.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub baseline_m: Option<f64>,
    /// The step of disparity of a stereo camera in pixels.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub step_px: Option<f64>,
    /// Whether the errors are absolute.
    pub is_absolute: bool,
    /// The distance in metres below which errors were ignored.
    pub from_m: f64,
    /// The quality of the fit; `None` without true distances.
    pub curve: Option<FitQuality>,
    /// The rotation of the targets that was applied to the true distances; `None` if they are perpendicular within the
    /// uncertainty.
    pub tilt_deg: Option<f64>,
    /// The input files and folders.
    pub sources: Vec<String>,
    /// The targets; empty for a curve of errors.
    pub targets: Vec<TargetReport>,
    /// The points: one per distance, or one per step of disparity of an oblique target.
    pub points: Vec<FittedPoint>,
    /// Whether all parameters were fitted and nothing was reported.
    pub passed: bool,
}

/// A fitted parameter.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Parameter {
    /// The name as in `--param`.
    pub name: &'static str,
    /// The value in the parameter's unit.
    pub value: f64,
    /// The 95 % confidence interval; `None` if the recording is too small for one.
    #[serde(rename = "confidence_interval_95")]
    pub interval_95: Option<[f64; 2]>,
    /// The unit of the value.
    pub unit: &'static str,
    /// A description.
    #[serde(rename = "description")]
    pub what: &'static str,
    /// Whether the value was measured rather than given.
    pub is_fitted: bool,
}

/// A parameter that the recording does not determine.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct NotFound {
    /// The name as in `--param`.
    pub name: &'static str,
    /// The reason.
    #[serde(rename = "reason")]
    pub why: String,
}

/// The quality of a fitted curve.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct FitQuality {
    /// The number of points used.
    pub points: usize,
    /// The root mean square of the residuals.
    pub rms: f64,
    /// The root mean square of the residuals in percent of the distance.
    pub rms_percent: f64,
    /// The coefficient of determination of the errors in percent; `None` if they do not vary.
    pub r_squared: Option<f64>,
    /// The ratio of the scatter of the points to that explained by their noise, 1 if the noise explains all of it; `None` if
    /// the noise is unknown.
    #[serde(rename = "reduced_chi")]
    pub scatter: Option<f64>,
}

/// The measurements of one target.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct TargetReport {
    /// The file or folder.
    pub name: String,
    /// The true distance, if it was given.
    pub distance_m: Option<f64>,
    /// The number of images.
    pub frames: usize,
    /// The share of the region's pixels that are valid.
    pub fill_rate: f64,
    /// The share of valid pixels that are mismatches.
    #[serde(rename = "outlier_rate")]
    pub mismatch_rate: f64,
    /// The rotation of the plane through its points.
    pub tilt_deg: Option<f64>,
    /// The standard deviation of a pixel over time, including the effect of steps.
    pub temporal_noise: Option<f64>,
    /// The standard deviation over space of the mean over time: the pattern that is the same in every frame.
    pub fixed_pattern: Option<f64>,
}

/// A measured error and the fitted one.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct FittedPoint {
    /// The index in [`FitReport::targets`]; `None` for a curve of errors.
    pub target: Option<usize>,
    /// The true distance.
    pub distance_m: f64,
    /// The measured error, positive if too far.
    pub error_percent: f64,
    /// The measured error in [`FitReport::unit`]; an error of disparity is negative if too far.
    pub error: f64,
    /// The standard error.
    #[serde(rename = "standard_error")]
    pub sigma: Option<f64>,
    /// The error of the fitted curve.
    pub fitted_percent: Option<f64>,
    /// The error of the fitted curve in [`FitReport::unit`].
    pub fitted: Option<f64>,
    /// Whether the point was used.
    pub is_used: bool,
}

impl FitReport {
    /// Returns a fitted parameter by name.
    #[must_use]
    pub fn parameter(&self, name: &str) -> Option<&Parameter> {
        self.parameters.iter().find(|parameter| parameter.name == name)
    }

    /// Returns a readable unit, and its number per [`FitReport::unit`].
    #[must_use]
    pub fn shown_unit(&self) -> (&'static str, f64) {
        match self.unit {
            "m" => ("mm", 1e3),
            unit => (unit, 1.0),
        }
    }

    /// Returns the engine.
    #[must_use]
    pub fn engine_kind(&self) -> Option<&'static EngineKind> {
        EngineKind::parse(&self.engine).ok()
    }

    /// Formats the parameters as a file for `--params`.
    #[must_use]
    pub fn toml(&self) -> String {
        let text = |text: &str| toml::Value::String(text.to_owned()).to_string();
        let mut lines = vec![
            format!(
                "# Fitted to recordings of {}: load with `oaktwin … --params FILE`.",
                self.model
            ),
            format!("engine = {}", text(&self.engine)),
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
                "# {}: not fitted, {}",
                missing.name,
                missing.why.replace(['\n', '\r'], " ")
            ));
        }
        lines.extend([
            String::new(),
            "# Information only; the following is not read.".to_owned(),
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

/// Formats a number with its significant digits.
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

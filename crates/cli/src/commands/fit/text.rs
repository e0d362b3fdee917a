//! The report of `fit` as text.

use std::fmt::Write;

use oaktwin::catalog::TextTable;
use oaktwin::fit::{FitReport, FittedPoint, Parameter, TargetReport};

use crate::number::fixed;
use crate::output;

/// The maximum number of targets that are listed.
const MAX_TARGETS: usize = 40;

pub(super) fn report(report: &FitReport) -> String {
    let mut text = format!(
        "{}, {}, {}: focal length {:.2} px at {} px",
        report.model, report.sensor, report.engine, report.focal_length_px, report.width_px,
    );
    if let (Some(baseline_m), Some(step_px)) = (report.baseline_m, report.step_px) {
        let _ = write!(
            text,
            ", baseline {:.1} mm, steps of {step_px} px",
            1e3 * baseline_m
        );
    }
    text += "\n";
    if !report.targets.is_empty() {
        text += &targets(report);
    }
    let (unit, to_one) = report.shown_unit();
    text += &parameters(report);
    text += "\n";
    for missing in &report.not_found {
        let _ = writeln!(text, "Not fitted: {} ({})", missing.name, missing.why);
    }
    if let Some(curve) = &report.curve {
        let what = if report.is_absolute {
            "absolute errors"
        } else {
            "errors"
        };
        let from = if report.from_m > 0.0 {
            format!(" from {} m on", report.from_m)
        } else {
            String::new()
        };
        let r2 = curve
            .r_squared
            .map_or_else(|| "R2 is not defined".to_owned(), |r2| format!("R2 = {r2:.4}"));
        let _ = writeln!(
            text,
            "RMS residual {:.4} {unit}, {:.3} % of the distance (over {} {what}{from}); {r2}",
            to_one * curve.rms,
            curve.rms_percent,
            curve.points
        );
        if let Some(scatter) = curve.scatter {
            let _ = writeln!(
                text,
                "The points scatter {scatter:.2} times as much as their noise explains"
            );
        }
    }
    text
}

fn parameters(report: &FitReport) -> String {
    let rows = report.parameters.iter().map(|parameter| {
        let [value, low, high] = cells(parameter);
        vec![
            parameter.name.to_owned(),
            value,
            low,
            high,
            parameter.unit.to_owned(),
            parameter.what.to_owned(),
        ]
    });
    let header = ["Parameter", "Value", "95 % from", "to", "Unit", "What"];
    output::number_table(&TextTable {
        title: String::new(),
        header: header.map(str::to_owned).to_vec(),
        rows: rows.collect(),
    })
}

fn cells(parameter: &Parameter) -> [String; 3] {
    let number = |value: f64| {
        if parameter.name == "window" || parameter.name == "width" {
            format!("{value:.0}")
        } else if value.abs() >= 10.0 {
            format!("{value:.2}")
        } else if value.abs() < 0.01 {
            format!("{value:.6}")
        } else {
            format!("{value:.4}")
        }
    };
    let none = if parameter.is_fitted { "-" } else { "given" };
    let [low, high] = match parameter.interval_95 {
        Some(ends) => ends.map(number),
        None => [none.to_owned(), none.to_owned()],
    };
    [number(parameter.value), low, high]
}

fn targets(report: &FitReport) -> String {
    let (unit, to_one) = report.shown_unit();
    let header = [
        "Distance\n[m]".to_owned(),
        "\nFrames".to_owned(),
        "Fill\n[%]".to_owned(),
        "Error\n[%]".to_owned(),
        format!("Error\n[{unit}]"),
        format!("Curve\n[{unit}]"),
        format!("Temporal\n[{unit}]"),
        format!("Fixed\n[{unit}]"),
        "\nTarget".to_owned(),
    ];
    let row = |(number, target): (usize, &TargetReport)| {
        // A tilted target has a point for each of several true distances.
        let mean = |of: &dyn Fn(&FittedPoint) -> Option<f64>| {
            let points = report.points.iter().filter(|point| point.target == Some(number));
            let values: Vec<f64> = points.filter_map(of).collect();
            (!values.is_empty()).then(|| values.iter().sum::<f64>() / values.len() as f64)
        };
        vec![
            fixed(target.distance_m, 3),
            target.frames.to_string(),
            fixed(Some(100.0 * target.fill_rate), 1),
            fixed(mean(&|point| Some(point.error_percent)), 2),
            fixed(mean(&|point| Some(to_one * point.error)), 3),
            fixed(mean(&|point| Some(to_one * point.fitted?)), 3),
            fixed(target.temporal_noise.map(|noise| to_one * noise), 3),
            fixed(target.fixed_pattern.map(|noise| to_one * noise), 3),
            target.name.clone(),
        ]
    };
    let shown = report.targets.iter().enumerate().take(MAX_TARGETS);
    let mut text = output::number_table(&TextTable {
        title: String::new(),
        header: header.to_vec(),
        rows: shown.map(row).collect(),
    });
    if report.targets.len() > MAX_TARGETS {
        let _ = writeln!(text, "and {} more targets", report.targets.len() - MAX_TARGETS);
    }
    text
}

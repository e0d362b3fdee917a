//! The figure of a fit: errors, curve and residuals.

use super::method::Fitted;
use super::report::{FitReport, FittedPoint, number};
use crate::figure::{Figure, FigureAxis, FigureLayer, FigureShape};

const CURVE: [u8; 3] = [27, 94, 170];
const MEASURED: [u8; 3] = [190, 40, 70];
const LEFT_OUT: [u8; 3] = [160, 164, 170];
const INK: [u8; 3] = [60; 3];

pub(super) fn figures(report: &FitReport, found: Option<&dyn Fitted>) -> Vec<Figure> {
    let (unit, to_one) = report.shown_unit();
    let distances = || report.points.iter().map(|point| point.distance_m);
    let (near, far) = distances().fold((f64::INFINITY, 0.0f64), |(a, b), z| (a.min(z), b.max(z)));
    let x = FigureAxis {
        label: "true distance [m]".to_owned(),
        range: [0.0, (far * 1.02).max(0.1)],
    };
    let pick = |is_used: bool, of: &dyn Fn(&FittedPoint) -> Option<f64>| -> Vec<[f64; 2]> {
        let points = report.points.iter().filter(|point| point.is_used == is_used);
        points
            .filter_map(|point| Some([point.distance_m, of(point)?]))
            .collect()
    };
    let mut layers = vec![line(far, 0.0)];
    let mut heights = Vec::new();
    if let Some(found) = found {
        let (curve, band) = curve(found, report, near, far);
        if band.iter().any(|point| point[2] - point[1] > 0.0) {
            layers.push(layer("95 % of the curve", CURVE, FigureShape::Area(band)));
        }
        heights.extend(curve.iter().map(|point| point[1]));
        layers.push(layer(&name(found, report), CURVE, FigureShape::Line(curve)));
    }
    let measured = pick(true, &|point| Some(to_one * point.error));
    let left_out = pick(false, &|point| Some(to_one * point.error));
    let range = vertical(measured.iter().map(|point| point[1]).chain(heights));
    if !left_out.is_empty() {
        layers.push(layer("left out", LEFT_OUT, FigureShape::Dots(left_out)));
    }
    layers.push(layer("measured", MEASURED, FigureShape::Dots(measured)));
    let what = if report.is_absolute {
        "absolute error"
    } else {
        "error"
    };
    let (of, far_is) = if report.unit == "px" {
        ("disparity", ", negative if too far")
    } else {
        ("depth", ", positive if too far")
    };
    let side = if report.is_absolute { "" } else { far_is };
    let mut figures = vec![Figure {
        title: format!("{}: {what} of {of} over distance", report.model),
        subtitle: subtitle(report, found),
        x: x.clone(),
        y: FigureAxis {
            label: format!("{what} of {of} [{unit}]{side}"),
            range,
        },
        layers,
    }];
    figures.extend(residuals(report, &x, far));
    figures
}

/// Draws the residuals of the fitted curve, in thousandths because longer numbers do not fit beside the axis; `None` without
/// a curve. The farthest distance is `far`.
fn residuals(report: &FitReport, x: &FigureAxis, far: f64) -> Option<Figure> {
    let (unit, to_one) = report.shown_unit();
    let used = || report.points.iter().filter(|point| point.is_used);
    let left: Vec<[f64; 2]> = used()
        .filter_map(|point| Some([point.distance_m, 1e3 * to_one * (point.error - point.fitted?)]))
        .collect();
    if left.is_empty() {
        return None;
    }
    let spread: Vec<[f64; 3]> = used()
        .filter_map(|point| {
            let two = 2e3 * to_one * point.sigma?;
            Some([point.distance_m, -two, two])
        })
        .collect();
    let ends = spread.iter().flat_map(|point| [point[1], point[2]]);
    let range = vertical(left.iter().map(|point| point[1]).chain(ends));
    let mut layers = vec![line(far, 0.0)];
    if !spread.is_empty() {
        layers.push(layer(
            "two standard errors of a point",
            MEASURED,
            FigureShape::Area(spread),
        ));
    }
    layers.push(layer("measured minus fitted", MEASURED, FigureShape::Dots(left)));
    Some(Figure {
        title: "Residuals of the fitted curve".to_owned(),
        subtitle: String::new(),
        x: x.clone(),
        y: FigureAxis {
            label: format!("residual [{unit} / 1000]"),
            range,
        },
        layers,
    })
}

fn layer(label: &str, color: [u8; 3], shape: FigureShape) -> FigureLayer {
    FigureLayer {
        label: label.to_owned(),
        color,
        shape,
    }
}

fn line(far: f64, at: f64) -> FigureLayer {
    layer("", INK, FigureShape::Line(vec![[0.0, at], [2.0 * far, at]]))
}

fn curve(found: &dyn Fitted, report: &FitReport, near: f64, far: f64) -> (Vec<[f64; 2]>, Vec<[f64; 3]>) {
    let (_, to_one) = report.shown_unit();
    let error_domain = found.error_domain();
    let at = |z: f64, off: f64| {
        let value = to_one * error_domain.of_error(found.error(z) + off, z);
        if report.is_absolute { value.abs() } else { value }
    };
    let places = found.places(near, far);
    let curve = places.iter().map(|&z| [z, at(z, 0.0)]).collect();
    let band = places
        .iter()
        .filter_map(|&z| {
            let half = found.half_width(z)?;
            let ends = [at(z, half), at(z, -half)];
            Some([z, ends[0].min(ends[1]), ends[0].max(ends[1])])
        })
        .collect();
    (curve, band)
}

fn name(found: &dyn Fitted, report: &FitReport) -> String {
    let r2 = report.curve.and_then(|curve| curve.r_squared);
    let r2 = r2.map_or(String::new(), |r2| format!(", R2 = {r2:.3}"));
    format!("{}{r2}", found.name(report))
}

fn subtitle(report: &FitReport, found: Option<&dyn Fitted>) -> String {
    let noise = found.map_or(String::new(), |found| found.noise(report));
    format!(
        "{}, focal length {} px at {} px, {} points{noise}",
        report.engine,
        number(report.focal_length_px),
        report.width_px,
        report.curve.map_or(report.points.len(), |curve| curve.points)
    )
}

/// Returns the range of all values, with a margin and including 0.
fn vertical(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let (low, high) = values
        .filter(|value| value.is_finite())
        .fold((0.0f64, 0.0f64), |(low, high), value| {
            (low.min(value), high.max(value))
        });
    let room = 0.08 * (high - low).max(1e-3);
    [
        if low < 0.0 { low - room } else { 0.0 },
        if high > 0.0 || low == 0.0 {
            high + room
        } else {
            0.0
        },
    ]
}

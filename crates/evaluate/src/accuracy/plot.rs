//! The figure of error over distance.

use super::{AccuracyReport, AccuracyRow, Band, Bands, Comparison, Devices, Reading};
use crate::figure::{Figure, FigureAxis, FigureLayer, FigureShape};
use oaktwin_catalog::Source;

const CURVE: [u8; 3] = [27, 94, 170];
const SPREAD: [u8; 3] = [120, 160, 210];
const OTHER: [u8; 3] = [176, 96, 20];
const MEASURED: [u8; 3] = [190, 40, 70];
const BANDS: [[u8; 3]; 2] = [[70, 150, 90], [130, 130, 140]];

/// Draws a report. The errors are absolute if they are medians of several devices or compared with absolute measured errors.
pub(super) fn figure(report: &AccuracyReport, curve: &[AccuracyRow], is_absolute: bool) -> Figure {
    let many = report.devices.are_many();
    let is_absolute = is_absolute && (many || report.measured.is_some());
    let value = |error: Option<f64>| match error {
        Some(error) if is_absolute => error.abs(),
        Some(error) => error,
        None => f64::NAN,
    };
    let own: Vec<[f64; 2]> = curve
        .iter()
        .map(|row| [row.distance_m, value(row.reading.error_percent)])
        .collect();
    let other: Vec<[f64; 2]> = curve
        .iter()
        .filter_map(|row| Some([row.distance_m, value(row.other_reading.as_ref()?.error_percent)]))
        .collect();
    let area = |range: fn(&Reading) -> Option<[f64; 2]>| -> Vec<[f64; 3]> {
        let rows = curve.iter();
        rows.filter_map(|row| range(&row.reading).map(|[low, high]| [row.distance_m, low, high]))
            .collect()
    };
    let spread = area(|reading| reading.error_quartiles_percent);
    let band = area(|reading| reading.error_5_to_95_percent);
    let measured: Vec<[f64; 2]> = (report.measured.iter().flat_map(|measured| &measured.points))
        .map(|point| [point.distance_m, point.measured_error_percent])
        .collect();
    let far = (own.iter().chain(&measured))
        .map(|point| point[0])
        .fold(0.0, f64::max);
    let range = vertical(
        report.published.as_ref(),
        far,
        is_absolute,
        [&own, &other, &measured],
        if band.is_empty() { &spread } else { &band },
    );

    let mut layers = bands(report.published.as_ref(), range[0] < 0.0);
    let mut add = |label: String, color: [u8; 3], shape: FigureShape| {
        layers.push(FigureLayer { label, color, shape });
    };
    if !band.is_empty() {
        add(
            "5 to 95 % of the devices".to_owned(),
            SPREAD,
            FigureShape::Area(band),
        );
    }
    if !spread.is_empty() {
        let label = "the middle half of the devices".to_owned();
        add(label, CURVE, FigureShape::Area(spread));
    }
    if range[0] < 0.0 {
        let zero = vec![[0.0, 0.0], [2.0 * far, 0.0]];
        add(String::new(), [60; 3], FigureShape::Line(zero));
    }
    let names = names(report);
    add(names[0].clone(), CURVE, FigureShape::Line(own));
    if !other.is_empty() {
        add(names[1].clone(), OTHER, FigureShape::Line(other));
    }
    if let Some(comparison) = &report.measured {
        add(measured_label(comparison), MEASURED, FigureShape::Dots(measured));
    }
    Figure {
        title: format!("{}: depth error over distance", report.model),
        subtitle: subtitle(report),
        x: FigureAxis {
            label: "true distance [m]".to_owned(),
            range: [0.0, (far * 1.02).max(0.1)],
        },
        y: FigureAxis {
            label: if is_absolute {
                "absolute error of the region's median [%]".to_owned()
            } else {
                "error of the region's median [%], + is too far".to_owned()
            },
            range,
        },
        layers,
    }
}

fn measured_label(comparison: &Comparison) -> String {
    let r2 = comparison
        .r_squared
        .map_or_else(|| "not defined".to_owned(), |r2| format!("{r2:.3}"));
    let from = if comparison.from_m > 0.0 {
        format!(" from {} m", comparison.from_m)
    } else {
        String::new()
    };
    format!("measured (R2 = {r2}{from})")
}

fn names(report: &AccuracyReport) -> [String; 2] {
    if report.engine == "single-view" {
        let carried = "depth copied: exact by construction".to_owned();
        let recomputed = "depth recomputed from its disparity".to_owned();
        return if report.is_carried() {
            [carried, recomputed]
        } else {
            [recomputed, carried]
        };
    }
    let name = match report.devices {
        Devices::Population { count } => format!("median of {count} devices"),
        Devices::Factory { count } => format!("median of {count} devices of the factory population"),
        Devices::One { device_seed } => format!("the device of seed {device_seed}"),
        Devices::AsGiven => "the twin".to_owned(),
    };
    [name, String::new()]
}

fn subtitle(report: &AccuracyReport) -> String {
    let method = if report.protocol_deviations.is_empty() {
        "the vendor's method".to_owned()
    } else {
        format!(
            "not the vendor's method: {}",
            report.protocol_deviations.join(", ")
        )
    };
    format!(
        "{}, {} px at {}x{}, region {}x{} px, {} captures, {method}",
        report.engine,
        (report.focal_length_px * 10.0).round() / 10.0,
        report.image_width_px,
        report.image_height_px,
        report.region_width_px,
        report.region_height_px,
        report.captures
    )
}

/// Returns one layer for each condition, from the widest band to the narrowest.
fn bands(published: Option<&Bands>, is_signed: bool) -> Vec<FigureLayer> {
    let Some(published) = published else {
        return Vec::new();
    };
    let mut conditions: Vec<Option<&str>> = Vec::new();
    for band in &published.bands {
        if !conditions.contains(&band.condition.as_deref()) {
            conditions.push(band.condition.as_deref());
        }
    }
    let source = match published.source {
        Source::VendorPage => "the vendor's accuracy",
        Source::Estimate => "the parameter sheet's estimate (nothing is published)",
        _ => "the catalog's accuracy",
    };
    let mut layers = Vec::new();
    for (condition, color) in conditions.into_iter().zip(BANDS.into_iter().cycle()) {
        let of = published
            .bands
            .iter()
            .filter(|band| band.condition.as_deref() == condition);
        let steps = of
            .flat_map(Band::steps)
            .map(|band| {
                let low = if is_signed { -band.error_percent } else { 0.0 };
                [band.from_m, band.to_m, low, band.error_percent]
            })
            .collect();
        let label = condition.map_or_else(|| source.to_owned(), |condition| format!("{source}, {condition}"));
        layers.insert(
            0,
            FigureLayer {
                label,
                color,
                shape: FigureShape::Steps(steps),
            },
        );
    }
    layers
}

/// Returns the range of all values, limited to a multiple of the published accuracy.
fn vertical(
    published: Option<&Bands>,
    far_m: f64,
    is_absolute: bool,
    lines: [&Vec<[f64; 2]>; 3],
    spread: &[[f64; 3]],
) -> [f64; 2] {
    let bands = published.map(|bands| bands.bands.as_slice()).unwrap_or_default();
    let widest = (bands.iter().flat_map(Band::steps))
        .filter(|band| band.from_m < far_m)
        .map(|band| band.error_percent)
        .fold(0.0, f64::max);
    let values = lines.into_iter().flatten().map(|point| point[1]);
    let values = values
        .chain(spread.iter().map(|point| point[2]))
        .filter(|value| value.is_finite());
    let (low, high) = values.fold((0.0f64, 0.0f64), |(low, high), value| {
        (low.min(value), high.max(value))
    });
    let limit = if widest > 0.0 {
        40.0 * widest
    } else {
        f64::INFINITY
    };
    let high = high.max(widest).min(limit).max(1e-3) * 1.08;
    // The rounding errors of carried depth do not count as negative errors.
    let low = if is_absolute || low > -1e-3 {
        0.0
    } else {
        low.min(-widest).max(-limit) * 1.08
    };
    [low, high]
}

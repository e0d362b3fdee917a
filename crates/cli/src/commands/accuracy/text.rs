//! The report of `accuracy` as text.

use std::fmt::Write;

use oaktwin::accuracy::{Band, Comparison, Devices, Reading, Report, Row, Verdict};
use oaktwin::catalog::{Source, Table};

use crate::output;

pub(super) fn report(report: &Report) -> String {
    let mut text = heading(report);
    match report.carries_depth {
        None => text += &output::number_table(&own_table(report, String::new())),
        Some(carries) => text += &single_view(report, carries),
    }
    text += "\n";
    text += &verdict(report);
    if let Some(comparison) = &report.measured {
        text += &measured(comparison);
    }
    text
}

fn heading(report: &Report) -> String {
    let devices = match report.devices {
        Devices::Population { count } => {
            format!("the median of {count} devices (seeds 0 to {})", count - 1)
        }
        Devices::Factory { count } => format!("the median of {count} devices of the factory population"),
        Devices::One { device_seed } => format!("the device of seed {device_seed}"),
        Devices::AsGiven => "one device".to_owned(),
    };
    let method = if report.protocol_deviations.is_empty() {
        "by the vendor's method".to_owned()
    } else {
        format!(
            "not by the vendor's method ({})",
            report.protocol_deviations.join("; ")
        )
    };
    let published = match &report.published {
        None => "Published accuracy: none for this sensor".to_owned(),
        Some(bands) => {
            let source = match bands.source {
                Source::VendorPage => "the vendor's page",
                Source::Estimate => "an estimate in the parameter sheet; nothing is published",
                other => other.as_str(),
            };
            let mut conditions: Vec<&str> = Vec::new();
            for condition in bands.bands.iter().filter_map(|band| band.condition.as_deref()) {
                if !conditions.contains(&condition) {
                    conditions.push(condition);
                }
            }
            let conditions = match &conditions[..] {
                [] => String::new(),
                some => format!("\n  Bands are {}; the strictest applies", some.join(" and ")),
            };
            format!("Published accuracy: {source} ({}){conditions}", bands.measure)
        }
    };
    format!(
        "{}, {}, {}: {devices}\n\
         {}x{} px, focal length {:.1} px, disparity times depth {:.2} px m\n\
         Region of {}x{} px, {} captures: {method}\n\
         {published}\n",
        report.model,
        report.sensor,
        report.engine,
        report.image_width_px,
        report.image_height_px,
        report.focal_length_px,
        report.disparity_times_depth_px_m,
        report.region_width_px,
        report.region_height_px,
        report.captures,
    )
}

fn own_table(report: &Report, title: String) -> Table {
    let many = report.devices.are_many();
    let is_factory = matches!(report.devices, Devices::Factory { .. });
    let header = [
        "Distance\n[m]",
        "Error\n[%]",
        if is_factory {
            "5 to 95 %\n[%]"
        } else {
            "Quartiles\n[%]"
        },
        "Fill\n[%]",
        "Plane\nRMS [mm]",
        "Subpixel\n[px]",
        "Temporal\n[mm]",
        "Precision\n[mm]",
        "Z off\n[mm]",
        "Band\n[%]",
        "\nVerdict",
    ];
    let rows = report.distances.iter().map(|row| {
        let reading = &row.reading;
        vec![
            distance(row),
            error(reading, many),
            quartiles(reading),
            fixed(Some(reading.fill_rate * 100.0), 1),
            fixed(reading.plane_fit_rms_mm, 2),
            fixed(reading.subpixel_rms_px, 3),
            fixed(reading.temporal_noise_mm, 2),
            fixed(reading.precision_mm, 2),
            signed(reading.z_accuracy_mm, 1),
            band(row),
            row.verdict.as_str().to_owned(),
        ]
    });
    without_column(
        Table {
            title,
            header: header.map(str::to_owned).to_vec(),
            rows: rows.collect(),
        },
        (!many).then_some(2),
    )
}

fn single_view(report: &Report, carries: bool) -> String {
    let [carried, recomputed] = [
        "Depth copied from the rendering: exact by construction; only its position is wrong",
        "Depth recomputed from the quantized and jittered disparity",
    ];
    let [own, other] = if carries {
        [carried, recomputed]
    } else {
        [recomputed, carried]
    };
    let own = format!("\nOutput of this sensor. {own}");
    let other = format!("\nAlternative interpretation. {other}");
    let mut text = output::number_table(&reading_table(report, own, !carries, |row| {
        Some((&row.reading, row.verdict))
    }));
    text += &output::number_table(&reading_table(report, other, carries, |row| {
        Some((row.other_reading.as_ref()?, row.other_verdict()?))
    }));
    text
}

/// Returns the table of one reading of Isaac Sim's sensor. If depth is recomputed, it includes the jitter and the invalid share.
fn reading_table<'a>(
    report: &'a Report,
    title: String,
    is_recomputed: bool,
    reading: impl Fn(&'a Row) -> Option<(&'a Reading, Verdict)>,
) -> Table {
    let mut header = vec!["Distance\n[m]", "Error\n[%]", "Pixel error\n[%]"];
    if is_recomputed {
        header.extend(["Jitter of d\n[%]", "Invalid\n[%]"]);
    }
    header.extend([
        "Fill\n[%]",
        "Subpixel\n[px]",
        "Temporal\n[mm]",
        "Band\n[%]",
        "\nVerdict",
    ]);
    let rows = report.distances.iter().filter_map(|row| {
        let (reading, verdict) = reading(row)?;
        let mut cells = vec![
            distance(row),
            error(reading, false),
            fixed(reading.pixel_error_percent, 2),
        ];
        if is_recomputed {
            cells.push(fixed(row.jitter_percent_of_disparity, 2));
            cells.push(fixed(row.invalid_if_recomputed.map(|share| share * 100.0), 1));
        }
        cells.extend([
            fixed(Some(reading.fill_rate * 100.0), 1),
            fixed(reading.subpixel_rms_px, 3),
            fixed(reading.temporal_noise_mm, 1),
            band(row),
            verdict.as_str().to_owned(),
        ]);
        Some(cells)
    });
    Table {
        title,
        header: header.into_iter().map(str::to_owned).collect(),
        rows: rows.collect(),
    }
}

fn without_column(mut table: Table, column: Option<usize>) -> Table {
    if let Some(column) = column {
        for cells in std::iter::once(&mut table.header).chain(&mut table.rows) {
            cells.remove(column);
        }
    }
    table
}

fn verdict(report: &Report) -> String {
    let of = |verdict: Verdict| -> Vec<&Row> {
        report
            .distances
            .iter()
            .filter(|row| row.verdict == verdict)
            .collect()
    };
    let (inside, outside) = (of(Verdict::Inside), of(Verdict::Outside));
    let judged = inside.len() + outside.len();
    let mut text = match (inside.len(), outside.len()) {
        (0, 0) => "No verdict: no distance has both a measurement and a published accuracy.\n".to_owned(),
        (_, 0) => format!("Inside the published accuracy at {}.\n", all_of(judged)),
        (_, out) => {
            let places: Vec<String> = outside.iter().take(8).map(|row| distance(row)).collect();
            let more = if out > places.len() { ", …" } else { "" };
            format!(
                "OUTSIDE the published accuracy at {out} of {}: {}{more} m.\n",
                count(judged, "distance"),
                places.join(", ")
            )
        }
    };
    if report.is_carried() {
        let other = |verdict| {
            report
                .distances
                .iter()
                .filter(|row| row.other_verdict() == Some(verdict))
                .count()
        };
        let (inside, outside) = (other(Verdict::Inside), other(Verdict::Outside));
        if inside + outside > 0 {
            let _ = writeln!(
                text,
                "This is true by construction; depth recomputed from disparity would be outside at {outside} of {}.",
                inside + outside
            );
        }
    }
    let nothing = of(Verdict::NothingMeasured).len();
    if nothing > 0 {
        let _ = writeln!(
            text,
            "The sensor measures nothing at {}.",
            count(nothing, "distance")
        );
    }
    text
}

fn all_of(number: usize) -> String {
    match number {
        1 => "the one distance".to_owned(),
        _ => format!("all {number} distances"),
    }
}

fn count(number: usize, what: &str) -> String {
    if number == 1 {
        format!("1 {what}")
    } else {
        format!("{number} {what}s")
    }
}

fn measured(comparison: &Comparison) -> String {
    let from = if comparison.from_m > 0.0 {
        format!(" from {} m", comparison.from_m)
    } else {
        String::new()
    };
    let what = if comparison.is_absolute {
        "absolute error"
    } else {
        "error"
    };
    let r2 = comparison
        .r_squared
        .map_or_else(|| "is not defined".to_owned(), |r2| format!("= {r2:.4}"));
    let rms = comparison
        .rms_difference_percent
        .map_or_else(String::new, |rms| format!(", RMS difference {rms:.3} %"));
    let mut text = format!(
        "{}: R2 of the {what} in percent {r2} over {}{from}{rms}\n",
        comparison.file,
        count(comparison.compared_points, "point"),
    );
    if comparison.unmeasured_points > 0 {
        let _ = writeln!(
            text,
            "  {} ignored, where the twin measures nothing",
            count(comparison.unmeasured_points, "point")
        );
    }
    text
}

fn distance(row: &Row) -> String {
    let text = format!("{:.3}", row.distance_m);
    let whole = text.trim_end_matches('0');
    let digits = whole.len().max(text.len() - 1);
    text[..digits].to_owned()
}

/// Formats an error. The error of several devices is absolute and has no sign.
fn error(reading: &Reading, many: bool) -> String {
    if many {
        fixed(reading.error_percent, 2)
    } else {
        signed(reading.error_percent, 2)
    }
}

fn quartiles(reading: &Reading) -> String {
    reading
        .error_5_to_95_percent
        .or(reading.error_quartiles_percent)
        .map_or_else(|| "-".to_owned(), |[low, high]| format!("{low:.2}-{high:.2}"))
}

fn band(row: &Row) -> String {
    if row.bands.is_empty() {
        return "-".to_owned();
    }
    let one = |band: &Band| {
        let text = format!("{:.2}", band.error_percent);
        format!("<{}", text.trim_end_matches('0').trim_end_matches('.'))
    };
    row.bands.iter().map(one).collect::<Vec<_>>().join(" ")
}

fn fixed(value: Option<f64>, digits: usize) -> String {
    value.map_or_else(|| "-".to_owned(), |value| format!("{value:.digits$}"))
}

fn signed(value: Option<f64>, digits: usize) -> String {
    value.map_or_else(
        || "-".to_owned(),
        |value| {
            let text = format!("{value:+.digits$}");
            // Zero has no sign.
            if text.trim_start_matches(['+', '-', '0', '.']).is_empty() {
                text.replacen(['+', '-'], "", 1)
            } else {
                text
            }
        },
    )
}

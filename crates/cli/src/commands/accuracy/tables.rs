//! The tables of `accuracy`.

use oaktwin::accuracy::{AccuracyReport, AccuracyRow, Devices, Reading, Verdict};
use oaktwin::catalog::TextTable;

use super::cells::{band, distance, error, quartiles};
use crate::number::{fixed, signed};
use crate::output;

pub(super) fn distance_table(report: &AccuracyReport, title: String) -> TextTable {
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
        TextTable {
            title,
            header: header.map(str::to_owned).to_vec(),
            rows: rows.collect(),
        },
        (!many).then_some(2),
    )
}

pub(super) fn single_view(report: &AccuracyReport, carries: bool) -> String {
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
    report: &'a AccuracyReport,
    title: String,
    is_recomputed: bool,
    reading: impl Fn(&'a AccuracyRow) -> Option<(&'a Reading, Verdict)>,
) -> TextTable {
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
    TextTable {
        title,
        header: header.into_iter().map(str::to_owned).collect(),
        rows: rows.collect(),
    }
}

fn without_column(mut table: TextTable, column: Option<usize>) -> TextTable {
    if let Some(column) = column {
        for cells in std::iter::once(&mut table.header).chain(&mut table.rows) {
            cells.remove(column);
        }
    }
    table
}

//! Whether an accuracy is the published one, and how it compares with a measured one.

use std::fmt::Write;

use oaktwin::accuracy::{AccuracyReport, AccuracyRow, Comparison, Verdict};

use super::cells::distance;

pub(super) fn text(report: &AccuracyReport) -> String {
    let of = |verdict: Verdict| -> Vec<&AccuracyRow> {
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

pub(super) fn measured(comparison: &Comparison) -> String {
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

//! How costs grow with triangles, pixels, instances, disparities, frames and threads.

use std::collections::BTreeMap;
use std::process::Command;

use super::median;
use super::turns::{lines, program};
use crate::workspace::output;

#[derive(clap::Args)]
pub(crate) struct Args {
    /// Frames per point
    #[arg(long, default_value_t = 9)]
    frames: u32,
    /// Only these axes
    axes: Vec<String>,
}

/// Runs the benchmark and prints a table per axis.
pub(crate) fn run(args: &Args) -> Result<(), String> {
    let own = program("scaling-bench")?;
    let mut axes = args.axes.clone();
    if axes.is_empty() {
        axes = output(Command::new(&own).arg("axes"))?
            .lines()
            .map(str::to_owned)
            .collect();
    }
    println!(
        "Medians of {} frames: processor time on one thread, except elapsed time for threads",
        args.frames
    );
    for axis in &axes {
        // Each axis starts with fresh memory.
        let mut command = Command::new(&own);
        let text = output(command.arg(axis).arg(args.frames.to_string()))?;
        print(axis, &text);
    }
    Ok(())
}

fn print(axis: &str, text: &str) {
    let mut points: Vec<u64> = Vec::new();
    let mut rows: Vec<(String, BTreeMap<u64, f64>)> = Vec::new();
    for line in lines(text) {
        let (Some(what), Some(at)) = (line["what"].as_str(), line["at"].as_u64()) else {
            continue;
        };
        let values = line["values"].as_array().into_iter().flatten();
        let value = median(values.filter_map(serde_json::Value::as_f64).collect());
        if !points.contains(&at) {
            points.push(at);
        }
        match rows.iter_mut().find(|(known, _)| known == what) {
            Some((_, row)) => _ = row.insert(at, value),
            None => rows.push((what.to_owned(), BTreeMap::from([(at, value)]))),
        }
    }
    let columns: Vec<String> = points.iter().map(ToString::to_string).collect();
    println!("\n| {axis} | {} | last / first |", columns.join(" | "));
    println!("|---|{}", "---:|".repeat(points.len() + 1));
    for (what, row) in rows {
        let of = |at: Option<&u64>| at.and_then(|at| row.get(at)).copied().unwrap_or(f64::NAN);
        let cells: Vec<String> = points.iter().map(|at| shown(of(Some(at)))).collect();
        let growth = of(points.last()) / of(points.first());
        println!("| {what} | {} | {} |", cells.join(" | "), shown(growth));
    }
}

/// Returns a number with about three digits.
fn shown(value: f64) -> String {
    let decimals = match value.abs() {
        small if small < 10.0 => 2,
        medium if medium < 100.0 => 1,
        _ => 0,
    };
    format!("{value:.decimals$}")
}

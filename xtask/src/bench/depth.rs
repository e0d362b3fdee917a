//! The engines and filters, compared with NumPy implementations and DepthAI's own filters.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;

use serde_json::Value;

use super::median;
use super::turns::{Script, Times, lines, program};
use crate::python::CURRENT;
use crate::workspace::{self, output};

#[derive(clap::Args)]
pub(crate) struct Args {
    /// Number of rounds
    #[arg(long, default_value_t = 3)]
    rounds: usize,
    /// Frames per turn
    #[arg(long, default_value_t = 20)]
    frames: usize,
    /// Run only cases whose name contains this
    #[arg(long, default_value = "")]
    case: String,
    /// Skip NumPy and DepthAI
    #[arg(long)]
    no_python: bool,
}

/// One of our cases on a number of threads, or a peer's.
#[derive(Default)]
struct Case {
    by_threads: BTreeMap<u64, Times>,
    peers: BTreeMap<String, Times>,
    pixels: f64,
    bytes: f64,
}

const THREADS: [u64; 2] = [1, 2];

/// Runs the benchmark and prints its table.
pub(crate) fn run(args: &Args) -> Result<(), String> {
    let own = program("depth-bench")?;
    let folder = workspace::target().join("bench-depth");
    output(Command::new(&own).arg("make").arg(&folder))?;
    let peers = if args.no_python {
        None
    } else {
        Some(Script::new(&CURRENT, "bench_depth.py")?)
    };

    let mut names: Vec<String> = Vec::new();
    let mut cases: BTreeMap<String, Case> = BTreeMap::new();
    let mut bandwidths: BTreeMap<u64, Vec<f64>> = BTreeMap::new();
    for _ in 0..args.rounds.max(1) {
        for threads in THREADS {
            for line in own_lines(&own, args, threads)? {
                if let Some(bandwidth) = line["bytes_a_second"].as_f64() {
                    bandwidths.entry(threads).or_default().push(bandwidth);
                    continue;
                }
                let name = line["case"].as_str().unwrap_or_default().to_owned();
                if !names.contains(&name) {
                    names.push(name.clone());
                }
                let case = cases.entry(name).or_default();
                case.pixels = line["pixels"].as_f64().unwrap_or(f64::NAN);
                case.bytes = line["bytes"].as_f64().unwrap_or(f64::NAN);
                case.by_threads.entry(threads).or_default().take(&line);
            }
        }
        let peer_lines = match &peers {
            Some(peers) => lines(&output(peers.command().arg(&folder).arg(&args.case))?),
            None => Vec::new(),
        };
        for line in peer_lines {
            let text = |key: &str| line[key].as_str().unwrap_or_default().to_owned();
            if let Some(case) = cases.get_mut(&text("case")) {
                case.peers.entry(text("peer")).or_default().take(&line);
            }
        }
    }
    println!(
        "1280 × 800, medians of {} rounds of {} frames, in turns\n",
        args.rounds, args.frames
    );
    print_bandwidth(bandwidths);
    print_cases(&names, cases);
    Ok(())
}

fn own_lines(own: &Path, args: &Args, threads: u64) -> Result<Vec<Value>, String> {
    let mut command = Command::new(own);
    command
        .arg("run")
        .arg(args.frames.to_string())
        .arg(threads.to_string())
        .arg(&args.case);
    Ok(lines(&output(&mut command)?))
}

/// The bandwidth of copying memory, reads and writes together.
fn print_bandwidth(bandwidths: BTreeMap<u64, Vec<f64>>) {
    for (threads, values) in bandwidths {
        let least = 8.0 * 1280.0 * 800.0;
        let bandwidth = median(values);
        println!(
            "memory, {threads} thread{}: {:.1} GB/s copied; it could move a float32 image in and one out {:.0} times a second",
            if threads == 1 { "" } else { "s" },
            bandwidth / 1e9,
            bandwidth / least
        );
    }
}

fn print_cases(names: &[String], mut cases: BTreeMap<String, Case>) {
    println!(
        "\n| | 1 thread, ms (frames/s) | 2 threads, ms (frames/s) | Gpixel/s | GB/s | peer | its ms | ratio, clock (processor) |"
    );
    println!("|---|---:|---:|---:|---:|---|---:|---:|");
    for name in names {
        let Some(mut case) = cases.remove(name) else {
            continue;
        };
        let mut times = |threads: u64| case.by_threads.remove(&threads).unwrap_or_default().medians();
        let ((one, one_cpu), (two, _)) = (times(1), times(2));
        let rate = |seconds: f64| format!("{:.2} ({:.0})", seconds * 1e3, 1.0 / seconds);
        let own = format!(
            "| {name} | {} | {} | {:.2} | {:.1} |",
            rate(one),
            rate(two),
            case.pixels / two / 1e9,
            case.bytes / one / 1e9
        );
        if case.peers.is_empty() {
            println!("{own} | | |");
        }
        for (peer, times) in case.peers {
            let (wall, cpu) = times.medians();
            println!(
                "{own} {peer} | {:.1} | {:.1} x ({:.1}) |",
                wall * 1e3,
                wall / one,
                cpu / one_cpu
            );
        }
    }
}

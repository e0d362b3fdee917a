//! The stereo matcher against OpenCV's semi-global matching, on one thread and on two.

use std::collections::BTreeMap;
use std::process::Command;

use serde_json::Value;

use super::median;
use crate::python::{ENVIRONMENTS, Interpreter};
use crate::workspace::{self, output};

#[derive(clap::Args)]
pub(crate) struct Args {
    /// How often everybody takes a turn
    #[arg(long, default_value_t = 3)]
    rounds: usize,
    /// Frames of a turn
    #[arg(long, default_value_t = 10)]
    frames: usize,
    /// Leave OpenCV out
    #[arg(long)]
    no_python: bool,
}

/// Our cases: what they are called, and what is set.
const CASES: [(&str, &[&str]); 5] = [
    ("8 paths", &["paths=8"]),
    ("5 paths", &["paths=5"]),
    ("4 paths", &["paths=4"]),
    ("8 paths, 24 bits of census", &["paths=8", "kernelMask=0xFFFFFF"]),
    (
        "8 paths, extended, 5 bits",
        &["paths=8", "extendedDisparity=true", "subpixelFractionalBits=5"],
    ),
];

const THREADS: [&str; 2] = ["1", "2"];

/// Seconds a frame by the clock, of processor time, and the most memory.
#[derive(Default)]
struct Times {
    wall: Vec<f64>,
    cpu: Vec<f64>,
    peak_bytes: f64,
}

/// Measures and prints.
pub(crate) fn run(args: &Args) -> Result<(), String> {
    let package = [
        "--release",
        "--package",
        "oaktwin-testkit",
        "--no-default-features",
    ];
    let mut programs = workspace::build(&[&package[..], &["--bin", "stereo-bench"]].concat())?;
    let own = programs
        .remove("stereo-bench")
        .ok_or("cargo built no program named stereo-bench")?;
    let folder = workspace::target().join("bench-stereo");
    output(Command::new(&own).arg("make").arg(&folder))?;
    let python = if args.no_python {
        None
    } else {
        let [current, _] = &ENVIRONMENTS;
        Some(current.prepare(current.choose(&Interpreter::find_all())?)?)
    };

    let mut names: Vec<String> = Vec::new();
    let mut all: BTreeMap<(String, &str), Times> = BTreeMap::new();
    for _ in 0..args.rounds.max(1) {
        for threads in THREADS {
            for (name, settings) in CASES {
                let mut command = Command::new(&own);
                command
                    .arg("run")
                    .arg(args.frames.to_string())
                    .arg(threads)
                    .args(settings);
                take(&mut names, &mut all, name, threads, &output(&mut command)?);
            }
            if let Some(python) = &python {
                let mut command = Command::new(python);
                command
                    .arg(workspace::root().join("tests/oracles/bench_stereo.py"))
                    .args([folder.as_os_str(), threads.as_ref()])
                    .arg(args.frames.to_string())
                    .env_remove("PYTHONPATH")
                    .env_remove("PYTHONHOME");
                take(&mut names, &mut all, "OpenCV", threads, &output(&mut command)?);
            }
        }
    }
    println!(
        "1280 × 800, 96 disparities, 8 bits, 3 subpixel bits; medians of {} rounds of {} frames, in turns\n",
        args.rounds, args.frames
    );
    print(&names, all);
    Ok(())
}

fn take<'a>(
    names: &mut Vec<String>,
    all: &mut BTreeMap<(String, &'a str), Times>,
    name: &str,
    threads: &'a str,
    text: &str,
) {
    let lines = text
        .lines()
        .filter_map(|line| serde_json::from_str::<Value>(line).ok());
    for line in lines {
        let name = line["peer"].as_str().unwrap_or(name).to_owned();
        if !names.contains(&name) {
            names.push(name.clone());
        }
        let times = all.entry((name, threads)).or_default();
        let numbers = |key: &str| {
            let list = line[key].as_array().cloned().unwrap_or_default();
            list.into_iter().filter_map(|value| value.as_f64())
        };
        times.wall.extend(numbers("wall_s"));
        times.cpu.extend(numbers("cpu_s"));
        times.peak_bytes = times.peak_bytes.max(line["peak_bytes"].as_f64().unwrap_or(0.0));
    }
}

/// What everything is compared with.
const PEER: &str = "OpenCV, 8 paths";

fn print(names: &[String], mut all: BTreeMap<(String, &str), Times>) {
    let mut numbers = BTreeMap::new();
    for ((name, threads), times) in std::mem::take(&mut all) {
        numbers.insert(
            (name, threads),
            (median(times.wall), median(times.cpu), times.peak_bytes),
        );
    }
    let of = |name: &str, threads: &'static str| {
        let none = (f64::NAN, f64::NAN, f64::NAN);
        numbers.get(&(name.to_owned(), threads)).copied().unwrap_or(none)
    };
    let (peer, peer_cpu, _) = of(PEER, "1");
    println!(
        "| | 1 thread, ms (processor) | 2 threads, ms | frames/s on 2 | second thread's efficiency | {PEER} on 1 thread is slower by (processor) | peak memory |"
    );
    println!("|---|---:|---:|---:|---:|---:|---:|");
    for name in names {
        let ((one, one_cpu, _), (two, _, peak)) = (of(name, "1"), of(name, "2"));
        println!(
            "| {name} | {:.1} ({:.1}) | {:.1} | {:.0} | {:.2} | {:.1} x ({:.1}) | {:.0} MB |",
            one * 1e3,
            one_cpu * 1e3,
            two * 1e3,
            1.0 / two,
            one / two / 2.0,
            peer / one,
            peer_cpu / one_cpu,
            peak / 1e6
        );
    }
}

//! The stereo matcher, alone and called from Python, compared with OpenCV's semi-global matching on one and two threads.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;

use super::turns::{Script, Times, lines, program};
use crate::python::{CURRENT, PACKAGE, build_wheel};
use crate::workspace::{self, output};

#[derive(clap::Args)]
pub(crate) struct Args {
    /// Number of rounds
    #[arg(long, default_value_t = 3)]
    rounds: usize,
    /// Frames per turn
    #[arg(long, default_value_t = 10)]
    frames: usize,
    /// Skip OpenCV and the calls from Python
    #[arg(long)]
    no_python: bool,
}

/// Our cases: their names and parameters.
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

/// Runs the benchmark and prints its table.
pub(crate) fn run(args: &Args) -> Result<(), String> {
    let own = program("stereo-bench")?;
    let folder = workspace::target().join("bench-stereo");
    output(Command::new(&own).arg("make").arg(&folder))?;
    let peer = if args.no_python {
        None
    } else {
        Some((Script::new(&CURRENT, "bench_stereo.py")?, package(&folder)?))
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
            if let Some((peer, package)) = &peer {
                let mut command = peer.command();
                command
                    .env("PYTHONPATH", package)
                    .env("RAYON_NUM_THREADS", threads);
                command
                    .args([folder.as_os_str(), threads.as_ref()])
                    .arg(args.frames.to_string());
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

/// Builds our Python package and returns the folder that it is installed in.
fn package(folder: &Path) -> Result<PathBuf, String> {
    let python = PACKAGE.ready()?;
    let wheel = build_wheel(&python, "release")?;
    let package = folder.join("package");
    let mut install = Command::new(&python);
    install.args(["-m", "pip", "install", "--disable-pip-version-check"]);
    install.args(["--no-deps", "--upgrade", "--target"]);
    output(install.arg(&package).arg(wheel))?;
    Ok(package)
}

fn take<'a>(
    names: &mut Vec<String>,
    all: &mut BTreeMap<(String, &'a str), Times>,
    name: &str,
    threads: &'a str,
    text: &str,
) {
    for line in lines(text) {
        let name = line["peer"].as_str().unwrap_or(name).to_owned();
        if !names.contains(&name) {
            names.push(name.clone());
        }
        all.entry((name, threads)).or_default().take(&line);
    }
}

/// The peer that defines the ratios.
const PEER: &str = "OpenCV, 8 paths";

fn print(names: &[String], all: BTreeMap<(String, &str), Times>) {
    let mut numbers = BTreeMap::new();
    for ((name, threads), times) in all {
        let peak_bytes = times.peak_bytes;
        let (wall, cpu) = times.medians();
        numbers.insert((name, threads), (wall, cpu, peak_bytes));
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

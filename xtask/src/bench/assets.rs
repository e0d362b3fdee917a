//! Writing all five assets with the library, the program, and OpenUSD in Python, in turns.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Instant;

use super::median;
use super::turns::Script;
use crate::python::CURRENT;
use crate::workspace::{self, output};

#[derive(clap::Args)]
pub(crate) struct Args {
    /// Print the medians and ratios as JSON
    #[arg(long)]
    json: bool,
    /// Number of rounds
    #[arg(long, default_value_t = 15)]
    rounds: u32,
}

/// Repetitions in a process that excludes its own start; the first is its warm-up.
const RUNS_IN_PROCESS: usize = 20;

/// The programs measured.
struct Contestants {
    library: PathBuf,
    program: PathBuf,
    peer: Script,
}

/// Medians, in seconds.
struct Medians {
    library: f64,
    program: f64,
    python_inside: f64,
    python_whole: f64,
}

/// Runs the benchmark and prints its table.
pub(crate) fn run(args: &Args) -> Result<(), String> {
    let contestants = Contestants::build()?;
    let folder = workspace::target().join("bench-assets");
    let medians = contestants.measure(args.rounds.max(1), &folder)?;
    if args.json {
        println!("{}", medians.json());
    } else {
        medians.print(args.rounds.max(1));
    }
    Ok(())
}

impl Contestants {
    fn build() -> Result<Self, String> {
        let what = [
            "--release",
            "--workspace",
            "--bin",
            "oaktwin",
            "--example",
            "time_assets",
        ];
        let mut programs = workspace::build(&what)?;
        let mut take = |name| {
            programs
                .remove(name)
                .ok_or(format!("cargo built no program named {name}"))
        };
        let (program, library) = (take("oaktwin")?, take("time_assets")?);
        Ok(Self {
            library,
            program,
            peer: Script::new(&CURRENT, "bench_assets.py")?,
        })
    }

    /// Runs each program once per round, so that a change of the machine's speed affects all of them.
    fn measure(&self, rounds: u32, folder: &Path) -> Result<Medians, String> {
        let (mut library, mut program) = (Vec::new(), Vec::new());
        let (mut python_inside, mut python_whole) = (Vec::new(), Vec::new());
        for _ in 0..rounds {
            library.push(inside(
                Command::new(&self.library).arg(empty(folder, "library")?),
            )?);
            let into = empty(folder, "program")?;
            program.push(whole(
                Command::new(&self.program)
                    .args(["asset", "sheet", "-o"])
                    .arg(into),
            )?);
            python_inside.push(inside(self.peer.command().arg(empty(folder, "python")?))?);
            python_whole.push(whole(self.peer.command().arg(empty(folder, "python")?).arg("1"))?);
        }
        Ok(Medians {
            library: median(library),
            program: median(program),
            python_inside: median(python_inside),
            python_whole: median(python_whole),
        })
    }
}

impl Medians {
    fn print(&self, rounds: u32) {
        println!("All five assets written as text, median of {rounds} rounds in turns:\n");
        println!("| what is timed | OpenUSD in Python | oaktwin | ratio |");
        println!("|---|---:|---:|---:|");
        let row = |what: &str, peer: f64, own: f64| {
            println!(
                "| {what} | {:.2} ms | {:.2} ms | {:.1} x |",
                peer * 1e3,
                own * 1e3,
                peer / own
            );
        };
        row(
            "the work alone, in a process that has started and warmed up",
            self.python_inside,
            self.library,
        );
        row(
            "the whole command, from start to exit",
            self.python_whole,
            self.program,
        );
    }

    fn json(&self) -> serde_json::Value {
        serde_json::json!({
            "library_s": self.library,
            "program_s": self.program,
            "python_inside_s": self.python_inside,
            "python_whole_s": self.python_whole,
            "ratio_inside": self.python_inside / self.library,
            "ratio_whole": self.python_whole / self.program,
        })
    }
}

/// An empty folder for one run.
fn empty(folder: &Path, name: &str) -> Result<PathBuf, String> {
    let place = folder.join(name);
    let failed = |error: std::io::Error| format!("{}: {error}", place.display());
    if place.exists() {
        std::fs::remove_dir_all(&place).map_err(failed)?;
    }
    std::fs::create_dir_all(&place).map_err(failed)?;
    Ok(place)
}

/// The seconds from a process's start to its exit.
fn whole(command: &mut Command) -> Result<f64, String> {
    command.stdin(Stdio::null());
    let start = Instant::now();
    output(command)?;
    Ok(start.elapsed().as_secs_f64())
}

/// Returns the median of the times that a process prints, one per line in seconds; the first is its warm-up.
fn inside(command: &mut Command) -> Result<f64, String> {
    let text = output(command.arg(RUNS_IN_PROCESS.to_string()))?;
    let times: Vec<f64> = text
        .lines()
        .skip(1)
        .filter_map(|line| line.trim().parse().ok())
        .collect();
    if times.len() + 1 == RUNS_IN_PROCESS {
        Ok(median(times))
    } else {
        Err(format!("unexpected output: {text}"))
    }
}

//! Opening USD stages, compared with OpenUSD in Python; then the cost of colour relative to depth.

use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::Value;

use super::median;
use super::turns::{Script, Times, lines};
use crate::python::CURRENT;
use crate::workspace::{self, output};

#[derive(clap::Args)]
pub(crate) struct Args {
    /// Number of rounds
    #[arg(long, default_value_t = 5)]
    rounds: usize,
}

/// A stage, and the number of its frames to render afterwards.
struct Stage {
    title: &'static str,
    file: PathBuf,
    frames: usize,
}

/// A program that opens stages, and its repetitions per process; the first is its warm-up.
struct Loaders {
    own: PathBuf,
    peer: Script,
}

const OPENINGS: usize = 3;

/// Runs the benchmark and prints its table.
pub(crate) fn run(args: &Args) -> Result<(), String> {
    let package = ["--release", "--package", "oaktwin-testkit"];
    let loaders = Loaders {
        own: workspace::build_program("load-bench", &package)?,
        peer: Script::new(&CURRENT, "bench_load.py")?,
    };
    let folder = workspace::target().join("bench-load");
    std::fs::create_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    output(loaders.peer.command().arg("make").arg(&folder))?;

    println!(
        "Opening and extracting, medians of {} rounds in turns; in parentheses the ratio of processor times\n",
        args.rounds
    );
    println!(
        "| stage | triangles | OpenUSD in Python, triangles | arrays as stored | oaktwin | ratio | to arrays |"
    );
    println!("|---|---:|---:|---:|---:|---:|---:|");
    let mut frames = Vec::new();
    for stage in stages(&folder) {
        if stage.file.exists() {
            frames.extend(loaders.compare(&stage, args.rounds)?);
        } else {
            println!("skipped: {}: set OAKTWIN_TEST_DATA", stage.title);
        }
    }
    print_frames(&frames);
    Ok(())
}

fn stages(folder: &Path) -> Vec<Stage> {
    let data = PathBuf::from(std::env::var_os("OAKTWIN_TEST_DATA").unwrap_or_default());
    let stage = |title, file, frames| Stage { title, file, frames };
    vec![
        stage(
            "Open Chess Set",
            data.join("data/scenes/OpenChessSet/chess_set.usda"),
            10,
        ),
        stage("1 M quads, binary", folder.join("quads.usdc"), 0),
        stage("1 M quads, text", folder.join("quads.usda"), 0),
        stage(
            "90 000 prims, 10 000 references",
            folder.join("references.usda"),
            0,
        ),
    ]
}

impl Loaders {
    /// Opens a stage in turns, prints its row, and returns what the last round rendered.
    fn compare(&self, stage: &Stage, rounds: usize) -> Result<Vec<Value>, String> {
        let mut own = Times::default();
        let mut peers = ["triangles", "arrays"].map(|what| (what, Times::default()));
        let mut last = Vec::new();
        for _ in 0..rounds.max(1) {
            let mut command = Command::new(&self.own);
            command
                .arg(&stage.file)
                .args([OPENINGS, stage.frames].map(|n| n.to_string()));
            last = lines(&output(&mut command)?);
            last.iter().take(OPENINGS).skip(1).for_each(|line| own.take(line));
            for (what, peer) in &mut peers {
                let mut python = self.peer.command();
                python.arg(what).arg(&stage.file).arg(OPENINGS.to_string());
                let opened = lines(&output(&mut python)?);
                opened.iter().skip(1).for_each(|line| peer.take(line));
            }
        }
        let triangles = last
            .first()
            .map_or(0, |line| line["triangles"].as_u64().unwrap_or(0));
        let (own_wall, own_cpu) = own.medians();
        let [(triangles_wall, triangles_cpu), (arrays_wall, arrays_cpu)] =
            peers.map(|(_, times)| times.medians());
        println!(
            "| {} | {triangles} | {:.1} ms | {:.1} ms | {:.1} ms | {:.2} x ({:.2}) | {:.2} x ({:.2}) |",
            stage.title,
            triangles_wall * 1e3,
            arrays_wall * 1e3,
            own_wall * 1e3,
            triangles_wall / own_wall,
            triangles_cpu / own_cpu,
            arrays_wall / own_wall,
            arrays_cpu / own_cpu
        );
        Ok(last.split_off(OPENINGS.min(last.len())))
    }
}

/// Compares colour with depth for the same view, in turns.
fn print_frames(frames: &[Value]) {
    if frames.is_empty() {
        return;
    }
    let middle = |kind: &str, time: &str| {
        let values = frames
            .iter()
            .skip(1)
            .filter_map(|frame| frame[kind][time].as_f64());
        median(values.collect()) * 1e3
    };
    println!("\n| Open Chess Set, 1280 × 800 | frame | processor time |\n|---|---:|---:|");
    for kind in ["depth", "rgb"] {
        println!(
            "| {kind} | {:.1} ms | {:.1} ms |",
            middle(kind, "wall_s"),
            middle(kind, "cpu_s")
        );
    }
    println!(
        "| rgb over depth | {:.1} x | {:.1} x |",
        middle("rgb", "wall_s") / middle("depth", "wall_s"),
        middle("rgb", "cpu_s") / middle("depth", "cpu_s")
    );
}

//! Colour frames that take time, compared with moments.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::json;

use super::median;
use crate::processor;
use crate::workspace::{self, output};

/// How often each command runs.
const ROUNDS: usize = 3;

/// The frames of a shorter and a longer command, whose difference is the cost of the other frames. A motion needs two.
const FRAMES: [u32; 2] = [2, 6];

/// The options of each kind of frame.
const KINDS: [(&str, &[&str]); 3] = [
    ("a moment", &[]),
    ("rows read in 24 ms", &["--readout", "24"]),
    (
        "rows read in 24 ms, each exposed for 8 ms",
        &["--readout", "24", "--exposure", "8"],
    ),
];

/// Renders the demo room from an OAK that moves at 0.3 m/s and turns at 34°/s, and prints the processor time of a frame.
pub(crate) fn run() -> Result<(), String> {
    let program = workspace::build_program("oaktwin", &["--release", "--package", "oaktwin-cli"])?;
    let folder = workspace::target().join("bench-render/shutter");
    output(Command::new(&program).arg("demo").arg("--output").arg(&folder))?;
    let [short, long] = [trajectory(&folder, FRAMES[0])?, trajectory(&folder, FRAMES[1])?];
    let mut times = vec![Vec::new(); KINDS.len()];
    for _ in 0..ROUNDS {
        for ((_, options), times) in KINDS.iter().zip(&mut times) {
            let seconds = |trajectory: &Path| {
                let before = processor::used();
                output(&mut render(&program, &folder, trajectory, options))?;
                Ok::<f64, String>((processor::used() - before).as_secs_f64())
            };
            times.push((seconds(&long)? - seconds(&short)?) / f64::from(FRAMES[1] - FRAMES[0]));
        }
    }
    println!(
        "\nColour frames of the demo room, 640 x 400, one thread, processor time; at most 8 renderings per frame:"
    );
    let moment = median(times.first().cloned().unwrap_or_default());
    for ((name, _), times) in KINDS.iter().zip(times) {
        let time = median(times);
        println!("  {name:<44} {:6.0} ms  {:4.1} x", time * 1e3, time / moment);
    }
    Ok(())
}

fn render(program: &Path, folder: &Path, trajectory: &Path, options: &[&str]) -> Command {
    let mut command = Command::new(program);
    command
        .arg("render")
        .arg(folder.join("demo_room/demo_room.usda"))
        .args([
            "--model",
            "OAK-D-Pro-PoE",
            "--camera",
            "rgb",
            "--resolution",
            "640x400",
        ])
        .args(["--annotators", "rgb", "--threads", "1", "--trajectory"])
        .arg(trajectory)
        .arg("--output")
        .arg(folder.join("frames"))
        .args(options);
    command
}

/// Writes poses that begin where the demo looks from, ten per second.
fn trajectory(folder: &Path, frames: u32) -> Result<PathBuf, String> {
    let poses: Vec<_> = (0..frames)
        .map(|frame| {
            let time = 0.1 * f64::from(frame);
            let (sin, cos) = (34f64.to_radians() * time / 2.0).sin_cos();
            json!({"time": time, "position": [0.3 * time, 0.0, 1.15], "orientation": [0.0, 0.0, sin, cos]})
        })
        .collect();
    let path = folder.join(format!("{frames}.json"));
    let text = serde_json::to_string(&poses).map_err(|error| error.to_string())?;
    fs::write(&path, text).map_err(|error| format!("{}: {error}", path.display()))?;
    Ok(path)
}

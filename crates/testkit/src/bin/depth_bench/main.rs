//! Benchmarks of the sensor models and filters, for `cargo xtask bench depth`.
//!
//! `depth-bench make FOLDER` writes the input images: `depth.npy` and
//! `depth_640.npy` (metres), `rgb.npy`, `millimetres.npy` (four noisy frames). `depth-bench run FRAMES THREADS [NAME]` times each case (or those whose name
//! contains NAME) and prints one JSON object per case.

#![expect(clippy::print_stdout, reason = "the output is the program's purpose")]

mod bandwidth;
mod cases;
mod make;
mod room;

use std::error::Error;
use std::path::Path;

use oaktwin_testkit::process;
use serde_json::json;

const WIDTH: u32 = 1280;
const HEIGHT: u32 = 800;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match words[..] {
        ["make", folder] => make::images(Path::new(folder)),
        ["run", frames, threads] => run(frames.parse()?, threads.parse()?, ""),
        ["run", frames, threads, name] => run(frames.parse()?, threads.parse()?, name),
        _ => Err("usage: depth-bench make FOLDER | run FRAMES THREADS [NAME]".into()),
    }
}

fn run(frames: u64, threads: usize, name: &str) -> Result<(), Box<dyn Error>> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build()?;
    let bandwidth = bandwidth::copying(threads);
    println!("{}", json!({ "bytes_a_second": bandwidth, "threads": threads }));
    let (depth, rgb) = room::ray_cast(WIDTH, HEIGHT);
    for mut case in cases::all(&depth, &rgb)? {
        if !case.name.contains(name) {
            continue;
        }
        let mut times = Vec::new();
        // The first is the warm-up.
        for frame in 0..=frames {
            let work = || pool.install(|| (case.work)(frame).map_err(|error| error.to_string()));
            let (done, elapsed) = process::timed(work);
            done?;
            if frame > 0 {
                times.push((elapsed.wall_s, elapsed.cpu_s));
            }
        }
        let (walls, cpus): (Vec<f64>, Vec<f64>) = times.into_iter().unzip();
        println!(
            "{}",
            json!({
                "case": case.name,
                "threads": threads,
                "pixels": case.pixels,
                "bytes": case.bytes,
                "wall_s": walls,
                "cpu_s": cpus,
            })
        );
    }
    Ok(())
}

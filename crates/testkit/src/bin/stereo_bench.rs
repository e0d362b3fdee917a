//! Benchmarks the stereo matcher, for `cargo xtask bench stereo`.
//!
//! `stereo-bench make FOLDER` writes the input pair: `left.npy`, `right.npy` (1280×800, 8 bits).
//! `stereo-bench run FRAMES THREADS [NAME=VALUE…]` matches it repeatedly with the given parameters and prints a JSON
//! object: wall time and processor time per frame in seconds, and the peak memory.

#![expect(clippy::print_stdout, reason = "the output is the program's purpose")]

use std::error::Error;
use std::fs;
use std::path::Path;

use oaktwin_camera::{ImageSize, StereoGeometry};
use oaktwin_depth::preset::Platform;
use oaktwin_depth::stereo_matching::{Parameters, RectifiedPair, StereoMatching};
use oaktwin_image::{ImageView, npy};
use oaktwin_testkit::process;
use oaktwin_testkit::stereo_pair::textured_pair;
use serde_json::json;

const SIZE: ImageSize = ImageSize::new(1280, 800);

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match words[..] {
        ["make", folder] => make(Path::new(folder)),
        ["run", frames, threads, ref settings @ ..] => run(frames.parse()?, threads.parse()?, settings),
        _ => Err("usage: stereo-bench make FOLDER | run FRAMES THREADS [NAME=VALUE…]".into()),
    }
}

fn make(folder: &Path) -> Result<(), Box<dyn Error>> {
    fs::create_dir_all(folder)?;
    for (name, image) in ["left", "right"].into_iter().zip(textured_pair(SIZE)?) {
        let shape = [SIZE.height as usize, SIZE.width as usize];
        fs::write(
            folder.join(name).with_extension("npy"),
            npy::encode(&shape, image.pixels())?,
        )?;
    }
    Ok(())
}

fn run(frames: usize, threads: usize, settings: &[&str]) -> Result<(), Box<dyn Error>> {
    let stereo = StereoGeometry {
        focal_length_px: 800.0,
        baseline_m: 0.075,
    };
    let mut parameters = Parameters::new(Platform::Rvc2, stereo, SIZE.width);
    parameters.set("subpixelFractionalBits", "3")?;
    for setting in settings {
        let (name, value) = setting
            .split_once('=')
            .ok_or("invalid setting: NAME=VALUE required")?;
        parameters.set(name, value)?;
    }
    let engine = StereoMatching::new(parameters)?;
    let [left, right] = textured_pair(SIZE)?;
    let pair = RectifiedPair::new(ImageView::from(&left), ImageView::from(&right))?;
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build()?;
    let mut times = Vec::new();
    let mut kept = 0;
    // The first is the warm-up.
    for frame in 0..=frames {
        let (matched, elapsed) = process::timed(|| pool.install(|| engine.disparity(&pair)));
        if frame > 0 {
            times.push((elapsed.wall_s, elapsed.cpu_s));
        }
        kept = matched.disparity.pixels().iter().filter(|&&d| d > 0).count();
    }
    let (walls, cpus): (Vec<f64>, Vec<f64>) = times.into_iter().unzip();
    println!(
        "{}",
        json!({
            "wall_s": walls,
            "cpu_s": cpus,
            "peak_bytes": process::peak_bytes(),
            "kept": kept,
        })
    );
    Ok(())
}

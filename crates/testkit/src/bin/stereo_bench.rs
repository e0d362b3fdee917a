//! Benchmarks the stereo matcher, for `cargo xtask bench stereo`.
//!
//! `stereo-bench make FOLDER` writes the input pair: `left.npy`, `right.npy` (1280×800, 8 bits).
//! `stereo-bench run FRAMES THREADS [NAME=VALUE…]` matches it repeatedly with the given parameters and prints a JSON
//! object: wall time and processor time per frame in seconds, and the peak memory.

#![expect(clippy::print_stdout, reason = "the output is the program's purpose")]

use std::error::Error;
use std::fs;
use std::path::Path;
use std::time::Instant;

use oaktwin_camera::StereoGeometry;
use oaktwin_depth::preset::Platform;
use oaktwin_depth::stereo_matching::{Pair, Parameters, StereoMatching};
use oaktwin_image::{Image, ImageView, npy};
use oaktwin_testkit::process;
use oaktwin_testkit::random::Random;
use serde_json::json;

const WIDTH: u32 = 1280;
const HEIGHT: u32 = 800;

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
    for (name, image) in ["left", "right"].into_iter().zip(pair()?) {
        let shape = [HEIGHT as usize, WIDTH as usize];
        fs::write(
            folder.join(name).with_extension("npy"),
            npy::encode(&shape, image.pixels())?,
        )?;
    }
    Ok(())
}

/// A slanted wall with boxes in front of it, with a texture of 2 px.
fn pair() -> Result<[Image<u8>; 2], Box<dyn Error>> {
    let mut random = Random::new(1);
    let (width, height) = (WIDTH as usize, HEIGHT as usize);
    let wide = 2 * width;
    let fine: Vec<f64> = (0..wide * (height + 1))
        .map(|_| random.range(0.0, 255.0))
        .collect();
    let level = |x: f64, y: usize| {
        let (from, part) = (x.floor().max(0.0), x - x.floor());
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a column")]
        let column = (from as usize).min(wide - 2);
        let row = |y: usize| fine[y * wide + column] * (1.0 - part) + fine[y * wide + column + 1] * part;
        0.5 * (row(y) + row(y + 1))
    };
    let mut images = [Vec::new(), Vec::new()];
    for y in 0..height {
        for x in 0..width {
            #[expect(clippy::cast_precision_loss, reason = "pixels")]
            let (u, v) = (x as f64, y as f64);
            let mut seen = [(6.0 + 0.01 * v, 0.0); 2];
            for k in 0..7 {
                let k = f64::from(k);
                let (left, top, d) = (120.0 + 160.0 * k, 60.0 + 70.0 * k, 12.3 + 9.7 * k);
                for (image, moved) in seen.iter_mut().zip([0.0, d]) {
                    if u + moved >= left && u + moved < left + 130.0 && v >= top && v < top + 260.0 {
                        *image = (d, 500.0);
                    }
                }
            }
            let [(_, left), (d, right)] = seen;
            for (image, at) in images.iter_mut().zip([u + left, u + d + right]) {
                let noise = random.range(-2.0, 2.0);
                #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "8 bits")]
                image.push((level(at, y) + noise).clamp(0.0, 255.0) as u8);
            }
        }
    }
    let [left, right] = images.map(|pixels| Image::new(WIDTH, HEIGHT, pixels).ok_or("no image"));
    Ok([left?, right?])
}

fn run(frames: usize, threads: usize, settings: &[&str]) -> Result<(), Box<dyn Error>> {
    let stereo = StereoGeometry {
        focal_length_px: 800.0,
        baseline_m: 0.075,
    };
    let mut parameters = Parameters::new(Platform::Rvc2, stereo, WIDTH);
    parameters.set("subpixelFractionalBits", "3")?;
    for setting in settings {
        let (name, value) = setting
            .split_once('=')
            .ok_or("invalid setting: NAME=VALUE required")?;
        parameters.set(name, value)?;
    }
    let engine = StereoMatching::new(parameters)?;
    let [left, right] = pair()?;
    let pair = Pair::new(ImageView::from(&left), ImageView::from(&right))?;
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build()?;
    let mut times = Vec::new();
    let mut kept = 0;
    // The first is the warm-up.
    for frame in 0..=frames {
        let (start, cpu) = (Instant::now(), process::cpu_s());
        let matched = pool.install(|| engine.disparity(&pair));
        if frame > 0 {
            times.push((start.elapsed().as_secs_f64(), process::cpu_s() - cpu));
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

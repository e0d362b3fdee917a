//! Times of the single-view sensor on one thread: images of 1280x800 of a wall, a slanted floor and things before them,
//! with the parameters of an OAK-D Pro.
//!
//! `cargo run --release -p oaktwin-depth --example single_view_time`
#![expect(clippy::print_stdout, reason = "a program for people")]

use std::error::Error;
use std::sync::LazyLock;
use std::time::Instant;

use oaktwin_depth::Shot;
use oaktwin_depth::random::{Stage, Stream};
use oaktwin_depth::single_view::{Assumptions, Parameters, SingleView, Wanted};
use oaktwin_image::Image;

/// What it is, changes of parameters, what is looked at, what is made of it.
type Case<'a> = (&'a str, &'a [(&'a str, &'a str)], Shot<'a>, Wanted);

const WIDTH: u16 = 1280;
const HEIGHT: u16 = 800;

/// The time this thread has run, where Linux says it, else that of the clock.
fn seconds() -> f64 {
    static START: LazyLock<Instant> = LazyLock::new(Instant::now);
    let start = *START;
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap_or_default();
    let ran = text.split(' ').next().and_then(|ns| ns.parse::<f64>().ok());
    ran.map_or_else(|| start.elapsed().as_secs_f64(), |ns| ns / 1e9)
}

/// The best of some runs.
fn time(what: &str, pixels: f64, mut work: impl FnMut()) {
    work();
    let best = (0..5).map(|_| {
        let start = seconds();
        for _ in 0..24 {
            work();
        }
        (seconds() - start) / 24.0
    });
    let best = best.fold(f64::INFINITY, f64::min);
    println!(
        "{what:36} {:8.1} /s  {:6.3} ns/px",
        1.0 / best,
        best * 1e9 / pixels
    );
}

fn depth(x: u16, y: u16) -> f32 {
    let (x, y) = (f32::from(x), f32::from(y));
    let floor = 600.0 / (y - 380.0);
    let back = if floor > 0.0 { floor.min(6.0) } else { 6.0 };
    match (x, y) {
        (300.0..=500.0, 200.0..=600.0) => 1.5,
        (800.0..=900.0, 100.0..=700.0) => 1.0 + (x - 800.0) * 0.004,
        (_, 0.0..=40.0) => f32::INFINITY,
        _ => back,
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build()?;
    Ok(pool.install(|| run().map_err(|error| error.to_string()))?)
}

fn run() -> Result<(), Box<dyn Error>> {
    let (width, height) = (u32::from(WIDTH), u32::from(HEIGHT));
    let places = || (0..HEIGHT).flat_map(|y| (0..WIDTH).map(move |x| (x, y)));
    let image = Image::new(width, height, places().map(|(x, y)| depth(x, y)).collect()).ok_or("size")?;
    let rgb = places().map(|(x, y)| {
        let grey = if (x / 8 + y / 8) % 2 == 0 { 90 } else { 140 };
        [grey, grey / 2, 200 - grey, 255]
    });
    let rgb = Image::new(width, height, rgb.collect()).ok_or("size")?;
    let positions = image.map(|&z| [0.0, 0.0, z, 1.0]);
    let stream = Stream::new(1, "left");
    let pixels = f64::from(width * height);

    let plane = stream.plane(Stage::Jitter, 1, 0);
    let mut row = vec![0.0f32; WIDTH.into()];
    let mut bytes = vec![0u8; WIDTH.into()];
    let mut copy = vec![0.0f32; image.pixels().len()];
    time("copying an image", pixels, || {
        copy.copy_from_slice(image.pixels());
        std::hint::black_box(&mut copy);
    });
    time("normals", pixels, || {
        (0..height).for_each(|y| plane.normals(y, &mut row));
    });
    time("bytes", pixels, || {
        (0..height).for_each(|y| plane.bytes(y, &mut bytes));
    });

    let mut base = Parameters::ISAAC_5_1;
    for (name, value) in [
        ("baselineMM", "75"),
        ("focalLengthPixel", "805"),
        ("maxDisparityPixel", "95"),
        ("minDistance", "0.6"),
        ("maxDistance", "12"),
        ("noiseSigma", "0.2"),
        ("noiseDownscaleFactorPixel", "2"),
        ("confidenceThreshold", "0.8"),
    ] {
        base.set(name, value)?;
    }
    let shot = Shot::new((&image).into());
    let colored = shot.with_rgb((&rgb).into())?;
    let whole = colored.with_positions((&positions).into())?;
    let all = Wanted {
        positions: true,
        colors: true,
        imager: true,
        view: true,
    };
    let only = std::env::args().nth(1);
    let cases: [Case<'_>; 8] = [
        ("OAK-D Pro", &[], shot, Wanted::default()),
        (
            "noiseDownscaleFactorPixel 1",
            &[("noiseDownscaleFactorPixel", "1")],
            shot,
            Wanted::default(),
        ),
        ("noiseMean 0", &[("noiseMean", "0")], shot, Wanted::default()),
        (
            "no outlier removal",
            &[("outlierRemovalEnabled", "0")],
            shot,
            Wanted::default(),
        ),
        (
            "neither",
            &[("outlierRemovalEnabled", "0"), ("noiseMean", "0")],
            shot,
            Wanted::default(),
        ),
        ("with a picture", &[], colored, Wanted::default()),
        ("with all outputs", &[], whole, all),
        ("with a rainbow", &[("rgbDepthOutputMode", "3")], shot, all),
    ];
    for (what, changes, shot, wanted) in cases {
        if only.as_deref().is_some_and(|only| only != what) {
            continue;
        }
        let mut parameters = base;
        for (name, value) in changes {
            parameters.set(name, value)?;
        }
        let sensor = SingleView::new(parameters, Assumptions::default())?;
        let mut frame = 0;
        time(what, pixels, || {
            frame += 1;
            let mut shot = shot;
            shot.frame = frame;
            std::hint::black_box(sensor.sense(&shot, &stream, wanted));
        });
    }

    let sensor = SingleView::new(base, Assumptions::default())?;
    let shape = [1024, 60, 106];
    let batch: Vec<f32> = image
        .pixels()
        .iter()
        .copied()
        .cycle()
        .take(shape.iter().product())
        .collect();
    let mut out = vec![0.0; batch.len()];
    let mut frame = 0;
    let mut failed = None;
    time("a batch of 1024 images of 106x60", batch.len() as f64, || {
        frame += 1;
        failed = sensor
            .sense_batch(&batch, shape, frame, 0, &stream, &mut out)
            .err();
    });
    Ok(failed.map_or(Ok(()), Err)?)
}

//! Light by another surface, against a sum over all pixels in double precision.

use std::f64::consts::{PI, TAU};

use super::*;
use crate::time_of_flight::unwrap::turn_m;

const WIDTH: u32 = 160;
const HEIGHT: u32 = 120;

/// A surface that a pixel sees: its depth and normal, of any length, away from the camera.
type SurfaceFunction = fn(u: f64, v: f64) -> (f64, [f64; 3]);

/// Two walls at 90°, the edge farthest, 1.5 m away.
fn concave(u: f64, _: f64) -> (f64, [f64; 3]) {
    (1.5 / (1.0 + u.abs()), [u.signum(), 0.0, 1.0])
}

/// The edge nearest.
fn convex(u: f64, _: f64) -> (f64, [f64; 3]) {
    (1.0 / (1.0 - u.abs()), [-u.signum(), 0.0, 1.0])
}

fn slanted(u: f64, v: f64) -> (f64, [f64; 3]) {
    (1.5 / (1.0 + 0.6 * u - 0.3 * v), [0.6, -0.3, 1.0])
}

/// The two walls, a floor, and a board in front of them.
fn furnished(u: f64, v: f64) -> (f64, [f64; 3]) {
    let board = (0.05..0.3).contains(&u) && (-0.2..0.15).contains(&v);
    if board {
        return (0.8 / (1.0 + 0.4 * u), [0.4, 0.0, 1.0]);
    }
    let (wall, floor) = (concave(u, v), (0.4 / v, [0.0, 1.0, 0.0]));
    if v > 0.0 && floor.0 < wall.0 { floor } else { wall }
}

fn ray(i: usize) -> [f64; 2] {
    let (x, y) = (i % WIDTH as usize, i / WIDTH as usize);
    [(x, WIDTH), (y, HEIGHT)].map(|(at, size)| (at as f64 + 0.5 - f64::from(size) / 2.0) * 4.0 / 457.0)
}

fn image(seen: SurfaceFunction) -> Image<f32> {
    let pixels = (0..(WIDTH * HEIGHT) as usize).map(|i| {
        let [u, v] = ray(i);
        seen(u, v).0 as f32
    });
    Image::new(WIDTH, HEIGHT, pixels.collect()).unwrap()
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Point, normal away from the camera, and m² of what a pixel sees.
fn surface(seen: SurfaceFunction, i: usize) -> ([f64; 3], [f64; 3], f64) {
    let [u, v] = ray(i);
    let (z, normal) = seen(u, v);
    let size = dot(normal, normal).sqrt();
    let (point, normal) = ([z * u, z * v, z], normal.map(|n| n / size));
    (
        point,
        normal,
        (4.0 / 457.0f64).powi(2) * z * z * z / dot(normal, point),
    )
}

/// By how much too far a pixel is reported, m along its ray; every pixel lights.
fn bias(seen: SurfaceFunction, albedo: f64, i: usize) -> f64 {
    let (x, n, _) = surface(seen, i);
    let range = dot(x, x).sqrt();
    let direct = dot(n, x) / range.powi(3);
    let turns = [80.0, 100.0].map(turn_m);
    let mut sums = [[direct, 0.0]; 2];
    for j in 0..(WIDTH * HEIGHT) as usize {
        let (y, m, area) = surface(seen, j);
        let way = [0, 1, 2].map(|k| y[k] - x[k]);
        let (square, reach) = (dot(way, way), dot(y, y).sqrt());
        let (here, there) = (-dot(n, way), dot(m, way));
        if here <= 1e-9 || there <= 1e-9 {
            continue;
        }
        let light =
            albedo * dot(m, y) / reach.powi(3) * area * here * there / (square * (PI * square + area));
        for (sum, turn) in sums.iter_mut().zip(turns) {
            let phase = TAU * (reach + square.sqrt() - range) / 2.0 / turn;
            *sum = [sum[0] + light * phase.cos(), sum[1] + light * phase.sin()];
        }
    }
    let [low, high] = [0, 1].map(|k| sums[k][1].atan2(sums[k][0]) / TAU * turns[k]);
    (0.64 * low + high) / 1.64
}

fn with(albedo: f64, multipath: f64) -> Parameters {
    Parameters {
        albedo,
        multipath,
        enable_optical_correction: false,
        ..exact()
    }
}

/// By how much more it reports than without.
fn reported(depth: &Image<f32>, albedo: f64) -> Vec<f64> {
    let (on, off) = (sense(with(albedo, 1.0), depth), sense(with(albedo, 0.0), depth));
    let both = on.0.pixels().iter().zip(off.0.pixels());
    both.map(|(&on, &off)| f64::from(on) - f64::from(off)).collect()
}

/// Mean of the middle rows.
fn column(values: &[f64], x: usize) -> f64 {
    let rows = values.chunks_exact(WIDTH as usize).skip(40).take(40);
    rows.map(|row| row[x]).sum::<f64>() / 40.0
}

/// Too far, the more so the whiter, and as much as light from every pixel makes it. It grows towards the edge, up to where the
/// longer way is hardly longer; the light itself grows to the edge, where it no longer is out of phase.
#[test]
fn a_concave_corner_is_too_far() {
    let depth = image(concave);
    let mut before = [0.0; 5];
    for albedo in [0.1, 0.5, 0.9] {
        let found = reported(&depth, albedo);
        // Pixels from the edge.
        let at = [60, 40, 20, 8, 2];
        let biases = at.map(|far| (column(&found, 79 - far) + column(&found, 80 + far)) / 2.0);
        for (&far, &found) in at.iter().zip(&biases) {
            let expected = bias(concave, albedo, 60 * WIDTH as usize + 80 + far);
            assert!(
                (found - expected).abs() < 0.06 * expected + 0.000_3,
                "{far}: {found} {expected}"
            );
        }
        assert!(biases[..3].is_sorted_by(|far, near| far < near) && biases[3..].is_sorted_by(|a, b| a > b));
        assert!(biases.iter().zip(before).all(|(now, before)| *now > before));
        before = biases;
    }
    // Small enough for the output.
    let amplitude = |multipath| -> Vec<f64> {
        let p = Parameters {
            signal_e: 50_000.0,
            ..with(0.5, multipath)
        };
        let output = sensor(p).output(&shot(&depth, 0), &random());
        output.amplitude.pixels().iter().map(|&a| f64::from(a)).collect()
    };
    let (on, off) = (amplitude(1.0), amplitude(0.0));
    let shares = [60, 40, 20, 8, 2].map(|far| column(&on, 80 + far) / column(&off, 80 + far) - 1.0);
    assert!(shares.is_sorted_by(|far, near| far < near) && shares[4] > 0.1 && shares[4] < 0.3);
    // Both walls alike.
    let found = reported(&depth, 0.9);
    assert!((column(&found, 70) - column(&found, 89)).abs() < 0.000_5);
}

/// What nothing lights is as without, but for rounding.
#[test]
fn a_wall_and_a_ridge_stay() {
    for seen in [slanted, convex] {
        let depth = image(seen);
        let off = reported(&depth, 0.9);
        let changed = off.iter().filter(|off| off.abs() > 1e-4).count();
        assert!(
            changed < off.len() / 500 && off.iter().all(|off| off.abs() < 0.0011),
            "{changed}"
        );
    }
}

/// Edges do not leak: all kinds of pixels are as the sum says.
#[test]
fn a_furnished_corner_is_as_the_sum() {
    let depth = image(furnished);
    let found = reported(&depth, 0.8);
    let mut off: Vec<(f64, usize)> = (0..found.len())
        .step_by(37)
        .map(|i| ((found[i] - bias(furnished, 0.8, i)).abs(), i))
        .collect();
    off.sort_by(|a, b| a.0.total_cmp(&b.0));
    let at = |percent: usize| off[off.len() * percent / 100].0;
    assert!(at(50) < 0.0015 && at(95) < 0.006, "{} {}", at(50), at(95));
}

/// Twice as much light by other surfaces is twice the error, while it is small.
#[test]
fn strength_is_a_factor() {
    let depth = image(concave);
    let off = sense(with(0.1, 0.0), &depth);
    let mean = |multipath| {
        let on = sense(with(0.1, multipath), &depth);
        let both = on.0.pixels().iter().zip(off.0.pixels());
        both.map(|(&on, &off)| f64::from(on) - f64::from(off))
            .sum::<f64>()
            / off.0.pixels().len() as f64
    };
    let (once, twice) = (mean(1.0), mean(2.0));
    assert!(
        once > 0.000_5 && (twice / once - 2.0).abs() < 0.1,
        "{once} {twice}"
    );
}

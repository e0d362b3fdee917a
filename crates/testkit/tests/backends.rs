//! Compares both backends with the double-precision reference over random scenes.

#![allow(
    clippy::print_stdout,
    clippy::expect_used,
    clippy::unwrap_used,
    reason = "a test"
)]

use oaktwin_camera::ImageSize;
use oaktwin_image::ZDepth;
use oaktwin_render::{Backend, Hit, Renderer, View};
use oaktwin_scene::Scene;
use oaktwin_testkit::random::{self, Kind, Lens, Random};
use oaktwin_testkit::reference::{Crossing, Reference};

/// Not a multiple of any tile or vector size.
const SIZE: ImageSize = ImageSize::new(83, 47);

/// The tolerance of edges in single precision, px.
const SLACK_PX: f64 = 0.01;

/// The relative tolerance of depth.
const SAME: f64 = 1e-5;

/// The maximum share of pixels that may be on the other side of an edge.
const SILHOUETTES: f64 = 1e-3;

#[test]
fn backends_agree_with_the_reference() {
    check_seeds(0..2);
}

#[test]
#[ignore = "slow: many more scenes"]
fn slow_backends_agree_with_the_reference_in_many_scenes() {
    check_seeds(2..60);
}

fn check_seeds(seeds: std::ops::Range<u64>) {
    let mut findings = Vec::new();
    let mut silhouettes = 0;
    for seed in seeds {
        for kind in Kind::ALL {
            let mut random = Random::new(seed * 1000 + kind as u64);
            let scene = random::scene(kind, &mut random);
            let views = Lens::ALL.map(|lens| (lens, random::view(lens, SIZE, kind.centre(), &mut random)));
            let renderer = Renderer::new(scene);
            for (lens, view) in views {
                let reference = Reference::new(renderer.scene(), &view);
                let truth = reference.image();
                for backend in backends(lens) {
                    let what = format!("{kind:?} {lens:?} {backend:?} seed {seed}");
                    match compare(&renderer, &view, backend, &reference, &truth) {
                        Ok(count) => silhouettes += count,
                        Err(finding) => findings.push(format!("{what}: {finding}")),
                    }
                }
            }
        }
    }
    println!("{silhouettes} pixels on silhouettes differ");
    assert!(findings.is_empty(), "{}", findings.join("\n"));
}

/// The rasterizer supports only pinholes.
fn backends(lens: Lens) -> Vec<Backend> {
    match lens {
        Lens::Pinhole => vec![Backend::Raster, Backend::Ray],
        Lens::Rational | Lens::Fisheye => vec![Backend::Ray],
    }
}

/// Returns the number of pixels on the other side of a silhouette, or a description of the errors.
fn compare(
    renderer: &Renderer,
    view: &View,
    backend: Backend,
    reference: &Reference,
    truth: &[Option<Crossing>],
) -> Result<usize, String> {
    let ZDepth(depth) = renderer.depth(view, backend);
    let seen = renderer.visibility(view, backend);
    let size = view.camera.intrinsics.size;
    if (depth.width(), depth.height()) != (size.width, size.height) {
        return Err(format!("{} × {}", depth.width(), depth.height()));
    }
    let mut silhouettes = 0;
    let mut wrong = Vec::new();
    for (i, truth) in truth.iter().enumerate() {
        let i32 = u32::try_from(i).expect("a small image");
        let (x, y) = (i32 % size.width, i32 / size.width);
        let single = depth.pixels()[i];
        let z = f64::from(single);
        let is_same = match truth {
            Some(truth) => (z - truth.z).abs() <= SAME * truth.z,
            None => single == f32::INFINITY,
        };
        if !is_same {
            silhouettes += 1;
            if !reference.explains(x, y, z, SLACK_PX) {
                wrong.push(format!("({x}, {y}) is {z}, not {truth:?}"));
            }
        }
        if single.to_bits() != seen.z.0.pixels()[i].to_bits() {
            wrong.push(format!(
                "({x}, {y}) is {z} alone and {} with ids",
                seen.z.0.pixels()[i]
            ));
        }
        let hit = seen.hits.pixels()[i];
        if hit.is_miss() != single.is_infinite() || (hit.is_miss() && hit != Hit::MISS) {
            wrong.push(format!("({x}, {y}) is {z} and shows {hit:?}"));
        } else if !hit.is_miss() {
            let of_hit = reference.plane_at(x, y, hit);
            let tolerance = |c: Crossing| (SAME + 4e-7 / c.cos_incidence.max(1e-6)) * c.z.abs();
            if of_hit.is_none_or(|crossing| (crossing.z - z).abs() > tolerance(crossing)) {
                wrong.push(format!(
                    "({x}, {y}) is {z} and shows {hit:?}, which is at {of_hit:?}"
                ));
            }
        }
    }
    #[expect(clippy::cast_precision_loss, reason = "a small image")]
    let most = 1.0 + SILHOUETTES * truth.len() as f64;
    if silhouettes as f64 > most {
        wrong.push(format!("{silhouettes} of {} pixels differ", truth.len()));
    }
    match wrong.first() {
        None => Ok(silhouettes),
        Some(first) => Err(format!("{} pixels are wrong: {first}", wrong.len())),
    }
}

#[test]
fn any_number_of_threads_gives_the_same_bytes() {
    for kind in [Kind::Soup, Kind::Spheres, Kind::Coplanar] {
        let mut random = Random::new(77);
        let scene = random::scene(kind, &mut random);
        for lens in Lens::ALL {
            let view = random::view(lens, SIZE, kind.centre(), &mut random);
            for backend in backends(lens) {
                let first = on_threads(1, &scene, &view, backend);
                for threads in [2, 5] {
                    assert_eq!(
                        first,
                        on_threads(threads, &scene, &view, backend),
                        "{kind:?} {backend:?}"
                    );
                }
            }
        }
    }
}

/// The bits of the depth and the hits.
fn on_threads(threads: usize, scene: &Scene, view: &View, backend: Backend) -> (Vec<u32>, Vec<Hit>) {
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .build()
        .unwrap();
    pool.install(|| {
        let seen = Renderer::new(scene.clone()).visibility(view, backend);
        let bits = seen.z.0.pixels().iter().map(|z| z.to_bits()).collect();
        (bits, seen.hits.into_pixels())
    })
}

//! Compares both backends with the double-precision reference over random scenes.

#![allow(
    clippy::print_stdout,
    clippy::expect_used,
    clippy::unwrap_used,
    reason = "a test"
)]

use oaktwin_camera::ImageSize;
use oaktwin_render::{Backend, Hit, Renderer, View};
use oaktwin_scene::Scene;
use oaktwin_testkit::agreement;
use oaktwin_testkit::random::{self, Kind, Lens, Random};
use oaktwin_testkit::reference::Reference;

/// Not a multiple of any tile or vector size.
const SIZE: ImageSize = ImageSize::new(83, 47);

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
                    match silhouettes_of(agreement::compare(&renderer, &view, backend, &reference, &truth)) {
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

/// Rejects images in which too many pixels are on the other side of a silhouette.
fn silhouettes_of(compared: Result<usize, String>) -> Result<usize, String> {
    let most = 1.0 + SILHOUETTES * f64::from(SIZE.width * SIZE.height);
    match compared {
        #[expect(clippy::cast_precision_loss, reason = "a small image")]
        Ok(count) if count as f64 > most => Err(format!("{count} pixels differ")),
        compared => compared,
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

//! How long the ray caster takes to prepare and to render some large meshes:
//! `cargo run --release -p oaktwin-render --example ray_speed [SCENE ...]`.
#![allow(clippy::print_stdout, reason = "a program")]
#![allow(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    reason = "coordinates"
)]

use std::collections::HashMap;
use std::fmt;
use std::time::Instant;

use oaktwin_camera::math::{DAffine3, DVec3};
use oaktwin_camera::{
    Camera, ImageSize, Intrinsics, LensModel, OpenCvFisheye, PixelPoint, RigidTransform, Usd,
};
use oaktwin_render::{Backend, Clip, Ray, Renderer, View};
use oaktwin_scene::{Instance, Mesh, Scene};

fn main() {
    let chosen: Vec<String> = std::env::args().skip(1).collect();
    let is_chosen = |name: &str| chosen.is_empty() || chosen.iter().any(|c| c == name);
    if is_chosen("plane") {
        measure("displaced plane", grid(708, 0.5), DVec3::new(0.0, 0.0, -3.0));
    }
    if is_chosen("sphere") {
        measure("displaced icosphere", sphere(7), DVec3::new(0.0, 0.0, -2.2));
    }
    if is_chosen("inside") {
        measure("inside of the icosphere", sphere(7), DVec3::new(0.1, 0.2, -0.3));
    }
    if is_chosen("heightfield") {
        measure("heightfield", grid(2001, 0.2), DVec3::new(0.0, 0.0, -3.0));
    }
}

fn measure(name: &str, mesh: Mesh, eye: DVec3) {
    let (triangles, vertices) = (mesh.triangles.len(), mesh.positions.len());
    let scene = Scene {
        meshes: vec![mesh],
        instances: vec![Instance {
            mesh: 0,
            path: String::new(),
            world_from_mesh: DAffine3::IDENTITY,
            labels: Vec::new(),
        }],
        ..Scene::default()
    };
    println!("{name}: {triangles} triangles, {vertices} vertices");
    let mut renderer = Renderer::new(scene);
    let tiny = view(LensModel::Pinhole, 1, 1, eye);
    let build = least(3, || {
        renderer = Renderer::new(renderer.scene().clone());
        Timer::time(|| {
            let _ = renderer.depth(&tiny, Backend::Ray);
        })
    });
    println!("  build {build}");
    if std::env::var_os("RAYS").is_some() {
        shadows(&renderer, eye);
    }
    let fisheye = LensModel::OpenCvFisheye(OpenCvFisheye {
        k: [-0.02, 0.001, 0.0, 0.0],
    });
    for (lens, kind) in [(LensModel::Pinhole, "pinhole"), (fisheye, "fisheye")] {
        let view = view(lens, 1280, 800, eye);
        let mut hits = 0;
        let frame = least(9, || {
            Timer::time(|| {
                let z = renderer.depth(&view, Backend::Ray);
                hits = z.0.pixels().iter().filter(|z| z.is_finite()).count();
            })
        });
        println!("  {kind} {frame}, {hits} hits");
    }
}

/// Rays by themselves: from what is seen towards a lamp, and into the view.
fn shadows(renderer: &Renderer, eye: DVec3) {
    let view = view(LensModel::Pinhole, 1280, 800, eye);
    let z = renderer.depth(&view, Backend::Ray);
    let lamp = eye + DVec3::new(1.0, -2.0, 0.3);
    let mut seen = Vec::new();
    let mut shadows = Vec::new();
    for (i, z) in z.0.pixels().iter().enumerate() {
        let pixel = PixelPoint::<Usd>::new((i % 1280) as f64 + 0.5, (i / 1280) as f64 + 0.5);
        let direction = view.camera.intrinsics.normalized_from_pixel(pixel).extend(1.0);
        seen.push(Ray {
            origin: eye,
            direction,
            near: 0.01,
            far: f64::INFINITY,
        });
        if z.is_finite() {
            let origin = eye + direction * f64::from(*z);
            shadows.push(Ray {
                origin,
                direction: lamp - origin,
                near: 1e-3,
                far: 1.0,
            });
        }
    }
    let mut count = 0;
    let time = least(3, || {
        Timer::time(|| count = renderer.occluded(&shadows).iter().filter(|x| **x).count())
    });
    println!("  {} shadow rays {time}, {count} in the shadow", shadows.len());
    let time = least(3, || {
        Timer::time(|| count = renderer.cast_rays(&seen).iter().flatten().count())
    });
    println!("  {} single rays {time}, {count} hits", seen.len());
}

/// Seconds on the clock and of all threads together.
#[derive(Clone, Copy)]
struct Timer {
    wall: f64,
    threads: f64,
}

impl Timer {
    fn time(run: impl FnOnce()) -> Self {
        let (start, threads) = (Instant::now(), thread_seconds());
        run();
        Self {
            wall: start.elapsed().as_secs_f64(),
            threads: thread_seconds() - threads,
        }
    }
}

impl fmt::Display for Timer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{:.1} ms, {:.1} ms of threads",
            self.wall * 1e3,
            self.threads * 1e3
        )
    }
}

/// Where Linux says how long threads ran; else 0.
fn thread_seconds() -> f64 {
    let Ok(tasks) = std::fs::read_dir("/proc/self/task") else {
        return 0.0;
    };
    let nanoseconds = |task: std::io::Result<std::fs::DirEntry>| {
        let text = std::fs::read_to_string(task.ok()?.path().join("schedstat")).ok()?;
        text.split(' ').next()?.parse::<f64>().ok()
    };
    tasks.filter_map(nanoseconds).sum::<f64>() / 1e9
}

fn least(times: u32, mut run: impl FnMut() -> Timer) -> Timer {
    let mut least = run();
    for _ in 1..times {
        let next = run();
        least.wall = least.wall.min(next.wall);
        least.threads = least.threads.min(next.threads);
    }
    least
}

fn view(lens: LensModel, width: u32, height: u32, eye: DVec3) -> View {
    let intrinsics = Intrinsics::from_hfov(ImageSize::new(width, height), 77f64.to_radians());
    let mut world_from_camera = RigidTransform::IDENTITY;
    world_from_camera.translation = eye;
    View {
        camera: Camera::new(intrinsics, lens),
        world_from_camera,
        clip: Clip::default(),
    }
}

/// Waves over a square that fills the view.
fn grid(n: u32, height: f32) -> Mesh {
    let at = |i: u32| 6.0 * (i as f32 / (n - 1) as f32 - 0.5);
    let wave = |x: f32, y: f32| {
        height
            * ((1.7 * x).sin() * (2.3 * y).cos() + 0.3 * (9.0 * x + 4.0 * y).sin() + 0.05 * (41.0 * x).cos())
    };
    let positions = (0..n * n)
        .map(|i| {
            let (x, y) = (at(i % n), at(i / n));
            [x, y, wave(x, y)]
        })
        .collect();
    let triangles = (0..(n - 1) * (n - 1))
        .flat_map(|i| {
            let a = i / (n - 1) * n + i % (n - 1);
            [[a, a + 1, a + n], [a + 1, a + n + 1, a + n]]
        })
        .collect();
    Mesh {
        positions,
        triangles,
        ..Mesh::default()
    }
}

/// A ball with bumps, 20 · 4^levels triangles.
fn sphere(levels: u32) -> Mesh {
    let phi = f64::midpoint(1.0, 5f64.sqrt());
    let mut points: Vec<DVec3> = Vec::new();
    for (a, b) in [(-1.0, phi), (1.0, phi), (-1.0, -phi), (1.0, -phi)] {
        points.extend([
            DVec3::new(a, b, 0.0),
            DVec3::new(0.0, a, b),
            DVec3::new(b, 0.0, a),
        ]);
    }
    let mut triangles: Vec<[u32; 3]> = Vec::new();
    let near = |a: u32, b: u32| (points[a as usize].distance(points[b as usize]) - 2.0).abs() < 1e-9;
    for a in 0..12 {
        for b in a + 1..12 {
            for c in b + 1..12 {
                if near(a, b) && near(b, c) && near(c, a) {
                    triangles.push([a, b, c]);
                }
            }
        }
    }
    for _ in 0..levels {
        let mut middles: HashMap<(u32, u32), u32> = HashMap::new();
        let mut next = Vec::with_capacity(triangles.len() * 4);
        for [a, b, c] in triangles {
            let mut middle = |a: u32, b: u32| {
                *middles.entry((a.min(b), a.max(b))).or_insert_with(|| {
                    points.push((points[a as usize] + points[b as usize]) / 2.0);
                    points.len() as u32 - 1
                })
            };
            let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
            next.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]);
        }
        triangles = next;
    }
    let positions = points
        .iter()
        .map(|p| {
            let n = p.normalize();
            let bump = 1.0 + 0.08 * (11.0 * n.x).sin() * (9.0 * n.y).cos() * (7.0 * n.z).sin();
            (n * bump).as_vec3().to_array()
        })
        .collect();
    Mesh {
        positions,
        triangles,
        ..Mesh::default()
    }
}

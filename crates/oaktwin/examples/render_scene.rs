//! Renders ground-truth depth of a scene with an OAK's cameras:
//!
//! ```sh
//! cargo run --release --example render_scene -- room.usda OAK4-D
//! ```
//!
//! The camera is one metre above the origin and faces along x.

#![expect(clippy::print_stdout, reason = "the output is the program's purpose")]

use std::error::Error;
use std::path::PathBuf;

use oaktwin::camera::math::DVec3;
use oaktwin::catalog::Catalog;
use oaktwin::render::{Backend, OakOptions, OpenOptions, Renderer, SceneFile, look_at, oak_cameras};

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args_os().skip(1);
    let usage = "usage: render_scene SCENE MODEL";
    let scene = PathBuf::from(arguments.next().ok_or(usage)?);
    let model = arguments.next().ok_or(usage)?;

    let scene = SceneFile::open(&scene, &OpenOptions::default())?;
    for finding in &scene.findings {
        println!("{finding}");
    }
    let catalog = Catalog::builtin();
    let twin = catalog.nominal(catalog.device(&model.to_string_lossy())?);
    let up = scene.scene.up.direction();
    let world_from_body = look_at(up, up + DVec3::X, up)?;
    let (cameras, _) = oak_cameras(&twin, &world_from_body, &OakOptions::default())?;

    let renderer = Renderer::new(scene.scene);
    for camera in &cameras {
        let depth = renderer
            .depth(&camera.view(&camera.world_from_mount), Backend::Auto)
            .0;
        let hits = depth.pixels().iter().filter(|z| z.is_finite());
        let (nearest, farthest) = hits.clone().fold((f32::INFINITY, 0f32), |(near, far), z| {
            (near.min(*z), far.max(*z))
        });
        println!(
            "{}: {}x{} pixels, {} with a hit at {nearest} to {farthest} m",
            camera.path,
            depth.width(),
            depth.height(),
            hits.count(),
        );
    }
    Ok(())
}

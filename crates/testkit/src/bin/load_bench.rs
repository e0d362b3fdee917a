//! Times opening a USD stage, for `cargo xtask bench load`: `load-bench STAGE RUNS` prints a JSON object per run,
//! the first being the warm-up; `load-bench STAGE RUNS FRAMES` then also renders depth and colour alternately.

#![expect(clippy::print_stdout, reason = "the output is the program's purpose")]

use std::error::Error;

use oaktwin_camera::ImageSize;
use oaktwin_camera::math::DVec3;
use oaktwin_image::annotation::Annotator;
use oaktwin_render::{AnnotateOptions, Backend, Renderer, View};
use oaktwin_scene::Scene;
use oaktwin_testkit::process::{Elapsed, timed};
use oaktwin_testkit::views::looking_at;
use oaktwin_usd::stage::{SceneOptions, open_scene};
use serde_json::json;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let usage = "usage: load-bench STAGE RUNS [FRAMES]";
    let stage = arguments.next().ok_or(usage)?;
    let runs: usize = arguments.next().ok_or(usage)?.parse()?;
    let frames: usize = arguments.next().map_or(Ok(0), |frames| frames.parse())?;
    let mut scene = Scene::default();
    for _ in 0..runs.max(1) {
        drop(std::mem::take(&mut scene));
        let (opened, Elapsed { wall_s, cpu_s }) = timed(|| open_scene(&stage, &SceneOptions::default()));
        scene = opened?.scene;
        let triangles: usize = scene
            .instances
            .iter()
            .filter_map(|placed| scene.meshes.get(placed.mesh as usize))
            .map(|mesh| mesh.triangles.len())
            .sum();
        println!(
            "{}",
            json!({ "wall_s": wall_s, "cpu_s": cpu_s, "meshes": scene.instances.len(), "triangles": triangles })
        );
    }
    if frames > 0 {
        render(scene, frames);
    }
    Ok(())
}

/// Renders depth and colour of the same view alternately, after a warm-up of both.
fn render(scene: Scene, frames: usize) {
    let view = from_above_a_corner(&scene);
    let renderer = Renderer::new(scene);
    let options = AnnotateOptions::default();
    let annotators = [Annotator::DistanceToImagePlane, Annotator::Rgb];
    for _ in 0..=frames {
        let [depth, rgb] = annotators.map(|annotator| {
            // Dropping the images is not timed.
            let (_, Elapsed { wall_s, cpu_s }) =
                timed(|| renderer.annotate(&view, &[annotator], Backend::Auto, &options));
            json!({ "wall_s": wall_s, "cpu_s": cpu_s })
        });
        println!("{}", json!({ "depth": depth, "rgb": rgb }));
    }
}

/// A view of 1280 × 800 pixels, 77° wide, that contains the whole scene.
fn from_above_a_corner(scene: &Scene) -> View {
    let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    for placed in &scene.instances {
        for position in scene
            .meshes
            .get(placed.mesh as usize)
            .iter()
            .flat_map(|mesh| &mesh.positions)
        {
            let place = placed
                .world_from_mesh
                .transform_point3(DVec3::from(position.map(f64::from)));
            (low, high) = (low.min(place), high.max(place));
        }
    }
    let (centre, reach) = (low.midpoint(high), low.distance(high) / 2.0);
    let up = scene.up.direction();
    let aside = up.any_orthonormal_vector();
    let direction = (0.6 * up + aside + 0.7 * up.cross(aside)).normalize();
    let eye = centre + 1.1 * reach * direction;
    looking_at(eye, centre, up, ImageSize::new(1280, 800))
}

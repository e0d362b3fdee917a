//! Compares the backends with the double-precision reference.

use oaktwin_image::ZDepth;
use oaktwin_render::{Backend, Hit, Renderer, View};

use crate::reference::{Crossing, Reference};

/// The tolerance of edges in single precision, px.
const SLACK_PX: f64 = 0.01;

/// The relative tolerance of depth.
const SAME: f64 = 1e-5;

/// Compares a backend with the image of the reference, and returns the number of pixels on the other side of a silhouette.
///
/// # Errors
/// Returns a description of the first pixel that no surface within reach of the edges explains.
pub fn compare(
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
    let places = (0..size.height).flat_map(|y| (0..size.width).map(move |x| (x, y)));
    for ((i, truth), (x, y)) in truth.iter().enumerate().zip(places) {
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
    match wrong.first() {
        None => Ok(silhouettes),
        Some(first) => Err(format!("{} pixels are wrong: {first}", wrong.len())),
    }
}

//! Meshes for the page's 3D view.
//!
//! The layout matches `MeshHeader` in `web/src/protocol.ts`.

pub(crate) mod textured;
mod view;
mod welded;

use oaktwin::camera::math::DVec3;
use oaktwin::catalog::Twin;
use oaktwin::usd::body;

pub(crate) use textured::of_textures;
pub(crate) use view::{MAX_WELDED, of_scene, triangles};
use welded::Welded;

/// Encodes triangles, each with a number in the place of its object.
pub(crate) fn of_triangles<'a>(triangles: impl Iterator<Item = (&'a [DVec3; 3], u32)>) -> Vec<u8> {
    let mut welded = Welded::default();
    for (corners, object) in triangles {
        welded.add_triangle(*corners, [0; 3], object);
    }
    welded.encode(welded.len())
}

/// Encodes the body of a model in its own frame.
pub(crate) fn of_body(twin: &Twin) -> Vec<u8> {
    let body = body::body(twin);
    let mut welded = Welded::default();
    for (object, part) in (0..).zip(&body.parts) {
        let material = body
            .materials
            .iter()
            .find(|material| material.name == part.material);
        let linear = material.map_or([0.2; 3], |material| material.diffuse);
        let color = linear.map(oaktwin::image::srgb::srgb_from_linear);
        let mut from = 0;
        for count in &part.face_vertex_counts {
            let count = usize::try_from(*count).unwrap_or(0);
            let face = part
                .face_vertex_indices
                .get(from..from + count)
                .unwrap_or_default();
            from += count;
            for corner in 2..face.len() {
                for index in [face[0], face[corner - 1], face[corner]] {
                    let point = usize::try_from(index)
                        .ok()
                        .and_then(|index| part.points.get(index));
                    welded.add(
                        DVec3::from(point.copied().unwrap_or_default().map(f64::from)),
                        color,
                        object,
                    );
                }
            }
        }
    }
    welded.encode(welded.len())
}

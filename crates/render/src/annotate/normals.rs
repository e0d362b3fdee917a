use oaktwin_image::Image;
use oaktwin_scene::Scene;
use rayon::prelude::*;

use super::surface::SurfaceFinder;
use crate::rays::Rays;
use crate::{View, Visibility};

/// Returns unit normals in the world frame, 0 for a miss: interpolated where the mesh has normals, else the normals of the
/// triangles.
///
/// Normals point to the visible side, also where the mesh is not marked double-sided, because depth includes both sides too.
#[expect(clippy::cast_possible_truncation, reason = "normals are float32")]
pub(super) fn normals(scene: &Scene, view: &View, rays: &Rays, seen: &Visibility) -> Image<[f32; 3]> {
    let (width, height) = (seen.hits.width(), seen.hits.height());
    let mut normals = Image::filled(width, height, [0.0; 3]);
    let row_length = (width as usize).max(1);
    let rows = normals.pixels_mut().par_chunks_mut(row_length);
    let seen_rows = (seen.z.0.pixels().par_chunks(row_length)).zip(seen.hits.pixels().par_chunks(row_length));
    rows.zip(seen_rows)
        .zip(0..height)
        .for_each(|((row, (depths, hits)), y)| {
            let mut finder = SurfaceFinder::new(scene, view);
            for (((normal, z), hit), x) in row.iter_mut().zip(depths).zip(hits).zip(0..) {
                let surface = (!hit.is_miss())
                    .then(|| rays.centre(x, y))
                    .flatten()
                    .and_then(|ray| finder.find(*hit, ray, *z));
                if let Some(surface) = surface {
                    *normal = surface.normal.to_array().map(|n| n as f32);
                }
            }
        });
    normals
}

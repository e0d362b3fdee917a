//! What is seen through the invisible, or clear, parts of surfaces.

use oaktwin_base::interrupt;
use oaktwin_scene::Scene;
use rayon::prelude::*;

use crate::View;
use crate::blocks::{BLOCK, Blocks};
use crate::cutout::{Cutouts, Transparent};
use crate::ray::{Ray, RayCaster, Stack};
use crate::rays::Rays;
use crate::visibility::{Hit, Visibility};

/// Casts a ray through each pixel, of an image of solid surfaces or of some blocks of it, that sees an invisible part, or a clear one if
/// that is what `transparent` asks for.
pub(crate) fn look_through(
    cutouts: &Cutouts,
    caster: &RayCaster,
    scene: &Scene,
    view: &View,
    blocks: Option<&Blocks>,
    transparent: Transparent,
    seen: &mut Visibility,
) {
    let rays = Rays::with_table(view, || caster.table(view));
    let (width, height) = (seen.hits.width(), seen.hits.height());
    let row_length = (width as usize).max(1);
    let origin = view.world_from_camera.translation;
    let rows = (seen.hits.pixels_mut().par_chunks_mut(row_length))
        .zip(seen.z.0.pixels_mut().par_chunks_mut(row_length))
        .zip(0..height);
    rows.for_each_init(Stack::default, |stack, ((hits, depths), y)| {
        if interrupt::is_unwanted() {
            return;
        }
        for ((hit, z), x) in hits.iter_mut().zip(depths).zip(0_u32..) {
            if hit.is_miss() || blocks.is_some_and(|blocks| !blocks.contains(x / BLOCK, y / BLOCK)) {
                continue;
            }
            let Some(ray) = rays.centre(x, y) else { continue };
            let direction = view.world_from_camera.rotation * ray;
            if cutouts.shows(scene, *hit, origin, direction, transparent) {
                continue;
            }
            let ahead = Ray {
                origin,
                direction,
                near: view.clip.near_m,
                far: view.clip.far_m,
            };
            let behind = match transparent {
                Transparent::Surface => caster.cast(scene, ahead, stack),
                Transparent::Through => caster.cast_through(scene, ahead, stack),
            };
            #[expect(clippy::cast_possible_truncation, reason = "depths have single precision")]
            let found = match behind {
                Some((t, behind)) => (behind, (t * ray.z) as f32),
                None => (Hit::MISS, f32::INFINITY),
            };
            (*hit, *z) = found;
        }
    });
}

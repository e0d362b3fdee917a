use oaktwin_camera::LensModel;
use oaktwin_image::{Image, RangeDepth, ZDepth};
use oaktwin_scene::Scene;
use rayon::prelude::*;

use super::surface::{SurfaceFinder, ray_in_camera};
use crate::{View, Visibility};

/// Whether every pixel looks forward, so that its range follows from its depth.
pub(super) fn follows_from_depth(view: &View) -> bool {
    matches!(view.camera.lens, LensModel::Pinhole | LensModel::OpenCvPinhole(_))
}

/// The range along each pixel's ray, `z / cos`, where every pixel looks forward.
#[expect(clippy::cast_possible_truncation, reason = "a range is float32")]
pub(super) fn from_depth(view: &View, depth: &ZDepth) -> RangeDepth {
    along_rows(view, depth, |row, y| {
        for (range, x) in row.iter_mut().zip(0..) {
            if range.is_finite() {
                *range =
                    ray_in_camera(view, x, y).map_or(f32::INFINITY, |ray| (f64::from(*range) / ray.z) as f32);
            }
        }
    })
}

/// The same for every lens: what is seen sideways, where the depth says nothing, is asked of the triangle itself.
#[expect(clippy::cast_possible_truncation, reason = "a range is float32")]
pub(super) fn from_visibility(scene: &Scene, view: &View, seen: &Visibility) -> RangeDepth {
    if follows_from_depth(view) {
        return from_depth(view, &seen.z);
    }
    along_rows(view, &seen.z, |row, y| {
        let mut finder = SurfaceFinder::new(scene, view);
        for (range, x) in row.iter_mut().zip(0..) {
            let (Some(hit), Some(ray)) = (seen.hits.get(x, y), ray_in_camera(view, x, y)) else {
                *range = f32::INFINITY;
                continue;
            };
            let found = (!hit.is_miss()).then(|| finder.find(*hit, ray, *range)).flatten();
            *range = found.map_or(f32::INFINITY, |surface| surface.range as f32);
        }
    })
}

fn along_rows(view: &View, depth: &ZDepth, change: impl Fn(&mut [f32], u32) + Sync) -> RangeDepth {
    let size = view.camera.intrinsics.size;
    let mut range: Image<f32> = depth.0.clone();
    range
        .pixels_mut()
        .par_chunks_mut((size.width as usize).max(1))
        .zip(0..size.height)
        .for_each(|(row, y)| change(row, y));
    RangeDepth(range)
}

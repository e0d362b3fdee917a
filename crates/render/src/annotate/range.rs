use oaktwin_camera::math::DVec3;
use oaktwin_image::{RangeDepth, ZDepth};
use oaktwin_scene::Scene;
use rayon::prelude::*;

use super::surface::SurfaceFinder;
use crate::rays::Rays;
use crate::{View, Visibility};

/// Returns the range along each pixel's ray where all rays have z = 1.
#[expect(clippy::cast_possible_truncation, reason = "a range is float32")]
pub(super) fn from_depth(rays: &Rays, depth: &ZDepth) -> RangeDepth {
    along_rows(depth, |row, y| {
        for (range, x) in row.iter_mut().zip(0..) {
            if range.is_finite() {
                let length = rays.centre(x, y).map_or(f64::INFINITY, DVec3::length);
                *range = (f64::from(*range) * length) as f32;
            }
        }
    })
}

/// Returns the range along each pixel's ray for every lens; where rays point sideways it is computed from the triangle.
#[expect(clippy::cast_possible_truncation, reason = "a range is float32")]
pub(super) fn from_visibility(scene: &Scene, view: &View, rays: &Rays, seen: &Visibility) -> RangeDepth {
    if rays.are_along_axis() {
        return from_depth(rays, &seen.z);
    }
    along_rows(&seen.z, |row, y| {
        let mut finder = SurfaceFinder::new(scene, view);
        for (range, x) in row.iter_mut().zip(0..) {
            let surface = (seen.hits.get(x, y).filter(|hit| !hit.is_miss()))
                .zip(rays.centre(x, y))
                .and_then(|(hit, ray)| finder.find(*hit, ray, *range));
            *range = surface.map_or(f32::INFINITY, |surface| surface.range as f32);
        }
    })
}

fn along_rows(depth: &ZDepth, change: impl Fn(&mut [f32], u32) + Sync) -> RangeDepth {
    let mut range = depth.0.clone();
    let (width, height) = (range.width() as usize, range.height());
    let rows = range.pixels_mut().par_chunks_mut(width.max(1));
    rows.zip(0..height).for_each(|(row, y)| change(row, y));
    RangeDepth(range)
}

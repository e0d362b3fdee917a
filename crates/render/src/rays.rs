use std::sync::Arc;

use oaktwin_camera::math::DVec3;
use oaktwin_camera::{LensModel, PixelPoint, Usd};

use crate::View;
use crate::ray::{RayTable, ray_through};

/// The rays of a view's pixels in the camera frame: with z = 1 where the view is clipped along the optical axis, else of
/// length 1. A point at `t` times the ray is clipped by `t`, which is the z-depth for a pinhole.
#[derive(Debug)]
pub(crate) struct Rays<'a> {
    view: &'a View,
    along_axis: bool,
    /// For ideal pinholes: the difference from a pixel's ray to the ray of the next pixel to the right, and below.
    steps: Option<[DVec3; 2]>,
    /// The rays of other lenses, if they are known.
    table: Option<Arc<RayTable>>,
}

impl<'a> Rays<'a> {
    /// Creates the rays of a view. For a lens with distortion, they are computed when they are needed.
    pub(crate) fn new(view: &'a View) -> Self {
        let camera = &view.camera;
        let steps = [DVec3::X / camera.intrinsics.fx, DVec3::Y / camera.intrinsics.fy];
        Self {
            view,
            along_axis: view.clips_along_axis(),
            steps: (camera.lens == LensModel::Pinhole).then_some(steps),
            table: None,
        }
    }

    /// Creates the rays of a view. For a lens with distortion, they are taken from `table`.
    pub(crate) fn with_table(view: &'a View, table: impl FnOnce() -> Arc<RayTable>) -> Self {
        let mut rays = Self::new(view);
        if rays.steps.is_none() {
            rays.table = Some(table());
        }
        rays
    }

    /// Whether all rays have z = 1.
    pub(crate) fn are_along_axis(&self) -> bool {
        self.along_axis
    }

    /// Returns the ray through the centre of a pixel, which may be one to the right of the image or below it.
    #[inline]
    pub(crate) fn centre(&self, x: u32, y: u32) -> Option<DVec3> {
        let centre = PixelPoint::<Usd>::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
        if self.steps.is_some() {
            return Some((self.view.camera.intrinsics.normalized_from_pixel(centre)).extend(1.0));
        }
        let known = self.table.as_ref().and_then(|table| table.direction(x, y));
        match known {
            Some(ray) => (!ray.is_nan()).then_some(ray),
            None => self.through([centre.x, centre.y]),
        }
    }

    /// Returns the rays of the pixels to the right of and below a pixel with the given ray.
    #[inline]
    pub(crate) fn next(&self, x: u32, y: u32, ray: DVec3) -> [Option<DVec3>; 2] {
        match &self.steps {
            None => [self.centre(x + 1, y), self.centre(x, y + 1)],
            Some([across, down]) => [Some(ray + *across), Some(ray + *down)],
        }
    }

    /// Returns the ray through a point of the image in pixels; the centre of the first pixel is at 0.5.
    pub(crate) fn through(&self, at: [f64; 2]) -> Option<DVec3> {
        ray_through(&self.view.camera, self.along_axis, at)
    }
}

#[cfg(test)]
mod tests {
    use oaktwin_scene::Scene;

    use super::*;
    use crate::fixture;
    use crate::ray::RayCaster;

    #[test]
    fn rays_of_a_table_are_the_computed_ones() {
        let caster = RayCaster::new(&Scene::default());
        for view in [fixture::view(), fixture::fisheye()] {
            let (kept, computed) = (Rays::with_table(&view, || caster.table(&view)), Rays::new(&view));
            let size = view.camera.intrinsics.size;
            // One column and one row more than the image has.
            for (x, y) in (0..=size.height).flat_map(|y| (0..=size.width).map(move |x| (x, y))) {
                assert_eq!(kept.centre(x, y), computed.centre(x, y));
                if let Some(ray) = kept.centre(x, y) {
                    assert_eq!(kept.next(x, y, ray), computed.next(x, y, ray));
                }
            }
        }
    }
}

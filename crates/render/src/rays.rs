use oaktwin_camera::math::DVec3;
use oaktwin_camera::{LensModel, PixelPoint, Usd};
use oaktwin_image::Image;
use rayon::prelude::*;

use crate::View;

/// The rays of a view's pixels in the camera frame: with z = 1 where the view is clipped along the optical axis, else of
/// length 1. A point at `t` times the ray is clipped by `t`, which is the z-depth for a pinhole.
#[derive(Debug)]
pub(crate) struct Rays<'a> {
    view: &'a View,
    along_axis: bool,
    /// For lenses with distortion: one column and one row more than the image has; NaN where the lens has no ray.
    table: Option<Image<DVec3>>,
    /// For ideal pinholes: the difference from a pixel's ray to that of the next pixel to the right, and below.
    steps: [DVec3; 2],
}

impl<'a> Rays<'a> {
    pub(crate) fn new(view: &'a View) -> Self {
        let mut rays = Self {
            view,
            along_axis: view.clips_along_axis(),
            table: None,
            steps: [
                DVec3::X / view.camera.intrinsics.fx,
                DVec3::Y / view.camera.intrinsics.fy,
            ],
        };
        if view.camera.lens != LensModel::Pinhole {
            let size = view.camera.intrinsics.size;
            let (width, height) = (size.width.saturating_add(1), size.height.saturating_add(1));
            let mut table = Image::filled(width, height, DVec3::NAN);
            let rows = table.pixels_mut().par_chunks_mut(width as usize);
            rows.zip(0..height).for_each(|(row, y)| {
                for (ray, x) in row.iter_mut().zip(0..) {
                    let at = [f64::from(x) + 0.5, f64::from(y) + 0.5];
                    *ray = rays.through(at).unwrap_or(DVec3::NAN);
                }
            });
            rays.table = Some(table);
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
        match &self.table {
            Some(table) => table.get(x, y).copied().filter(|ray| !ray.is_nan()),
            None => {
                let centre = PixelPoint::<Usd>::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
                Some((self.view.camera.intrinsics.normalized_from_pixel(centre)).extend(1.0))
            }
        }
    }

    /// Returns the rays of the pixels to the right of and below a pixel with the given ray.
    #[inline]
    pub(crate) fn next(&self, x: u32, y: u32, ray: DVec3) -> [Option<DVec3>; 2] {
        match &self.table {
            Some(_) => [self.centre(x + 1, y), self.centre(x, y + 1)],
            None => [Some(ray + self.steps[0]), Some(ray + self.steps[1])],
        }
    }

    /// Returns the ray through a point of the image in pixels; the centre of the first pixel is at 0.5.
    pub(crate) fn through(&self, [x, y]: [f64; 2]) -> Option<DVec3> {
        let ray = self.view.camera.unproject(PixelPoint::<Usd>::new(x, y))?;
        Some(if self.along_axis { ray / ray.z } else { ray })
    }
}

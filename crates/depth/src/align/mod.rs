//! Depth of one camera as another sees it: each sample becomes a point, the point a pixel of the other image, and the
//! nearest in each pixel stays.
//!
//! # What lands where
//! A pixel (x, y) is the ray through (x + 0.5, y + 0.5). Its point goes into the target pixel that contains its
//! projection; the depth there is along the target's axis. With [`Fill::Footprint`], the default, it also goes into the
//! other pixels whose centre lies in its *footprint*: what the source pixel covers in the target, a rectangle around the
//! projection as large as the projections of half a pixel to the right and below make it, and an eighth more on each
//! side, since neighbours on a slanted surface stand a little apart. So depth of 800 rows in a picture of 2160 is dense
//! without being blended: every value is a measured one. `DepthAI`'s `ImageAlign` aligns at the depth's own size and
//! resizes the result, with an interpolation that is an option there; at depth edges resizing mixes near and far unless
//! it takes the nearest, and no value is mixed here.
//!
//! What only the target sees stays 0, and so does what the source did not measure. A footprint is at most
//! [`MOST_PIXELS_A_SIDE`] pixels wide and high: a sample just before the target's lens would cover the image.

mod project;
#[cfg(test)]
mod tests;

use std::sync::atomic::{AtomicU32, Ordering};

use oaktwin_camera::math::DVec3;
use oaktwin_camera::{Camera, LensModel, PixelPoint, RigidTransform, Usd};
use oaktwin_image::{Image, ImageView, ZDepth};
use rayon::prelude::*;

use crate::ShotError;
use project::Projection;

/// The largest footprint, px.
pub const MOST_PIXELS_A_SIDE: u32 = 64;

/// How much wider a footprint is than the pixel that it comes from, on both sides together.
const FOOTPRINT: f64 = 1.25;

/// Which target pixels a sample goes into.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Fill {
    /// The one that it falls into: a target of more pixels is a grid of holes.
    Nearest,
    /// All that it covers.
    #[default]
    Footprint,
}

/// From one camera's depth to another's.
#[derive(Clone, Debug)]
pub struct Align {
    source: Camera,
    target: Camera,
    target_from_source: RigidTransform,
    fill: Fill,
    /// Of a lens that bends rays: where each pixel's ray meets z = 1, row by row; NaN where it has none.
    rays: Option<Vec<[f64; 2]>>,
}

impl Align {
    /// Of the camera that measured, the camera that is to see, and where both stand (OpenCV's axes, metres).
    #[must_use]
    pub fn new(source: Camera, target: Camera, target_from_source: RigidTransform, fill: Fill) -> Self {
        let rays = (source.lens != LensModel::Pinhole).then(|| rays(&source));
        Self {
            source,
            target,
            target_from_source,
            fill,
            rays,
        }
    }

    /// The camera that is to see.
    #[must_use]
    pub fn target(&self) -> &Camera {
        &self.target
    }

    /// The depth that the target sees: metres along its axis, 0 where nothing was measured. What is not finite and above
    /// 0 in `depth` is no sample.
    ///
    /// # Errors
    /// The depth has not the source's size.
    pub fn align(&self, depth: ImageView<'_, f32>) -> Result<ZDepth, ShotError> {
        let (size, out) = (self.source.intrinsics.size, self.target.intrinsics.size);
        if (depth.width(), depth.height()) != (size.width, size.height) {
            return Err(ShotError {
                what: "camera",
                width: size.width,
                height: size.height,
                depth_width: depth.width(),
                depth_height: depth.height(),
            });
        }
        // Positive floats are ordered as their bits, and the smallest of many does not depend on their order.
        let nearest: Vec<AtomicU32> = (0..out.width as usize * out.height as usize)
            .map(|_| AtomicU32::new(f32::INFINITY.to_bits()))
            .collect();
        let projection = Projection::new(&self.target, out);
        depth
            .pixels()
            .par_chunks_exact((size.width as usize).max(1))
            .enumerate()
            .for_each(|(y, row)| self.splat(y, row, &projection, &nearest));
        let pixels = nearest
            .into_iter()
            .map(|bits| {
                let z = f32::from_bits(bits.into_inner());
                if z < f32::INFINITY { z } else { 0.0 }
            })
            .collect();
        // As many as were made.
        let image = Image::new(out.width, out.height, pixels);
        Ok(ZDepth(
            image.unwrap_or_else(|| Image::filled(out.width, out.height, 0.0)),
        ))
    }

    fn splat(&self, y: usize, row: &[f32], projection: &Projection, nearest: &[AtomicU32]) {
        let k = &self.source.intrinsics;
        let centre = k.principal_point::<Usd>();
        let [step_x, step_y] = [1.0 / k.fx, 1.0 / k.fy];
        let ray_y = (y as f64 + 0.5 - centre.y) * step_y;
        let (rotation, translation) = (
            self.target_from_source.rotation,
            self.target_from_source.translation,
        );
        for (x, &z) in row.iter().enumerate() {
            if !(z > 0.0 && z < f32::INFINITY) {
                continue;
            }
            let [a, b] = match &self.rays {
                Some(rays) => rays[y * row.len() + x],
                None => [(x as f64 + 0.5 - centre.x) * step_x, ray_y],
            };
            let z = f64::from(z);
            let at = |a: f64, b: f64| rotation * DVec3::new(a * z, b * z, z) + translation;
            let point = at(a, b);
            let Some([u, v]) = projection.pixel(point) else {
                continue;
            };
            #[expect(clippy::cast_possible_truncation, reason = "depth is single precision")]
            let bits = (point.z as f32).to_bits();
            let half = match self.fill {
                Fill::Nearest => [0.0; 2],
                Fill::Footprint => {
                    let right = projection.pixel(at(a + 0.5 * step_x, b));
                    let below = projection.pixel(at(a, b + 0.5 * step_y));
                    match (right, below) {
                        // The box around a cell that the lens or a roll of the camera may have turned.
                        (Some(right), Some(below)) => [0, 1].map(|axis| {
                            let centre = [u, v][axis];
                            FOOTPRINT * ((right[axis] - centre).abs() + (below[axis] - centre).abs())
                        }),
                        _ => [0.0; 2],
                    }
                }
            };
            projection.cover([u, v], half, |pixel| {
                nearest[pixel].fetch_min(bits, Ordering::Relaxed);
            });
        }
    }
}

/// Where each pixel's ray meets the plane z = 1.
fn rays(camera: &Camera) -> Vec<[f64; 2]> {
    let size = camera.intrinsics.size;
    (0..size.height)
        .into_par_iter()
        .flat_map_iter(|y| {
            (0..size.width).map(move |x| {
                let pixel = PixelPoint::<Usd>::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
                match camera.unproject(pixel) {
                    Some(ray) if ray.z > 0.0 => [ray.x / ray.z, ray.y / ray.z],
                    _ => [f64::NAN; 2],
                }
            })
        })
        .collect()
}

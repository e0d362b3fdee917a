//! Alignment of depth to another camera: each sample is projected into the other image, and the nearest sample in each
//! pixel wins.
//!
//! # Splatting
//! A pixel (x, y) is the ray through (x + 0.5, y + 0.5). Its point goes into the target pixel that contains its
//! projection; the depth there is the one that [`AlignedZ`] names. With [`Fill::Footprint`], the default, it also goes into the
//! other pixels whose centres lie in its *footprint*: the area that the source pixel covers in the target, a rectangle
//! around the projection whose size follows from the projections of half a pixel to the right and below, and an eighth more
//! on each side, since neighbours on a slanted surface are a little apart. Depth of 800 rows is therefore dense in an image
//! of 2160 rows without being blended: every value was measured. `DepthAI`'s `ImageAlign` aligns at the depth's own size and
//! resizes the result, with an interpolation that is an option there; at depth edges resizing mixes near and far unless
//! it takes the nearest, and no value is mixed here.
//!
//! # Depth
//! The stereo of RVC2 moves pixels and does not change their depth: in aligned pictures of five units, every value is f·b/d of
//! a whole disparity d, rounded to millimetres. [`AlignedZ::of_stereo`] is the default for each platform.
//!
//! Pixels that only the target sees, or that the source did not measure, are 0. A footprint is at most
//! [`MOST_PIXELS_A_SIDE`] pixels wide and high: a sample close to the target's lens would cover the image.

mod project;
#[cfg(test)]
mod tests;

use std::sync::atomic::{AtomicU32, Ordering};

use oaktwin_base::parameter::{Platform, choice};
use oaktwin_camera::math::DVec3;
use oaktwin_camera::{Camera, LensModel, PixelPoint, RigidTransform, Usd};
use oaktwin_image::{Image, ImageView, ZDepth};
use rayon::prelude::*;

use crate::ShotError;
use project::Projection;

/// The maximum side of a footprint, px.
pub const MOST_PIXELS_A_SIDE: u32 = 64;

/// The width of a footprint relative to its source pixel.
const FOOTPRINT: f64 = 1.25;

choice! {
    /// The splatting mode.
    Fill {
        /// All pixels that the sample covers.
        Footprint = "footprint",
        /// The pixel that contains the projection: a target with more pixels than the source has holes.
        Nearest = "nearest",
    }
}

choice! {
    /// The depth of aligned samples.
    AlignedZ {
        /// Along the axis of the camera that depth is aligned to.
        Geometric = "geometric",
        /// The depth that the sensor measured, along its own axis: pixels move and keep their values.
        Measured = "measured",
    }
}

impl AlignedZ {
    /// Returns the depth that the alignment of a stereo pair reports on a platform: `measured` on RVC2, as pictures of five
    /// units show. No picture shows what RVC4 reports; it is `geometric` there.
    #[must_use]
    pub fn of_stereo(platform: Option<Platform>) -> Self {
        match platform {
            Some(Platform::Rvc2) => Self::Measured,
            Some(Platform::Rvc4) | None => Self::Geometric,
        }
    }
}

/// The modes of an alignment.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct AlignMode {
    /// The splatting mode.
    pub fill: Fill,
    /// The depth of aligned samples.
    pub z: AlignedZ,
}

/// The alignment of one camera's depth to another camera.
#[derive(Clone, Debug)]
pub struct Align {
    source: Camera,
    target: Camera,
    target_from_source: RigidTransform,
    mode: AlignMode,
    /// For lenses with distortion, the intersection of each pixel's ray with z = 1, row by row; NaN without a ray.
    rays: Option<Vec<[f64; 2]>>,
}

impl Align {
    /// Creates the alignment from the camera that measured, the target camera, and their relative pose (OpenCV's axes,
    /// metres).
    #[must_use]
    pub fn new(source: Camera, target: Camera, target_from_source: RigidTransform, mode: AlignMode) -> Self {
        let rays = (source.lens != LensModel::Pinhole).then(|| rays(&source));
        Self {
            source,
            target,
            target_from_source,
            mode,
            rays,
        }
    }

    /// The target camera.
    #[must_use]
    pub fn target(&self) -> &Camera {
        &self.target
    }

    /// Returns the depth in the target camera: metres along the axis that [`AlignedZ`] names, 0 where nothing was measured.
    /// Values in `depth` that are not finite and positive are ignored.
    ///
    /// # Errors
    /// Returns an error if the size of the depth differs from the source camera's.
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
        // Positive floats have the order of their bits, and a minimum does not depend on the order of its arguments.
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
            let measured = z;
            let z = f64::from(z);
            let at = |a: f64, b: f64| rotation * DVec3::new(a * z, b * z, z) + translation;
            let point = at(a, b);
            let Some([u, v]) = projection.pixel(point) else {
                continue;
            };
            #[expect(clippy::cast_possible_truncation, reason = "depth is single precision")]
            let aligned = match self.mode.z {
                AlignedZ::Geometric => point.z as f32,
                AlignedZ::Measured => measured,
            };
            let bits = aligned.to_bits();
            let half = match self.mode.fill {
                Fill::Nearest => [0.0; 2],
                Fill::Footprint => {
                    let right = projection.pixel(at(a + 0.5 * step_x, b));
                    let below = projection.pixel(at(a, b + 0.5 * step_y));
                    match (right, below) {
                        // The bounding box of the cell, which the lens or a roll of the camera may have rotated.
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

/// Returns the intersection of each pixel's ray with the plane z = 1.
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

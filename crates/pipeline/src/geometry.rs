//! Pixel rays: range to z-depth, resampling, point clouds.

use rayon::prelude::*;

use oaktwin_camera::{Camera, ImageSize, PixelPoint, Usd};
use oaktwin_image::{Image, ImageView};

/// The centre of a pixel.
fn centre(x: usize, y: usize) -> PixelPoint<Usd> {
    PixelPoint::new(x as f64 + 0.5, y as f64 + 0.5)
}

/// The factors from range to z-depth, pixel by pixel; NaN outside the lens's field of view.
#[expect(clippy::cast_possible_truncation, reason = "depth is single precision")]
pub(crate) fn z_of_range(camera: &Camera) -> Vec<f32> {
    let size = camera.intrinsics.size;
    (0..size.height as usize)
        .into_par_iter()
        .flat_map_iter(|y| {
            (0..size.width as usize).map(move |x| {
                camera
                    .unproject(centre(x, y))
                    .map_or(f32::NAN, |ray| ray.z as f32)
            })
        })
        .collect()
}

/// For each pixel of `to` the index of the pixel of `from` on the same ray, for cameras at the same position; `None` outside
/// its image.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "within the image"
)]
pub(crate) fn places(from: &Camera, to: &Camera) -> Vec<Option<usize>> {
    let (size, own) = (to.intrinsics.size, from.intrinsics.size);
    let place = |x: usize, y: usize| {
        let seen = from.project(to.unproject(centre(x, y))?)?.to::<Usd>();
        let (u, v) = (seen.x.floor(), seen.y.floor());
        let inside = u >= 0.0 && v >= 0.0 && u < f64::from(own.width) && v < f64::from(own.height);
        inside.then(|| v as usize * own.width as usize + u as usize)
    };
    (0..size.height as usize)
        .into_par_iter()
        .flat_map_iter(|y| (0..size.width as usize).map(move |x| place(x, y)))
        .collect()
}

/// The samples at these indices.
pub(crate) fn resample<T: Copy>(
    image: &Image<T>,
    places: &[Option<usize>],
    size: ImageSize,
    outside: T,
) -> Image<T> {
    let pixels = places
        .iter()
        .map(|place| {
            place
                .and_then(|at| image.pixels().get(at))
                .copied()
                .unwrap_or(outside)
        })
        .collect();
    Image::new(size.width, size.height, pixels)
        .unwrap_or_else(|| Image::filled(size.width, size.height, outside))
}

/// The point of each pixel in the camera's frame with USD's axes (x right, y up, z backward), metres, and 1; all 0 for
/// invalid depth.
#[expect(clippy::cast_possible_truncation, reason = "points are float32")]
pub(crate) fn positions(camera: &Camera, z: ImageView<'_, f32>) -> Image<[f32; 4]> {
    let mut positions = Image::filled(z.width(), z.height(), [0f32; 4]);
    let columns = (z.width() as usize).max(1);
    let rows = positions.pixels_mut().par_chunks_mut(columns);
    rows.zip(z.pixels().par_chunks(columns))
        .enumerate()
        .for_each(|(y, (row, depths))| {
            for ((x, point), &z) in row.iter_mut().enumerate().zip(depths) {
                if !(z > 0.0 && z < f32::INFINITY) {
                    continue;
                }
                let Some(ray) = camera.unproject(centre(x, y)).filter(|ray| ray.z > 0.0) else {
                    continue;
                };
                let seen = ray * (f64::from(z) / ray.z);
                *point = [seen.x as f32, -seen.y as f32, -z, 1.0];
            }
        });
    positions
}

/// The colours of valid depth, and 0 elsewhere.
pub(crate) fn measured_only(mut colors: Image<[u8; 4]>, z: &Image<f32>) -> Image<[u8; 4]> {
    for (color, z) in colors.pixels_mut().iter_mut().zip(z.pixels()) {
        if *z <= 0.0 {
            *color = [0; 4];
        }
    }
    colors
}

#[cfg(test)]
mod tests {
    use super::*;
    use oaktwin_camera::{Intrinsics, LensModel};

    fn pinhole(width: u32, height: u32, hfov_deg: f64) -> Camera {
        let size = ImageSize::new(width, height);
        Camera::new(
            Intrinsics::from_hfov(size, hfov_deg.to_radians()),
            LensModel::Pinhole,
        )
    }

    #[test]
    fn converts_range_to_z() {
        let camera = pinhole(4, 2, 90.0);
        let factors = z_of_range(&camera);
        // The ray of the first pixel is (−1.5, −0.5, 2).
        let expected = 2.0 / (1.5f32 * 1.5 + 0.5 * 0.5 + 4.0).sqrt();
        assert!((factors[0] - expected).abs() < 1e-6 && (factors[7] - expected).abs() < 1e-6);
    }

    #[test]
    fn resamples_a_narrower_view() {
        let image = Image::new(4, 2, (0..8).collect()).unwrap();
        // The middle half of the view at the same resolution: each sample twice.
        let narrow = pinhole(4, 2, 2.0 * 0.5f64.atan().to_degrees());
        let places = places(&pinhole(4, 2, 90.0), &narrow);
        let seen = resample(&image, &places, ImageSize::new(4, 2), -1);
        assert_eq!(seen.pixels(), [1, 1, 2, 2, 5, 5, 6, 6]);
        let wide = super::places(&narrow, &pinhole(4, 2, 90.0));
        let seen = resample(&image, &wide, ImageSize::new(4, 2), -1);
        assert_eq!((seen.pixels()[0], seen.pixels()[3]), (-1, -1));
    }
}

//! Conversion of depth to points.

use oaktwin_camera::math::DVec3;
use oaktwin_camera::{Camera, PixelPoint, Usd};
use oaktwin_image::{Image, ImageView};

use super::{DepthView, MeasuredCamera, RecordedCamera};

/// Returns the intersection of the ray at each pixel centre with the plane z = 1; NaN if there is none.
#[must_use]
pub fn rays(camera: &Camera) -> Image<[f32; 2]> {
    let size = camera.intrinsics.size;
    let mut rays = Image::filled(size.width, size.height, [f32::NAN; 2]);
    let columns = (size.width as usize).max(1);
    for (y, row) in (0u32..).zip(rays.pixels_mut().chunks_exact_mut(columns)) {
        for (x, ray) in (0u32..).zip(row) {
            let centre = PixelPoint::<Usd>::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
            if let Some(seen) = camera.unproject(centre).filter(|seen| seen.z > 0.0) {
                #[expect(clippy::cast_possible_truncation, reason = "points are in single precision")]
                let at = [(seen.x / seen.z) as f32, (seen.y / seen.z) as f32];
                *ray = at;
            }
        }
    }
    rays
}

/// Returns the point of each pixel, metres in the camera's optical frame; NaN for invalid depth.
pub fn points<'a>(rays: &'a Image<[f32; 2]>, depth: DepthView<'a>) -> impl Iterator<Item = [f32; 3]> + 'a {
    (0..rays.pixels().len()).map(move |at| {
        let z = match depth {
            DepthView::Metres(image) => image.pixels().get(at).copied().unwrap_or(0.0),
            DepthView::Millimetres(image) => image.pixels().get(at).map_or(0.0, |mm| f32::from(*mm) / 1000.0),
        };
        match rays.pixels().get(at) {
            Some([x, y]) if z > 0.0 && z < f32::INFINITY && !x.is_nan() => [x * z, y * z, z],
            _ => [f32::NAN; 3],
        }
    })
}

/// Returns the colour of each measured point in the image of the recorded camera, 0 where that does not see it; `None` if
/// measured depth is an image of the same camera, where each pixel has its own colour.
#[must_use]
pub fn measured_colors(
    rays: &Image<[f32; 2]>,
    depth: DepthView<'_>,
    camera: &RecordedCamera,
    rgb: Option<ImageView<'_, [u8; 4]>>,
) -> Option<Image<[u8; 4]>> {
    Some(colors(
        rays,
        depth,
        camera.measured.as_ref()?,
        &camera.camera,
        rgb?,
    ))
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "within the image"
)]
fn colors(
    rays: &Image<[f32; 2]>,
    depth: DepthView<'_>,
    measured: &MeasuredCamera,
    camera: &Camera,
    rgb: ImageView<'_, [u8; 4]>,
) -> Image<[u8; 4]> {
    let color = |point: [f32; 3]| {
        let point = measured
            .camera_from_measured
            .apply(DVec3::from(point.map(f64::from)));
        let at = point.is_finite().then(|| camera.project(point))??.to::<Usd>();
        let (x, y) = (at.x.floor(), at.y.floor());
        let is_inside = x >= 0.0 && y >= 0.0 && x < f64::from(rgb.width()) && y < f64::from(rgb.height());
        let index = is_inside.then(|| y as usize * rgb.width() as usize + x as usize)?;
        rgb.pixels().get(index).copied()
    };
    let colors = points(rays, depth).map(|point| color(point).unwrap_or_default());
    Image::new(rays.width(), rays.height(), colors.collect())
        .unwrap_or_else(|| Image::filled(rays.width(), rays.height(), [0; 4]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use oaktwin_camera::math::DVec3;
    use oaktwin_camera::{ImageSize, Intrinsics, LensModel, OpenCv, OpenCvPinhole};
    use oaktwin_image::ImageView;

    #[test]
    fn points_project_to_their_pixels() {
        let lens = LensModel::OpenCvPinhole(OpenCvPinhole::from_slice(&[-0.1, 0.02]).unwrap());
        let camera = Camera::new(Intrinsics::from_hfov(ImageSize::new(7, 5), 1.2), lens);
        let depth: Vec<f32> = (0u8..35).map(|at| f32::from(at) * 0.1).collect();
        let view = DepthView::Metres(ImageView::new(7, 5, &depth).unwrap());
        let rays = rays(&camera);
        let points: Vec<[f32; 3]> = points(&rays, view).collect();
        assert!(points[0][0].is_nan());
        for (at, point) in points.iter().enumerate().skip(1) {
            assert_eq!(point[2], depth[at]);
            let pixel = camera
                .project(DVec3::from(point.map(f64::from)))
                .unwrap()
                .to::<OpenCv>();
            let (x, y) = ((at % 7) as f64, (at / 7) as f64);
            assert!(
                (pixel.x - x).abs() < 1e-5 && (pixel.y - y).abs() < 1e-5,
                "{pixel:?}"
            );
        }
    }
}

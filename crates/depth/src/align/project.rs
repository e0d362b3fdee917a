use oaktwin_camera::math::DVec3;
use oaktwin_camera::{Camera, ImageSize, LensModel, Usd};

use super::MOST_PIXELS_A_SIDE;

/// Projects points into one camera.
pub(super) struct Projection {
    camera: Camera,
    /// fx, fy and the principal point (USD's convention), px.
    f: [f64; 2],
    c: [f64; 2],
    size: ImageSize,
}

impl Projection {
    pub(super) fn new(camera: &Camera, size: ImageSize) -> Self {
        let centre = camera.intrinsics.principal_point::<Usd>();
        Self {
            camera: *camera,
            f: [camera.intrinsics.fx, camera.intrinsics.fy],
            c: [centre.x, centre.y],
            size,
        }
    }

    /// Returns the projection of a point, which may lie outside the image; the first pixel covers 0 to 1. Returns `None`
    /// behind the camera and outside the lens's range.
    #[inline]
    pub(super) fn pixel(&self, point_in_target: DVec3) -> Option<[f64; 2]> {
        if point_in_target.z <= 0.0 || point_in_target.z.is_nan() {
            return None;
        }
        if self.camera.lens == LensModel::Pinhole {
            let inverse = 1.0 / point_in_target.z;
            return Some([
                self.f[0] * point_in_target.x * inverse + self.c[0],
                self.f[1] * point_in_target.y * inverse + self.c[1],
            ]);
        }
        let pixel = self.camera.project(point_in_target)?.to::<Usd>();
        Some([pixel.x, pixel.y])
    }

    /// Visits the pixel that contains `[u, v]` and those whose centres are within `half` of it.
    #[inline]
    pub(super) fn cover(&self, [u, v]: [f64; 2], half: [f64; 2], mut visit: impl FnMut(usize)) {
        let columns = span(u, half[0], self.size.width);
        let rows = span(v, half[1], self.size.height);
        let width = self.size.width as usize;
        for y in rows {
            for x in columns.clone() {
                visit(y as usize * width + x as usize);
            }
        }
    }
}

/// Returns the pixels of an axis of `length` that a sample at `at` covers.
#[inline]
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "cut to the image before"
)]
fn span(at: f64, half: f64, length: u32) -> std::ops::Range<u32> {
    let own = at.floor();
    let half = half.min(f64::from(MOST_PIXELS_A_SIDE / 2));
    // Pixel centres are at half pixels: from the first that is not left of the span to the last inside it.
    let first = (at - half - 0.5).ceil().min(own);
    let end = ((at + half - 0.5).floor() + 1.0).max(own + 1.0);
    let length = f64::from(length);
    // False for NaN; outside the image there are no pixels.
    if !(first < length && end > 0.0) {
        return 0..0;
    }
    first.max(0.0) as u32..end.min(length) as u32
}

use oaktwin_camera::math::{DMat3, DVec3};
use oaktwin_camera::{Camera, LensModel, RigidTransform, Usd};
use oaktwin_dataset::StereoImages;
use oaktwin_depth::imager::Recorded;
use oaktwin_image::Image;
use oaktwin_render::{Backend, Renderer, View};

use super::Pair;

/// The maximum difference between the disparities of a surface in both images, px.
const SAME_SURFACE_PX: f64 = 1.0;
/// The signs of a disparity from the left image to the right one, and back.
const SIGNS: [f64; 2] = [-1.0, 1.0];

impl Pair {
    /// Returns the rectified images with their exact disparity; `left` is the view of the rectified left camera.
    #[must_use]
    pub fn images(&self, renderer: &Renderer, left: &View) -> StereoImages {
        let geometry = &self.geometry;
        let cameras =
            [geometry.left, geometry.right].map(|intrinsics| Camera::new(intrinsics, LensModel::Pinhole));
        let right_from_left = RigidTransform::new(DMat3::IDENTITY, DVec3::new(geometry.baseline, 0.0, 0.0));
        let right = View {
            camera: cameras[1],
            world_from_camera: left.world_from_camera * right_from_left,
            clip: left.clip,
        };
        let right_z = renderer.depth(&right, Backend::Auto);
        let [left_x, right_x] =
            [geometry.left, geometry.right].map(|camera| camera.principal_point::<Usd>().x);
        let (scale, offset) = (geometry.left.fx * geometry.baseline, left_x - right_x);
        let disparity = |z: f32| scale / f64::from(z) + offset;
        let depths = [&self.z.0, &right_z.0];
        let matches = [0, 1].map(|side| matches(depths[side], depths[1 - side], SIGNS[side], disparity));
        let [(left, left_matched), (right, right_matched)] = matches;
        StereoImages {
            images: [&self.rectified_left, &self.rectified_right].map(eight_bits),
            cameras,
            baseline_m: geometry.baseline,
            disparities: [left, right],
            is_matched: [left_matched, right_matched],
        }
    }
}

/// Returns the disparity of each pixel, and whether the other image shows its surface.
fn matches(
    own: &Image<f32>,
    other: &Image<f32>,
    sign: f64,
    disparity: impl Fn(f32) -> f64,
) -> (Image<f32>, Image<bool>) {
    let (width, height) = (own.width(), own.height());
    let mut disparities = Image::filled(width, height, f32::INFINITY);
    let mut is_matched = Image::filled(width, height, false);
    let pixels = disparities.pixels_mut().iter_mut().zip(is_matched.pixels_mut());
    for ((index, z), (found, matched)) in (0u32..).zip(own.pixels()).zip(pixels) {
        if !z.is_finite() {
            continue;
        }
        let (x, y) = (index % width.max(1), index / width.max(1));
        let own = disparity(*z);
        #[expect(
            clippy::cast_possible_truncation,
            reason = "images are float32, and the cast saturates"
        )]
        let (narrow, column) = (own as f32, (f64::from(x) + sign * own).round() as i64);
        *found = narrow;
        let there = u32::try_from(column).ok().and_then(|column| other.get(column, y));
        *matched = there.is_some_and(|z| z.is_finite() && disparity(*z) - own <= SAME_SURFACE_PX);
    }
    (disparities, is_matched)
}

fn eight_bits(image: &Recorded) -> Image<u8> {
    match image {
        Recorded::Eight(image) => image.clone(),
        Recorded::Ten(image) => image.map(|value| (*value >> 2).min(255) as u8),
    }
}

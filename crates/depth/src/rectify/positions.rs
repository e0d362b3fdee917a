//! The positions of rectified pixels in the raw image.

use oaktwin_camera::math::DMat3;
use oaktwin_camera::{
    Camera, ImageSize, Intrinsics, LensModel, OpenCv, OpenCvPinhole, PixelPoint, undistort_rectify_map,
};

use super::Method;

/// The spacing of a mesh's nodes in pixels (`StereoDepth`'s `meshStep`).
const STEP: u32 = 16;

/// `[x, y]` in the OpenCV convention for each pixel, row by row; NaN where a ray points backwards.
pub(super) fn positions(
    camera: &Camera,
    rectified_from_camera: DMat3,
    rectified: &Intrinsics,
    method: Method,
) -> Vec<[f32; 2]> {
    match method.for_camera(camera) {
        Method::Auto | Method::Homography => {
            let straight = Camera::new(camera.intrinsics, LensModel::Pinhole);
            undistort_rectify_map(&straight, rectified_from_camera, rectified).collect()
        }
        Method::Mesh => mesh(camera, rectified_from_camera, rectified),
        Method::Full => undistort_rectify_map(camera, rectified_from_camera, rectified).collect(),
    }
}

/// The distances in pixels between the positions of a homography and of the lens, for pixels [`STEP`] apart.
pub(super) fn remaining(
    camera: &Camera,
    rectified_from_camera: DMat3,
    rectified: &Intrinsics,
) -> impl Iterator<Item = f32> {
    let coarse = coarse(rectified, 0);
    let [straight, bent] = [Method::Homography, Method::Full]
        .map(|method| positions(camera, rectified_from_camera, &coarse, method));
    let inside = |x: f32, side: u32| x >= 0.0 && x <= side as f32;
    let ImageSize { width, height } = camera.intrinsics.size;
    straight
        .into_iter()
        .zip(bent)
        // A pixel outside the raw image has no error.
        .filter(move |([x, y], _)| inside(*x, width) && inside(*y, height))
        .map(|(a, b)| (a[0] - b[0]).hypot(a[1] - b[1]))
}

/// The intrinsics of every [`STEP`]th pixel, with further ones at the end of rows and columns. The first pixel centre coincides.
fn coarse(rectified: &Intrinsics, further: u32) -> Intrinsics {
    let size = rectified.size;
    let step = f64::from(STEP);
    let centre = rectified.principal_point::<OpenCv>();
    Intrinsics::new(
        ImageSize::new(
            size.width.div_ceil(STEP) + further,
            size.height.div_ceil(STEP) + further,
        ),
        rectified.fx / step,
        rectified.fy / step,
        PixelPoint::<OpenCv>::new(centre.x / step, centre.y / step),
    )
}

fn mesh(camera: &Camera, rectified_from_camera: DMat3, rectified: &Intrinsics) -> Vec<[f32; 2]> {
    let lens = match camera.lens {
        LensModel::OpenCvPinhole(lens) => LensModel::OpenCvPinhole(first_eight(&lens)),
        other => other,
    };
    let camera = Camera::new(camera.intrinsics, lens);
    let size = rectified.size;
    let coarse = coarse(rectified, 1);
    let nodes = coarse.size;
    let at: Vec<[f32; 2]> = undistort_rectify_map(&camera, rectified_from_camera, &coarse).collect();
    let node = |x: u32, y: u32| {
        at.get(y as usize * nodes.width as usize + x as usize)
            .copied()
            .unwrap_or([f32::NAN; 2])
    };
    #[expect(clippy::cast_precision_loss, reason = "below 16")]
    let part = |at: u32| (at % STEP) as f32 / STEP as f32;
    (0..size.height)
        .flat_map(|y| (0..size.width).map(move |x| (x, y)))
        .map(|(x, y)| {
            let (column, row) = (x / STEP, y / STEP);
            let top = mixed(node(column, row), node(column + 1, row), part(x));
            let bottom = mixed(node(column, row + 1), node(column + 1, row + 1), part(x));
            mixed(top, bottom, part(y))
        })
        .collect()
}

fn first_eight(lens: &OpenCvPinhole) -> OpenCvPinhole {
    let mut coefficients = *lens.coefficients();
    coefficients[8..].fill(0.0);
    OpenCvPinhole::new(coefficients)
}

fn mixed(a: [f32; 2], b: [f32; 2], part: f32) -> [f32; 2] {
    [a[0] + (b[0] - a[0]) * part, a[1] + (b[1] - a[1]) * part]
}

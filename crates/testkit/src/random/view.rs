use oaktwin_camera::math::{DMat3, DVec3};
use oaktwin_camera::{
    Camera, ImageSize, Intrinsics, LensModel, OpenCvFisheye, OpenCvPinhole, PixelPoint, RigidTransform, Usd,
};
use oaktwin_render::{Clip, View};

use super::Random;

/// The lens of a random camera.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lens {
    /// An ideal pinhole, 20° to 110° wide, with a shifted principal point and slightly non-square pixels.
    Pinhole,
    /// OpenCV's rational model with coefficients typical of a calibrated 80° camera.
    Rational,
    /// OpenCV's fisheye model, 127° wide.
    Fisheye,
}

impl Lens {
    /// All lenses.
    pub const ALL: [Self; 3] = [Self::Pinhole, Self::Rational, Self::Fisheye];
}

/// Creates a camera of `size` pixels within 6 m of `centre`, often inside objects, that roughly faces the centre.
#[must_use]
pub fn view(lens: Lens, size: ImageSize, centre: DVec3, random: &mut Random) -> View {
    let width = f64::from(size.width);
    let middle = PixelPoint::<Usd>::new(
        width / 2.0 + random.range(-2.0, 2.0),
        f64::from(size.height) / 2.0 + random.range(-2.0, 2.0),
    );
    let camera = match lens {
        Lens::Pinhole => {
            let hfov = random.range(20.0, 110.0).to_radians();
            let focal = width / 2.0 / (hfov / 2.0).tan();
            let intrinsics = Intrinsics::new(size, focal, focal * random.range(0.95, 1.05), middle);
            Camera::new(intrinsics, LensModel::Pinhole)
        }
        Lens::Rational => {
            let focal = width / 2.0 / 40f64.to_radians().tan();
            let mut coefficients = [0.0; 14];
            coefficients[..8].copy_from_slice(&[8.4, 3.1, 3e-4, -2e-4, 0.14, 8.8, 5.6, 0.9]);
            let intrinsics = Intrinsics::new(size, focal, focal, middle);
            Camera::new(
                intrinsics,
                LensModel::OpenCvPinhole(OpenCvPinhole::new(coefficients)),
            )
        }
        Lens::Fisheye => {
            let focal = width / 127f64.to_radians();
            let k = [-0.023, -0.0012, 0.002, -0.0024];
            let intrinsics = Intrinsics::new(size, focal, focal, middle);
            Camera::new(intrinsics, LensModel::OpenCvFisheye(OpenCvFisheye { k }))
        }
    };
    let from = random.magnitude(0.05, 6.0) * random.direction();
    let target = 0.5 * random.in_cube();
    let forward = (target - from).try_normalize().unwrap_or(DVec3::Z);
    let right = forward
        .cross(random.direction())
        .try_normalize()
        .unwrap_or_else(|| forward.any_orthonormal_vector());
    let rotation = DMat3::from_cols(right, forward.cross(right), forward);
    let near_m = if random.below(3) == 0 {
        random.magnitude(0.02, 2.0)
    } else {
        0.01
    };
    let far_m = if random.below(3) == 0 {
        random.magnitude(3.0, 30.0)
    } else {
        1e7
    };
    View {
        camera,
        world_from_camera: RigidTransform::new(rotation, centre + from),
        clip: Clip { near_m, far_m },
    }
}

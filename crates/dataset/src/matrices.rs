//! The matrices of `camera_params`, as four rows each, for points as rows.

use oaktwin_camera::math::DMat4;
use oaktwin_camera::{Axes, LensModel, Usd};

use crate::FrameCamera;

/// Returns the matrix from camera to clip space.
pub(crate) fn projection(view: &FrameCamera) -> [f64; 16] {
    let size = view.camera.intrinsics.size;
    let (width, height) = (f64::from(size.width), f64::from(size.height));
    let intrinsics = match view.camera.lens {
        LensModel::Pinhole => view.camera.intrinsics,
        _ => view.optics.isaac_intrinsics(size),
    };
    let centre = intrinsics.principal_point::<Usd>();
    let [near, far] = view.clipping_range;
    // For an infinite far plane, these are the limits of n/(f − n) and n f/(f − n).
    let (depth, depth_offset) = if far.is_finite() {
        (near / (far - near), near * far / (far - near))
    } else {
        (0.0, near)
    };
    let mut m = [0.0; 16];
    m[0] = 2.0 * intrinsics.fx / width;
    m[5] = 2.0 * intrinsics.fy / height;
    m[8] = 1.0 - 2.0 * centre.x / width;
    m[9] = 2.0 * centre.y / height - 1.0;
    m[10] = depth;
    m[11] = -1.0;
    m[14] = depth_offset;
    m
}

/// Returns the matrix from world to camera, scene units.
pub(crate) fn view_transform(view: &FrameCamera) -> [f64; 16] {
    let usd_from_opencv = Axes::Usd.rotation_from(Axes::OpenCv);
    let camera_from_world = view.world_from_camera.inverse();
    let m = DMat4::from_mat3_translation(
        usd_from_opencv * camera_from_world.rotation,
        usd_from_opencv * camera_from_world.translation / view.meters_per_unit,
    );
    // Columns of a matrix for column vectors are the rows for row vectors. Adding 0 replaces −0 by 0.
    m.to_cols_array().map(|value| value + 0.0)
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::CameraParams;
    use oaktwin_camera::math::{DMat3, DVec3, DVec4};
    use oaktwin_camera::{Camera, ImageSize, Intrinsics, PixelPoint, RigidTransform, UsdOptics};
    use proptest::prelude::*;

    /// The camera in the tests of Isaac Sim's pose writer.
    pub(crate) fn view(eye: DVec3, right: DVec3, up: DVec3, clipping_range: [f64; 2]) -> FrameCamera {
        let optics = UsdOptics {
            focal_length_mm: 24.0,
            horizontal_aperture_mm: 20.955,
            vertical_aperture_mm: 15.2908,
            horizontal_aperture_offset_mm: 0.0,
            vertical_aperture_offset_mm: 0.0,
        };
        let intrinsics = optics.isaac_intrinsics(ImageSize::new(512, 512));
        FrameCamera {
            optics,
            camera: Camera::new(intrinsics, LensModel::Pinhole),
            world_from_camera: RigidTransform::new(DMat3::from_cols(right, -up, up.cross(right)), eye),
            clipping_range,
            meters_per_unit: 1.0,
            focus_distance: 400.0,
            f_stop: 0.0,
        }
    }

    proptest! {
        /// Projects a point by the documented formula of the two matrices, and compares with the camera.
        #[test]
        fn a_point_lands_on_its_pixel(
            axis in prop::array::uniform3(-1.0..1.0f64), angle in -3.0..3.0f64, eye in prop::array::uniform3(-9.0..9.0f64),
            point in (-1.0..1.0f64, -1.0..1.0f64, 0.5..20.0f64), cx in 300.0..900.0f64, cy in 200.0..600.0f64,
        ) {
            prop_assume!(DVec3::from(axis).length() > 0.1);
            let rotation = DMat3::from_axis_angle(DVec3::from(axis).normalize(), angle);
            let mut view = view(DVec3::ZERO, DVec3::X, DVec3::Y, [0.1, 100.0]);
            view.world_from_camera = RigidTransform::new(rotation, eye.into());
            view.meters_per_unit = 0.01;
            let size = ImageSize::new(1280, 800);
            view.camera.intrinsics = Intrinsics::new(size, 800.0, 790.0, PixelPoint::<Usd>::new(cx, cy));
            let params = CameraParams::new(&view);

            let point_in_camera = DVec3::from(point);
            let point_in_world = view.world_from_camera.apply(point_in_camera) / view.meters_per_unit;
            // For row vectors, these are transposes of glam's matrices.
            let matrix = |rows: &[f64; 16]| DMat4::from_cols_array(rows);
            let clip: DVec4 =
                matrix(&params.projection) * (matrix(&params.view_transform) * point_in_world.extend(1.0));
            let u = (clip.x / clip.w + 1.0) / 2.0 * 1280.0;
            let v = (1.0 - clip.y / clip.w) / 2.0 * 800.0;
            let pixel = view.camera.project(point_in_camera).unwrap().to::<Usd>();
            prop_assert!((pixel.x - u).abs() < 1e-6 && (pixel.y - v).abs() < 1e-6, "{u} {v} {pixel:?}");
        }
    }
}

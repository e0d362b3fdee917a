use glam::DMat3;

use crate::{Camera, Intrinsics, OpenCv, PixelPoint};

/// Returns the source position of each pixel of a rectified image: the lookup table of `cv2.initUndistortRectifyMap` and, for
/// a fisheye lens, `cv2.fisheye.initUndistortRectifyMap`.
///
/// The items are `[x, y]` in the [`OpenCv`] convention for each pixel of `rectified.size`, row by row. As in OpenCV, positions
/// may be outside the image, and beyond the lens model's fold they follow its formula. NaN where a ray does not intersect the
/// plane z = 1 (OpenCV divides anyway).
///
/// ```
/// use oaktwin_camera::{Camera, ImageSize, Intrinsics, LensModel, math::DMat3, undistort_rectify_map};
///
/// let intrinsics = Intrinsics::from_hfov(ImageSize::new(4, 2), 1.2);
/// let camera = Camera::new(intrinsics, LensModel::Pinhole);
/// let map: Vec<[f32; 2]> = undistort_rectify_map(&camera, DMat3::IDENTITY, &intrinsics).collect();
/// assert_eq!(map.len(), 8);
/// assert!((map[5][0] - 1.0).abs() < 1e-6 && (map[5][1] - 1.0).abs() < 1e-6);
/// ```
pub fn undistort_rectify_map(
    camera: &Camera,
    rectified_from_camera: DMat3,
    rectified: &Intrinsics,
) -> impl Iterator<Item = [f32; 2]> + use<> {
    let (camera, rectified) = (*camera, *rectified);
    let camera_from_rectified = rectified_from_camera.transpose();
    (0..rectified.size.height).flat_map(move |row| {
        (0..rectified.size.width).map(move |column| {
            let pixel = PixelPoint::<OpenCv>::new(f64::from(column), f64::from(row));
            let ray = camera_from_rectified * rectified.normalized_from_pixel(pixel).extend(1.0);
            let normalized = ray.truncate() / ray.z;
            if ray.z <= 0.0 {
                return [f32::NAN; 2];
            }
            let source = camera
                .intrinsics
                .pixel_from_normalized(camera.lens.distort(normalized));
            source.xy().as_vec2().to_array()
        })
    })
}

use oaktwin_camera::Intrinsics;
use oaktwin_camera::math::{DMat3, DVec2, DVec3};

/// How far, in pixels, the image moves at most when a lens's tilt (τx, τy, rad) is left out.
///
/// The tilt is the last step of OpenCV's model, so the error at a pixel follows from the pixel alone: its ray needs
/// no undistortion. The error is smooth; its extreme lies on the border or the centre lines of the image.
pub(super) fn largest_error_px(intrinsics: &Intrinsics, [tau_x, tau_y]: [f64; 2]) -> f64 {
    const STEPS: u32 = 32;
    let tilt = tilt_matrix(tau_x, tau_y);
    let (width, height) = (
        f64::from(intrinsics.size.width),
        f64::from(intrinsics.size.height),
    );
    let at = |i: u32, extent: f64| f64::from(i) / f64::from(STEPS) * extent;
    let mut worst = 0.0_f64;
    for i in 0..=STEPS {
        for j in 0..=STEPS {
            let pixel = oaktwin_camera::PixelPoint::<oaktwin_camera::Usd>::new(at(i, width), at(j, height));
            let untilted = intrinsics.normalized_from_pixel(pixel);
            let tilted = tilt * untilted.extend(1.0);
            let tilted = DVec2::new(tilted.x, tilted.y) / tilted.z;
            let moved = (tilted - untilted) * DVec2::new(intrinsics.fx, intrinsics.fy);
            worst = worst.max(moved.length());
        }
    }
    worst
}

/// OpenCV's matTilt (documentation of `calib3d`, "Detailed Description").
fn tilt_matrix(tau_x: f64, tau_y: f64) -> DMat3 {
    let rotation = DMat3::from_rotation_y(-tau_y) * DMat3::from_rotation_x(-tau_x);
    let (r13, r23, r33) = (rotation.z_axis.x, rotation.z_axis.y, rotation.z_axis.z);
    let projection = DMat3::from_cols(
        DVec3::new(r33, 0.0, 0.0),
        DVec3::new(0.0, r33, 0.0),
        DVec3::new(-r13, -r23, 1.0),
    );
    projection * rotation
}

#[cfg(test)]
mod tests {
    use super::*;
    use oaktwin_camera::ImageSize;

    #[test]
    fn no_tilt_no_error_and_more_tilt_more_error() {
        let camera = Intrinsics::from_hfov(ImageSize::new(1280, 800), 77_f64.to_radians());
        assert_eq!(largest_error_px(&camera, [0.0, 0.0]), 0.0);
        let small = largest_error_px(&camera, [0.001, 0.0]);
        let large = largest_error_px(&camera, [0.01, 0.0]);
        assert!(small > 0.01 && large > 9.0 * small, "{small} {large}");
    }

    /// The rotation that OpenCV's documentation prints, entry by entry.
    #[test]
    fn rotation_is_that_of_opencv() {
        let (x, y) = (0.02_f64, -0.03_f64);
        let rows = [
            [y.cos(), y.sin() * x.sin(), -y.sin() * x.cos()],
            [0.0, x.cos(), x.sin()],
            [y.sin(), -y.cos() * x.sin(), y.cos() * x.cos()],
        ];
        let expected = DMat3::from_cols_array_2d(&rows).transpose();
        let ours = DMat3::from_rotation_y(-y) * DMat3::from_rotation_x(-x);
        assert!(ours.abs_diff_eq(expected, 1e-15));
    }
}

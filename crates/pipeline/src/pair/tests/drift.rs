//! A pair that has drifted since its calibration: dots are where the closed forms expect them.

use super::*;
use oaktwin_camera::StereoDrift;

#[test]
fn dots_are_where_the_drifted_cameras_see_them() {
    // A unit that must be rectified, and a nominal pair that is already.
    for twin in [
        twin("oak-d-pro-poe"),
        unit("oak-d-pro-poe", "example-oak-d-pro-poe.json"),
    ] {
        let drift = StereoDrift::parse("yaw=1.5,pitch=-1,roll=2,baseline=300,focalLength=800").unwrap();
        let x = 1.3f32;
        // A homography would leave the unit's distortion.
        let rectify = RectifyOptions {
            method: Method::Full,
            ..RectifyOptions::of(oaktwin_depth::preset::Platform::Rvc2)
        };
        let calibrated = PairOptions {
            rectify: Some(rectify),
            ..dots_only(0.5)
        };
        let options = PairOptions { drift, ..calibrated };
        let cameras = PairCameras::new(&twin, &options).unwrap();
        let calibrated = PairCameras::new(&twin, &calibrated).unwrap();
        assert_eq!(cameras.rectify().geometry(), calibrated.rectify().geometry());
        let seen = cameras.capture(&wall(x), &RigidTransform::IDENTITY, 0);
        let images = [&seen.rectified_left, &seen.rectified_right].map(numbers);
        let geometry = seen.geometry;
        let matches = drift.matches(&geometry.left, geometry.baseline);
        let rectified_from_body = calibrated.body_from_rectified_left().inverse();
        let mut errors = [Vec::new(), Vec::new()];
        for point in dots_on_wall(&twin, f64::from(x)) {
            let in_left = rectified_from_body.apply(point);
            let actual = drift.intrinsics(&geometry.left);
            let left = actual.pixel_from_normalized(in_left.truncate() / in_left.z);
            let error = matches.error(left, in_left.z);
            let disparity = geometry.stereo_geometry().disparity(in_left.z);
            let right = PixelPoint::new(left.x - disparity - error.disparity_px, left.y + error.row_px);
            let found = [centroid(&images[0], left), centroid(&images[1], right)];
            if let [Some((in_left, a)), Some((in_right, b))] = found
                && a > 400.0
                && b > 400.0
            {
                errors[0].push((in_left.xy() - left.xy()).length());
                errors[1].push((in_right.xy() - right.xy()).length());
            }
        }
        let [left, right] = errors.map(|errors| (errors.len(), within(&errors, 0.95)));
        println!("{left:?} {right:?}");
        assert!(left.0 > 1500 && left.1 < 0.15 && right.1 < 0.15);
    }
}

//! The change of a stereo pair since its calibration.

use glam::{DMat3, DVec3};
use oaktwin_base::parameter::{ParameterError, Platform, Table, parameters, settings};

use crate::{BaselineAxis, Intrinsics, OpenCv, PixelPoint, RigidTransform, StereoGeometry};

parameters! {
    /// The change of a stereo pair since its calibration, to which its images are still rectified. The left camera keeps its
    /// pose; angles rotate the right camera in the frame of the rectified images (x right, y down, z forward).
    pub struct StereoDrift("drift", platform) {
        /// The rotation to the right. It adds f·tan(yaw)·(1 + x²) to disparity, with x = tan of the angle from the optical axis.
        yaw_mrad: f64 = 0.0 => ("yaw".unit("mrad").range(-50.0..=50.0)),
        /// The rotation upwards. It moves the right image down by f·tan(pitch)·(1 + y²).
        pitch_mrad: f64 = 0.0 => ("pitch".unit("mrad").range(-50.0..=50.0)),
        /// The clockwise rotation about the optical axis. It moves the right image by x·tan(roll) vertically.
        roll_mrad: f64 = 0.0 => ("roll".unit("mrad").range(-50.0..=50.0)),
        /// The growth of the baseline. Depth becomes too small by the same fraction.
        baseline_um: f64 = 0.0 => ("baseline".unit("µm").range(-5000.0..=5000.0)),
        /// The growth of both focal lengths. Depth becomes too small by the same fraction.
        focal_length_ppm: f64 = 0.0 => ("focalLength".unit("ppm").range(-50000.0..=50000.0)),
        /// The warming of both lenses, each kelvin of which adds 50 ppm to the focal lengths: an estimate between glass (about
        /// 10 ppm) and a single lens of acrylic (about 280 ppm).
        temperature_k: f64 = 0.0 => ("temperature".unit("K").range(-100.0..=100.0).estimate()),
    }
}

/// The growth of the focal lengths with temperature, 1/K: an estimate. From dn/dT and expansion, acrylic has 2.8e-4 and BK7 glass
/// about 1e-5; OAKs have lenses of several materials.
const FOCAL_LENGTH_PER_K: f64 = 5e-5;

impl Default for StereoDrift {
    fn default() -> Self {
        Self::defaults(Platform::default())
    }
}

/// The error of a match.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MatchError {
    /// The measured minus the true disparity, px.
    pub disparity_px: f64,
    /// The vertical offset of the right image, px, positive downwards. Block matching loses density where it is large.
    pub row_px: f64,
}

impl StereoDrift {
    /// Reads a drift from text: `yaw=0.3,baseline=50`.
    ///
    /// # Errors
    /// Returns an error if a name is unknown or a value is out of range.
    pub fn parse(text: &str) -> Result<Self, ParameterError> {
        let mut drift = Self::default();
        for setting in settings(text) {
            let (name, value) = setting.map_err(|setting| {
                let what = format!("'{setting}' has no value");
                ParameterError::new("drift", what, "write NAME=VALUE,…, as in yaw=0.3,baseline=50")
            })?;
            drift.set_by_name(name, value).map_err(|error| {
                ParameterError::new("drift", format!("{}: {}", error.name, error.what), error.remedy)
            })?;
        }
        Ok(drift)
    }

    /// Returns the text of a drift that [`StereoDrift::parse`] reads: what differs from 0.
    #[must_use]
    pub fn to_text(&self) -> String {
        let none = Self::default();
        let rows = Self::rows().filter(|row| (row.get)(self) != (row.get)(&none));
        let settings = rows.map(|row| format!("{}={}", row.about.name, (row.get)(self)));
        settings.collect::<Vec<_>>().join(",")
    }

    /// Whether nothing has changed.
    #[must_use]
    pub fn is_none(&self) -> bool {
        *self == Self::default()
    }

    /// Returns the actual focal lengths divided by the calibrated ones.
    #[must_use]
    pub fn focal_length_ratio(&self) -> f64 {
        1.0 + self.focal_length_ppm * 1e-6 + self.temperature_k * FOCAL_LENGTH_PER_K
    }

    /// Returns the actual intrinsics of a camera.
    #[must_use]
    pub fn intrinsics(&self, calibrated: &Intrinsics) -> Intrinsics {
        let ratio = self.focal_length_ratio();
        let centre = calibrated.principal_point::<OpenCv>();
        Intrinsics::new(
            calibrated.size,
            calibrated.fx * ratio,
            calibrated.fy * ratio,
            centre,
        )
    }

    /// Returns the growth of the baseline, m.
    #[must_use]
    pub fn baseline_m(&self) -> f64 {
        self.baseline_um * 1e-6
    }

    /// Returns the rotation of the actual right camera: from its frame to the calibrated rectified frame.
    #[must_use]
    pub fn rectified_from_actual(&self) -> DMat3 {
        let [pitch, yaw, roll] = [self.pitch_mrad, self.yaw_mrad, self.roll_mrad].map(|angle| angle * 1e-3);
        DMat3::from_rotation_y(yaw) * DMat3::from_rotation_x(pitch) * DMat3::from_rotation_z(roll)
    }

    /// Returns the actual pose of the right camera in the frame in which its calibrated pose is given, m.
    /// `rectified_from_right` is the rotation that rectifies its images.
    #[must_use]
    pub fn right_camera(
        &self,
        calibrated: &RigidTransform,
        rectified_from_right: DMat3,
        axis: BaselineAxis,
    ) -> RigidTransform {
        let right_from_rectified = rectified_from_right.transpose();
        let along = match axis {
            BaselineAxis::Horizontal => DVec3::X,
            BaselineAxis::Vertical => DVec3::Y,
        };
        let moved = right_from_rectified * along * self.baseline_m();
        let turned = right_from_rectified * self.rectified_from_actual() * rectified_from_right;
        *calibrated * RigidTransform::new(turned, moved)
    }

    /// Prepares the errors of the matches of rectified images with these calibrated intrinsics and baseline in metres. The cameras
    /// are side by side.
    #[must_use]
    pub fn matches(&self, intrinsics: &Intrinsics, baseline_m: f64) -> DriftedMatches {
        DriftedMatches {
            actual: self.intrinsics(intrinsics),
            right_from_left: RigidTransform::new(
                self.rectified_from_actual(),
                DVec3::new(baseline_m + self.baseline_m(), 0.0, 0.0),
            )
            .inverse(),
            stereo: StereoGeometry {
                focal_length_px: intrinsics.fx,
                baseline_m,
            },
        }
    }
}

/// What a drifted pair sees in its rectified images.
#[derive(Clone, Copy, Debug)]
pub struct DriftedMatches {
    /// The actual intrinsics of both cameras.
    pub actual: Intrinsics,
    /// The actual transform from the left to the right camera, m.
    pub right_from_left: RigidTransform,
    /// The calibrated geometry.
    pub stereo: StereoGeometry,
}

impl DriftedMatches {
    /// Returns the error of the match of a rectified left pixel that sees a surface at a depth in metres.
    #[must_use]
    pub fn error(&self, pixel: PixelPoint<OpenCv>, depth_m: f64) -> MatchError {
        let ray = self.actual.normalized_from_pixel(pixel).extend(1.0);
        let seen = self.right_from_left.apply(ray * depth_m);
        let right = self.actual.pixel_from_normalized(seen.truncate() / seen.z);
        MatchError {
            disparity_px: pixel.x - right.x - self.stereo.disparity(depth_m),
            row_px: right.y - pixel.y,
        }
    }

    /// Returns the depth that the calibration assigns to the match of such a pixel, metres; infinite at or below a disparity of 0.
    #[must_use]
    pub fn assumed_depth(&self, pixel: PixelPoint<OpenCv>, depth_m: f64) -> f64 {
        let disparity = self.stereo.disparity(depth_m) + self.error(pixel, depth_m).disparity_px;
        if disparity > 0.0 {
            self.stereo.depth(disparity)
        } else {
            f64::INFINITY
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ImageSize;

    const BASELINE_M: f64 = 0.075;

    fn camera() -> Intrinsics {
        let centre = PixelPoint::<OpenCv>::new(639.5, 399.5);
        Intrinsics::new(ImageSize::new(1280, 800), 800.0, 800.0, centre)
    }

    fn error(drift: &str, at: [f64; 2], depth_m: f64) -> MatchError {
        let drift = StereoDrift::parse(drift).unwrap();
        let pixel = PixelPoint::new(639.5 + at[0], 399.5 + at[1]);
        drift.matches(&camera(), BASELINE_M).error(pixel, depth_m)
    }

    fn assert_near(a: f64, b: f64, within: f64) {
        assert!((a - b).abs() < within, "{a} is not {b}");
    }

    #[test]
    fn no_drift_has_no_error() {
        let found = error("", [300.0, -200.0], 2.0);
        assert_near(found.disparity_px, 0.0, 1e-9);
        assert_near(found.row_px, 0.0, 1e-9);
        assert!(StereoDrift::default().is_none());
    }

    #[test]
    fn yaw_offsets_disparity() {
        for depth_m in [0.6, 3.0, 50.0] {
            let at_axis = error("yaw=0.5", [0.0, 0.0], depth_m);
            assert_near(at_axis.disparity_px, 0.4, 0.01);
            assert_near(at_axis.row_px, 0.0, 1e-9);
        }
        // At infinity the right image's x is the left one's.
        let aside = error("yaw=0.5", [400.0, 0.0], 1e6);
        assert_near(aside.disparity_px, 0.4 * (1.0 + 0.25), 1e-3);
    }

    #[test]
    fn pitch_and_roll_move_rows() {
        let found = error("pitch=-1", [0.0, 200.0], 1e6);
        assert_near(found.row_px, -0.8 * (1.0 + 0.0625), 1e-3);
        assert_near(found.disparity_px, 0.0, 1e-3);
        let found = error("roll=2", [300.0, 100.0], 1e6);
        assert_near(found.row_px, -0.6, 2e-3);
        assert_near(found.disparity_px, -0.2, 2e-3);
    }

    #[test]
    fn baseline_and_focal_length_scale_disparity() {
        let disparity = 800.0 * BASELINE_M / 2.0;
        let found = error("baseline=75", [123.0, -7.0], 2.0);
        assert_near(found.disparity_px, disparity * 1e-3, 1e-9);
        let found = error("focal-length=1000", [123.0, -7.0], 2.0);
        assert_near(found.disparity_px, disparity * 1e-3, 1e-9);
        let found = error("temperature=20", [0.0, 0.0], 2.0);
        assert_near(found.disparity_px, disparity * 1e-3, 1e-9);
    }

    #[test]
    fn the_pose_of_the_right_camera_gives_the_same_match() {
        let drift = StereoDrift::parse("yaw=1,pitch=-2,roll=3,baseline=200,focalLength=900").unwrap();
        // A pair that is not yet rectified.
        let rectified_from_right = DMat3::from_rotation_y(0.02) * DMat3::from_rotation_x(-0.01);
        let calibrated = RigidTransform::new(rectified_from_right, DVec3::new(BASELINE_M, 0.0, 0.0));
        let actual = drift.right_camera(&calibrated, rectified_from_right, BaselineAxis::Horizontal);
        let pixel = PixelPoint::<OpenCv>::new(800.0, 250.0);
        let intrinsics = drift.intrinsics(&camera());
        let point = intrinsics.normalized_from_pixel(pixel).extend(1.0) * 1.7;
        // Rectification turns what the actual camera sees as its calibration says.
        let seen = rectified_from_right * actual.inverse().apply(point);
        let right = intrinsics.pixel_from_normalized(seen.truncate() / seen.z);
        let expected = drift.matches(&camera(), BASELINE_M).error(pixel, 1.7);
        let true_disparity = 800.0 * BASELINE_M / 1.7;
        assert_near(pixel.x - right.x - true_disparity, expected.disparity_px, 1e-9);
        assert_near(right.y - pixel.y, expected.row_px, 1e-9);
    }

    #[test]
    fn text_is_checked() {
        let message = |text| StereoDrift::parse(text).unwrap_err().to_string();
        assert!(message("yawn=1").contains("yaw"), "{}", message("yawn=1"));
        assert!(message("yaw").contains("has no value"));
        assert!(message("yaw=nan").contains("NaN"), "{}", message("yaw=nan"));
        assert!(
            message("yaw=900").contains("-50 to 50 mrad"),
            "{}",
            message("yaw=900")
        );
        let drift = StereoDrift::parse(" yaw = 1 , focal_length=-30.5").unwrap();
        assert_eq!(drift.to_text(), "yaw=1,focalLength=-30.5");
        assert_eq!(StereoDrift::default().to_text(), "");
    }
}

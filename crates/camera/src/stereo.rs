/// The geometry of a rectified stereo pair: depth = focal length · baseline / disparity.
///
/// A disparity of 0 is an infinite depth here, where `DepthAI` writes 0.
///
/// ```
/// use oaktwin_camera::StereoGeometry;
///
/// let stereo = StereoGeometry { focal_length_px: 800.0, baseline_m: 0.075 };
/// assert_eq!(stereo.disparity(4.0), 15.0);
/// assert!((stereo.depth(95.0) - 0.632).abs() < 1e-3);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StereoGeometry {
    /// The focal length of the rectified images, px.
    pub focal_length_px: f64,
    /// The baseline in metres.
    pub baseline_m: f64,
}

impl StereoGeometry {
    /// Returns the disparity of a depth along the optical axis, px.
    #[must_use]
    pub fn disparity(&self, depth_m: f64) -> f64 {
        self.focal_length_px * self.baseline_m / depth_m
    }

    /// Returns the depth of a disparity, m. A matcher's largest disparity gives its minimum depth.
    #[must_use]
    pub fn depth(&self, disparity_px: f64) -> f64 {
        self.focal_length_px * self.baseline_m / disparity_px
    }

    /// Returns the difference to the next larger measurable depth, m: exactly `depth(d − step) − z = z² / (f b / step − z)`.
    ///
    /// The usual `z² · step / (f b)` is its first-order approximation, and too small. Infinite if the disparity is at most
    /// one step.
    #[must_use]
    pub fn depth_step(&self, depth_m: f64, disparity_step_px: f64) -> f64 {
        let disparity = self.disparity(depth_m);
        if disparity <= disparity_step_px {
            return f64::INFINITY;
        }
        depth_m * disparity_step_px / (disparity - disparity_step_px)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn depth_step_reaches_the_next_depth(
            f in 300.0..3000.0f64, b in 0.01..0.2f64, z in 0.2..20.0f64, step in 0.01..1.0f64,
        ) {
            let stereo = StereoGeometry { focal_length_px: f, baseline_m: b };
            let d = stereo.disparity(z);
            prop_assert!((stereo.depth(d) - z).abs() < 1e-12 * z);
            let dz = stereo.depth_step(z, step);
            if d > step {
                let next = stereo.depth(d - step);
                prop_assert!((z + dz - next).abs() < 1e-9 * next);
                prop_assert!(dz > z * z * step / (f * b));
            } else {
                prop_assert_eq!(dz, f64::INFINITY);
            }
        }
    }

    #[test]
    fn minimum_depth_of_an_oak() {
        // OAK-D Pro W: 97° across 1280 px, 75 mm, 95 and 190 px.
        let focal_length_px = 640.0 / 48.5f64.to_radians().tan();
        let stereo = StereoGeometry {
            focal_length_px,
            baseline_m: 0.075,
        };
        assert!((stereo.depth(95.0) - 0.447).abs() < 5e-4);
        assert!((stereo.depth(190.0) - 0.224).abs() < 5e-4);
        assert!((stereo.depth(1.0) - focal_length_px * 0.075).abs() < 1e-12);
    }
}

use oaktwin_camera::Camera;

use crate::preset::Platform;
use oaktwin_parameter::choice;

choice! {
    /// How pixels of the rectified images find their place in the raw ones.
    Method {
        /// As an RVC2 decides: a homography up to a horizontal field of view of 85°, a mesh above.
        Auto = "auto",
        /// A 3×3 matrix: rows meet as far as the lens has no distortion.
        Homography = "homography",
        /// A position every 16 pixels with the lens's first eight coefficients, and linearly between.
        Mesh = "mesh",
        /// A position for each pixel, with all of the lens.
        Full = "full",
    }
}

choice! {
    /// Whose intrinsics the rectified images get, both of them.
    Target {
        /// The right camera's: an RVC2.
        Right = "right",
        /// The left camera's: an RVC4 and `DepthAI`'s host node.
        Left = "left",
    }
}

/// What stands where a rectified image sees beyond the raw one: `rectifyEdgeFillColor`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EdgeFill {
    /// A grey value; 0 is the device's default.
    Value(u8),
    /// The nearest pixel of the border: `DepthAI`'s −1.
    Replicate,
}

impl Default for EdgeFill {
    fn default() -> Self {
        Self::Value(0)
    }
}

/// How a pair is rectified. The default is an RVC2's way.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct RectifyOptions {
    /// How pixels find their place.
    pub method: Method,
    /// Whose intrinsics the images get.
    pub target: Target,
    /// What stands beyond the border.
    pub edge_fill: EdgeFill,
}

impl RectifyOptions {
    /// As a platform does it.
    #[must_use]
    pub fn of(platform: Platform) -> Self {
        match platform {
            Platform::Rvc2 => Self::default(),
            Platform::Rvc4 => Self {
                method: Method::Full,
                target: Target::Left,
                edge_fill: EdgeFill::default(),
            },
        }
    }
}

/// The widest horizontal field of view of a homography, degrees (`DepthAI`, `useHomographyRectification`).
const WIDEST_HOMOGRAPHY_DEG: f64 = 85.0;

impl Method {
    /// Itself, or what `Auto` stands for.
    #[must_use]
    pub fn for_camera(self, camera: &Camera) -> Self {
        if self != Self::Auto {
            return self;
        }
        let k = &camera.intrinsics;
        let half_width = f64::from(k.size.width) / 2.0;
        let hfov_deg = 2.0 * (half_width / k.fx).atan().to_degrees();
        if camera.lens.is_perspective() && hfov_deg <= WIDEST_HOMOGRAPHY_DEG {
            Self::Homography
        } else {
            Self::Mesh
        }
    }
}

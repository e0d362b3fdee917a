use oaktwin_camera::{Camera, RectifiedIntrinsics};

use crate::preset::Platform;
use oaktwin_base::parameter::choice;
use serde::{Deserialize, Serialize};

choice! {
    /// The method that maps rectified pixels to raw ones.
    Method {
        /// RVC2's choice: a homography up to a horizontal field of view of 85°, a mesh above.
        Auto = "auto",
        /// A 3×3 matrix: rows are aligned if the lens has no distortion.
        Homography = "homography",
        /// A node every 16 pixels with the lens's first eight coefficients, interpolated linearly.
        Mesh = "mesh",
        /// A position for each pixel, with the complete lens model.
        Full = "full",
    }
}

/// The value of rectified pixels outside the raw image: `rectifyEdgeFillColor`.
///
/// In files, it is `DepthAI`'s number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(try_from = "i16", into = "i16")]
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

impl TryFrom<i16> for EdgeFill {
    type Error = String;

    fn try_from(number: i16) -> Result<Self, String> {
        match (number, u8::try_from(number)) {
            (-1, _) => Ok(Self::Replicate),
            (_, Ok(value)) => Ok(Self::Value(value)),
            _ => Err(format!(
                "invalid fill '{number}'; expected a grey value from 0 to 255, or -1 for the nearest pixel"
            )),
        }
    }
}

impl From<EdgeFill> for i16 {
    fn from(fill: EdgeFill) -> Self {
        match fill {
            EdgeFill::Replicate => -1,
            EdgeFill::Value(value) => value.into(),
        }
    }
}

/// The options of rectification. The defaults match RVC2.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct RectifyOptions {
    /// The method.
    pub method: Method,
    /// The intrinsics of both images; if they differ, the left one's.
    pub target: RectifiedIntrinsics,
    /// The value of pixels outside the raw image.
    pub edge_fill: EdgeFill,
}

impl Default for RectifyOptions {
    fn default() -> Self {
        Self::of(Platform::Rvc2)
    }
}

impl RectifyOptions {
    /// Returns the options of a platform.
    #[must_use]
    pub fn of(platform: Platform) -> Self {
        Self {
            method: match platform {
                Platform::Rvc2 => Method::Auto,
                Platform::Rvc4 => Method::Full,
            },
            target: RectifiedIntrinsics::of(platform),
            edge_fill: EdgeFill::default(),
        }
    }
}

/// The maximum horizontal field of view of a homography, degrees (`DepthAI`, `useHomographyRectification`).
const WIDEST_HOMOGRAPHY_DEG: f64 = 85.0;

impl Method {
    /// The method for a camera, with `Auto` resolved.
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

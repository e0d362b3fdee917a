use crate::Image;

/// Distance along the optical axis, metres: Isaac's `distance_to_image_plane`, ROS's and `DepthAI`'s depth.
///
/// In ground truth, a miss is `+inf`. In a sensor's output, 0 means no measurement.
#[derive(Clone, Debug, PartialEq)]
pub struct ZDepth(pub Image<f32>);

/// Distance from the optical centre, metres: Isaac's `distance_to_camera`. Invalid values as in [`ZDepth`].
#[derive(Clone, Debug, PartialEq)]
pub struct RangeDepth(pub Image<f32>);

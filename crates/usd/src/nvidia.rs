//! Names of NVIDIA's depth-sensor schemas, which no OpenUSD library registers.

/// Kit's schema of a depth sensor (Isaac Sim 5.1 and 6), for render products.
pub(crate) const PRODUCT_SCHEMA: &str = "OmniSensorDepthSensorSingleViewAPI";
/// Where its attributes are.
pub(crate) const PRODUCT_NAMESPACE: &str = "omni:rtx:post:depthSensor:";
/// ovrtx's schema of a depth sensor, for cameras.
pub(crate) const CAMERA_SCHEMA: &str = "OmniSensorGenericDepthSensorSingleViewAPI";
/// Where its attributes are.
pub(crate) const CAMERA_NAMESPACE: &str = "omni:sensor:depthSensor:";
/// Names and tick rate of any sensor. Isaac Sim 6.0 takes no camera of an asset for one of its own without it; 6.1 applies it
/// itself.
pub(crate) const SENSOR_SCHEMA: &str = "OmniSensorAPI";
/// An `int` in Isaac Sim 5.x, a range in pixels; a `bool` in 6.x.
pub const OUTLIER_REMOVAL: &str = "outlierRemovalEnabled";

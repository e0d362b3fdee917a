//! Names of NVIDIA's depth-sensor schemas, which no OpenUSD library registers.

/// Kit's depth-sensor schema for render products (Isaac Sim 5.1 and 6).
pub(crate) const PRODUCT_SCHEMA: &str = "OmniSensorDepthSensorSingleViewAPI";
/// The namespace of its attributes.
pub(crate) const PRODUCT_NAMESPACE: &str = "omni:rtx:post:depthSensor:";
/// ovrtx's depth-sensor schema for cameras.
pub(crate) const CAMERA_SCHEMA: &str = "OmniSensorGenericDepthSensorSingleViewAPI";
/// The namespace of its attributes.
pub(crate) const CAMERA_NAMESPACE: &str = "omni:sensor:depthSensor:";
/// Names and tick rate of a sensor. Isaac Sim 6.0 recognises an asset's cameras as sensors only if it is applied; 6.1
/// applies it automatically.
pub(crate) const SENSOR_SCHEMA: &str = "OmniSensorAPI";
/// The outlier filter: an `int` range in pixels in Isaac Sim 5.x, a `bool` in 6.x.
pub const OUTLIER_REMOVAL: &str = "outlierRemovalEnabled";

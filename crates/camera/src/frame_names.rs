//! The names of coordinate frames in ROS, as in the vendor's package `depthai_descriptions`. Descriptions of robots, recordings and live
//! messages all take them from here.

/// The usual name of a device, which is its body frame and begins the names of its other frames.
pub const DEVICE: &str = "oak";

/// Returns the name of a camera's frame (x forward), such as `oak_left_camera_frame`.
#[must_use]
pub fn camera(device: &str, role: &str) -> String {
    format!("{device}_{role}_camera_frame")
}

/// Returns the name of the optical frame (z forward) that belongs to a camera's frame: `oak_left_camera_optical_frame`, or
/// `NAME_optical_frame` if the camera's frame has another name.
#[must_use]
pub fn optical(camera: &str) -> String {
    format!(
        "{}_optical_frame",
        camera.strip_suffix("_frame").unwrap_or(camera)
    )
}

/// Returns the name of the inertial sensor's frame, such as `oak_imu_frame`.
#[must_use]
pub fn imu(device: &str) -> String {
    format!("{device}_imu_frame")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_the_vendors() {
        let left = camera(DEVICE, "left");
        assert_eq!(left, "oak_left_camera_frame");
        assert_eq!(optical(&left), "oak_left_camera_optical_frame");
        assert_eq!(optical("Camera_left"), "Camera_left_optical_frame");
        assert_eq!(imu("front"), "front_imu_frame");
    }
}

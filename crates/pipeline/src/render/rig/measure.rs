//! Measures images that were rendered or recorded elsewhere.

use oaktwin_camera::ImageSize;
use oaktwin_image::Image;
use oaktwin_image::ZDepth;
use oaktwin_image::annotation::Frame;

use super::{Rig, RigError};
use crate::render::depth_sensor::sense_frame;
use crate::sensor::ParameterError;

impl Rig {
    /// Measures the exact depth that the camera of the rig's first depth sensor sees, in metres along the optical axis, with its colour
    /// image if there is one: what [`Rig::shoot`] does with images of its own. The result has the requested outputs of the sensor.
    ///
    /// # Errors
    /// Returns an error if the rig has no depth sensor, its engine matches pairs, or an image has another size than the camera.
    pub fn measure(
        &mut self,
        depth: ZDepth,
        rgb: Option<Image<[u8; 4]>>,
        number: u64,
    ) -> Result<Frame, RigError> {
        let wrong = |what: String, remedy: &str| ParameterError::new("depth", what, remedy);
        let Some(index) = self.sensors.iter().position(Option::is_some) else {
            let what = format!("{} has no depth sensor that is requested", self.name);
            return Err(wrong(what, "add depth_sensor_distance to the annotators").into());
        };
        let camera = self.cameras[index].camera;
        let expected = camera.intrinsics.size;
        let depth_size = ImageSize::new(depth.0.width(), depth.0.height());
        let rgb_size = rgb.as_ref().map(|rgb| ImageSize::new(rgb.width(), rgb.height()));
        let mut sizes = [Some(depth_size), rgb_size].into_iter().flatten();
        if let Some(size) = sizes.find(|size| *size != expected) {
            let what = format!("an image is {size}, but the camera is {expected}");
            let remedy = "give images of the camera's size, or set the size of the rig";
            return Err(wrong(what, remedy).into());
        }
        let mut frame = Frame {
            distance_to_image_plane: Some(depth),
            rgb,
            ..Frame::default()
        };
        if let Some(sensor) = &mut self.sensors[index] {
            sense_frame(sensor, &camera, number, None, &self.annotators, &mut frame)?;
        }
        frame.distance_to_image_plane = None;
        frame.rgb = None;
        Ok(frame)
    }
}

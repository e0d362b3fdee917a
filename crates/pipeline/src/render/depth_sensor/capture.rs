//! The depth sensor's outputs for a rendered frame.

use crate::pair::Pair;
use crate::sensor::{self, EngineInput, Input, Sensor, Shot};
use oaktwin_camera::Camera;
use oaktwin_depth::stereo_matching;
use oaktwin_image::ImageView;
use oaktwin_image::annotation::{Annotator, Frame};

/// The inputs of a depth sensor, the same for every requested output, so that the measurement does not depend on it.
const INPUTS: [Annotator; 2] = [Annotator::Rgb, Annotator::DistanceToImagePlane];

/// Returns the annotators to render for these outputs of a camera: without the depth sensor's outputs, but with its inputs if the frame
/// `is_sensed`.
#[must_use]
pub fn scene_annotators(annotators: &[Annotator], is_sensed: bool) -> Vec<Annotator> {
    let mut needed = annotators.to_vec();
    needed.retain(|one| !one.is_depth_sensor());
    if is_sensed {
        needed.extend(INPUTS);
    }
    needed.sort_unstable();
    needed.dedup();
    needed
}

/// Returns the input of a sensor in a frame of this number; `None` if the frame lacks it.
#[must_use]
pub fn sensor_input<'a>(
    sensor: &Sensor,
    frame: &'a Frame,
    number: u64,
    pair: Option<&'a Pair>,
) -> Option<Input<'a>> {
    match sensor.engine().kind().input {
        EngineInput::Depth => shot(frame, number).map(Input::Depth),
        EngineInput::Pair => {
            let pair = pair?;
            // Both have the same bit depth.
            let pair = stereo_matching::Pair::new(&pair.rectified_left, &pair.rectified_right);
            pair.ok().map(Input::Pair)
        }
    }
}

/// The depth and colour of a frame of this number.
fn shot(frame: &Frame, number: u64) -> Option<Shot<'_>> {
    let depth = frame.distance_to_image_plane.as_ref()?;
    let mut shot = Shot::new((&depth.0).into());
    shot.frame = number;
    match &frame.rgb {
        // Both are of the same camera and size.
        Some(rgb) => shot.with_rgb(rgb.into()).ok(),
        None => Some(shot),
    }
}

/// Adds the sensor outputs that are `requested` to a frame with depth, and optionally colours, of `camera`; `pair` is the stereo
/// pair for engines that match one. They are images of [`Sensor::output_camera`]. Returns the annotators that cannot be produced.
pub fn sense_frame(
    sensor: &mut Sensor,
    camera: &Camera,
    number: u64,
    pair: Option<&Pair>,
    requested: &[Annotator],
    frame: &mut Frame,
) -> Vec<Annotator> {
    if let Some(input) = sensor_input(sensor, frame, number, pair) {
        let captured = sensor::capture(sensor, camera, input, requested);
        let rgb = frame.rgb.as_ref().map(ImageView::from);
        if let Ok(capture) = captured {
            frame.update(sensor::frame(sensor, camera, capture, rgb, requested));
        }
    }
    let is_missing = |annotator: &Annotator| {
        annotator.is_depth_sensor() && !frame.annotations().any(|(present, _)| present == *annotator)
    };
    requested.iter().copied().filter(is_missing).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn renders_the_inputs_of_a_sensor() {
        use Annotator as A;
        let requested = [A::CameraParams, A::DepthSensorDistance];
        assert_eq!(scene_annotators(&requested, false), [A::CameraParams]);
        assert_eq!(
            scene_annotators(&requested, true),
            [A::Rgb, A::DistanceToImagePlane, A::CameraParams]
        );
        assert_eq!(scene_annotators(&[A::Normals], false), [A::Normals]);
    }
}

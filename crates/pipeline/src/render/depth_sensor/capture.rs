//! The depth sensor's outputs for a rendered frame.

use crate::pair::Pair;
use crate::sensor::{self, DepthShot, EngineInput, Input, ParameterError, Sensor, needs_a_pair};
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

/// Returns the input of a sensor in a frame of this number.
///
/// # Errors
/// Returns an error if the frame has no depth, or if there is no pair and the engine requires one.
pub fn sensor_input<'a>(
    sensor: &Sensor,
    frame: &'a Frame,
    number: u64,
    pair: Option<&'a Pair>,
) -> Result<Input<'a>, ParameterError> {
    let kind = sensor.engine().kind();
    let unfit = |what: String| ParameterError::new("engine", what, "choose another engine");
    match kind.input {
        EngineInput::Depth => {
            // The models of cameras see what mirrors show; others measure surfaces.
            let apparent = frame.apparent_depth.as_ref().filter(|_| kind.models.is_some());
            let depth = apparent.or(frame.distance_to_image_plane.as_ref());
            let depth = depth.ok_or_else(|| unfit(format!("{kind} requires depth, and there is none")))?;
            let mut shot = DepthShot::new((&depth.0).into());
            shot.frame = number;
            if let Some(velocities) = &frame.radial_velocities {
                let velocities = velocities.each_ref().map(ImageView::from);
                shot = (shot.with_radial_velocities(velocities))
                    .map_err(|error| unfit(format!("{kind}: {error}")))?;
            }
            if let Some(returns) = frame
                .returns
                .as_ref()
                .filter(|_| sensor.engine().ages_s().is_some())
            {
                shot = (shot.with_returns(returns)).map_err(|error| unfit(format!("{kind}: {error}")))?;
            }
            let colors = frame.infrared.as_ref().filter(|_| kind.models.is_some());
            let shot = match colors.or(frame.rgb.as_ref()) {
                Some(rgb) => shot.with_rgb(rgb.into()),
                None => Ok(shot),
            };
            let shot = shot.map_err(|error| unfit(format!("{kind}: {error}")))?;
            Ok(Input::Depth(shot))
        }
        EngineInput::Pair => {
            let pair = pair.ok_or_else(|| needs_a_pair(kind, "the input is a depth image"))?;
            let pair = stereo_matching::RectifiedPair::new(&pair.rectified_left, &pair.rectified_right);
            let pair = pair.map_err(|error| unfit(format!("{kind}: {error}")))?;
            Ok(Input::Pair(pair))
        }
    }
}

/// Adds the sensor outputs that are `requested` to a frame with depth, and optionally colours, of `camera`; `pair` is the stereo
/// pair for engines that match one. They are images of [`Sensor::output_camera`]. Returns the annotators that cannot be produced.
///
/// # Errors
/// Returns the errors of [`sensor_input`] and of the engine.
pub fn sense_frame(
    sensor: &mut Sensor,
    camera: &Camera,
    number: u64,
    pair: Option<&Pair>,
    requested: &[Annotator],
    frame: &mut Frame,
) -> Result<Vec<Annotator>, ParameterError> {
    let input = sensor_input(sensor, frame, number, pair)?;
    let capture = sensor::capture(sensor, camera, input, requested)?;
    let rgb = frame.rgb.as_ref().map(ImageView::from);
    frame.update(sensor::frame(sensor, camera, capture, rgb, requested));
    let is_missing = |annotator: &Annotator| {
        annotator.is_depth_sensor() && !frame.annotations().any(|(present, _)| present == *annotator)
    };
    Ok(requested.iter().copied().filter(is_missing).collect())
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

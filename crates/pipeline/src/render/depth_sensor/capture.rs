//! The depth sensor's outputs for a rendered frame.

use crate::geometry::positions;
use crate::pair::Pair;
use crate::sensor::{EngineInput, Input, Sensor, Shot};
use oaktwin_camera::Camera;
use oaktwin_depth::stereo_matching;
use oaktwin_image::annotation::{Annotator, Frame};
use oaktwin_image::{Image, ZDepth};

/// The inputs of a depth sensor, the same for every requested output, so that the measurement does not depend on it.
const INPUTS: [Annotator; 2] = [Annotator::Rgb, Annotator::DistanceToImagePlane];

/// Returns the annotators to render for these outputs of a camera: without those of the depth sensor, but with its inputs if the frame
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

/// The input of a sensor in a frame of this number; `None` if the frame lacks it.
pub(in crate::render) fn input<'a>(
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

/// Adds the sensor outputs that are `asked` for to a frame with depth, and optionally colours, of `camera`; `pair` is the stereo
/// pair for engines that match one. Returns the annotators that cannot be produced.
pub fn sense_frame(
    sensor: &mut Sensor,
    camera: &Camera,
    number: u64,
    pair: Option<&Pair>,
    asked: &[Annotator],
    frame: &mut Frame,
) -> Vec<Annotator> {
    fill(sensor, camera, number, pair, asked, frame);
    let is_missing = |annotator: &Annotator| {
        annotator.is_depth_sensor() && !frame.annotations().any(|(present, _)| present == *annotator)
    };
    asked.iter().copied().filter(is_missing).collect()
}

fn fill(
    sensor: &mut Sensor,
    camera: &Camera,
    number: u64,
    pair: Option<&Pair>,
    asked: &[Annotator],
    frame: &mut Frame,
) {
    let wants = |annotator| asked.contains(&annotator);
    let (wants_positions, wants_colors) = (
        wants(Annotator::DepthSensorPointCloudPosition),
        wants(Annotator::DepthSensorPointCloudColor),
    );
    let position = Annotator::DepthSensorPointCloudPosition;
    let color = Annotator::DepthSensorPointCloudColor;
    let own = sensor.engine().outputs();
    let seen = frame
        .distance_to_image_plane
        .as_ref()
        .filter(|_| wants_positions && own.contains(&position))
        .map(|z| positions(camera, &z.0));
    let captured = input(sensor, frame, number, pair).and_then(|input| {
        let input = match (&seen, input) {
            (Some(seen), Input::Depth(shot)) => Input::Depth(shot.with_positions(seen.into()).ok()?),
            (_, input) => input,
        };
        sensor.capture(input, asked).ok()
    });
    let Some(mut capture) = captured else {
        return;
    };
    frame.depth_sensor_imager = capture.take(Annotator::DepthSensorImager);
    frame.depth_sensor_output_visualization = capture.take(Annotator::DepthSensorOutputVisualization);
    // Where no sample moves, a pixel's point is where its ray reaches the measured depth.
    frame.depth_sensor_point_cloud_position = if own.contains(&position) {
        capture.take(position)
    } else {
        wants_positions.then(|| positions(camera, &capture.distance.0))
    };
    frame.depth_sensor_point_cloud_color = if own.contains(&color) {
        capture.take(color)
    } else {
        let rgb = frame.rgb.as_ref().filter(|_| wants_colors);
        rgb.and_then(|rgb| measured(rgb, &capture.distance))
    };
    frame.depth_sensor_distance = wants(Annotator::DepthSensorDistance).then_some(capture.distance);
}

/// The colours of valid depth.
fn measured(rgb: &Image<[u8; 4]>, distance: &ZDepth) -> Option<Image<[u8; 4]>> {
    let both = rgb.pixels().iter().zip(distance.0.pixels());
    let colors = both.map(|(&color, &z)| if z > 0.0 { color } else { [0; 4] });
    Image::new(rgb.width(), rgb.height(), colors.collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn renders_the_inputs_of_a_sensor() {
        use Annotator as A;
        let asked = [A::CameraParams, A::DepthSensorDistance];
        assert_eq!(scene_annotators(&asked, false), [A::CameraParams]);
        assert_eq!(
            scene_annotators(&asked, true),
            [A::Rgb, A::DistanceToImagePlane, A::CameraParams]
        );
        assert_eq!(scene_annotators(&[A::Normals], false), [A::Normals]);
    }
}

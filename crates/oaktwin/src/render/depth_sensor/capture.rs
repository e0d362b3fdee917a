//! What a depth sensor reports of a rendered frame.

use oaktwin_render::View;
use rayon::prelude::*;

use crate::camera::{PixelPoint, Usd};
use crate::image::annotation::{Annotator, Frame};
use crate::image::{Image, ZDepth};
use crate::sensor::{Capture, Engine, Sensor, Shot, single_view};

/// What a depth sensor looks at, whatever of it is asked for: so the same is measured in every case.
const INPUTS: [Annotator; 2] = [Annotator::Rgb, Annotator::DistanceToImagePlane];

/// What is to be rendered so that these annotations of a camera can be written: without those that a depth sensor makes,
/// with what one looks at where the frame `is_sensed`.
#[must_use]
pub fn scene_annotators(annotators: &[Annotator], is_sensed: bool) -> Vec<Annotator> {
    let mut needed = annotators.to_vec();
    needed.retain(|one| !one.is_of_depth_sensor());
    if is_sensed {
        needed.extend(INPUTS);
    }
    needed.sort_unstable();
    needed.dedup();
    needed
}

/// What a sensor looks at in a frame of this number.
pub(in crate::render) fn shot<'a>(frame: &'a Frame, number: u64) -> Option<Shot<'a>> {
    let depth = frame.distance_to_image_plane.as_ref()?;
    let mut shot = Shot::new((&depth.0).into());
    shot.frame = number;
    match &frame.rgb {
        // Both are of one camera, and so of one size.
        Some(rgb) => shot.with_rgb(rgb.into()).ok(),
        None => Some(shot),
    }
}

/// Adds what is asked for of a sensor to a frame that has what it looks at.
pub(in crate::render) fn capture(
    sensor: &mut Sensor,
    view: &View,
    number: u64,
    asked: &[Annotator],
    frame: &mut Frame,
) {
    let wants = |annotator| asked.contains(&annotator);
    let (wants_positions, wants_colors) = (
        wants(Annotator::DepthSensorPointCloudPosition),
        wants(Annotator::DepthSensorPointCloudColor),
    );
    let is_single_view = matches!(sensor.engine(), Engine::SingleView(_));
    let seen = frame
        .distance_to_image_plane
        .as_ref()
        .filter(|_| wants_positions && is_single_view)
        .map(|z| positions(view, z));
    let captured = shot(frame, number).and_then(|shot| {
        let shot = match &seen {
            Some(seen) => shot.with_positions(seen.into()).ok()?,
            None => shot,
        };
        let wanted = single_view::Wanted {
            positions: wants_positions,
            colors: wants_colors,
            imager: wants(Annotator::DepthSensorImager),
            view: wants(Annotator::DepthSensorOutputVisualization),
        };
        Some(sensor.capture(&shot, wanted))
    });
    let Some(Capture {
        distance,
        single_view,
    }) = captured
    else {
        return;
    };
    if let Some(output) = single_view {
        frame.depth_sensor_point_cloud_position = output.positions;
        frame.depth_sensor_point_cloud_color = output.colors;
        frame.depth_sensor_imager = output.imager;
        frame.depth_sensor_output_visualization = output.view;
    } else {
        // Nothing has moved: a pixel's point is where its ray reaches what it measured.
        frame.depth_sensor_point_cloud_position = wants_positions.then(|| positions(view, &distance));
        frame.depth_sensor_point_cloud_color = frame
            .rgb
            .as_ref()
            .filter(|_| wants_colors)
            .and_then(|rgb| measured(rgb, &distance));
    }
    frame.depth_sensor_distance = wants(Annotator::DepthSensorDistance).then_some(distance);
}

/// The point that each pixel sees, in the camera's frame with USD's axes, metres, and 1; all 0 where there is none.
#[expect(clippy::cast_possible_truncation, reason = "points are float32")]
fn positions(view: &View, depth: &ZDepth) -> Image<[f32; 4]> {
    let (width, height) = (depth.0.width(), depth.0.height());
    let mut positions = Image::filled(width, height, [0.0f32; 4]);
    let columns = (width as usize).max(1);
    let rows = positions.pixels_mut().par_chunks_mut(columns);
    let depths = depth.0.pixels().par_chunks(columns);
    rows.zip(depths).enumerate().for_each(|(y, (row, depths))| {
        for ((x, point), &z) in row.iter_mut().enumerate().zip(depths) {
            if !(z > 0.0 && z < f32::INFINITY) {
                continue;
            }
            let centre = PixelPoint::<Usd>::new(x as f64 + 0.5, y as f64 + 0.5);
            let Some(ray) = view.camera.unproject(centre).filter(|ray| ray.z > 0.0) else {
                continue;
            };
            let seen = ray * (f64::from(z) / ray.z);
            *point = [seen.x as f32, -seen.y as f32, -z, 1.0];
        }
    });
    positions
}

/// Colours where there is a depth.
fn measured(rgb: &Image<[u8; 4]>, distance: &ZDepth) -> Option<Image<[u8; 4]>> {
    let both = rgb.pixels().iter().zip(distance.0.pixels());
    let colors = both.map(|(&color, &z)| if z > 0.0 { color } else { [0; 4] });
    Image::new(rgb.width(), rgb.height(), colors.collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::camera::{Camera, ImageSize, Intrinsics, LensModel, RigidTransform};
    use crate::render::Clip;

    #[test]
    fn what_is_rendered_for_a_sensor() {
        use Annotator as A;
        let asked = [A::CameraParams, A::DepthSensorDistance];
        assert_eq!(scene_annotators(&asked, false), [A::CameraParams]);
        assert_eq!(
            scene_annotators(&asked, true),
            [A::Rgb, A::DistanceToImagePlane, A::CameraParams]
        );
        assert_eq!(scene_annotators(&[A::Normals], false), [A::Normals]);
    }

    #[test]
    fn points_have_the_axes_of_usd() {
        let intrinsics = Intrinsics::from_hfov(ImageSize::new(4, 2), 90f64.to_radians());
        let view = View {
            camera: Camera::new(intrinsics, LensModel::Pinhole),
            world_from_camera: RigidTransform::IDENTITY,
            clip: Clip::default(),
        };
        let depth = Image::new(4, 2, vec![4.0, 0.0, f32::INFINITY, 2.0, 1.0, 1.0, 1.0, 8.0]).unwrap();
        let points = positions(&view, &ZDepth(depth));
        assert_eq!(points.get(0, 0), Some(&[-3.0, 1.0, -4.0, 1.0]));
        assert_eq!(points.get(1, 0), Some(&[0.0; 4]));
        assert_eq!(points.get(2, 0), Some(&[0.0; 4]));
        assert_eq!(points.get(3, 1), Some(&[6.0, -2.0, -8.0, 1.0]));
    }
}

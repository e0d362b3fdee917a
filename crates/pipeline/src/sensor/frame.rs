//! From a capture to annotations: the only place where the points and colours of a measurement are made.

use oaktwin_camera::{Camera, UsdOptics};
use oaktwin_dataset::FrameCamera;
use oaktwin_depth::{Capture, CaptureLayer, Input, OutputCamera, ParameterError, Sensor};
use oaktwin_image::annotation::{Annotation, Annotator, Frame};
use oaktwin_image::{Image, ImageView};

use crate::geometry::{measured_only, positions};

const POSITION: Annotator = Annotator::DepthSensorPointCloudPosition;
const COLOR: Annotator = Annotator::DepthSensorPointCloudColor;

/// Measures an input of a camera; see [`Sensor::capture`]. An engine that moves samples moves their points too.
///
/// # Errors
/// Returns an error if the engine requires another kind of input.
pub(crate) fn capture(
    sensor: &mut Sensor,
    camera: &Camera,
    input: Input<'_>,
    request: &[Annotator],
) -> Result<Capture, ParameterError> {
    let Input::Depth(shot) = input else {
        return sensor.capture(input, request);
    };
    let needs_points = request.contains(&POSITION) && sensor.engine().outputs().contains(&POSITION);
    let seen = needs_points.then(|| positions(camera, shot.depth()));
    let shot = match &seen {
        // Both have the size of the depth.
        Some(seen) => shot.with_positions(seen.into()).unwrap_or(shot),
        None => shot,
    };
    sensor.capture(shot, request)
}

/// The requested depth sensor annotations of a capture, which are all images of the sensor's output camera. Its input has
/// this camera and, where colours are requested, this colour image.
pub(crate) fn frame(
    sensor: &Sensor,
    camera: &Camera,
    mut capture: Capture,
    rgb: Option<ImageView<'_, [u8; 4]>>,
    request: &[Annotator],
) -> Frame {
    let wants = |annotator| request.contains(&annotator);
    let moved_points = capture.take::<Image<[f32; 4]>>(POSITION);
    let moved_colors = capture.take::<Image<[u8; 4]>>(COLOR);
    let points = wants(POSITION)
        .then(|| moved_points.unwrap_or_else(|| points(&sensor.output_camera(camera), &capture.distance.0)));
    let colors = match sensor.engine().outputs().contains(&COLOR) {
        true if moved_colors.is_some() && capture.is_filtered() => {
            moved_colors.map(|colors| measured_only(colors, &capture.distance.0))
        }
        true => moved_colors,
        false => rgb
            .filter(|_| wants(COLOR))
            .and_then(|rgb| Image::new(rgb.width(), rgb.height(), rgb.pixels().to_vec()))
            .map(|rgb| measured_only(sensor.filters().companion(rgb), &capture.distance.0)),
    };
    let mut frame = Frame {
        depth_sensor_point_cloud_color: colors,
        depth_sensor_point_cloud_position: points,
        depth_sensor_distance: wants(Annotator::DepthSensorDistance).then_some(capture.distance),
        ..Frame::default()
    };
    for (annotator, layer) in capture.extras {
        if let Some(data) = annotation(layer) {
            frame.put(annotator, data);
        }
    }
    frame
}

/// The annotation of a layer; `None` of outputs that frames do not have.
fn annotation(layer: CaptureLayer) -> Option<Annotation> {
    match layer {
        CaptureLayer::Levels(levels) => Some(Annotation::Levels(levels)),
        CaptureLayer::Floats(numbers) => Some(Annotation::Scalar(numbers)),
        CaptureLayer::Colors(colors) => Some(Annotation::Color(colors)),
        CaptureLayer::Reasons(codes) => Some(Annotation::Reasons(codes.into())),
        CaptureLayer::Points(points) => Some(Annotation::PixelPoints(points)),
        CaptureLayer::Bytes(_) | CaptureLayer::Disparity(_) => None,
    }
}

/// The view of a sensor's output camera; `input` is the view of the sensor's input.
pub(crate) fn sensor_view(output: &OutputCamera, input: &FrameCamera) -> FrameCamera {
    let intrinsics = &output.camera.intrinsics;
    let optics = if *intrinsics == input.camera.intrinsics {
        input.optics
    } else {
        // The focal length in millimetres is constant, so pixels grow as the image shrinks.
        let pixel_size_um = input.optics.focal_length_mm * 1e3 / intrinsics.mean_focal_length();
        UsdOptics::from_intrinsics(intrinsics, pixel_size_um, Default::default())
    };
    FrameCamera {
        optics,
        camera: output.camera,
        world_from_camera: input.world_from_camera * output.input_from_output(),
        ..*input
    }
}

/// The points of measured depth in the frame of the input's camera, with USD's axes.
#[expect(clippy::cast_possible_truncation, reason = "points are float32")]
fn points(camera: &OutputCamera, metres: &Image<f32>) -> Image<[f32; 4]> {
    let mut points = positions(&camera.camera, metres.into());
    if camera.shift_m != 0.0 {
        for point in points.pixels_mut().iter_mut().filter(|point| point[3] > 0.0) {
            point[0] = (f64::from(point[0]) - camera.shift_m) as f32;
        }
    }
    points
}

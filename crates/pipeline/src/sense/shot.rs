//! From a capture to the frame that is written.

use super::SenseOptions;
use crate::geometry::positions;
use crate::sensor::{Capture, Engine};
use oaktwin_camera::{Camera, ImageSize};
use oaktwin_dataset::{InputName, Layer, LayerData, Shot};
use oaktwin_depth::align::Align;
use oaktwin_image::annotation::{Annotator, Frame};
use oaktwin_image::{Image, ZDepth};

/// A point cloud with USD's axes and its colours, as far as they are needed.
struct Cloud {
    positions: Option<Image<[f32; 4]>>,
    colors: Option<Image<[u8; 4]>>,
}

/// The camera and outputs of a sequence.
pub(super) struct OutputContext<'a> {
    pub(super) options: &'a SenseOptions,
    /// The camera of the sensor's input.
    pub(super) camera: Camera,
    /// See [`Engine::lateral_shift_m`].
    pub(super) shift_m: f64,
    pub(super) align: Option<Align>,
}

impl OutputContext<'_> {
    /// The outputs that are needed.
    pub(super) fn request(&self) -> Vec<Annotator> {
        let mut request = self.options.annotators.clone();
        if self.options.cloud.is_some() {
            request.push(Annotator::DepthSensorPointCloudPosition);
            request.push(Annotator::DepthSensorPointCloudColor);
        }
        request
    }

    /// The frame of a capture, with its aligned depth and its point cloud.
    pub(super) fn shot(
        &self,
        engine: &dyn Engine,
        mut capture: Capture,
        rgb: Option<&Image<[u8; 4]>>,
        input: InputName,
    ) -> Shot {
        let options = self.options;
        let wants = |annotator: Annotator| options.annotators.contains(&annotator);
        let name = Annotator::DepthSensorDistance.name();
        let mut layers = Vec::new();
        if let (Some(align), Some(to)) = (&self.align, options.align) {
            // The aligner was made for this size.
            if let Ok(ZDepth(aligned)) = align.align((&capture.distance.0).into()) {
                layers.push(Layer {
                    folder: name,
                    name: format!("{name}_aligned_{}", to.camera),
                    data: LayerData::Depth(aligned),
                });
            }
        }
        let Cloud { positions, colors } = self.cloud(engine, &capture, rgb);
        if let (Some(positions), Some(axes)) = (&positions, options.cloud) {
            layers.push(Layer {
                folder: Annotator::DepthSensorPointCloudPosition.name(),
                name: "depth_sensor_point_cloud".to_owned(),
                data: LayerData::Cloud {
                    positions: positions.clone(),
                    colors: colors.clone(),
                    axes,
                },
            });
        }
        let frame = Frame {
            depth_sensor_imager: capture.take(Annotator::DepthSensorImager),
            depth_sensor_output_visualization: capture.take(Annotator::DepthSensorOutputVisualization),
            depth_sensor_distance: Some(capture.distance),
            depth_sensor_point_cloud_position: positions
                .filter(|_| wants(Annotator::DepthSensorPointCloudPosition)),
            depth_sensor_point_cloud_color: colors.filter(|_| wants(Annotator::DepthSensorPointCloudColor)),
            ..Frame::default()
        };
        Shot {
            layers,
            input,
            ..Shot::new(frame, 0)
        }
    }

    /// The measured points and their colours, if they are needed.
    fn cloud(&self, engine: &dyn Engine, capture: &Capture, rgb: Option<&Image<[u8; 4]>>) -> Cloud {
        let request = self.request();
        let wants = |annotator| request.contains(&annotator);
        let ZDepth(metres) = &capture.distance;
        let positions = wants(Annotator::DepthSensorPointCloudPosition).then(|| {
            let moved = capture.extra::<Image<[f32; 4]>>(Annotator::DepthSensorPointCloudPosition);
            // Filters may have changed the depth; then the points are computed from it.
            match moved.filter(|_| !capture.is_filtered()) {
                Some(positions) => positions.clone(),
                None => self.seen(metres),
            }
        });
        let is_whole =
            |image: &Image<[u8; 4]>| (image.width(), image.height()) == (metres.width(), metres.height());
        let color = Annotator::DepthSensorPointCloudColor;
        let colors = if engine.outputs().contains(&color) {
            let colors = capture.extra::<Image<[u8; 4]>>(color);
            colors.cloned().filter(is_whole)
        } else {
            rgb.filter(|rgb| wants(color) && is_whole(rgb)).map(|rgb| {
                let mut colors = rgb.clone();
                for (color, z) in colors.pixels_mut().iter_mut().zip(metres.pixels()) {
                    if *z <= 0.0 {
                        *color = [0; 4];
                    }
                }
                colors
            })
        };
        Cloud { positions, colors }
    }

    /// The points of reported depth in the frame of the sensor's camera.
    #[expect(clippy::cast_possible_truncation, reason = "points are float32")]
    fn seen(&self, metres: &Image<f32>) -> Image<[f32; 4]> {
        let mut points = positions(&self.reported(metres), metres);
        for point in points.pixels_mut().iter_mut().filter(|point| point[3] > 0.0) {
            point[0] = (f64::from(point[0]) - self.shift_m) as f32;
        }
        points
    }

    /// The camera of reported images, which filters may have reduced.
    fn reported(&self, metres: &Image<f32>) -> Camera {
        reported(&self.camera, ImageSize::new(metres.width(), metres.height()))
    }
}

/// The camera with a resized image.
pub(super) fn reported(camera: &Camera, size: ImageSize) -> Camera {
    if camera.intrinsics.size == size {
        *camera
    } else {
        Camera::new(camera.intrinsics.resized(size, false), camera.lens)
    }
}

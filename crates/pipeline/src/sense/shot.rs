//! From a capture to the frame that is written.

use std::path::Path;

use super::SenseOptions;
use super::camera::read_pose;
use crate::align;
use crate::sensor::{Capture, OutputCamera, Sensor, frame, sensor_view};
use oaktwin_camera::{Camera, RigidTransform};
use oaktwin_dataset::{CameraParams, FrameCamera, InputName, LayerData, Shot, ShotLayer};
use oaktwin_depth::align::Align;
use oaktwin_image::annotation::Annotator;
use oaktwin_image::{Image, ImageView};

/// The camera and outputs of a sequence.
pub(super) struct OutputContext<'a> {
    pub(super) options: &'a SenseOptions,
    /// The camera of the sensor's input.
    pub(super) camera: Camera,
    /// The view of the sensor's input, at the origin.
    pub(super) view: FrameCamera,
    /// The camera that the outputs are images of.
    pub(super) reported: OutputCamera,
    pub(super) align: Option<Align>,
}

impl OutputContext<'_> {
    /// The outputs that are needed.
    pub(super) fn request(&self) -> Vec<Annotator> {
        let mut request = self.options.annotators.clone();
        request.push(Annotator::DepthSensorDistance);
        if self.options.cloud.is_some() {
            request.push(Annotator::DepthSensorPointCloudPosition);
            request.push(Annotator::DepthSensorPointCloudColor);
        }
        request
    }

    /// The parameters of the outputs' camera; its pose is that in the `camera_params` of the input, or the origin.
    pub(super) fn params(&self, of_input: Option<&Path>) -> CameraParams {
        let pose = of_input.and_then(read_pose);
        let (world_from_camera, meters_per_unit) = pose.unwrap_or((RigidTransform::IDENTITY, 1.0));
        let view = FrameCamera {
            world_from_camera,
            meters_per_unit,
            clipping_range: self.view.clipping_range.map(|metres| metres / meters_per_unit),
            ..self.view
        };
        CameraParams::new(&sensor_view(&self.reported, &view))
    }

    /// The frame of a capture, with its aligned depth and its point cloud.
    pub(super) fn shot(
        &self,
        sensor: &Sensor,
        capture: Capture,
        rgb: Option<&Image<[u8; 4]>>,
        params: CameraParams,
        input: InputName,
    ) -> Shot {
        let options = self.options;
        let wants = |annotator: &Annotator| options.annotators.contains(annotator);
        let mut layers = Vec::new();
        if let (Some(align), Some(to)) = (&self.align, options.align) {
            layers.extend(align::layer(align, &to, &capture.distance.0));
        }
        let rgb = rgb.map(ImageView::from);
        let mut frame = frame(sensor, &self.camera, capture, rgb, &self.request());
        if let (Some(positions), Some(axes)) = (&frame.depth_sensor_point_cloud_position, options.cloud) {
            layers.push(ShotLayer {
                folder: Annotator::DepthSensorPointCloudPosition.name(),
                name: "depth_sensor_point_cloud".to_owned(),
                data: LayerData::Cloud {
                    positions: positions.clone(),
                    colors: frame.depth_sensor_point_cloud_color.clone(),
                    axes,
                },
            });
        }
        if !wants(&Annotator::DepthSensorPointCloudPosition) {
            frame.depth_sensor_point_cloud_position = None;
        }
        if !wants(&Annotator::DepthSensorPointCloudColor) {
            frame.depth_sensor_point_cloud_color = None;
        }
        Shot {
            layers,
            sensor_params: Some(params),
            input,
            ..Shot::new(frame, 0)
        }
    }
}

//! What the cameras of a rig record in colour.

use oaktwin_camera::Camera;
use oaktwin_depth::imager::ColorImager;
use oaktwin_depth::random::Stream;
use oaktwin_image::annotation::Frame;
use oaktwin_render::WHITE;

use super::{RigError, RigSpec};
use crate::render::PlacedCamera;

/// The image sensor of a camera.
#[derive(Clone, Copy, Debug)]
pub(super) struct RgbImager {
    imager: ColorImager,
    random: Stream,
}

impl RgbImager {
    /// Returns the image sensor of each camera; none if colours are exact.
    pub(super) fn of(cameras: &[PlacedCamera], spec: &RigSpec) -> Result<Vec<Self>, RigError> {
        let Some(parameters) = spec.rgb_imager else {
            return Ok(Vec::new());
        };
        let imagers = cameras.iter().map(|camera| {
            Ok(Self {
                imager: ColorImager::new(parameters, camera.photosites)?,
                random: Stream::new(spec.sensor.seed, &camera.path),
            })
        });
        imagers.collect()
    }

    /// Replaces the colours of a frame of this number by those that the sensor records of their light.
    pub(super) fn record(&self, camera: &Camera, number: u64, frame: &mut Frame) {
        if let Some(light) = frame.light.take() {
            let recorded =
                (self.imager).record(&light, 1.0 / WHITE, &camera.intrinsics, &self.random, number);
            frame.rgb = Some(recorded);
        }
    }
}

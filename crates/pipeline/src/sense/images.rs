//! The images that a depth sensor measures.

use std::path::Path;

use super::options::ImageCamera;
use super::{InputKind, SenseError, SenseOptions, camera};
use crate::geometry::{places, resample, z_of_range};
use crate::sensor::{Sensor, SensorOptions, sensor};
use oaktwin_base::diagnostic::{Finding, Level};
use oaktwin_camera::{Camera, ImageSize, LensModel};
use oaktwin_catalog::{Twin, TwinCamera, TwinDepthSensor};
use oaktwin_image::Image;

/// The camera of a sensor's images, and the way from an image as it was given to one of that camera.
#[derive(Debug)]
pub(super) struct Images {
    /// The camera of the images as they are given.
    pub(super) given: Camera,
    /// The camera of the images that the sensor measures: the same, or the model's if they are resampled.
    pub(super) measured: Camera,
    /// The camera of the model's depth sensor.
    pub(super) own: TwinCamera,
    /// The factors from range to z-depth, for range images.
    z_of_range: Option<Vec<f32>>,
    /// The image pixel of each of the model's pixels, if the images are resampled.
    places: Option<Vec<Option<usize>>>,
}

/// The images of which a sensor is opened.
pub(super) struct ImageInput<'a> {
    pub(super) size: ImageSize,
    pub(super) kind: InputKind,
    /// Their `camera_params`.
    pub(super) params: Option<&'a Path>,
    /// The key of the noise, if it is not the sensor's prim.
    pub(super) name: Option<String>,
}

impl Images {
    /// Creates the sensor of a twin for images of one camera.
    pub(super) fn open(
        twin: &Twin,
        sensor_of_twin: &TwinDepthSensor,
        given: ImageInput<'_>,
        options: &SenseOptions,
        findings: &mut Vec<Finding>,
    ) -> Result<(Self, Sensor), SenseError> {
        let (size, prim) = (given.size, &sensor_of_twin.spec.prim);
        let own = twin.depth_camera(sensor_of_twin).ok_or_else(|| {
            SenseError::option(format!("the camera of {prim} is unknown; choose another model"))
        })?;
        let ImageCamera {
            camera: image,
            is_models,
        } = camera::of_images(
            size,
            options.field_of_view,
            given.params,
            own.intrinsics,
            findings,
        )?;
        let resampled = options.resample && !is_models;
        let measured = if resampled {
            findings.retain(|finding| !matches!(finding.code, "own-size" | "image-lens"));
            findings.push(Finding::new(
                "resampled",
                Level::Note,
                prim,
                format!(
                    "images of {size}, focal length {:.2} px, resampled to the model's {}, {:.2} px (nearest samples)",
                    image.intrinsics.fx, own.intrinsics.size, own.intrinsics.fx
                ),
                "",
            ));
            Camera::new(own.intrinsics, LensModel::Pinhole)
        } else {
            image
        };
        let settings = SensorOptions {
            image: Some(measured.intrinsics),
            name: given.name,
            ..options.sensor.clone()
        };
        let (sensor, more) = sensor(twin, sensor_of_twin, &settings)?;
        findings.extend(more);
        let images = Self {
            given: image,
            measured,
            own,
            z_of_range: (given.kind == InputKind::Range).then(|| z_of_range(&image)),
            places: resampled.then(|| places(&image, &measured)),
        };
        Ok((images, sensor))
    }

    /// Converts a depth image and its colours to images of the measured camera.
    pub(super) fn convert(
        &self,
        mut z: Image<f32>,
        rgb: Option<Image<[u8; 4]>>,
    ) -> (Image<f32>, Option<Image<[u8; 4]>>) {
        if let Some(factors) = &self.z_of_range {
            for (z, factor) in z.pixels_mut().iter_mut().zip(factors) {
                *z *= factor;
            }
        }
        let Some(places) = &self.places else {
            return (z, rgb);
        };
        let size = self.measured.intrinsics.size;
        (
            resample(&z, places, size, f32::INFINITY),
            rgb.map(|rgb| resample(&rgb, places, size, [0, 0, 0, 255])),
        )
    }
}

//! A depth sensor for images that arrive one by one.

use super::images::{ImageInput, Images};
use super::{InputKind, SenseError, SenseOptions};
use crate::limits::check_size;
use crate::sensor::{self, DepthShot, EngineInput, OutputCamera, Sensor, depth_sensor, frame, needs_a_pair};
use oaktwin_base::diagnostic::Finding;
use oaktwin_camera::{Camera, ImageSize};
use oaktwin_catalog::Twin;
use oaktwin_image::Image;
use oaktwin_image::annotation::Annotator;

/// A twin's depth sensor on images of one camera, measured one by one: what [`sense`](super::sense) does with a sequence.
#[derive(Debug)]
pub struct ImageSensor {
    images: Images,
    sensor: Sensor,
}

/// The output of an [`ImageSensor`]: images of its [`output_camera`](ImageSensor::output_camera).
#[derive(Clone, Debug, PartialEq)]
pub struct Measured {
    /// The measured depth, metres along the optical axis; 0 where nothing was measured.
    pub distance: Image<f32>,
    /// The colours of measured pixels, if a colour image was given.
    pub colors: Option<Image<[u8; 4]>>,
}

impl ImageSensor {
    /// Creates the sensor for images of a size. Of the options, those about outputs and files have no effect; without an input
    /// kind, images are depth along the optical axis.
    ///
    /// # Errors
    /// Returns an error if an option is invalid, or if the engine requires image pairs.
    pub fn new(
        twin: &Twin,
        size: ImageSize,
        options: &SenseOptions,
    ) -> Result<(Self, Vec<Finding>), SenseError> {
        check_size(size).map_err(|error| SenseError::option(error.to_string()))?;
        check_engine(options)?;
        let of_twin = depth_sensor(twin, options.depth_sensor.as_deref())?;
        let given = ImageInput {
            size,
            kind: options.input_kind.unwrap_or(InputKind::Z),
            params: None,
            name: options.sensor.name.clone(),
        };
        let mut findings = Vec::new();
        let (images, sensor) = Images::open(twin, of_twin, given, options, &mut findings)?;
        Ok((Self { images, sensor }, findings))
    }

    /// Measures a depth image in metres and its colour image. Each frame has its own noise, and equal frames have equal noise.
    ///
    /// # Errors
    /// Returns an error if an image does not have the sensor's size.
    pub fn measure(
        &mut self,
        z: Image<f32>,
        rgb: Option<Image<[u8; 4]>>,
        frame_number: u64,
    ) -> Result<Measured, SenseError> {
        let expected = self.images.given.intrinsics.size;
        let found = ImageSize::new(z.width(), z.height());
        if found != expected {
            return Err(SenseError::option(format!(
                "the depth image is {found} instead of {expected}; create a sensor for each size"
            )));
        }
        let (z, rgb) = self.images.convert(z, rgb);
        let mut shot = DepthShot::new((&z).into());
        shot.frame = frame_number;
        let mut request = vec![Annotator::DepthSensorDistance];
        if let Some(rgb) = &rgb {
            shot = shot
                .with_rgb(rgb.into())
                .map_err(|error| SenseError::option(format!("{error}; give images of the same size")))?;
            request.push(Annotator::DepthSensorPointCloudColor);
        }
        let camera = &self.images.measured;
        let capture = sensor::capture(&mut self.sensor, camera, shot.into(), &request)?;
        let rgb = rgb.as_ref().map(Into::into);
        let frame = frame(&self.sensor, camera, capture, rgb, &request);
        let distance = frame
            .depth_sensor_distance
            .ok_or_else(|| SenseError::option("the engine reports no distance; choose another engine"))?;
        Ok(Measured {
            distance: distance.0,
            colors: frame.depth_sensor_point_cloud_color,
        })
    }

    /// Returns the camera that the depth images are images of.
    #[must_use]
    pub fn input_camera(&self) -> Camera {
        self.images.given
    }

    /// Returns the camera that the outputs are images of.
    #[must_use]
    pub fn output_camera(&self) -> OutputCamera {
        self.sensor.output_camera(&self.images.measured)
    }

    /// Returns the name of the engine.
    #[must_use]
    pub fn engine(&self) -> &str {
        &self.sensor.engine().kind().name
    }

    /// Forgets all earlier frames.
    pub fn reset(&mut self) {
        self.sensor.reset();
    }
}

/// Rejects engines that match image pairs.
pub(super) fn check_engine(options: &SenseOptions) -> Result<(), SenseError> {
    match options.sensor.engine.as_deref() {
        Some(engine) if engine.input == EngineInput::Pair => {
            Err(needs_a_pair(engine, "the input is a depth image").into())
        }
        _ => Ok(()),
    }
}

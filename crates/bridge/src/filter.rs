//! The filter between topics: a depth image and its camera in, what the OAK reports out.

use std::num::NonZeroU32;

use oaktwin::camera::{Camera, ImageSize};
use oaktwin::catalog::Twin;
use oaktwin::depth::OutputCamera;
use oaktwin::diagnostic::Finding;
use oaktwin::image::Image;
use oaktwin::sense::{
    FieldOfView, ImageSensor, Measured, SenseError, SenseOptions, check_measured, check_unit,
};
use oaktwin::sensor::SensorOptions;

use crate::convert::{Depth, Points};
use crate::message::{Header, PointCloud2};

/// A twin's depth sensor on a stream of images. It is created again when the camera of the images or the options change.
#[derive(Debug)]
pub struct DepthFilter {
    twin: Twin,
    options: SenseOptions,
    current: Option<Current>,
}

#[derive(Debug)]
struct Current {
    /// The camera of the images; `None` if only their size is known.
    input: Option<Camera>,
    size: ImageSize,
    sensor: ImageSensor,
    output: OutputCamera,
    points: Option<Points>,
}

/// The input of one frame.
#[derive(Debug)]
pub struct FilterInput {
    /// The depth image.
    pub depth: Depth,
    /// The camera of the image; without it, the field of view is from the options, else the model's.
    pub camera: Option<Camera>,
    /// The colour image of the same camera and size.
    pub rgb: Option<Image<[u8; 4]>>,
    /// The number of the frame, which keys its noise.
    pub frame: u64,
}

/// The output of one frame.
#[derive(Debug)]
pub struct FilterOutput<'a> {
    /// The measured depth and the colours.
    pub measured: Measured,
    /// The camera of the measured images.
    pub camera: &'a OutputCamera,
    /// The camera of the depth image.
    pub input_camera: Camera,
    /// The findings about this frame, and about the sensor if it was created for it.
    pub findings: Vec<Finding>,
    points: &'a mut Option<Points>,
}

impl FilterOutput<'_> {
    /// Returns the points of every `step`th pixel of the measured depth in the frame of the input; see [`Points::message`].
    /// The step of the first call remains.
    pub fn point_cloud(&mut self, header: Header, step: NonZeroU32) -> PointCloud2 {
        let points = self.points.get_or_insert_with(|| Points::new(self.camera, step));
        points.message(header, &self.measured.distance, self.measured.colors.as_ref())
    }
}

impl DepthFilter {
    /// Creates a filter and checks its options on images of the model's own camera. Of the options, those about outputs and
    /// files have no effect.
    ///
    /// # Errors
    /// Returns an error if an option is invalid.
    pub fn new(twin: Twin, options: SenseOptions) -> Result<Self, SenseError> {
        check(&twin, &options)?;
        Ok(Self {
            twin,
            options,
            current: None,
        })
    }

    /// The twin.
    #[must_use]
    pub fn twin(&self) -> &Twin {
        &self.twin
    }

    /// The options.
    #[must_use]
    pub fn options(&self) -> &SenseOptions {
        &self.options
    }

    /// Changes the options of the sensor. If they differ, its temporal filters forget earlier frames.
    ///
    /// # Errors
    /// Returns an error if an option is invalid; the filter remains as it was.
    pub fn set_sensor(&mut self, sensor: SensorOptions) -> Result<(), SenseError> {
        if sensor == self.options.sensor {
            return Ok(());
        }
        let options = SenseOptions {
            sensor,
            ..self.options.clone()
        };
        check(&self.twin, &options)?;
        self.options = options;
        self.current = None;
        Ok(())
    }

    /// Forgets all earlier frames.
    pub fn reset(&mut self) {
        if let Some(current) = &mut self.current {
            current.sensor.reset();
        }
    }

    /// Measures a frame.
    ///
    /// # Errors
    /// Returns an error if the camera or the colour image is of another size than the depth image, or the sensor cannot be
    /// created for the camera.
    pub fn apply(&mut self, input: FilterInput) -> Result<FilterOutput<'_>, SenseError> {
        let FilterInput {
            depth: Depth { metres, unit },
            camera,
            rgb,
            frame,
        } = input;
        let size = ImageSize::new(metres.width(), metres.height());
        let mut findings = Vec::new();
        let is_same = |current: &Current| current.input == camera && current.size == size;
        let mut current = match self.current.take().filter(is_same) {
            Some(current) => current,
            None => {
                let (created, more) = create(&self.twin, &self.options, camera, size)?;
                findings.extend(more);
                created
            }
        };
        // The image is consumed by the sensor; a sample of it is enough to find odd values.
        let sample: Vec<f32> = metres.pixels().iter().step_by(97).copied().collect();
        let has_rgb = rgb.is_some();
        let measured = current.sensor.measure(metres, rgb, frame);
        let current = self.current.insert(current);
        let measured = measured?;
        findings.extend(check_unit(&sample, unit));
        if check_measured(&sample, &[], has_rgb).is_some() {
            findings.extend(check_measured(&sample, measured.distance.pixels(), has_rgb));
        }
        Ok(FilterOutput {
            measured,
            camera: &current.output,
            input_camera: current.sensor.input_camera(),
            findings,
            points: &mut current.points,
        })
    }
}

/// Creates the sensor of a twin for images of its own camera, to check options.
pub(crate) fn check(twin: &Twin, options: &SenseOptions) -> Result<(), SenseError> {
    let sensor = oaktwin::sensor::depth_sensor(twin, options.depth_sensor.as_deref())?;
    let own = twin.depth_camera(sensor).map(|camera| camera.intrinsics.size);
    let size = own.unwrap_or(ImageSize::new(1280, 800));
    ImageSensor::new(twin, size, options).map(|_| ())
}

fn create(
    twin: &Twin,
    options: &SenseOptions,
    camera: Option<Camera>,
    size: ImageSize,
) -> Result<(Current, Vec<Finding>), SenseError> {
    let options = match camera {
        Some(camera) => SenseOptions {
            field_of_view: FieldOfView::Camera(camera),
            ..options.clone()
        },
        None => options.clone(),
    };
    let (sensor, findings) = ImageSensor::new(twin, size, &options)?;
    let output = sensor.output_camera();
    let current = Current {
        input: camera,
        size,
        sensor,
        output,
        points: None,
    };
    Ok((current, findings))
}

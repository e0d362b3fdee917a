//! Depth that is measured by another camera of the device, and aligned to a camera of the recipe.

use oaktwin_base::diagnostic::{Finding, Level};
use oaktwin_camera::RigidTransform;
use oaktwin_catalog::{LensChoice, Twin};
use oaktwin_depth::align::Fill;
use oaktwin_image::ZDepth;
use oaktwin_pipeline::align::{AlignTo, align_to};
use oaktwin_pipeline::render::{OakOptions, PlacedCamera, oak_cameras};
use oaktwin_pipeline::sensor::{Sensor, depth_sensor};

use crate::GenerateError;
use crate::context::Context;
use crate::recipe::Texts;

/// The camera that depth is aligned to, and the camera that measures it, as indices into the cameras of a frame.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Aligned {
    pub(crate) target: usize,
    pub(crate) source: usize,
}

impl Context {
    /// Returns the names of the cameras to write: the recipe's, or else the camera that depth is aligned to.
    pub(crate) fn camera_names(&self) -> Vec<String> {
        let Texts(names) = &self.file.recipe.camera.cameras;
        match &self.file.recipe.sensor.align {
            Some(target) if names.is_empty() => vec![target.to_string()],
            _ => names.clone(),
        }
    }

    /// Finds the camera that depth is aligned to, and adds the camera that measures it to `cameras` if it is not among them.
    ///
    /// # Errors
    /// Returns an error if the recipe does not write the camera, or the device has no depth sensor.
    pub(crate) fn add_aligned(
        &self,
        twin: &Twin,
        world_from_body: &RigidTransform,
        cameras: &mut Vec<PlacedCamera>,
    ) -> Result<Option<Aligned>, GenerateError> {
        let Some(target) = &self.file.recipe.sensor.align else {
            return Ok(None);
        };
        let of = |name: String| {
            let options = OakOptions {
                cameras: &[name],
                size: self.file.recipe.camera.size(),
                ..OakOptions::default()
            };
            Ok::<_, GenerateError>(oak_cameras(twin, world_from_body, &options)?.0)
        };
        let place = |wanted: &PlacedCamera, cameras: &[PlacedCamera]| {
            cameras.iter().position(|camera| camera.path == wanted.path)
        };
        let found = of(target.to_string())?;
        let Some(target) = found.first().and_then(|camera| place(camera, cameras)) else {
            return Err(self.unfit(
                "sensor.align",
                format!("{target} is none of the cameras of the recipe"),
                "add it to camera.cameras",
            ));
        };
        let sensor = depth_sensor(twin, None)?;
        let source = of(sensor.spec.prim.clone())?.into_iter().next();
        let Some(source) = source else { return Ok(None) };
        let source = place(&source, cameras).unwrap_or_else(|| {
            cameras.push(source);
            cameras.len() - 1
        });
        Ok(Some(Aligned { target, source }))
    }

    /// Reports the cameras whose frames have no measured depth, although the recipe asks for it.
    pub(crate) fn without_measurement(
        &self,
        cameras: &[PlacedCamera],
        sensors: &[Option<Sensor>],
        aligned: Option<&Aligned>,
    ) -> Vec<Finding> {
        if !self
            .annotators
            .iter()
            .any(|annotator| annotator.is_depth_sensor())
        {
            return Vec::new();
        }
        let without = cameras
            .iter()
            .zip(sensors)
            .enumerate()
            .filter(|(at, (_, sensor))| {
                sensor.is_none() && aligned.is_none_or(|aligned| aligned.target != *at)
            });
        let note = |(_, (camera, _)): (usize, (&PlacedCamera, &Option<Sensor>))| {
            Finding::new(
                "no-depth-sensor",
                Level::Note,
                &camera.path,
                "is not the camera of a depth sensor: its frames have no measured depth",
                "add depth to camera.cameras, or align the sensor's depth to a camera with sensor.align",
            )
        };
        without.map(note).collect()
    }

    /// Returns depth that `source` measured with its sensor as the device aligns it to `target`.
    ///
    /// # Errors
    /// Returns an error if the position of a camera is unknown.
    pub(crate) fn aligned(
        &self,
        twin: &Twin,
        (source, sensor): (&PlacedCamera, &Sensor),
        depth: &ZDepth,
    ) -> Result<Option<ZDepth>, GenerateError> {
        let Some(camera) = self.file.recipe.sensor.align else {
            return Ok(None);
        };
        let to = AlignTo {
            camera,
            size: self.file.recipe.camera.size(),
            fill: Fill::default(),
            z: None,
        };
        let own = depth_sensor(twin, None)?;
        let align = align_to(twin, own, sensor, &source.camera, &to, LensChoice::default())
            .map_err(|what| self.unfit("sensor.align", what, "remove it"))?;
        Ok(align.align((&depth.0).into()).ok())
    }
}

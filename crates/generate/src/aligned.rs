//! Depth that is measured by another camera of the device, and aligned to a camera of the recipe.

use oaktwin_base::diagnostic::{Finding, Level};
use oaktwin_camera::RigidTransform;
use oaktwin_catalog::{LensChoice, Twin};
use oaktwin_dataset::Shot;
use oaktwin_depth::align::Fill;
use oaktwin_image::ZDepth;
use oaktwin_image::annotation::Annotator;
use oaktwin_pipeline::align::{AlignTo, align_to};
use oaktwin_pipeline::render::{OakOptions, PlacedCamera, Rig, RigError, oak_cameras};
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

/// Takes a frame of one camera of a rig, with some annotators.
pub(crate) type Take<'a> =
    dyn FnMut(&mut Rig, usize, &[Annotator]) -> Result<(Shot, Vec<Finding>), RigError> + 'a;

impl Context {
    /// Returns the names of the cameras to write: the recipe's, or else the camera that depth is aligned to.
    pub(crate) fn camera_names(&self) -> Vec<String> {
        let Texts(names) = &self.file.recipe.camera.cameras;
        match &self.file.recipe.sensor.align {
            Some(target) if names.is_empty() => vec![target.to_string()],
            _ => names.clone(),
        }
    }

    /// Finds the camera that depth is aligned to and the camera that measures it, and returns the name of the latter if it is not among
    /// the `cameras` of the recipe and must be added after them.
    ///
    /// # Errors
    /// Returns an error if the recipe does not write the camera, or the device has no depth sensor.
    pub(crate) fn find_aligned(
        &self,
        twin: &Twin,
        cameras: &[PlacedCamera],
    ) -> Result<(Option<Aligned>, Option<String>), GenerateError> {
        let Some(target) = &self.file.recipe.sensor.align else {
            return Ok((None, None));
        };
        let place = |name: String| {
            let options = OakOptions {
                cameras: &[name],
                size: self.file.recipe.camera.size(),
                ..OakOptions::default()
            };
            let found = oak_cameras(twin, &RigidTransform::IDENTITY, &options)?.0;
            let wanted = found.first().map(|camera| &camera.path);
            let place = cameras.iter().position(|camera| Some(&camera.path) == wanted);
            Ok::<_, GenerateError>(place)
        };
        let Some(target_place) = place(target.to_string())? else {
            return Err(self.unfit(
                "sensor.align",
                format!("{target} is none of the cameras of the recipe"),
                "add it to camera.cameras",
            ));
        };
        let prim = &depth_sensor(twin, None)?.spec.prim;
        let source = place(prim.clone())?;
        let aligned = Aligned {
            target: target_place,
            source: source.unwrap_or(cameras.len()),
        };
        Ok((Some(aligned), source.is_none().then(|| prim.clone())))
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

    /// Puts measured depth into the frame of the camera that it is aligned to. `take` takes a frame of another camera of the rig.
    ///
    /// # Errors
    /// Returns an error if the sensor cannot measure, or the position of a camera is unknown.
    pub(crate) fn put_aligned(
        &self,
        twin: &Twin,
        &Aligned { target, source }: &Aligned,
        rig: &mut Rig,
        shots: &mut [Shot],
        take: &mut Take<'_>,
    ) -> Result<Vec<Finding>, GenerateError> {
        let Some(sensor) = rig.sensors()[source].clone() else {
            return Ok(Vec::new());
        };
        let own = shots
            .get(source)
            .and_then(|shot| shot.frame.depth_sensor_distance.clone());
        let (depth, findings) = match own {
            Some(depth) => (Some(depth), Vec::new()),
            None => {
                let (shot, findings) = take(rig, source, &[Annotator::DepthSensorDistance])?;
                (shot.frame.depth_sensor_distance, findings)
            }
        };
        if let Some(depth) = depth {
            let from = (&rig.cameras()[source], &sensor);
            let shot = &mut shots[target];
            shot.frame.depth_sensor_distance = self.aligned(twin, from, &depth)?;
            shot.sensor_view.clone_from(&shot.view);
            shot.sensor_params.clone_from(&shot.camera_params);
        }
        Ok(findings)
    }

    /// Returns depth that `source` measured with its sensor as the device aligns it to `target`.
    ///
    /// # Errors
    /// Returns an error if the position of a camera is unknown.
    fn aligned(
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

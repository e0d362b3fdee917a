//! The depth sensors of rendered cameras: their parameters and their outputs.

mod capture;
mod stage;

use std::collections::BTreeMap;

pub use capture::{scene_annotators, sense_frame, sensor_input};

use super::camera::{DepthSensorSource, PlacedCamera};
use crate::sensor::{self, Illumination, ParameterError, Sensor, SensorOptions};
use oaktwin_base::diagnostic::Finding;
use oaktwin_catalog::Twin;

/// The options of the cameras' depth sensors.
#[derive(Clone, Copy, Debug)]
pub struct DepthSensorOptions<'a> {
    /// The device, if the cameras belong to an OAK.
    pub twin: Option<&'a Twin>,
    /// The sensor options. By default, the depth sensor of an OAK uses the engine of its technology, and the depth sensor of a stage uses
    /// `single-view`. The image is the camera's own, and the default name is the name of its prim.
    pub sensor: &'a SensorOptions,
    /// The light that an OAK sees.
    pub light: Illumination,
}

/// An invalid depth sensor: `CAMERA: PARAMETER: what is wrong; what to do`.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{place}: {error}")]
pub struct DepthSensorError {
    /// The prim with the parameter, or the camera.
    pub place: String,
    /// What is wrong.
    pub error: ParameterError,
}

/// Returns the depth sensor of each camera that has one, and the findings.
///
/// # Errors
/// Returns an error if a parameter does not exist, has the wrong type or is out of range.
pub fn depth_sensors(
    cameras: &[PlacedCamera],
    options: &DepthSensorOptions<'_>,
) -> Result<(Vec<Option<Sensor>>, Vec<Finding>), DepthSensorError> {
    let mut findings = Vec::new();
    let mut sensors = Vec::new();
    let names = names(cameras);
    for (camera, name) in cameras.iter().zip(names) {
        let sensor = match &camera.depth_sensor {
            None => None,
            Some(DepthSensorSource::Twin(prim)) => of_twin(camera, prim, options)?,
            Some(DepthSensorSource::Stage { sensor, .. }) => {
                Some(stage::sensor(sensor, &name, options.sensor)?)
            }
        };
        sensors.push(sensor.map(|(sensor, more)| {
            findings.extend(more);
            sensor
        }));
    }
    Ok((sensors, findings))
}

fn of_twin(
    camera: &PlacedCamera,
    prim: &str,
    options: &DepthSensorOptions<'_>,
) -> Result<Option<(Sensor, Vec<Finding>)>, DepthSensorError> {
    let Some(twin) = options.twin else {
        return Ok(None);
    };
    let Some(spec) = twin.depth_sensors.iter().find(|sensor| sensor.spec.prim == prim) else {
        return Ok(None);
    };
    let own = SensorOptions {
        engine: Some(options.sensor.engine_for(spec.spec.kind)),
        image: Some(camera.camera.intrinsics),
        ..options.sensor.clone()
    };
    let own = own.lit_by(options.light);
    let sensor = sensor::sensor(twin, spec, &own).map_err(|error| DepthSensorError {
        place: camera.path.clone(),
        error,
    })?;
    Ok(Some(sensor))
}

/// The noise key of each camera's sensor: the name of the camera's prim, or its path if several have that name, so that their
/// noise differs.
fn names(cameras: &[PlacedCamera]) -> Vec<String> {
    let name = |camera: &PlacedCamera| match &camera.depth_sensor {
        Some(DepthSensorSource::Stage { camera, .. }) => camera.clone(),
        Some(DepthSensorSource::Twin(prim)) => prim.clone(),
        None => String::new(),
    };
    let mut uses: BTreeMap<String, usize> = BTreeMap::new();
    for camera in cameras {
        *uses.entry(name(camera)).or_default() += 1;
    }
    cameras
        .iter()
        .map(|camera| {
            let name = name(camera);
            if uses.get(&name).is_some_and(|uses| *uses > 1) {
                camera.path.clone()
            } else {
                name
            }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::{OakOptions, oak_cameras};
    use crate::sensor::{STEREO_NOISE, TIME_OF_FLIGHT};
    use oaktwin_camera::RigidTransform;
    use oaktwin_catalog::Catalog;

    #[test]
    fn an_oak_has_the_engines_of_its_technologies() {
        let catalog = Catalog::builtin();
        let twin = catalog.nominal(catalog.device("OAK-D ToF").unwrap());
        let names = ["left".to_owned(), "depth".to_owned()];
        let options = OakOptions {
            cameras: &names,
            ..OakOptions::default()
        };
        let (cameras, _) = oak_cameras(&twin, &RigidTransform::IDENTITY, &options).unwrap();
        let sensor = SensorOptions::default();
        let options = DepthSensorOptions {
            twin: Some(&twin),
            sensor: &sensor,
            light: Illumination::default(),
        };
        let (sensors, _) = depth_sensors(&cameras, &options).unwrap();
        assert!(sensors[0].is_none());
        let engines = sensors[1..]
            .iter()
            .map(|sensor| sensor.as_ref().unwrap().engine().kind());
        assert_eq!(engines.collect::<Vec<_>>(), [&STEREO_NOISE, &TIME_OF_FLIGHT]);
        let stereo = SensorOptions {
            engine: Some((&STEREO_NOISE).into()),
            ..sensor.clone()
        };
        let options = DepthSensorOptions {
            sensor: &stereo,
            ..options
        };
        assert!(depth_sensors(&cameras[..2], &options).is_ok());
        let error = depth_sensors(&cameras, &options).unwrap_err();
        assert_eq!(error.place, "OAK-D ToF/Camera_pseudo_depth_tof");
    }

    #[test]
    fn two_oaks_have_different_noise() {
        let catalog = Catalog::builtin();
        let twin = catalog.nominal(catalog.device("OAK4-D").unwrap());
        let (mut cameras, _) = oak_cameras(&twin, &RigidTransform::IDENTITY, &OakOptions::default()).unwrap();
        assert_eq!(names(&cameras), ["Camera_pseudo_depth"]);
        cameras.push(cameras[0].clone());
        cameras[1].path = "Other/Camera_pseudo_depth".to_owned();
        assert_eq!(
            names(&cameras),
            ["OAK4-D/Camera_pseudo_depth", "Other/Camera_pseudo_depth"]
        );
    }
}

//! From a specification to a rig: the only place that chooses engines, the pair and the light of a depth sensor.

use std::sync::Arc;

use oaktwin_base::diagnostic::{Finding, Level, message, opt};
use oaktwin_camera::RigidTransform;
use oaktwin_catalog::Twin;

use super::colors::RgbImager;
use super::spec::{depth_sensor_of, engine_of};
use super::{PairUse, Rig, RigError, RigSpec};
use crate::pair::{PairCameras, PairOptions, illumination};
use crate::render::shutter::offsets_s;
use crate::render::sweep::SweptSensors;
use crate::render::{
    DepthSensorOptions, OakOptions, PlacedCamera, SceneCameraOptions, SceneFile, depth_sensors, oak_cameras,
    put_pair, scene_cameras,
};
use crate::sensor::{EngineInput, Illumination, SensorOptions, models};

impl Rig {
    /// Makes the rig of an OAK, with its body at the origin. The findings report where it deviates from the twin.
    ///
    /// # Errors
    /// Returns an error if the device lacks a camera, a sensor or a pair that the specification requires, or an option is invalid.
    pub fn new(twin: &Twin, spec: &RigSpec) -> Result<(Self, Vec<Finding>), RigError> {
        let options = OakOptions {
            cameras: &spec.cameras,
            lens: spec.pair.lens,
            size: spec.size,
        };
        let (mut cameras, mut findings) = oak_cameras(twin, &RigidTransform::IDENTITY, &options)?;
        let all = spec.all_sensors()?;
        findings.extend(retain_modelled(twin, &mut cameras, spec, &all));
        let pair = pair(twin, &mut cameras, spec, &all)?.map(|(pair, more)| {
            findings.extend(more);
            pair
        });
        let options = DepthSensorOptions {
            twin: Some(twin),
            sensor: &spec.sensor,
            // Pairs show it in their images; other engines have parameters for it.
            light: illumination(twin, spec.pair.projector, spec.pair.ambient)?,
        };
        let rig = Self::with_sensors(
            twin.device.name.clone(),
            cameras,
            pair,
            spec,
            &options,
            &mut findings,
        )?;
        findings.extend(rig.without_sensor(Some(twin), spec)?);
        Ok((rig, findings))
    }

    /// Makes the rig of a stage's own cameras, at their poses. The findings report unusual attributes.
    ///
    /// # Errors
    /// Returns an error if the stage lacks a camera or a sensor that the specification requires, or an attribute or option is invalid.
    pub fn of_stage(stage: &SceneFile, spec: &RigSpec) -> Result<(Self, Vec<Finding>), RigError> {
        for options in spec.all_sensors()? {
            if let Some(engine) = options
                .engine
                .as_deref()
                .filter(|kind| kind.input == EngineInput::Pair)
            {
                return Err(RigError::Option(message![
                    opt("engine").with(engine),
                    " requires the stereo pair of an OAK; place one in the scene with ",
                    opt("model"),
                    ", or use stereo-noise"
                ]));
            }
        }
        let options = SceneCameraOptions {
            cameras: &spec.cameras,
            size: spec.size,
            projection: spec.projection,
        };
        let (cameras, mut findings) = scene_cameras(stage, &options)?;
        let options = DepthSensorOptions {
            twin: None,
            sensor: &spec.sensor,
            light: Illumination::default(),
        };
        let rig = Self::with_sensors(
            stage.path.display().to_string(),
            cameras,
            None,
            spec,
            &options,
            &mut findings,
        )?;
        findings.extend(rig.without_sensor(None, spec)?);
        Ok((rig, findings))
    }

    fn with_sensors(
        name: String,
        cameras: Vec<PlacedCamera>,
        pair: Option<PairCameras>,
        spec: &RigSpec,
        options: &DepthSensorOptions<'_>,
        findings: &mut Vec<Finding>,
    ) -> Result<Self, RigError> {
        let mut sensors = Vec::new();
        let mut swept = None;
        if spec.senses() {
            let (own, more) = depth_sensors(&cameras, options)?;
            findings.extend(more);
            sensors = own;
            let sweep = spec.sweep.clone();
            swept = sweep
                .map(|sweep| SweptSensors::new(sweep, &cameras, options))
                .transpose()?;
        }
        if let Some(shutter) = &spec.shutter {
            shutter.check().map_err(RigError::Option)?;
        }
        sensors.resize(cameras.len(), None);
        let imagers = RgbImager::of(&cameras, spec)?;
        let offsets_s = offsets_s(&cameras, &spec.camera_offsets_ms).map_err(RigError::Option)?;
        Ok(Self {
            name,
            cameras,
            sensors,
            swept,
            pair: pair.map(Arc::new),
            pair_use: spec.pair_use,
            annotators: spec.annotators.clone(),
            are_outputs_optional: spec.are_outputs_optional,
            imagers,
            backend: spec.backend,
            transparent: spec.transparent,
            shutter: spec.shutter,
            offsets_s,
            twist: None,
        })
    }
}

/// Leaves out depth sensors that none of the engines models, if no camera is named and others remain.
fn retain_modelled(
    twin: &Twin,
    cameras: &mut Vec<PlacedCamera>,
    spec: &RigSpec,
    all: &[SensorOptions],
) -> Vec<Finding> {
    let is_modelled = |camera: &PlacedCamera| {
        let Some(sensor) = depth_sensor_of(twin, camera) else {
            return true;
        };
        all.iter()
            .any(|options| models(&options.engine_for(sensor.spec.kind), sensor.spec.kind))
    };
    if !spec.cameras.is_empty() || !spec.senses() || !cameras.iter().any(is_modelled) {
        return Vec::new();
    }
    let (kept, left_out) = std::mem::take(cameras).into_iter().partition(is_modelled);
    *cameras = kept;
    let left_out: Vec<PlacedCamera> = left_out;
    let note = |camera: &PlacedCamera| {
        Finding::new(
            "sensor-left-out",
            Level::Note,
            camera.path.clone(),
            "is left out, because the engine does not model it",
            message!["choose it with ", opt("camera"), " and an engine that does"],
        )
    };
    left_out.iter().map(note).collect()
}

/// The pair, if the specification has a use for it. The cameras of depth sensors that match it become its left camera.
fn pair(
    twin: &Twin,
    cameras: &mut [PlacedCamera],
    spec: &RigSpec,
    all: &[SensorOptions],
) -> Result<Option<(PairCameras, Vec<Finding>)>, RigError> {
    let matches = |options: &SensorOptions| {
        if options
            .engine
            .as_ref()
            .is_some_and(|kind| kind.input == EngineInput::Pair)
        {
            return true;
        }
        let mut kinds = cameras
            .iter()
            .filter_map(|camera| engine_of(twin, camera, options));
        kinds.any(|kind| kind.input == EngineInput::Pair)
    };
    let is_matched = all.iter().any(matches);
    let is_beside = !is_matched && spec.pair_use == PairUse::Beside;
    if !is_matched && spec.pair_use == PairUse::Matched {
        return Ok(None);
    }
    let options = PairOptions {
        size: spec.size,
        ..spec.pair.of_sensor(&spec.sensor)?
    };
    if is_matched {
        same_bias(options.bias_px, all)?;
    }
    if is_beside {
        // Only a matcher reports the depth of the rectified camera.
        return Ok(put_pair(twin, &mut cameras.to_vec(), &options).ok());
    }
    Ok(Some(put_pair(twin, cameras, &options)?))
}

/// Rejects a sweep of the pair's own calibration error.
fn same_bias(bias_px: f64, all: &[SensorOptions]) -> Result<(), RigError> {
    for swept in all {
        if swept.calibration_error_px()?.to_bits() != bias_px.to_bits() {
            return Err(RigError::Option(message![
                opt("sweep").with("bias"),
                ": not supported with stereo-matching, which renders the pair once; run with each ",
                opt("param").with("bias=")
            ]));
        }
    }
    Ok(())
}

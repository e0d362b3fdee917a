//! What a sensor measures of a scene.

use std::sync::{Mutex, PoisonError};

use oaktwin::camera::ImageSize;
use oaktwin::pair::PairOptions;
use oaktwin::render::{Rig, RigSpec};
use oaktwin::sense::FieldOfView;
use oaktwin::sensor::EngineInput;
use pyo3::prelude::*;

use super::DepthSensor;
use crate::arguments::{FrameNumber, Size};
use crate::engine::serve_all;
use crate::error::{error, wrong};
use crate::finding;
use crate::pair::PairSettings;
use crate::pose::Of;
use crate::progress::ProgressCallback;
use crate::scene::Scene;
use crate::shot::OUTPUTS;

/// The rig of the most recent shots, whose filters may remember them.
#[derive(Default)]
pub(super) struct Shooting(Mutex<Option<(RigSpec, Rig)>>);

impl Shooting {
    /// Forgets the earlier shots.
    pub(super) fn reset(&self) {
        *self.0.lock().unwrap_or_else(PoisonError::into_inner) = None;
    }
}

/// The light of a shot, and its image sensors.
pub(super) struct Light<'a, 'py> {
    pub(super) projector: f64,
    pub(super) ambient: f64,
    pub(super) imager: Option<&'a Bound<'py, PyAny>>,
}

impl<'a, 'py> Light<'a, 'py> {
    pub(super) fn new(projector: f64, ambient: f64, imager: Option<&'a Bound<'py, PyAny>>) -> Self {
        Self {
            projector,
            ambient,
            imager,
        }
    }
}

impl DepthSensor {
    /// The shot of a scene.
    pub(super) fn shot<'py>(
        &self,
        py: Python<'py>,
        scene: &Scene,
        world_from_body: &Bound<'py, PyAny>,
        size: Option<Size>,
        light: &Light<'_, 'py>,
        frame: Option<FrameNumber>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let world_from_body = Of::Body.one("world_from_body", world_from_body)?;
        let spec = self.spec(size, light)?;
        let (rig, findings) = self.rig(py, &spec)?;
        finding::warn(py, &findings)?;
        rig.check_memory(false).map_err(error)?;
        let number = self.frame(frame);
        let stage = scene.read(py);
        let renderer = &stage.renderer;
        let shot = serve_all(py, self.engine.as_slice(), ProgressCallback::default(), |_| {
            let mut rig = rig;
            let shot = rig.shoot_camera(renderer, 0, Some(&world_from_body), number, &spec.annotators);
            let mut kept = self.shooting.0.lock().unwrap_or_else(PoisonError::into_inner);
            *kept = Some((spec, rig));
            shot
        })?;
        let (shot, findings) = shot.map_err(error)?;
        finding::warn(py, &findings)?;
        crate::shot::shot(py, shot, &world_from_body, self.source.seed(), &findings)
    }

    /// What a rig makes for the shots.
    fn spec(&self, size: Option<Size>, light: &Light<'_, '_>) -> PyResult<RigSpec> {
        if !matches!(self.source.field_of_view, FieldOfView::Known) {
            let is = "belong to images of another camera";
            let remedy = "shoot with a sensor without them, or measure rendered depth";
            return Err(wrong("fx, hfov_deg, camera", is, remedy));
        }
        let options = self.source.options();
        let kind = options.engine_for(self.source.depth.spec.kind);
        let size = size.map(|Size(width, height)| (width, height));
        let settings = PairSettings {
            sensor: None,
            size,
            projector: light.projector,
            ambient: light.ambient,
            imager: light.imager,
            seed: options.seed,
            device_seed: options.device_seed,
            drift: None,
        };
        // Other engines need no pair, which the device may lack.
        let pair = if kind.input == EngineInput::Pair || light.imager.is_some() {
            settings.options(self.device.get())?
        } else {
            PairOptions {
                projector: light.projector,
                ambient: light.ambient,
                ..PairOptions::default()
            }
        };
        Ok(RigSpec {
            cameras: vec![self.source.depth.spec.prim.clone()],
            size: size.map(|(width, height)| ImageSize::new(width, height)),
            annotators: OUTPUTS.to_vec(),
            are_outputs_optional: true,
            pair: PairOptions {
                lens: self.lens,
                ..pair
            },
            sensor: options,
            ..RigSpec::default()
        })
    }

    /// The rig of a specification: that of the shot before, or a new one. It makes only what its engine can.
    fn rig(&self, py: Python<'_>, spec: &RigSpec) -> PyResult<(Rig, Vec<oaktwin::diagnostic::Finding>)> {
        py.detach(|| {
            let mut kept = self.shooting.0.lock().unwrap_or_else(PoisonError::into_inner);
            if let Some((_, rig)) = kept.take().filter(|(own, _)| own == spec) {
                return Ok((rig, Vec::new()));
            }
            Rig::new(&self.source.twin, spec).map_err(error)
        })
    }
}

use std::sync::{Arc, PoisonError};

use oaktwin::camera::{self, ImageSize};
use oaktwin::catalog::{Twin, TwinDepthSensor};
use oaktwin::diagnostic;
use oaktwin::sense::{self, FieldOfView};
use oaktwin::sensor::{self, Sensor, SensorOptions};
use pyo3::prelude::*;

use super::DepthSensor;
use crate::error::{error, wrong};

/// What images of one size are looked at with.
#[derive(Clone)]
pub(super) struct Eye {
    pub(super) camera: camera::Camera,
    pub(super) sensor: Arc<Sensor>,
    pub(super) findings: Vec<diagnostic::Finding>,
}

/// What eyes are made of.
pub(super) struct Source {
    pub(super) twin: Arc<Twin>,
    pub(super) depth: TwinDepthSensor,
    pub(super) options: SensorOptions,
    pub(super) field_of_view: FieldOfView,
}

impl Source {
    /// For images of a size; by default that of their camera, where it is known, or the model's own.
    pub(super) fn eye(&self, size: Option<ImageSize>) -> PyResult<Eye> {
        let Self {
            twin,
            depth,
            options,
            field_of_view,
        } = self;
        let own = twin.camera(depth.spec.camera).ok_or_else(|| {
            wrong(
                &depth.spec.prim,
                "its camera is not known",
                "choose another model",
            )
        })?;
        let size = size.unwrap_or(match field_of_view {
            FieldOfView::Camera(camera) => camera.intrinsics.size,
            _ => own.intrinsics.size,
        });
        let (camera, mut findings) =
            sense::image_camera(size, *field_of_view, own.intrinsics).map_err(error)?;
        let options = SensorOptions {
            image: Some(camera.intrinsics),
            ..options.clone()
        };
        let (sensor, more) = sensor::sensor(twin, depth, &options).map_err(error)?;
        findings.extend(more);
        Ok(Eye {
            camera,
            sensor: Arc::new(sensor),
            findings,
        })
    }
}

impl DepthSensor {
    /// The eye for a size; another size than before forgets all frames.
    pub(super) fn look<'a>(&self, eye: &'a mut Eye, size: ImageSize) -> PyResult<&'a mut Eye> {
        if eye.camera.intrinsics.size != size {
            *eye = self.source.eye(Some(size))?;
        }
        Ok(eye)
    }

    /// What is there of the images of a size.
    pub(super) fn now(&self, py: Python<'_>, size: Option<ImageSize>) -> PyResult<Eye> {
        py.detach(|| {
            let mut eye = self.eye.lock().unwrap_or_else(PoisonError::into_inner);
            let size = size.unwrap_or(eye.camera.intrinsics.size);
            Ok(self.look(&mut eye, size)?.clone())
        })
    }
}

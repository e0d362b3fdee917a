use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, PoisonError};

use oaktwin::camera::{self, ImageSize, RigidTransform};
use oaktwin::catalog::{Twin, TwinCamera, TwinDepthSensor};
use oaktwin::diagnostic;
use oaktwin::render::Clip;
use oaktwin::sense::{self, FieldOfView};
use oaktwin::sensor::{self, EngineInput, Sensor, SensorOptions};
use pyo3::prelude::*;

use super::DepthSensor;
use crate::camera::Camera;
use crate::error::{error, wrong};
use crate::threads;

/// The sensor and the camera for images of one size.
#[derive(Clone)]
pub(super) struct Eye {
    pub(super) camera: camera::Camera,
    pub(super) sensor: Arc<Sensor>,
    pub(super) findings: Vec<diagnostic::Finding>,
}

/// The settings from which sensors for image sizes are made.
pub(super) struct Source {
    pub(super) twin: Arc<Twin>,
    pub(super) depth: TwinDepthSensor,
    /// The options; the seed is `seed`.
    pub(super) options: SensorOptions,
    /// The noise seed, which a reset can change.
    pub(super) seed: AtomicU64,
    pub(super) field_of_view: FieldOfView,
}

impl Source {
    /// The same settings for another unit.
    pub(super) fn of_twin(&self, twin: &Arc<Twin>) -> PyResult<Self> {
        let kind = self.depth.spec.kind.as_str();
        Ok(Self {
            twin: Arc::clone(twin),
            depth: sensor::depth_sensor(twin, Some(kind)).map_err(error)?.clone(),
            options: self.options(),
            seed: AtomicU64::new(self.seed()),
            field_of_view: self.field_of_view,
        })
    }

    /// The camera of the model whose images the sensor measures.
    fn own(&self) -> PyResult<TwinCamera> {
        let spec = &self.depth.spec;
        let own = self.twin.depth_camera(&self.depth);
        own.ok_or_else(|| wrong(&spec.prim, "its camera is not known", "choose another model"))
    }

    /// Creates the sensor for images of a size; the default is the size of the camera, if set, otherwise the size of the
    /// model.
    pub(super) fn eye(&self, size: Option<ImageSize>) -> PyResult<Eye> {
        self.eye_with(size, &self.options())
    }

    /// The options with the present seed.
    pub(super) fn options(&self) -> SensorOptions {
        SensorOptions {
            seed: self.seed(),
            ..self.options.clone()
        }
    }

    pub(super) fn seed(&self) -> u64 {
        self.seed.load(Ordering::Relaxed)
    }

    /// Creates such a sensor with other options.
    pub(super) fn eye_with(&self, size: Option<ImageSize>, options: &SensorOptions) -> PyResult<Eye> {
        let Self {
            twin,
            depth,
            field_of_view,
            ..
        } = self;
        let own = self.own()?;
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
    /// The pose of the images' camera on the device.
    pub(super) fn body_from_images(&self) -> PyResult<RigidTransform> {
        match &self.camera {
            Some(camera) => Ok(camera.body_from_camera),
            None => self.source.own().map(|own| own.body_from_camera),
        }
    }

    /// Returns the sensor for an image size; a change of size clears the memory of earlier frames.
    pub(super) fn look<'a>(&self, eye: &'a mut Eye, size: ImageSize) -> PyResult<&'a mut Eye> {
        if eye.camera.intrinsics.size != size {
            *eye = self.source.eye(Some(size))?;
        }
        Ok(eye)
    }

    /// Measures with the sensor for an image size, which may remember what it measured. Called with the interpreter released.
    ///
    /// The sensor is locked while it measures, unless an engine in Python does: the engine may ask the sensor for its properties.
    pub(super) fn measure<T: Send>(
        &self,
        size: ImageSize,
        work: impl FnOnce(&mut Sensor, &camera::Camera) -> T + Send,
    ) -> PyResult<T> {
        let lock = || self.eye.lock().unwrap_or_else(PoisonError::into_inner);
        if self.engine.is_none() {
            // Locked before entering the pool, so that the pool's threads never wait for the lock.
            let mut eye = lock();
            let eye = self.look(&mut eye, size)?;
            let sensor = Arc::make_mut(&mut eye.sensor);
            return threads::install(|| work(sensor, &eye.camera));
        }
        let mut own = self.look(&mut lock(), size)?.clone();
        let sensor = Arc::make_mut(&mut own.sensor);
        let measured = threads::install(|| work(sensor, &own.camera))?;
        let mut eye = lock();
        if eye.camera.intrinsics.size == size {
            eye.sensor = own.sensor;
        }
        Ok(measured)
    }

    /// The camera of the outputs, for the most recent image size.
    pub(super) fn output_camera(&self, py: Python<'_>) -> PyResult<Camera> {
        let eye = self.now(py, None)?;
        let output = eye.sensor.output_camera(&eye.camera);
        let (near_m, far_m) = self.source.depth.spec.clipping_range_m;
        let mut own = Camera::rectified(
            output.camera,
            self.body_from_images()? * output.input_from_output(),
        );
        own.clip = match &self.camera {
            Some(camera) => camera.clip,
            None => Clip { near_m, far_m },
        };
        Ok(own)
    }

    /// An engine that matches pairs measures no depth images.
    pub(super) fn check_measures_depth(&self) -> PyResult<()> {
        let engine = self.source.options.engine.as_deref();
        let Some(engine) = engine.filter(|kind| kind.input == EngineInput::Pair) else {
            return Ok(());
        };
        let is = format!("{engine} matches image pairs and measures no depth images");
        let remedy = "use shoot(scene, pose), or StereoMatcher";
        Err(wrong("engine", is, remedy))
    }

    /// Starts a new sequence, with another seed if one is given.
    pub(super) fn restart(&self, seed: Option<u64>) -> PyResult<()> {
        self.memory.reset(None);
        self.shooting.reset();
        let mut eye = self.eye.lock().unwrap_or_else(PoisonError::into_inner);
        match seed {
            Some(seed) => {
                self.source.seed.store(seed, Ordering::Relaxed);
                self.next_frame.store(0, Ordering::Relaxed);
                *eye = self.source.eye(Some(eye.camera.intrinsics.size))?;
            }
            None => Arc::make_mut(&mut eye.sensor).reset(),
        }
        Ok(())
    }

    /// Returns the sensor for images of a size, which is shared.
    pub(super) fn of_size(&self, py: Python<'_>, size: ImageSize) -> PyResult<Arc<Sensor>> {
        // Releasing the interpreter is only worth its time if the lock is taken, or for another size.
        if let Ok(eye) = self.eye.try_lock()
            && eye.camera.intrinsics.size == size
        {
            return Ok(Arc::clone(&eye.sensor));
        }
        Ok(self.now(py, Some(size))?.sensor)
    }

    /// Returns a copy of the sensor for an image size; by default, for the most recent one.
    pub(super) fn now(&self, py: Python<'_>, size: Option<ImageSize>) -> PyResult<Eye> {
        py.detach(|| {
            let mut eye = self.eye.lock().unwrap_or_else(PoisonError::into_inner);
            let size = size.unwrap_or(eye.camera.intrinsics.size);
            Ok(self.look(&mut eye, size)?.clone())
        })
    }
}

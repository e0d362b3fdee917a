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
pub(super) struct SizedSensor {
    pub(super) camera: camera::Camera,
    pub(super) sensor: Arc<Sensor>,
    pub(super) findings: Vec<diagnostic::Finding>,
}

/// The settings from which sensors for image sizes are made.
pub(super) struct SensorSettings {
    pub(super) twin: Arc<Twin>,
    pub(super) depth: TwinDepthSensor,
    /// The options; the seed is `seed`.
    pub(super) options: SensorOptions,
    /// The noise seed, which a reset can change.
    pub(super) seed: AtomicU64,
    pub(super) field_of_view: FieldOfView,
}

impl SensorSettings {
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
    fn model_camera(&self) -> PyResult<TwinCamera> {
        let spec = &self.depth.spec;
        let camera = self.twin.depth_camera(&self.depth);
        camera.ok_or_else(|| wrong(&spec.prim, "its camera is not known", "choose another model"))
    }

    /// Creates the sensor for images of a size; the default is the size of the camera, if set, otherwise the size of the
    /// model.
    pub(super) fn sized(&self, size: Option<ImageSize>) -> PyResult<SizedSensor> {
        self.sized_with(size, &self.options())
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
    pub(super) fn sized_with(
        &self,
        size: Option<ImageSize>,
        options: &SensorOptions,
    ) -> PyResult<SizedSensor> {
        let Self {
            twin,
            depth,
            field_of_view,
            ..
        } = self;
        let camera = self.model_camera()?;
        let size = size.unwrap_or(match field_of_view {
            FieldOfView::Camera(camera) => camera.intrinsics.size,
            _ => camera.intrinsics.size,
        });
        let (camera, mut findings) =
            sense::image_camera(size, *field_of_view, camera.intrinsics).map_err(error)?;
        let options = SensorOptions {
            image: Some(camera.intrinsics),
            ..options.clone()
        };
        let (sensor, more) = sensor::sensor(twin, depth, &options).map_err(error)?;
        findings.extend(more);
        Ok(SizedSensor {
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
            None => self.source.model_camera().map(|camera| camera.body_from_camera),
        }
    }

    /// Returns the sensor for an image size; a change of size clears the memory of earlier frames.
    pub(super) fn resize<'a>(
        &self,
        sized: &'a mut SizedSensor,
        size: ImageSize,
    ) -> PyResult<&'a mut SizedSensor> {
        if sized.camera.intrinsics.size != size {
            *sized = self.source.sized(Some(size))?;
        }
        Ok(sized)
    }

    /// Measures with the sensor for an image size, which may remember what it measured. Called with the interpreter released.
    ///
    /// The sensor is locked while it measures, unless an engine in Python does: the engine may ask the sensor for its properties.
    pub(super) fn measure<T: Send>(
        &self,
        size: ImageSize,
        work: impl FnOnce(&mut Sensor, &camera::Camera) -> T + Send,
    ) -> PyResult<T> {
        let lock = || self.sized.lock().unwrap_or_else(PoisonError::into_inner);
        if self.engine.is_none() {
            // Locked before entering the pool, so that the pool's threads never wait for the lock.
            let mut sized = lock();
            let sized = self.resize(&mut sized, size)?;
            let sensor = Arc::make_mut(&mut sized.sensor);
            return threads::install(|| work(sensor, &sized.camera));
        }
        let mut copy = self.resize(&mut lock(), size)?.clone();
        let sensor = Arc::make_mut(&mut copy.sensor);
        let measured = threads::install(|| work(sensor, &copy.camera))?;
        let mut sized = lock();
        if sized.camera.intrinsics.size == size {
            sized.sensor = copy.sensor;
        }
        Ok(measured)
    }

    /// The camera of the outputs, for the most recent image size.
    pub(super) fn output_camera(&self, py: Python<'_>) -> PyResult<Camera> {
        let sized = self.now(py, None)?;
        let output = sized.sensor.output_camera(&sized.camera);
        let (near_m, far_m) = self.source.depth.spec.clipping_range_m;
        let mut camera = Camera::rectified(
            output.camera,
            self.body_from_images()? * output.input_from_output(),
        );
        camera.clip = match &self.camera {
            Some(camera) => camera.clip,
            None => Clip { near_m, far_m },
        };
        Ok(camera)
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
        let mut sized = self.sized.lock().unwrap_or_else(PoisonError::into_inner);
        match seed {
            Some(seed) => {
                self.source.seed.store(seed, Ordering::Relaxed);
                self.next_frame.store(0, Ordering::Relaxed);
                *sized = self.source.sized(Some(sized.camera.intrinsics.size))?;
            }
            None => Arc::make_mut(&mut sized.sensor).reset(),
        }
        Ok(())
    }

    /// Returns the sensor for images of a size, which is shared.
    pub(super) fn of_size(&self, py: Python<'_>, size: ImageSize) -> PyResult<Arc<Sensor>> {
        // Releasing the interpreter is only worth its time if the lock is taken, or for another size.
        if let Ok(sized) = self.sized.try_lock()
            && sized.camera.intrinsics.size == size
        {
            return Ok(Arc::clone(&sized.sensor));
        }
        Ok(self.now(py, Some(size))?.sensor)
    }

    /// Returns a copy of the sensor for an image size; by default, for the most recent one.
    pub(super) fn now(&self, py: Python<'_>, size: Option<ImageSize>) -> PyResult<SizedSensor> {
        py.detach(|| {
            let mut sized = self.sized.lock().unwrap_or_else(PoisonError::into_inner);
            let size = size.unwrap_or(sized.camera.intrinsics.size);
            Ok(self.resize(&mut sized, size)?.clone())
        })
    }
}

//! What a rig cannot make.

use oaktwin_base::diagnostic::{Finding, Level, message, opt};
use oaktwin_camera::ImageSize;
use oaktwin_catalog::Twin;
use oaktwin_files::memory;
use oaktwin_image::annotation::Annotator;
use oaktwin_render::Backend;

use super::{Rig, RigError, RigSpec};
use crate::limits::{frame_bytes, record_bytes};
use crate::render::scene_annotators;
use crate::sensor::Sensor;

impl Rig {
    /// Notes about cameras without a depth sensor whose outputs are requested; an error if none has one.
    pub(super) fn without_sensor(
        &self,
        twin: Option<&Twin>,
        spec: &RigSpec,
    ) -> Result<Vec<Finding>, RigError> {
        let is_asked = spec.senses() && (spec.sweep.is_some() || !spec.is_sensor_optional);
        let Some(first) = self.cameras.first().filter(|_| is_asked) else {
            return Ok(Vec::new());
        };
        if self.sensors.iter().all(Option::is_none) {
            let more = if self.cameras.len() > 1 {
                " and the other cameras have"
            } else {
                " has"
            };
            let remedy = match twin {
                Some(twin) if twin.depth_sensors.is_empty() => message![format!(
                    "choose a model with one: {}",
                    twin.device.models_with_depth(None)
                )],
                Some(_) => message!["choose ", opt("camera").with("depth")],
                None => message![
                    "choose a render product with OmniSensorDepthSensorSingleViewAPI, or place an OAK in the scene with ",
                    opt("model")
                ],
            };
            let sweep = opt("sweep");
            return Err(RigError::NoDepthSensor(message![
                format!("{}{more} no depth sensor, which depth_sensor_* and ", first.path),
                sweep,
                " require; ",
                remedy
            ]));
        }
        let both = self.cameras.iter().zip(&self.sensors);
        let without = both.filter(|(_, sensor)| sensor.is_none());
        let note = "has no depth sensor; its sensor outputs are skipped";
        Ok(without
            .map(|(camera, _)| Finding::new("no-depth-sensor", Level::Note, &camera.path, note, ""))
            .collect())
    }

    /// Rejects images that need more memory than is available, if that is known; also for a recording, if the frames are recorded.
    ///
    /// # Errors
    /// Returns an error that names the largest image.
    pub fn check_memory(&self, is_recorded: bool) -> Result<(), RigError> {
        let mut made = scene_annotators(&self.annotators, self.depth_sensor().is_some());
        made.extend(self.annotators.iter().filter(|one| one.is_depth_sensor()));
        let needs = |size: ImageSize| {
            let recorded = if is_recorded { record_bytes(size) } else { 0 };
            frame_bytes(size, &made) + recorded
        };
        let sizes = self
            .cameras
            .iter()
            .map(|camera| (camera.camera.intrinsics.size, camera));
        let Some((size, camera)) = sizes.max_by_key(|(size, _)| needs(*size)) else {
            return Ok(());
        };
        memory::check(needs(size)).map_err(|shortage| {
            RigError::Option(message![
                format!(
                    "{}: images of {size}: {}; choose a smaller ",
                    camera.path,
                    shortage.what()
                ),
                opt("resolution"),
                " or fewer outputs, or ",
                shortage.remedy()
            ])
        })
    }

    /// Notes about cameras that the rasterizer does not support.
    pub(in crate::render) fn cast_instead(&self) -> Vec<Finding> {
        let cameras = self.cameras.iter().filter(|camera| {
            let view = camera.view(&camera.world_from_mount);
            self.backend == Backend::Raster && self.backend.for_view(&view) != Backend::Raster
        });
        let note = "lens distortion is not supported by the rasterizer; using the ray caster";
        cameras
            .map(|camera| Finding::new("cast-instead", Level::Note, &camera.path, note, ""))
            .collect()
    }
}

/// A warning about sensor outputs that this sensor cannot produce.
pub(super) fn not_produced(place: &str, sensor: &Sensor, missing: &[Annotator]) -> Option<Finding> {
    let names: Vec<&str> = missing.iter().map(|annotator| annotator.name()).collect();
    (!names.is_empty()).then(|| {
        let engine = sensor.engine().kind();
        let filters = match sensor.filters().is_empty() {
            true => "",
            false => " with its filters",
        };
        Finding::new(
            "sensor-output-missing",
            Level::Warning,
            place,
            format!(
                "not supported by {engine}{filters}, skipped: {}",
                names.join(", ")
            ),
            message![
                "remove them from ",
                opt("annotators"),
                ", or choose another ",
                opt("engine")
            ],
        )
    })
}

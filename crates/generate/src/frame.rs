//! One frame: everything that is drawn for it, rendered and measured.

use std::collections::BTreeMap;
use std::path::PathBuf;

use oaktwin_base::diagnostic::{Finding, Level};
use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::DVec3;
use oaktwin_catalog::Twin;
use oaktwin_dataset::Shot;
use oaktwin_depth::imager::ColorParameters;
use oaktwin_image::annotation::Annotator;
use oaktwin_pipeline::pair::PairOptions;
use oaktwin_pipeline::render::{
    OakOptions, PairUse, PlacedCamera, Rig, RigSpec, depth_sensor_of, oak_cameras,
};
use oaktwin_pipeline::sensor::{EngineKind, Scalar, Sensor, SensorOptions};
use serde::Serialize;
use serde_json::{Value, json};

use crate::GenerateError;
use crate::aligned::Aligned;
use crate::arrange::{Arrangement, Stage};
use crate::context::Context;
use crate::described::objects;
use crate::motion::DrawnMotion;
use crate::recipe::{ParameterValue, RgbImagerRule};
use crate::saved::scene_files;
use crate::unit::DrawnUnit;
use crate::view::{DrawnView, Search};

/// Makes frames, one after the other, in any order. What two frames have in common is kept from one to the next.
#[derive(Debug)]
pub(crate) struct FrameMaker<'a> {
    context: &'a Context,
    shown: Option<Shown>,
}

/// An arrangement on its stage.
#[derive(Debug)]
pub(crate) struct Shown {
    arrangement: Arrangement,
    /// The twin of its unit.
    twin: Twin,
    stage: Stage,
    /// The biases of the inertial sensor at each of its frames, if there is one.
    biases: Vec<[DVec3; 2]>,
}

/// A finished frame.
#[derive(Debug)]
pub(crate) struct Made {
    /// One for each camera.
    pub(crate) shots: Vec<Shot>,
    pub(crate) unit: DrawnUnit,
    pub(crate) findings: Vec<Finding>,
}

/// Everything that is drawn at random for a frame.
#[derive(Debug, Serialize)]
struct Explained<'a> {
    frame: u64,
    arrangement: &'a Arrangement,
    camera: DrawnView,
    #[serde(skip_serializing_if = "Option::is_none")]
    motion: Option<DrawnMotion>,
    parameters: Vec<(String, Scalar)>,
}

/// The rig of a frame.
struct FrameRig {
    /// The cameras of the recipe, and then the camera that measures aligned depth if it is not among them.
    rig: Rig,
    /// The number of cameras of the recipe.
    written: usize,
    aligned: Option<Aligned>,
    /// Whether each camera is the one that the stereo pair measures for.
    has_pair: Vec<bool>,
    findings: Vec<Finding>,
}

impl<'a> FrameMaker<'a> {
    pub(crate) const fn new(context: &'a Context) -> Self {
        Self { context, shown: None }
    }

    /// Goes on with the arrangement that another one has left.
    pub(crate) const fn going_on(context: &'a Context, shown: Option<Shown>) -> Self {
        Self { context, shown }
    }

    /// Returns the arrangement of the last frame.
    pub(crate) fn into_shown(self) -> Option<Shown> {
        self.shown
    }

    /// Returns everything that is drawn for a frame.
    ///
    /// # Errors
    /// Returns an error if an object or the camera has no place.
    pub(crate) fn explain(&mut self, frame: u64) -> Result<Value, GenerateError> {
        let context = self.context;
        let shown = self.show(frame)?;
        let explained = Explained {
            frame,
            arrangement: &shown.arrangement,
            camera: context.view(shown, frame)?,
            motion: context.drawn_motion(frame),
            parameters: context.parameters(frame),
        };
        Ok(json!(explained))
    }

    /// Returns the files of the arrangement that a frame sees, relative to the data set, if the recipe asks for them and the frame is the
    /// first one of its arrangement.
    ///
    /// # Errors
    /// Returns an error if an object has no place, or an image cannot be read.
    pub(crate) fn scene_files(&mut self, frame: u64) -> Result<Vec<(PathBuf, Vec<u8>)>, GenerateError> {
        let recipe = &self.context.file.recipe;
        if !recipe.output.scenes || !frame.is_multiple_of(recipe.frames_per_scene) {
            return Ok(Vec::new());
        }
        let shown = self.show(frame)?;
        Ok(scene_files(&shown.stage, shown.arrangement.number)?)
    }

    /// Renders a frame.
    ///
    /// # Errors
    /// Returns an error if an object or the camera has no place, or the sensor cannot be created.
    pub(crate) fn make(&mut self, frame: u64) -> Result<Made, GenerateError> {
        self.make_with(frame, &self.context.annotators)
    }

    /// Renders a frame with other annotators than the recipe's.
    ///
    /// # Errors
    /// Returns the errors of [`make`](Self::make).
    pub(crate) fn make_with(&mut self, frame: u64, wanted: &[Annotator]) -> Result<Made, GenerateError> {
        let context = self.context;
        let shown = self.show(frame)?;
        let Shown {
            arrangement,
            twin,
            stage,
            biases,
        } = shown;
        let view = context.view(shown, frame)?;
        let mut annotators = wanted.to_vec();
        if context.needs.objects && !annotators.contains(&Annotator::InstanceIdSegmentation) {
            annotators.push(Annotator::InstanceIdSegmentation);
        }
        let made = context.rig(arrangement, twin, annotators, frame)?;
        let FrameRig {
            rig,
            written,
            aligned,
            has_pair,
            mut findings,
        } = made;
        let mut rig = rig.at(&view.world_from_body);
        let annotators = rig.annotators().to_vec();
        findings.extend(arrangement.findings.iter().cloned());
        let recipe = &context.file.recipe;
        let place = frame % recipe.frames_per_scene;
        let drawn = context.drawn_motion(frame);
        let mut moving = drawn.map(|drawn| {
            let pose = view.world_from_body;
            context.moving(&drawn, stage.renderer(), pose, place)
        });
        let mut take = |rig: &mut Rig, index: usize, annotators: &[Annotator]| match &mut moving {
            Some(moving) => rig.expose_camera(moving, index, frame, annotators),
            None => rig.shoot_camera(stage.renderer(), index, None, frame, annotators),
        };
        let biases = usize::try_from(place)
            .ok()
            .and_then(|place| biases.get(place).copied());
        let mut shots = Vec::new();
        for (index, has_pair) in has_pair.iter().enumerate().take(written) {
            let (mut shot, more) = take(&mut rig, index, &annotators)?;
            findings.extend(more);
            if !has_pair {
                shot.stereo = None;
            }
            if written == 1 {
                shot.render_product = None;
            }
            shot.sequence = arrangement.number;
            shot.time_ns = context.time_ns(place).saturating_add(rig.offset_ns(index));
            shot.imu_biases = biases;
            if context.needs.objects {
                let view = rig.cameras()[index].view(&shot.world_from_mount);
                let ids = match wanted.contains(&Annotator::InstanceIdSegmentation) {
                    true => shot.frame.instance_id_segmentation.clone(),
                    false => shot.frame.instance_id_segmentation.take(),
                };
                shot.objects = objects(context, arrangement, stage, &view, ids.as_ref());
            }
            shots.push(shot);
        }
        if let Some(aligned) = aligned.filter(|_| wanted.contains(&Annotator::DepthSensorDistance)) {
            findings.extend(context.put_aligned(twin, &aligned, &mut rig, &mut shots, &mut take)?);
        }
        Ok(Made {
            shots,
            unit: arrangement.unit.clone(),
            findings,
        })
    }

    /// Shows the arrangement that a frame sees.
    fn show(&mut self, frame: u64) -> Result<&Shown, GenerateError> {
        let number = self.context.file.recipe.scene_of(frame);
        let shown = match self.shown.take() {
            Some(shown) if shown.arrangement.number == number => shown,
            before => {
                let arrangement = Arrangement::draw(self.context, number)?;
                let stage = before.map(|before| before.stage);
                let stage = stage.filter(|stage| stage.suits(&arrangement));
                let mut stage = stage.unwrap_or_else(|| Stage::new(self.context, arrangement.base));
                stage.show(self.context, &arrangement);
                let unit = &arrangement.unit;
                Shown {
                    twin: self.context.units(&unit.model).twin(unit.number),
                    biases: self.context.biases(number, unit)?,
                    arrangement,
                    stage,
                }
            }
        };
        Ok(self.shown.insert(shown))
    }
}

impl Context {
    fn view(&self, shown: &Shown, frame: u64) -> Result<DrawnView, GenerateError> {
        let Shown {
            arrangement,
            twin,
            stage,
            ..
        } = shown;
        let (cameras, _) = self.cameras(twin, &RigidTransform::IDENTITY)?;
        let Some(camera) = cameras.first() else {
            return Err(self.unfit(
                "camera.cameras",
                "the model has none of these cameras",
                "name others",
            ));
        };
        let search = Search {
            context: self,
            arrangement,
            stage,
            camera: camera.camera,
            body_from_camera: camera.mount_from_camera,
        };
        search.find(frame)
    }

    /// Returns the cameras of the recipe, and then the one that measures aligned depth if it is not among them.
    pub(crate) fn all_cameras(&self, twin: &Twin) -> Result<Vec<PlacedCamera>, GenerateError> {
        let (mut cameras, _) = self.cameras(twin, &RigidTransform::IDENTITY)?;
        let (_, added) = self.find_aligned(twin, &cameras)?;
        if let Some(added) = added {
            let options = OakOptions {
                cameras: &[added],
                ..OakOptions::default()
            };
            cameras.extend(oak_cameras(twin, &RigidTransform::IDENTITY, &options)?.0);
        }
        Ok(cameras)
    }

    fn cameras(
        &self,
        twin: &Twin,
        world_from_body: &RigidTransform,
    ) -> Result<(Vec<PlacedCamera>, Vec<Finding>), GenerateError> {
        let names = self.camera_names();
        let options = OakOptions {
            cameras: &names,
            size: self.file.recipe.camera.size(),
            ..OakOptions::default()
        };
        Ok(oak_cameras(twin, world_from_body, &options)?)
    }

    /// Returns the drawn parameters of the engine.
    fn parameters(&self, frame: u64) -> Vec<(String, Scalar)> {
        self.drawn("sensor.parameters", &self.file.recipe.sensor.parameters, frame)
    }

    /// Returns the drawn image sensor of colours, if there is one.
    fn rgb_imager(&self, frame: u64) -> Result<Option<ColorParameters>, GenerateError> {
        let key = "camera.rgb_imager";
        let written = match &self.file.recipe.camera.rgb_imager {
            RgbImagerRule::Switch(false) => return Ok(None),
            RgbImagerRule::Switch(true) => &BTreeMap::new(),
            RgbImagerRule::Parameters(written) => written,
        };
        let mut parameters = ColorParameters::default();
        for (name, value) in self.drawn(key, written, frame) {
            parameters
                .set(&name, value)
                .map_err(|error| self.unfit(&format!("{key}.{}", error.name), error.what, error.remedy))?;
        }
        Ok(Some(parameters))
    }

    fn drawn(
        &self,
        key: &str,
        parameters: &BTreeMap<String, ParameterValue>,
        frame: u64,
    ) -> Vec<(String, Scalar)> {
        let value = |name: &String, value: &ParameterValue| match value {
            ParameterValue::Flag(flag) => Scalar::from(*flag),
            ParameterValue::Text(text) => text.into(),
            ParameterValue::Number(quantity) => {
                let mut numbers = self.random.numbers(&format!("{key}.{name}"), frame);
                quantity.draw(&mut numbers).into()
            }
        };
        parameters
            .iter()
            .map(|(name, written)| (name.clone(), value(name, written)))
            .collect()
    }

    /// Creates the rig of a frame, with its body at the origin.
    fn rig(
        &self,
        arrangement: &Arrangement,
        twin: &Twin,
        annotators: Vec<Annotator>,
        frame: u64,
    ) -> Result<FrameRig, GenerateError> {
        let recipe = &self.file.recipe;
        let (written, _) = self.cameras(twin, &RigidTransform::IDENTITY)?;
        let (aligned, added) = self.find_aligned(twin, &written)?;
        let mut names = self.camera_names();
        names.extend(added);
        let engine = match (&self.engine, &recipe.sensor.engine) {
            (Some(engine), _) => Some(engine.clone()),
            (None, Some(name)) => Some(EngineKind::parse(name)?.into()),
            (None, None) => None,
        };
        let sensor = SensorOptions {
            engine,
            preset: recipe.sensor.preset.clone(),
            filters: recipe.sensor.filters.0.clone(),
            parameters: self.parameters(frame),
            extended_disparity: recipe.sensor.extended_disparity,
            seed: recipe.seed,
            drift: Some(arrangement.unit.drift),
            ..SensorOptions::default()
        };
        let spec = RigSpec {
            cameras: names,
            size: recipe.camera.size(),
            annotators,
            is_sensor_optional: true,
            sensor,
            pair: PairOptions {
                projector: arrangement.projector,
                ambient: arrangement.infrared_ambient,
                ..PairOptions::default()
            },
            pair_use: match self.needs.stereo {
                true => PairUse::Described,
                false => PairUse::Matched,
            },
            rgb_imager: self.rgb_imager(frame)?,
            shutter: self.drawn_motion(frame).map(|motion| motion.shutter()),
            camera_offsets_ms: (recipe.camera.motion.as_ref())
                .map(|motion| motion.camera_offsets_ms.clone())
                .unwrap_or_default(),
            transparent: recipe.output.transparent,
            ..RigSpec::default()
        };
        let (rig, mut findings) = Rig::new(twin, &spec)?;
        let written = written.len();
        self.reject_memory(rig.sensors())?;
        let cameras = &rig.cameras()[..written];
        findings.extend(self.without_measurement(cameras, rig.sensors(), aligned.as_ref()));
        let has_pair: Vec<bool> = cameras.iter().map(|camera| is_stereo(twin, camera)).collect();
        if self.needs.stereo {
            if !has_pair.contains(&true) {
                return Err(self.unfit(
                    "output.formats",
                    "a stereo format describes a pair, and no camera of the recipe is a stereo depth sensor",
                    "add depth to camera.cameras, or remove the format",
                ));
            }
            let without = cameras.iter().zip(&has_pair).filter(|(_, has)| !**has);
            findings.extend(without.map(|(camera, _)| {
                let what = "is not part of a stereo pair; stereo formats leave it out";
                Finding::new("no-pair", Level::Note, &camera.path, what, "")
            }));
        }
        Ok(FrameRig {
            rig,
            written,
            aligned,
            has_pair,
            findings,
        })
    }

    /// Rejects filters that remember earlier frames.
    fn reject_memory(&self, sensors: &[Option<Sensor>]) -> Result<(), GenerateError> {
        if !sensors.iter().flatten().any(Sensor::remembers) {
            return Ok(());
        }
        Err(self.unfit(
            "sensor",
            "the temporal filter makes a frame depend on the frames before it",
            "choose another preset, or list the filters without it in sensor.filters",
        ))
    }
}

/// Whether a stereo depth sensor measures with a camera.
fn is_stereo(twin: &Twin, camera: &PlacedCamera) -> bool {
    depth_sensor_of(twin, camera).is_some_and(|sensor| sensor.spec.pair().is_some())
}

//! One frame: everything that is drawn for it, rendered and measured.

use std::collections::BTreeMap;
use std::sync::Arc;

use oaktwin_camera::math::DVec3;
use oaktwin_camera::{Camera, ImageSize, Intrinsics, OpenCv, PixelPoint, RigidTransform};
use oaktwin_catalog::{DepthKind, Twin};
use oaktwin_dataset::{Extent, Mask, Model, Object, Shot};
use oaktwin_depth::filter::Filter;
use oaktwin_diagnostic::Finding;
use oaktwin_image::annotation::{Annotator, Segmentation};
use oaktwin_pipeline::pair::{PairCameras, PairOptions};
use oaktwin_pipeline::render::{
    Backend, DepthSensorOptions, DepthSensorSource, FrameOptions, OakOptions, PlacedCamera, View,
    depth_sensors, oak_cameras, put_pair, render_shot,
};
use oaktwin_pipeline::sensor::{
    EngineInput, EngineKind, STEREO_NOISE, Sensor, SensorOptions, default_engine,
};
use serde::Serialize;
use serde_json::{Value, json};

use crate::GenerateError;
use crate::arrange::{Arrangement, Placed, Stage};
use crate::context::Context;
use crate::recipe::ParameterValue;
use crate::view::{DrawnView, Search};

/// Makes frames, one after the other, in any order. What two frames have in common is kept from one to the next.
#[derive(Debug)]
pub(crate) struct FrameMaker<'a> {
    context: &'a Context,
    /// The arrangement that is shown.
    arrangement: Option<Arrangement>,
    stage: Option<Stage>,
}

/// A finished frame.
#[derive(Debug)]
pub(crate) struct Made {
    /// One for each camera.
    pub(crate) shots: Vec<Shot>,
    pub(crate) findings: Vec<Finding>,
}

/// Everything that is drawn at random for a frame.
#[derive(Debug, Serialize)]
struct Explained<'a> {
    frame: u64,
    arrangement: &'a Arrangement,
    camera: DrawnView,
    parameters: Vec<(String, String)>,
}

/// The cameras and sensors of a frame.
struct Rig {
    cameras: Vec<PlacedCamera>,
    sensors: Vec<Option<Sensor>>,
    pair: Option<PairCameras>,
    findings: Vec<Finding>,
}

impl<'a> FrameMaker<'a> {
    pub(crate) const fn new(context: &'a Context) -> Self {
        Self {
            context,
            arrangement: None,
            stage: None,
        }
    }

    /// Returns everything that is drawn for a frame.
    ///
    /// # Errors
    /// Returns an error if an object or the camera has no place.
    pub(crate) fn explain(&mut self, frame: u64) -> Result<Value, GenerateError> {
        self.show(frame)?;
        let (arrangement, stage) = self.shown();
        let camera = self.view(arrangement, stage, frame)?;
        let explained = Explained {
            frame,
            arrangement,
            camera,
            parameters: self.parameters(frame),
        };
        Ok(json!(explained))
    }

    /// Renders a frame.
    ///
    /// # Errors
    /// Returns an error if an object or the camera has no place, or the sensor cannot be created.
    pub(crate) fn make(&mut self, frame: u64) -> Result<Made, GenerateError> {
        self.make_with(frame, &self.context.annotators)
    }

    /// Renders a frame with other annotators than those of the recipe.
    ///
    /// # Errors
    /// Returns the errors of [`make`](Self::make).
    pub(crate) fn make_with(&mut self, frame: u64, wanted: &[Annotator]) -> Result<Made, GenerateError> {
        self.show(frame)?;
        let (arrangement, stage) = self.shown();
        let context = self.context;
        let view = self.view(arrangement, stage, frame)?;
        let twin = context.twin(&arrangement.model);
        let mut rig = self.rig(twin, arrangement, &view.world_from_body, frame)?;
        let is_described =
            |need: fn(&oaktwin_dataset::Needs) -> bool| context.formats.iter().any(|kind| need(&kind.needs));
        let (with_objects, with_stereo) = (
            is_described(|needs| needs.objects),
            is_described(|needs| needs.stereo),
        );
        let mut annotators = wanted.to_vec();
        if with_objects && !annotators.contains(&Annotator::InstanceIdSegmentation) {
            annotators.push(Annotator::InstanceIdSegmentation);
        }
        let options = FrameOptions {
            annotators: &annotators,
            sensors: &rig.sensors,
            pair: rig.pair.as_ref(),
            sweep: None,
            backend: Backend::Auto,
            writes_pair: false,
            describes_pair: with_stereo,
            strict: false,
        };
        let recipe = &context.file.recipe;
        let mut shots = Vec::new();
        for index in 0..rig.cameras.len() {
            let number = usize::try_from(frame).unwrap_or(usize::MAX);
            let (mut shot, more) = render_shot(stage.renderer(), &rig.cameras, index, number, &options);
            rig.findings.extend(more);
            shot.sequence = arrangement.number;
            shot.time_ns = time_ns(frame % recipe.frames_per_scene, recipe.output.interval_s);
            if with_objects {
                let camera = &rig.cameras[index];
                let view = camera.view(&camera.world_from_mount);
                let ids = match wanted.contains(&Annotator::InstanceIdSegmentation) {
                    true => shot.frame.instance_id_segmentation.clone(),
                    false => shot.frame.instance_id_segmentation.take(),
                };
                shot.objects = objects(context, arrangement, stage, &view, ids.as_ref());
            }
            shots.push(shot);
        }
        Ok(Made {
            shots,
            findings: rig.findings,
        })
    }

    /// Shows the arrangement that a frame sees.
    fn show(&mut self, frame: u64) -> Result<(), GenerateError> {
        let number = self.context.file.recipe.scene_of(frame);
        if self
            .arrangement
            .as_ref()
            .is_some_and(|shown| shown.number == number)
        {
            return Ok(());
        }
        self.arrangement = None;
        let arrangement = Arrangement::draw(self.context, number)?;
        if !self.stage.as_ref().is_some_and(|stage| stage.suits(&arrangement)) {
            self.stage = Some(Stage::new(self.context, arrangement.base));
        }
        if let Some(stage) = &mut self.stage {
            stage.show(self.context, &arrangement);
        }
        self.arrangement = Some(arrangement);
        Ok(())
    }

    fn shown(&self) -> (&Arrangement, &Stage) {
        match (&self.arrangement, &self.stage) {
            (Some(arrangement), Some(stage)) => (arrangement, stage),
            _ => unreachable!("`show` comes first"),
        }
    }

    fn view(&self, arrangement: &Arrangement, stage: &Stage, frame: u64) -> Result<DrawnView, GenerateError> {
        let twin = self.context.twin(&arrangement.model);
        let (cameras, _) = self.cameras(twin, &RigidTransform::IDENTITY)?;
        let Some(camera) = cameras.first() else {
            return Err(self.context.unfit(
                "camera.cameras",
                "the model has none of these cameras",
                "name others",
            ));
        };
        let search = Search {
            context: self.context,
            arrangement,
            stage,
            camera: camera.camera,
            body_from_camera: camera.mount_from_camera,
        };
        search.find(frame)
    }

    fn cameras(
        &self,
        twin: &Twin,
        world_from_body: &RigidTransform,
    ) -> Result<(Vec<PlacedCamera>, Vec<Finding>), GenerateError> {
        let rule = &self.context.file.recipe.camera;
        let options = OakOptions {
            cameras: &rule.cameras.0,
            size: rule
                .resolution
                .map(|[width, height]| ImageSize::new(width, height)),
            ..OakOptions::default()
        };
        Ok(oak_cameras(twin, world_from_body, &options)?)
    }

    /// Returns the drawn parameters of the engine.
    fn parameters(&self, frame: u64) -> Vec<(String, String)> {
        let parameters = &self.context.file.recipe.sensor.parameters;
        let value = |name: &String, value: &ParameterValue| match value {
            ParameterValue::Flag(flag) => flag.to_string(),
            ParameterValue::Text(text) => text.clone(),
            ParameterValue::Number(quantity) => {
                let mut numbers = self
                    .context
                    .random
                    .numbers(&format!("sensor.parameters.{name}"), frame);
                quantity.draw(&mut numbers).to_string()
            }
        };
        parameters
            .iter()
            .map(|(name, written)| (name.clone(), value(name, written)))
            .collect()
    }

    fn rig(
        &self,
        twin: &Twin,
        arrangement: &Arrangement,
        world_from_body: &RigidTransform,
        frame: u64,
    ) -> Result<Rig, GenerateError> {
        let recipe = &self.context.file.recipe;
        let (mut cameras, mut findings) = self.cameras(twin, world_from_body)?;
        let engine = match &recipe.sensor.engine {
            Some(name) => Some(EngineKind::parse(name)?),
            None => None,
        };
        let options = SensorOptions {
            engine,
            preset: recipe.sensor.preset.clone(),
            filters: recipe.sensor.filters.0.clone(),
            parameters: self.parameters(frame),
            extended_disparity: recipe.sensor.extended_disparity,
            seed: recipe.seed,
            ..SensorOptions::default()
        };
        let kinds: Vec<_> = cameras
            .iter()
            .map(|camera| engine_of(twin, camera, engine))
            .collect();
        let with_stereo = self.context.formats.iter().any(|kind| kind.needs.stereo);
        let is_matching = kinds.iter().flatten().any(|kind| kind.input == EngineInput::Pair);
        let pair = (is_matching || with_stereo).then(|| {
            let pair = PairOptions {
                projector: arrangement.projector,
                ambient: arrangement.infrared_ambient,
                size: recipe
                    .camera
                    .resolution
                    .map(|[width, height]| ImageSize::new(width, height)),
                bias_px: options.calibration_error_px()?,
                seed: recipe.seed,
                ..PairOptions::default()
            };
            Ok::<_, GenerateError>(put_pair(twin, &mut cameras, &pair)?)
        });
        let pair = pair.transpose()?.map(|(pair, more)| {
            findings.extend(more);
            pair
        });
        let mut sensors = Vec::new();
        for (camera, kind) in cameras.iter().zip(kinds) {
            let mut options = SensorOptions {
                engine: kind,
                ..options.clone()
            };
            if arrangement.projector > 0.0 && kind == Some(&STEREO_NOISE) {
                // The dots give every surface texture. The recipe's own value comes later, and counts.
                options
                    .parameters
                    .insert(0, ("confidenceThreshold".to_owned(), "0".to_owned()));
            }
            let options = DepthSensorOptions {
                twin: Some(twin),
                sensor: &options,
            };
            let (made, more) = depth_sensors(std::slice::from_ref(camera), &options)?;
            findings.extend(more);
            sensors.extend(made);
        }
        self.reject_memory(&sensors)?;
        Ok(Rig {
            cameras,
            sensors,
            pair,
            findings,
        })
    }

    /// Rejects filters that remember earlier frames.
    fn reject_memory(&self, sensors: &[Option<Sensor>]) -> Result<(), GenerateError> {
        let filters = |sensor: &Sensor| {
            sensor
                .filters()
                .filters()
                .iter()
                .any(|one| matches!(one, Filter::Temporal(_)))
        };
        if !sensors.iter().flatten().any(filters) {
            return Ok(());
        }
        Err(self.context.unfit(
            "sensor",
            "the temporal filter makes a frame depend on the frames before it",
            "choose another preset, or list the filters without it in sensor.filters",
        ))
    }
}

/// The engine of a camera's depth sensor; `None` for a camera without one.
fn engine_of(
    twin: &Twin,
    camera: &PlacedCamera,
    chosen: Option<&'static EngineKind>,
) -> Option<&'static EngineKind> {
    let DepthSensorSource::Twin(prim) = camera.depth_sensor.as_ref()? else {
        return None;
    };
    let sensor = twin.depth_sensors.iter().find(|sensor| sensor.spec.prim == *prim);
    let kind = sensor.map_or(DepthKind::Stereo, |sensor| sensor.spec.kind);
    Some(chosen.unwrap_or_else(|| default_engine(kind)))
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    clippy::cast_precision_loss,
    reason = "nanoseconds of a data set"
)]
fn time_ns(index: u64, interval_s: f64) -> u64 {
    (index as f64 * interval_s * 1e9).round() as u64
}

/// Returns the objects of a frame with their masks.
fn objects(
    context: &Context,
    arrangement: &Arrangement,
    stage: &Stage,
    view: &View,
    ids: Option<&Segmentation>,
) -> Vec<Object> {
    let groups: Vec<Vec<u32>> = (stage.objects.iter())
        .map(|instances| {
            instances
                .clone()
                .filter_map(|index| u32::try_from(index).ok())
                .collect()
        })
        .collect();
    let size = view.camera.intrinsics.size;
    let silhouettes = stage.renderer().silhouettes(&extended(view), &groups);
    let visible = visible(&arrangement.objects, ids);
    let found = arrangement.objects.iter().zip(silhouettes).zip(visible);
    found
        .map(|((object, silhouette), visible)| {
            let inside = silhouette.iter().filter_map(|[x, y]| {
                let (x, y) = (x.checked_sub(size.width)?, y.checked_sub(size.height)?);
                (x < size.width && y < size.height).then_some([x, y])
            });
            // Both have the same rules, but not the same rounding.
            let inside: Vec<[u32; 2]> = inside.chain(visible.places()).collect();
            let whole = mask(&silhouette);
            let [left, top, width, height] = whole.bounding_box().unwrap_or_default().map(i64::from);
            Object {
                extent: Extent {
                    count: (silhouette.len() as u64).max(visible.count() as u64),
                    rectangle: [
                        left - i64::from(size.width),
                        top - i64::from(size.height),
                        width,
                        height,
                    ],
                },
                model: context.model(object),
                path: object.path.clone(),
                world_from_model: object.world_from_object,
                silhouette: mask(&inside),
                visible,
            }
        })
        .collect()
}

/// Returns a view of the surroundings, too: the image is extended by its own size on all sides.
fn extended(view: &View) -> View {
    let intrinsics = view.camera.intrinsics;
    let size = intrinsics.size;
    let moved = |value: f64, by: u32| value + f64::from(by);
    let center = intrinsics.principal_point::<OpenCv>();
    let center = PixelPoint::<OpenCv>::new(moved(center.x, size.width), moved(center.y, size.height));
    let larger = ImageSize::new(3 * size.width, 3 * size.height);
    let intrinsics = Intrinsics::new(larger, intrinsics.fx, intrinsics.fy, center);
    View {
        camera: Camera::new(intrinsics, view.camera.lens),
        ..*view
    }
}

/// Returns the visible pixels of each object.
fn visible(objects: &[Placed], ids: Option<&Segmentation>) -> Vec<Mask> {
    let mut places: Vec<Vec<[u32; 2]>> = vec![Vec::new(); objects.len()];
    let Some(Segmentation { ids, prim_paths }) = ids else {
        return vec![Mask::default(); objects.len()];
    };
    let of_path: BTreeMap<&str, usize> = objects
        .iter()
        .enumerate()
        .map(|(at, object)| (&*object.path, at))
        .collect();
    let object_of = |path: &str| {
        let parent = path.rsplit_once("/part_").map_or(path, |(parent, _)| parent);
        of_path.get(path).or_else(|| of_path.get(parent)).copied()
    };
    let of_id: BTreeMap<u32, usize> = (prim_paths.iter())
        .filter_map(|(id, path)| Some((*id, object_of(path)?)))
        .collect();
    let width = ids.width().max(1);
    let mut last = (0, None);
    for (index, id) in (0u32..).zip(ids.pixels()) {
        if last.0 != *id {
            last = (*id, of_id.get(id).copied());
        }
        if let Some(object) = last.1 {
            places[object].push([index % width, index / width]);
        }
    }
    places.iter().map(|places| mask(places)).collect()
}

/// Creates the mask of some pixels.
fn mask(places: &[[u32; 2]]) -> Mask {
    let corners = places
        .iter()
        .fold(None, |corners: Option<[[u32; 2]; 2]>, [x, y]| {
            let [low, high] = corners.unwrap_or([[*x, *y]; 2]);
            Some([
                [low[0].min(*x), low[1].min(*y)],
                [high[0].max(*x), high[1].max(*y)],
            ])
        });
    let Some([origin, last]) = corners else {
        return Mask::default();
    };
    let size = [last[0] - origin[0] + 1, last[1] - origin[1] + 1];
    let mut pixels = vec![false; size[0] as usize * size[1] as usize];
    for [x, y] in places {
        pixels[(y - origin[1]) as usize * size[0] as usize + (x - origin[0]) as usize] = true;
    }
    Mask { origin, size, pixels }
}

/// Creates the model of a placed object: all of its meshes, in metres with the file's axes.
#[expect(
    clippy::cast_possible_truncation,
    reason = "geometry is float32, and a scene's indices are u32"
)]
pub(crate) fn model_of(object: &Placed, name: &str) -> Model {
    let (mut positions, mut triangles) = (Vec::new(), Vec::new());
    let scene = &object.asset.scene;
    for instance in &scene.instances {
        let Some(mesh) = scene.meshes.get(instance.mesh as usize) else {
            continue;
        };
        let start = positions.len() as u32;
        positions.extend(mesh.positions.iter().map(|p| {
            let point = instance
                .world_from_mesh
                .transform_point3(DVec3::from(p.map(f64::from)));
            (point * object.scale).to_array().map(|x| x as f32)
        }));
        triangles.extend(
            mesh.triangles
                .iter()
                .map(|corners| corners.map(|index| start + index)),
        );
    }
    Model {
        id: object.entry as u32 + 1,
        name: name.to_owned(),
        label: object.label.clone(),
        positions,
        triangles,
    }
}

/// The models of a data set's objects, created on first use.
#[derive(Debug, Default)]
pub(crate) struct Models {
    known: std::sync::Mutex<BTreeMap<(usize, u64), Arc<Model>>>,
}

impl Models {
    pub(crate) fn get(&self, object: &Placed, name: &str) -> Arc<Model> {
        let mut known = self
            .known
            .lock()
            .unwrap_or_else(std::sync::PoisonError::into_inner);
        let model = known.entry((object.entry, object.scale.to_bits()));
        model.or_insert_with(|| Arc::new(model_of(object, name))).clone()
    }
}

//! Extracts plain values from the USD library's stage.

use std::rc::Rc;

use oaktwin_base::diagnostic::Finding;
use oaktwin_scene::Up;
use openusd::sdf::Specifier;
use openusd::usd;

use super::budget::Budget;
use super::error::one_line;
use super::inspect::Inspected;
use super::motion::Motion;
use super::packages::Packages;
use super::physics::PhysicsReader;
use super::plain::{api_schemas, plain_prim, plain_targets, plain_value};
use super::reader::{Outcome, Reader, Record};
use super::resolver::InspectingResolver;
use super::scene::{Builder, Children, Context, Findings, pose};
use super::walk::{VisitedPrim, Visitor, Walk, Which};
use super::{
    AttributeValue, Physics, Prim, RenderProduct, SceneCamera, SceneLimit, SceneOptions, Stage, StageError,
    StageMetadata, StageScene, StageTiming, composition,
};
use crate::nvidia::{CAMERA_NAMESPACE, PRODUCT_NAMESPACE};

/// The namespaces whose attributes make a prim of any type relevant to the linter's rules.
const SENSOR_NAMESPACES: [&str; 3] = [PRODUCT_NAMESPACE, CAMERA_NAMESPACE, "omni:lensdistortion:"];
/// OpenUSD's default unit, the centimetre.
const FALLBACK_METERS_PER_UNIT: f64 = 0.01;
/// OpenUSD's default rate of time codes, 1/s.
const FALLBACK_RATE: f64 = 24.0;

/// Opens and composes `path` and extracts cameras and sensors.
pub(super) fn stage(
    file: &str,
    path: &str,
    layer: Inspected,
    limit: SceneLimit,
) -> Result<Stage, StageError> {
    let layer = Rc::new(layer);
    let reader = open(file, path, &layer, limit, None)?;
    let metadata = metadata(&reader.stage);
    let mut extraction = Extraction::new(meters_per_unit(&metadata).0, None);
    extraction.run(&reader).map_err(|error| failed(file, &error))?;
    let overridden_cameras = if extraction.cameras.is_empty() {
        overridden_cameras(&reader).map_err(|error| failed(file, &error))?
    } else {
        Vec::new()
    };
    let mut findings = layer.findings.clone();
    findings.append(&mut composition::findings(&reader.stage));
    Ok(Stage {
        file: file.to_owned(),
        metadata,
        cameras: extraction.cameras,
        products: extraction.products,
        others: extraction.others,
        overridden_cameras,
        findings,
    })
}

/// Opens and composes `path` and builds a scene.
pub(super) fn scene(
    file: &str,
    path: &str,
    layer: Inspected,
    options: SceneOptions,
) -> Result<StageScene, StageError> {
    let opened = Opened::new(file, path, layer, options)?;
    let mut scene = opened.scene(None)?;
    if let Some(time) = options.time.filter(|_| opened.reader.budget().is_animated()) {
        let timing = StageTiming {
            is_animated: true,
            ..opened.timing()
        };
        scene.findings.extend(timing.check(&[time]));
    }
    Ok(scene)
}

/// Opens and composes `path`, and builds a scene with its bodies and joints.
pub(super) fn physics(
    file: &str,
    path: &str,
    layer: Inspected,
    options: SceneOptions,
) -> Result<(StageScene, Physics), StageError> {
    let opened = Opened::new(file, path, layer, options)?;
    let (unit, _) = meters_per_unit(&metadata(&opened.reader.stage));
    let mut physics = PhysicsReader::new(unit);
    let scene = opened.extracted(None, Some(&mut physics))?;
    Ok((scene, physics.finish()))
}

/// A composed stage, from which scenes are built.
pub(super) struct Opened {
    file: String,
    reader: Reader,
    options: SceneOptions,
    layer: Rc<Inspected>,
}

impl Opened {
    pub(super) fn new(
        file: &str,
        path: &str,
        layer: Inspected,
        options: SceneOptions,
    ) -> Result<Self, StageError> {
        let layer = Rc::new(layer);
        Ok(Self {
            file: file.to_owned(),
            reader: open(file, path, &layer, options.limit, options.time)?,
            options,
            layer,
        })
    }

    pub(super) fn reader(&self) -> &Reader {
        &self.reader
    }

    /// Returns the times of the stage, without what changes.
    pub(super) fn timing(&self) -> StageTiming {
        let stage = &self.reader.stage;
        let has_range = stage.has_authored_time_code_range();
        let rate = stage.time_codes_per_second();
        StageTiming {
            time_codes_per_second: if rate.is_finite() && rate > 0.0 {
                rate
            } else {
                FALLBACK_RATE
            },
            range: has_range.then(|| (stage.start_time_code(), stage.end_time_code())),
            ..StageTiming::default()
        }
    }

    /// Builds the scene at the reader's time, and notes what moves.
    pub(super) fn scene(&self, motion: Option<&mut Motion>) -> Result<StageScene, StageError> {
        self.extracted(motion, None)
    }

    fn extracted(
        &self,
        motion: Option<&mut Motion>,
        physics: Option<&mut PhysicsReader>,
    ) -> Result<StageScene, StageError> {
        let reader = &self.reader;
        let metadata = metadata(&reader.stage);
        let (meters_per_unit, invalid_unit) = meters_per_unit(&metadata);
        let up = match metadata.up_axis.as_deref() {
            Some("Z") => Up::Z,
            _ => Up::Y,
        };
        let builder = Builder::new(self.options, meters_per_unit, up);
        let mut extraction = Extraction::new(meters_per_unit, Some(builder));
        extraction.motion = motion;
        extraction.physics = physics;
        extraction
            .run(reader)
            .map_err(|error| failed(&self.file, &error))?;
        let mut findings = self.layer.findings.clone();
        findings.extend(invalid_unit);
        findings.append(&mut composition::findings(&reader.stage));
        findings.append(&mut reader.findings());
        findings.append(&mut extraction.findings.into_list());
        let scene = match extraction.builder {
            Some(builder) => {
                let (scene, found) = builder.finish();
                findings.append(&mut found.into_list());
                scene
            }
            None => oaktwin_scene::Scene::default(),
        };
        Ok(StageScene {
            scene,
            cameras: extraction.cameras,
            products: extraction.products,
            metadata,
            findings,
        })
    }
}

fn open(
    file: &str,
    path: &str,
    layer: &Rc<Inspected>,
    limit: SceneLimit,
    time: Option<f64>,
) -> Result<Reader, StageError> {
    let budget = Rc::new(Budget::new(limit));
    let packages = Rc::new(Packages::default());
    let resolver = InspectingResolver::new(path, layer, budget.clone(), packages.clone());
    let stage = usd::Stage::builder()
        .resolver(resolver)
        .open(path)
        .map_err(|error| failed(file, &error))?;
    Ok(Reader::new(stage, time, budget, packages))
}

fn failed(file: &str, error: &dyn std::fmt::Display) -> StageError {
    StageError::new(
        file,
        "",
        format!("cannot be read as USD: {}", one_line(&format!("{error:#}"))),
        "correct it, or export it again",
    )
}

/// Returns the stage unit in metres, and a finding if the authored value is invalid.
fn meters_per_unit(metadata: &StageMetadata) -> (f64, Option<Finding>) {
    match metadata.meters_per_unit {
        None => (FALLBACK_METERS_PER_UNIT, None),
        Some(unit) if unit.is_finite() && unit > 0.0 => (unit, None),
        Some(unit) => (
            FALLBACK_METERS_PER_UNIT,
            Some(Finding::new(
                "stage-unit",
                oaktwin_base::diagnostic::Level::Warning,
                "stage",
                format!("invalid metersPerUnit {unit}; using 0.01 (centimetres)"),
                "author the length of a stage unit in metres",
            )),
        ),
    }
}

/// Collects cameras, sensors and the scene during the traversal of a stage.
struct Extraction<'a> {
    meters_per_unit: f64,
    /// The scene's builder; `None` if only cameras and sensors are needed.
    builder: Option<Builder>,
    /// What moves; `None` if nobody asks.
    motion: Option<&'a mut Motion>,
    /// Bodies and joints; `None` if nobody asks.
    physics: Option<&'a mut PhysicsReader>,
    cameras: Vec<SceneCamera>,
    products: Vec<RenderProduct>,
    others: Vec<Prim>,
    findings: Findings,
}

impl Extraction<'_> {
    fn new(meters_per_unit: f64, builder: Option<Builder>) -> Self {
        Self {
            meters_per_unit,
            builder,
            motion: None,
            physics: None,
            cameras: Vec::new(),
            products: Vec::new(),
            others: Vec::new(),
            findings: Findings::default(),
        }
    }

    fn run(&mut self, reader: &Reader) -> Outcome<()> {
        Walk::new(reader).stage(self, &Context::default(), Which::Defined)
    }

    fn camera(&mut self, prim: Prim, context: &Context) {
        let pose = pose(&context.stage_from_prim, self.meters_per_unit);
        let mut warn = |what: &str| {
            let remedy = "use only translations and rotations on the camera and its ancestors";
            self.findings.warn("camera-transform", &prim.path, what, remedy);
        };
        let world_from_camera = match pose {
            Some((pose, None)) => pose,
            Some((pose, Some(removed))) => {
                warn(&format!("its transform contains {removed}, which is ignored"));
                pose
            }
            None => {
                warn("its transform is singular; the camera is placed at the origin");
                SceneCamera::default().world_from_camera
            }
        };
        self.cameras.push(SceneCamera {
            prim,
            world_from_camera,
        });
    }
}

impl Visitor for Extraction<'_> {
    type Context = Context;

    fn prim(
        &mut self,
        walk: &Walk<'_>,
        prim: &VisitedPrim,
        path: &str,
        context: &Context,
    ) -> Outcome<Option<Context>> {
        let reader = walk.reader;
        let opinions = prim.opinions(reader);
        let mut inner = context.with(opinions, path);
        if let Some(motion) = &mut self.motion {
            inner.node = motion.visit(reader, prim, path, context, &inner, opinions);
            if let (Some(node), "Camera") = (inner.node, prim.type_name.as_str()) {
                motion.camera(node, self.cameras.len());
            }
        }
        if let Some(physics) = &mut self.physics {
            physics.visit(reader, prim, path, &inner);
        }
        match prim.type_name.as_str() {
            "Camera" => self.camera(plain_prim(reader, prim, path), &inner),
            "RenderProduct" => self.products.push(RenderProduct {
                prim: plain_prim(reader, prim, path),
                cameras: plain_targets(reader, prim, path, "camera"),
            }),
            _ if self.builder.is_none() && concerns_sensors(reader, prim) => {
                self.others.push(plain_prim(reader, prim, path));
            }
            _ => {}
        }
        if let Some(builder) = &mut self.builder {
            if let Some(prototype) = &prim.prototype {
                builder.enter_prototype(prototype, path);
            }
            match builder.add(walk, prim, path, opinions, &inner)? {
                Children::Visit => {}
                Children::VisitWithoutDrawing => inner.drawn = false,
            }
        }
        Ok(Some(inner.hand_down(prim, opinions)))
    }
}

fn metadata(stage: &usd::Stage) -> StageMetadata {
    let field = |name: &str| stage.stage_metadata(name).ok().flatten().map(plain_value);
    let text = |value| match value {
        AttributeValue::Text(text) => Some(text),
        _ => None,
    };
    StageMetadata {
        up_axis: field("upAxis").and_then(text),
        meters_per_unit: field("metersPerUnit").and_then(|value| value.number()),
        default_prim: stage.default_prim().map(|name| name.as_str().to_owned()),
    }
}

fn concerns_sensors(reader: &Reader, prim: &Record) -> bool {
    let schema = |name: &String| name.starts_with("OmniSensor") || name.starts_with("OmniLensDistortion");
    let namespaced = prim.properties.iter().any(|name| {
        SENSOR_NAMESPACES
            .iter()
            .any(|prefix| name.as_str().starts_with(prefix))
    });
    namespaced
        || api_schemas(&reader.stage.prim(prim.path.clone()))
            .iter()
            .any(schema)
}

/// Returns the overrides of cameras without a definition, which the traversal of defined prims skips.
fn overridden_cameras(reader: &Reader) -> Outcome<Vec<String>> {
    let mut overrides = Overrides::default();
    Walk::new(reader).stage(&mut overrides, &true, Which::Active)?;
    Ok(overrides.cameras)
}

#[derive(Default)]
struct Overrides {
    cameras: Vec<String>,
}

impl Visitor for Overrides {
    /// Whether all ancestors are defined.
    type Context = bool;

    fn prim(
        &mut self,
        _: &Walk<'_>,
        prim: &VisitedPrim,
        path: &str,
        defined: &bool,
    ) -> Outcome<Option<bool>> {
        let defined = *defined && prim.specifier != Specifier::Over;
        if !defined && (prim.has("focalLength") || prim.has("horizontalAperture")) {
            self.cameras.push(path.to_owned());
        }
        Ok(Some(defined))
    }
}

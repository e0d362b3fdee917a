//! The rigs that measure: of models, or of the scene.

use oaktwin::catalog::DepthKind;
use oaktwin::coverage::{CoverageError, MeasuringRig};
use oaktwin::diagnostic::Finding;
use oaktwin::render::{RigError, RigSpec, SceneFile};
use oaktwin::sensor::{EngineInput, STEREO_MATCHING, depth_sensor};

use crate::args::CoverageArgs;
use crate::context::{Context, Result};
use crate::size;

/// The models to compare.
#[derive(Default)]
pub(super) struct Models {
    pub(super) rigs: Vec<MeasuringRig>,
    pub(super) findings: Vec<Finding>,
    pub(super) calibration_findings: Vec<Finding>,
}

/// Creates the rigs of the models. In a light, which is a factor on the scene's, stereo pairs are matched by default.
pub(super) fn of_models(context: &Context, args: &CoverageArgs, ambient: Option<f64>) -> Result<Models> {
    let engine = args.engine.options()?;
    let is_pair = engine
        .engine
        .as_deref()
        .is_some_and(|engine| engine.input == EngineInput::Pair);
    if !args.pair.imager.is_empty() && !is_pair {
        return Err("--imager requires --engine stereo-matching".into());
    }
    let mut pair = args.pair.options(args.unit.lens)?;
    pair.ambient = ambient.unwrap_or(pair.ambient);
    let spec = RigSpec {
        sensor: engine,
        size: size::parse("--resolution", args.resolution.as_deref())?,
        pair,
        ..RigSpec::default()
    };
    let mut models = Models::default();
    for name in &args.model {
        let (twin, findings) = context.twin(name, &args.unit)?;
        models.calibration_findings.extend(findings);
        let mut spec = spec.clone();
        let is_stereo = depth_sensor(&twin, args.sensor.as_deref())?.spec.kind == DepthKind::Stereo;
        if ambient.is_some() && is_stereo && spec.sensor.engine.is_none() {
            spec.sensor.engine = Some((&STEREO_MATCHING).into());
        }
        let (rig, findings) = MeasuringRig::new(&twin, args.sensor.as_deref(), args.pair.projector, &spec)?;
        if !models.rigs.iter().any(|known| known.name() == rig.name()) {
            models.rigs.push(rig);
            models.findings.extend(findings);
        }
    }
    Ok(models)
}

/// The rigs of the models or, if there are none, of the scene, whose findings are added.
pub(super) fn of(
    args: &CoverageArgs,
    models: Vec<MeasuringRig>,
    scene: &SceneFile,
    findings: &mut Vec<Finding>,
) -> Result<Vec<MeasuringRig>> {
    if !args.model.is_empty() {
        return Ok(models);
    }
    let (rigs, more) = rigs_of_scene(args, scene)?;
    findings.extend(more);
    Ok(rigs)
}

/// The depth sensors of the scene.
fn rigs_of_scene(args: &CoverageArgs, scene: &SceneFile) -> Result<(Vec<MeasuringRig>, Vec<Finding>)> {
    let spec = RigSpec {
        sensor: args.engine.options()?,
        ..RigSpec::default()
    };
    let made = MeasuringRig::of_stage(scene, &spec);
    let (rigs, findings) = made.map_err(|error| match error {
        CoverageError::Rig(RigError::Sensor(error)) => format!("{}: {error}", args.scene.display()).into(),
        error => Box::<dyn std::error::Error>::from(error),
    })?;
    if rigs.is_empty() {
        return Err(format!(
            "{}: the scene has no depth sensor; place an OAK with --model and --look-at",
            args.scene.display()
        )
        .into());
    }
    Ok((rigs, findings))
}

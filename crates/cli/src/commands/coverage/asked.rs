//! From arguments to candidates.

use oaktwin::camera::RigidTransform;
use oaktwin::camera::math::DVec3;
use oaktwin::catalog::DepthKind;
use oaktwin::coverage::{
    self, Base, Candidate, Coverage, CoverageError, MeasuringRig, Options, Placement, Region, Sweep,
};
use oaktwin::diagnostic::Finding;
use oaktwin::render::{OpenOptions, Renderer, RigError, RigSpec, SceneFile, trajectory};
use oaktwin::scene::{Bounds, Up};
use oaktwin::sensor::{EngineInput, STEREO_MATCHING, depth_sensor};
use oaktwin::usd::asset::LensChoice;

use crate::args::CoverageArgs;
use crate::context::{Context, Result};
use crate::{progress, size};

/// The models to compare.
#[derive(Default)]
pub(super) struct Models {
    pub(super) rigs: Vec<MeasuringRig>,
    pub(super) findings: Vec<Finding>,
    pub(super) calibration_findings: Vec<Finding>,
}

pub(super) fn region(args: &CoverageArgs) -> Result<Region> {
    let within = args.region_box.as_deref().map(|numbers| {
        let numbers: [f64; 6] = numbers.try_into().map_err(|_| "--region-box takes 6 numbers")?;
        let [x0, y0, z0, x1, y1, z1] = numbers;
        Ok::<_, Box<dyn std::error::Error>>(Bounds {
            min: DVec3::new(x0, y0, z0),
            max: DVec3::new(x1, y1, z1),
        })
    });
    Ok(Region {
        objects: args.region.clone(),
        within: within.transpose()?,
        ..Region::default()
    })
}

/// Rejects options without effect.
pub(super) fn check(args: &CoverageArgs) -> Result<()> {
    let needs = |option: &str| Err(format!("{option} requires --model").into());
    if args.model.is_empty() {
        return match &args.unit {
            unit if unit.calibration.is_some() => needs("--calibration"),
            unit if unit.lens == LensChoice::Fisheye => needs("--lens"),
            _ => Ok(()),
        };
    }
    if args.unit.calibration.is_some() && args.model.len() > 1 {
        return Err("--calibration: one unit has one model; give one --model".into());
    }
    if args.place.is_none() && args.poses.is_none() && args.mount.is_none() {
        return Err(
            "--model requires a pose: --look-at EYE TARGET, --pose, --poses FILE or --mount LINK".into(),
        );
    }
    Ok(())
}

/// Opens the scene.
pub(super) fn scene(args: &CoverageArgs) -> Result<SceneFile> {
    let options = OpenOptions {
        micro_texture: args.scene_options.micro_texture.unwrap_or(true),
        ..args.scene_options.open_options()?
    };
    Ok(SceneFile::open(&args.scene, &options)?)
}

/// Measures the candidates.
pub(super) fn measure(
    args: &CoverageArgs,
    renderer: &Renderer,
    region: &Region,
    candidates: &[Candidate<'_>],
) -> Result<Coverage> {
    let options = options(args);
    Ok(progress::watched(|watch| {
        coverage::measure(renderer, region, candidates, &options, watch)
    })?)
}

pub(super) fn options(args: &CoverageArgs) -> Options {
    Options {
        samples: args.samples,
        tolerance_mm: args.tolerance,
        ..Options::default()
    }
}

/// Creates the rigs of the models. In a light, which is a factor on the scene's, stereo pairs are matched by default.
pub(super) fn models(context: &Context, args: &CoverageArgs, ambient: Option<f64>) -> Result<Models> {
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

/// The depth sensors of the scene.
pub(super) fn own_rigs(args: &CoverageArgs, scene: &SceneFile) -> Result<(Vec<MeasuringRig>, Vec<Finding>)> {
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

/// The poses of the models.
pub(super) fn placements(args: &CoverageArgs, sweep: &Sweep, up: Up) -> Result<Vec<Placement>> {
    let base = if let Some(file) = &args.poses {
        let poses = trajectory::read(file)?;
        Base::Poses(poses.iter().map(|pose| pose.world_from_mount).collect())
    } else if let Some([eye, target, up]) = args.place.look_at(up)? {
        Base::LookAt { eye, target, up }
    } else {
        Base::Poses(vec![args.place.pose()?.unwrap_or(RigidTransform::IDENTITY)])
    };
    Ok(sweep.placements(&base, up.direction())?)
}

/// Every rig at every pose; a rig of the scene at its own.
pub(super) fn candidates<'a>(
    args: &CoverageArgs,
    rigs: &'a [MeasuringRig],
    placements: &[Placement],
) -> Vec<Candidate<'a>> {
    if args.model.is_empty() {
        let own = |rig: &'a MeasuringRig| Candidate::new(rig, "in the scene", rig.camera().world_from_mount);
        return rigs.iter().map(own).collect();
    }
    coverage::candidates(rigs, placements)
}

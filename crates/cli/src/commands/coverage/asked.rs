//! From arguments to candidates.

use oaktwin::camera::RigidTransform;
use oaktwin::camera::math::DVec3;
use oaktwin::coverage::{
    self, Base, Candidate, Coverage, CoverageOptions, MeasuringRig, Placement, PlacementSweep, Region,
};
use oaktwin::files::OutputFiles;
use oaktwin::render::{OpenOptions, Renderer, SceneFile, trajectory};
use oaktwin::scene::{Bounds, Up};
use oaktwin::usd::asset::LensChoice;

use crate::args::CoverageArgs;
use crate::context::Result;
use crate::progress;

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

pub(super) fn options(args: &CoverageArgs) -> CoverageOptions {
    CoverageOptions {
        samples: args.samples,
        tolerance_mm: args.tolerance,
        ..CoverageOptions::default()
    }
}

/// The poses of the models.
pub(super) fn placements(args: &CoverageArgs, sweep: &PlacementSweep, up: Up) -> Result<Vec<Placement>> {
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

/// The files of `--output`, none of which is an input.
pub(super) fn output_files(args: &CoverageArgs) -> Result<OutputFiles> {
    let folder = args.output.as_deref().map(OutputFiles::in_folder).transpose()?;
    let mut files = folder.unwrap_or_default();
    let inputs = [args.scene.as_path()].into_iter().chain(args.poses.as_deref());
    files.protect(inputs.chain(args.robot.files()));
    Ok(files)
}

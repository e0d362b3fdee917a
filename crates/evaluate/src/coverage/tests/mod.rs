mod candidates;
mod geometry;
mod patches;
mod pictures;
mod placements;
mod points;
mod regions;

use std::ops::ControlFlow;

use oaktwin_camera::math::{DAffine3, DVec3};
use oaktwin_camera::{ImageSize, RigidTransform};
use oaktwin_catalog::Catalog;
use oaktwin_pipeline::progress::Progress;
use oaktwin_pipeline::render::{Renderer, RigSpec, look_at};
use oaktwin_scene::{Instance, Mesh, Scene, shape};

use super::*;

/// A scene in the making.
#[derive(Default)]
struct Stage(Scene);

impl Stage {
    fn with(mut self, path: &str, mesh: Mesh, world_from_mesh: DAffine3) -> Self {
        self.0.instances.push(Instance {
            mesh: u32::try_from(self.0.meshes.len()).unwrap(),
            path: path.to_owned(),
            world_from_mesh,
            labels: Vec::new(),
            material_offset: 0,
        });
        self.0.meshes.push(mesh);
        self
    }

    /// Adds a plate of 0.5 m × 0.5 m across the x axis.
    fn plate(self, path: &str, centre: DVec3) -> Self {
        let plate = shape::plane(0.5, 0.5, shape::Axis::X);
        self.with(path, plate, DAffine3::from_translation(centre))
    }

    /// Adds a box.
    fn block(self, path: &str, centre: DVec3, size: DVec3) -> Self {
        let placed = DAffine3::from_translation(centre) * DAffine3::from_scale(size);
        self.with(path, shape::cube(1.0), placed)
    }
}

fn rig_of(model: &str, set: &[(&str, &str)]) -> MeasuringRig {
    let catalog = Catalog::builtin();
    let mut spec = RigSpec {
        size: Some(ImageSize::new(640, 400)),
        ..RigSpec::default()
    };
    // The plates have no texture.
    for (name, value) in [("confidenceThreshold", "0")].iter().chain(set) {
        spec.sensor.parameters.push(((*name).to_owned(), (*value).into()));
    }
    let twin = catalog.nominal(catalog.device(model).unwrap());
    MeasuringRig::new(&twin, None, None, &spec).unwrap().0
}

/// The pose of a rig whose depth camera is at `eye` and faces `target`.
fn facing(rig: &MeasuringRig, eye: DVec3, target: DVec3) -> RigidTransform {
    let mut body = look_at(eye, target, DVec3::Z).unwrap();
    let camera = rig.camera().view(&body).world_from_camera.translation;
    body.translation += eye - camera;
    body
}

fn objects(paths: &[&str]) -> Region {
    Region {
        objects: paths.iter().map(|path| (*path).to_owned()).collect(),
        ..Region::default()
    }
}

fn go_on(_: Progress) -> ControlFlow<()> {
    ControlFlow::Continue(())
}

/// What a camera at the origin that faces along x sees of a region.
fn ahead(stage: Stage, region: &Region, set: &[(&str, &str)]) -> CandidateCoverage {
    let rig = rig_of("OAK4-D", set);
    let candidate = Candidate::new(&rig, "ahead", facing(&rig, DVec3::ZERO, DVec3::X));
    let renderer = Renderer::new(stage.0);
    let coverage = measure(
        &renderer,
        region,
        &[candidate],
        &CoverageOptions::default(),
        &go_on,
    )
    .unwrap();
    coverage.candidates[0].clone()
}

/// The share whose pixels show the surface at their centre: half a pixel beside an edge, they may not.
fn resolved(shares: &Shares) -> f64 {
    let edges = shares.lost.get("not_resolved").copied().unwrap_or(0.0);
    assert!(edges < 0.02, "{shares:?}");
    shares.seen - edges
}

/// Asserts that a share is correct within four standard errors.
#[track_caller]
fn assert_share(share: f64, expected: f64) {
    let error = 4.0 * (expected * (1.0 - expected) / f64::from(SAMPLES)).sqrt();
    assert!((share - expected).abs() <= error, "{share} instead of {expected}");
}

use oaktwin_base::diagnostic::{Finding, Level};

use super::num;
use super::rule::Rule;
use super::scene::FALLBACK_METERS_PER_UNIT;
use crate::stage::Stage;

pub(super) const NO_CAMERA: Rule = Rule {
    code: "no-camera",
    level: Level::Error,
    what: "the stage defines no camera",
    remedy: "give the file that defines the cameras, or a stage that references it",
};
/// Its findings are created while the stage is read.
pub(super) const COMPOSITION: Rule = Rule {
    code: "composition",
    level: Level::Warning,
    what: "a reference, payload or sublayer cannot be resolved",
    remedy: "put the file at that path, or correct the path; its content is missing",
};
/// Its findings are created while the stage is read.
pub(super) const PACKAGE_LAYOUT: Rule = Rule {
    code: "package-layout",
    level: Level::Warning,
    what: "a USDZ package violates the format's alignment",
    remedy: "package it again with `oaktwin asset --format usdz` or OpenUSD's `usdzip`",
};
pub(super) const UP_AXIS: Rule = Rule {
    code: "up-axis",
    level: Level::Note,
    what: "the stage is not Z up; Isaac Sim's stages are",
    remedy: "",
};
pub(super) const STAGE_UNITS: Rule = Rule {
    code: "stage-units",
    level: Level::Note,
    what: "the stage unit is not the metre; Isaac Sim's stages are in metres",
    remedy: "",
};
pub(super) const DEFAULT_PRIM: Rule = Rule {
    code: "default-prim",
    level: Level::Note,
    what: "the stage has no default prim, so references that name no prim are empty",
    remedy: "",
};

pub(super) fn rules(stage: &Stage, findings: &mut Vec<Finding>) {
    if stage.cameras.is_empty() {
        findings.push(if let [first, ..] = &stage.overridden_cameras[..] {
            NO_CAMERA.with_remedy(
                "/",
                format!("the file only overrides cameras ({first}) that another file defines"),
                "put the missing file at the path of the reference or sublayer, and check again",
            )
        } else {
            NO_CAMERA.at("/", "the stage has no camera")
        });
        return;
    }
    let metadata = &stage.metadata;
    match metadata.up_axis.as_deref() {
        Some("Z") => {}
        Some(axis) => {
            findings.push(UP_AXIS.note("/", format!("upAxis is {axis}; Isaac Sim's stages are Z up")));
        }
        None => {
            findings.push(UP_AXIS.note(
                "/",
                "upAxis is not authored and defaults to Y; Isaac Sim's stages are Z up",
            ));
        }
    }
    match metadata.meters_per_unit {
        Some(1.0) => {}
        Some(unit) => findings.push(STAGE_UNITS.note(
            "/",
            format!("metersPerUnit is {}; Isaac Sim's stages are in metres", num(unit)),
        )),
        None => findings.push(STAGE_UNITS.note(
            "/",
            format!("metersPerUnit is not authored and defaults to {FALLBACK_METERS_PER_UNIT} (centimetres); Isaac Sim's stages are in metres"),
        )),
    }
    if metadata.default_prim.is_none() {
        findings.push(DEFAULT_PRIM.note("/", DEFAULT_PRIM.what));
    }
}

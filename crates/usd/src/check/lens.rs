use oaktwin_base::diagnostic::{Finding, Level};

use super::num;
use super::rule::Rule;
use super::scene::CheckedCamera;
use crate::lens::{self, MODEL};

pub(super) const LENS_MODEL: Rule = Rule {
    code: "lens-model",
    level: Level::Warning,
    what: "`omni:lensdistortion:model` does not match the applied lens schema, or several schemas are applied",
    remedy: "apply one lens schema and set `omni:lensdistortion:model` to its token",
};
pub(super) const LENS_VALUE: Rule = Rule {
    code: "lens-value",
    level: Level::Error,
    what: "a lens schema's focal length, principal point, image size or coefficient is invalid",
    remedy: "author finite values, a positive focal length and the image size that they apply to",
};
pub(super) const LENS_FOCAL_LENGTH: Rule = Rule {
    code: "lens-focal-length",
    level: Level::Warning,
    what: "the lens schema's fx and focalLength / horizontalAperture differ by more than 1 %",
    remedy: "derive both from the same intrinsics at the schema's imageSize",
};
pub(super) const LEGACY_DISTORTION: Rule = Rule {
    code: "legacy-distortion",
    level: Level::Note,
    what: "distortion attributes from before Isaac Sim 5.0 are authored: deprecated, and without effect on a pinhole",
    remedy: "",
};
pub(super) const PROJECTION_TYPE: Rule = Rule {
    code: "projection-type",
    level: Level::Warning,
    what: "`cameraProjectionType` requests a projection that Isaac Sim no longer supports",
    remedy: "set it to `pinhole`, and describe the lens with a lens-distortion schema",
};

/// The values of `cameraProjectionType` that Isaac Sim no longer supports.
const DROPPED_PROJECTIONS: [&str; 4] = [
    "fisheyeOrthographic",
    "fisheyeEquidistant",
    "fisheyeEquisolid",
    "fisheyeSpherical",
];

pub(super) fn rules(camera: &CheckedCamera<'_>, findings: &mut Vec<Finding>) {
    legacy(camera, findings);
    let prim = &camera.camera.prim;
    let path = camera.path();
    let Some(lens) = &camera.lens else { return };
    let applied: Vec<&str> = lens::applied(prim).map(|(schema, _)| schema).collect();
    if applied.len() > 1 {
        findings.push(LENS_MODEL.at(
            path,
            format!(
                "{} lens schemas are applied: {}",
                applied.len(),
                applied.join(", ")
            ),
        ));
    }
    let model = prim.text(MODEL);
    if model != Some(lens.model) {
        let value = model.map_or_else(|| "not authored".to_owned(), |model| format!("`{model}`"));
        findings.push(LENS_MODEL.with_remedy(
            path,
            format!("{MODEL} is {value}, but {} is applied", lens.schema),
            format!("set it to `{}`", lens.model),
        ));
    }
    if lens.parameters.is_none() {
        return;
    }
    let Some(intrinsics) = lens.intrinsics() else {
        findings.push(LENS_VALUE.at(
            path,
            format!("fx, fy, cx, cy or imageSize of {} is invalid", lens.schema),
        ));
        return;
    };
    if !lens.coefficients.iter().all(|k| k.is_finite()) {
        findings.push(LENS_VALUE.at(path, format!("a coefficient of {} is not finite", lens.schema)));
    }
    // A fisheye's fx is pixels per radian and need not be the pinhole's.
    if lens.model == "opencvPinhole" {
        let by_aperture = camera.camera.optics().isaac_intrinsics(intrinsics.size).fx;
        if (intrinsics.mean_focal_length() / by_aperture - 1.0).abs() > 0.01 {
            findings.push(LENS_FOCAL_LENGTH.at(
                path,
                format!(
                    "the lens schema has fx {} and fy {} px, but focalLength / horizontalAperture gives \
                     {by_aperture:.2} px at {}",
                    num(intrinsics.fx),
                    num(intrinsics.fy),
                    intrinsics.size
                ),
            ));
        }
    }
}

fn legacy(camera: &CheckedCamera<'_>, findings: &mut Vec<Finding>) {
    let prim = &camera.camera.prim;
    let path = camera.path();
    let projection = prim.text("cameraProjectionType");
    if let Some(projection) = projection.filter(|projection| DROPPED_PROJECTIONS.contains(projection)) {
        findings.push(PROJECTION_TYPE.at(path, format!("cameraProjectionType is `{projection}`")));
    }
    let is_legacy = |name: &&String| {
        name.starts_with("ftheta")
            || name.starts_with("physicalDistortion")
            || matches!(name.as_str(), "p0" | "p1" | "s0" | "s1" | "s2" | "s3")
    };
    let count = prim.attributes.keys().filter(is_legacy).count();
    if count > 0 {
        let effect = match projection {
            None | Some("pinhole") => "without effect on a pinhole",
            Some(_) => "replaced by lens-distortion schemas",
        };
        findings.push(LEGACY_DISTORTION.note(
            path,
            format!("{count} distortion attributes from before Isaac Sim 5.0: deprecated, {effect}"),
        ));
    }
}

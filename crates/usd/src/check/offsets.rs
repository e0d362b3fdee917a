use oaktwin_base::diagnostic::{Finding, Level};
use oaktwin_camera::{OpenCv, Usd};

use super::num;
use super::rule::Rule;
use super::scene::CheckedCamera;

pub(super) const APERTURE_OFFSET: Rule = Rule {
    code: "aperture-offset",
    level: Level::Warning,
    what: "aperture offsets are not zero, but are ignored by Isaac Sim's renderer (through 6.0)",
    remedy: "carry the principal point in a lens-distortion schema, `OmniLensDistortionOpenCvPinholeAPI` \
             (`oaktwin asset --calibration` does), or set the offsets to 0",
};
pub(super) const OFFSET_CONVENTION: Rule = Rule {
    code: "offset-convention",
    level: Level::Note,
    what: "aperture offsets and the lens schema define different principal points, as with the parameter sheet's \
           formula, whose horizontal sign is the opposite of OpenUSD's",
    remedy: "",
};

/// The tolerance for half a pixel between conventions, and rounding.
const AGREE_PX: f64 = 1.0;

pub(super) fn rules(camera: &CheckedCamera<'_>, findings: &mut Vec<Finding>) {
    let (h, v) = camera.camera.aperture_offsets();
    if h == 0.0 && v == 0.0 {
        return;
    }
    let path = camera.path();
    let lens_point = camera.lens.as_ref().and_then(crate::lens::Lens::intrinsics);
    let offsets = format!("aperture offsets ({}, {})", num(h), num(v));
    let Some(lens) = lens_point else {
        let k = camera.camera.optics().openusd_intrinsics(camera.resolution);
        let c = k.principal_point::<Usd>();
        let (dx, dy) = (
            c.x - f64::from(k.size.width) / 2.0,
            c.y - f64::from(k.size.height) / 2.0,
        );
        findings.push(APERTURE_OFFSET.at(
            path,
            format!(
                "{offsets} move the principal point by ({dx:.2}, {dy:.2}) px at {} in OpenUSD; Isaac Sim's renderer \
                 ignores them",
                k.size
            ),
        ));
        return;
    };
    findings.push(APERTURE_OFFSET.note(
        path,
        format!("{offsets} are ignored by Isaac Sim's renderer; the lens schema carries the principal point"),
    ));
    let by_offsets = camera
        .camera
        .optics()
        .openusd_intrinsics(lens.size)
        .principal_point::<OpenCv>();
    let by_lens = lens.principal_point::<OpenCv>();
    let difference = (by_offsets.xy() - by_lens.xy()).abs();
    if difference.max_element() > AGREE_PX {
        findings.push(OFFSET_CONVENTION.note(
            path,
            format!(
                "the principal point is ({:.2}, {:.2}) px by OpenUSD's aperture offsets and ({:.2}, {:.2}) px by the \
                 lens schema (OpenCV's convention)",
                by_offsets.x, by_offsets.y, by_lens.x, by_lens.y
            ),
        ));
    }
}

use oaktwin_base::diagnostic::{Finding, Level};

use super::rule::Rule;
use super::scene::CheckedCamera;
use super::{brief, num};

pub(super) const CAMERA_VALUE: Rule = Rule {
    code: "camera-value",
    level: Level::Error,
    what: "a focal length, aperture or other optical value is zero, negative, infinite or NaN",
    remedy: "author a positive number",
};
pub(super) const UNAUTHORED_OPTICS: Rule = Rule {
    code: "unauthored-optics",
    level: Level::Warning,
    what: "focal length or apertures are not authored, so OpenUSD's fallbacks (50, 20.955, 15.2908) apply",
    remedy: "author focalLength, horizontalAperture and verticalAperture together",
};
pub(super) const ANIMATED_OPTICS: Rule = Rule {
    code: "animated-optics",
    level: Level::Note,
    what: "optical attributes have time samples; the default value or the first sample was checked",
    remedy: "",
};
pub(super) const NOT_PERSPECTIVE: Rule = Rule {
    code: "not-perspective",
    level: Level::Note,
    what: "the camera is not perspective: it has no intrinsics, and most rules do not apply",
    remedy: "",
};
pub(super) const NON_SQUARE_PIXELS: Rule = Rule {
    code: "non-square-pixels",
    level: Level::Warning,
    what: "in OpenUSD, fx and fy differ at the camera's own image size; Isaac Sim's renderer uses square pixels",
    remedy: "set verticalAperture to horizontalAperture × height / width",
};
pub(super) const VERTICAL_APERTURE: Rule = Rule {
    code: "vertical-aperture",
    level: Level::Warning,
    what: "the vertical aperture does not match the aspect ratio of a render product",
    remedy: "set verticalAperture to horizontalAperture × height / width, or render at the camera's own aspect ratio",
};
pub(super) const DEPTH_OF_FIELD: Rule = Rule {
    code: "depth-of-field",
    level: Level::Warning,
    what: "depth of field is enabled (fStop above 0), and depends on attributes whose unit is ambiguous",
    remedy: "set fStop to 0; an OAK's fixed focus is sharp over its range",
};
pub(super) const CLIPPING_RANGE: Rule = Rule {
    code: "clipping-range",
    level: Level::Error,
    what: "the clipping range is empty, negative or not finite",
    remedy: "author (near, far) with 0 < near < far; the sheet has (0.01, 100) m",
};

/// The maximum deviation of fx / fy from 1 for square pixels, above the effect of rounding to four decimals.
const SQUARE: f64 = 1e-3;

const OPTICAL: [&str; 3] = ["focalLength", "horizontalAperture", "verticalAperture"];

/// Checks a camera's optics. Returns whether intrinsics can be computed.
pub(super) fn rules(camera: &CheckedCamera<'_>, findings: &mut Vec<Finding>) -> bool {
    let prim = &camera.camera.prim;
    let path = camera.path();
    clipping_range(camera, findings);
    let f_stop = camera.camera.f_stop();
    if f_stop > 0.0 {
        findings.push(DEPTH_OF_FIELD.at(
            path,
            format!("fStop is {}, which enables depth of field", num(f_stop)),
        ));
    } else if !(f_stop == 0.0) {
        findings.push(CAMERA_VALUE.with_remedy(path, format!("fStop is {}", num(f_stop)), "set it to 0"));
    }
    if !camera.camera.is_perspective() {
        let projection = prim.text("projection").unwrap_or_default();
        findings.push(NOT_PERSPECTIVE.note(
            path,
            format!("projection is `{projection}`, which has no intrinsics"),
        ));
        return false;
    }
    let animated: Vec<&str> = OPTICAL
        .into_iter()
        .filter(|name| {
            prim.attributes
                .get(*name)
                .is_some_and(|attribute| attribute.animated)
        })
        .collect();
    if !animated.is_empty() {
        findings.push(ANIMATED_OPTICS.note(
            path,
            format!(
                "{} changes over time; its first value was checked",
                animated.join(", ")
            ),
        ));
    }
    unauthored(camera, findings);
    if !values(camera, findings) {
        return false;
    }
    aspect(camera, findings);
    true
}

/// Reports invalid optical values. Returns whether all are valid.
fn values(camera: &CheckedCamera<'_>, findings: &mut Vec<Finding>) -> bool {
    let path = camera.path();
    let mut sound = true;
    for (name, value) in [
        ("focalLength", camera.camera.focal_length()),
        ("horizontalAperture", camera.camera.horizontal_aperture()),
        ("verticalAperture", camera.camera.vertical_aperture()),
    ] {
        if !(value.is_finite() && value > 0.0) {
            findings.push(CAMERA_VALUE.at(path, format!("{name} is {}", num(value))));
            sound = false;
        }
    }
    let (h, v) = camera.camera.aperture_offsets();
    if !(h.is_finite() && v.is_finite()) {
        findings.push(CAMERA_VALUE.with_remedy(
            path,
            format!("the aperture offsets are ({}, {})", num(h), num(v)),
            "set them to 0",
        ));
        sound = false;
    }
    sound
}

fn unauthored(camera: &CheckedCamera<'_>, findings: &mut Vec<Finding>) {
    let missing: Vec<&str> = OPTICAL
        .into_iter()
        .filter(|name| camera.camera.prim.value(name).is_none())
        .collect();
    match missing.len() {
        0 => {}
        3 => findings.push(UNAUTHORED_OPTICS.note(
            camera.path(),
            "focal length and apertures are not authored: OpenUSD's fallbacks (50, 20.955, 15.2908) apply",
        )),
        _ => findings.push(UNAUTHORED_OPTICS.at(
            camera.path(),
            format!(
                "{} is not authored although others are: OpenUSD's fallback (focalLength 50, apertures 20.955 and \
                 15.2908) applies",
                missing.join(" and ")
            ),
        )),
    }
}

/// Checks for square pixels at the camera's own size, and at products' sizes that have another aspect ratio.
fn aspect(camera: &CheckedCamera<'_>, findings: &mut Vec<Finding>) {
    let optics = camera.camera.optics();
    let oblong = |size| {
        let k = optics.openusd_intrinsics(size);
        ((k.fx / k.fy - 1.0).abs() > SQUARE).then_some(k)
    };
    let fitting = |size: oaktwin_camera::ImageSize| brief(optics.horizontal_aperture_mm / size.aspect());
    let own = camera.own_size();
    if let Some(own) = own
        && let Some(k) = oblong(own)
    {
        findings.push(NON_SQUARE_PIXELS.with_remedy(
            camera.path(),
            format!(
                "at the camera's own {own}, OpenUSD has fx {:.2} and fy {:.2} px; Isaac Sim's renderer uses fy = fx",
                k.fx, k.fy
            ),
            format!("set verticalAperture to {}", fitting(own)),
        ));
    }
    for (product, size) in &camera.products {
        if own.is_some_and(|own| (own.aspect() / size.aspect() - 1.0).abs() <= SQUARE) {
            continue;
        }
        if let Some(k) = oblong(*size) {
            let rendered = optics.isaac_intrinsics(*size).vfov().to_degrees();
            findings.push(VERTICAL_APERTURE.with_remedy(
                camera.path(),
                format!(
                    "verticalAperture {} does not match the {size} of {}: the vertical field of view is {:.2}° in \
                     OpenUSD, {rendered:.2}° in Isaac Sim's renderer",
                    num(optics.vertical_aperture_mm),
                    product.prim.path,
                    k.vfov().to_degrees(),
                ),
                format!(
                    "set verticalAperture to {}, or render at the camera's own aspect ratio",
                    fitting(*size)
                ),
            ));
        }
    }
}

fn clipping_range(camera: &CheckedCamera<'_>, findings: &mut Vec<Finding>) {
    let (near, far) = camera.camera.clipping_range();
    if !(near > 0.0 && near < far && far.is_finite()) {
        findings.push(CLIPPING_RANGE.at(
            camera.path(),
            format!("clippingRange is ({}, {})", num(near), num(far)),
        ));
    }
}

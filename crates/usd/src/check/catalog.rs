use oaktwin_base::diagnostic::{Finding, Level};
use oaktwin_base::parameter::nvidia::Attributes;
use oaktwin_base::parameter::{Kind, Table};
use oaktwin_catalog::{Twin, TwinDepthSensor};

use super::depth::Parameters;
use super::rule::Rule;
use super::scene::{CheckedCamera, CheckedDepthSensor, CheckedScene};
use super::units::slip;
use super::{brief, num, same};
use crate::asset::PrimNames;

pub(super) const CATALOG_VALUE: Rule = Rule {
    code: "catalog-value",
    level: Level::Warning,
    what: "a value differs from the catalog's value for this model",
    remedy: "set it to the catalog's value (`oaktwin show MODEL`), or check against the right model (`--model`)",
};
pub(super) const CATALOG_MISSING: Rule = Rule {
    code: "catalog-missing",
    level: Level::Warning,
    what: "the file lacks a camera or depth sensor of the model",
    remedy: "check against the right model, or write the asset again with `oaktwin asset`",
};

/// The tolerance of the sheet's four decimals, mm.
const PRINTED_MM: f64 = 5.5e-5;
/// The maximum relative deviation of a unit's focal length from its model's. Five factory calibrations: up to 2.1 %.
const CALIBRATED: f64 = 0.1;

pub(super) fn camera_rules(
    scene: &CheckedScene<'_>,
    camera: &CheckedCamera<'_>,
    findings: &mut Vec<Finding>,
) {
    let Some(known) = camera.known else { return };
    let expected = known.optics();
    let model = &known.twin.device.name;
    let path = camera.path();
    let differs = |name: &str, value: f64, expected: f64| {
        CATALOG_VALUE.with_remedy(
            path,
            format!("{name} is {}, but {model} has {}", num(value), brief(expected)),
            format!("set it to {}, or check against the right model", brief(expected)),
        )
    };
    let focal_length = camera.camera.focal_length();
    // Other rules report values that are invalid or off by a power of ten.
    let is_reported =
        |value: f64, expected: f64| !value.is_finite() || value <= 0.0 || slip(value, expected).is_some();
    if !is_reported(focal_length, expected.focal_length_mm)
        && (focal_length - expected.focal_length_mm).abs() > PRINTED_MM
    {
        let off = focal_length / expected.focal_length_mm - 1.0;
        findings.push(if camera.is_calibrated() && off.abs() <= CALIBRATED {
            CATALOG_VALUE.note(
                path,
                format!(
                    "focalLength is {}, {:+.2} % from {model}'s nominal {}, as in a calibrated unit",
                    num(focal_length),
                    off * 100.0,
                    brief(expected.focal_length_mm)
                ),
            )
        } else {
            differs("focalLength", focal_length, expected.focal_length_mm)
        });
    }
    for (name, value, expected) in [
        (
            "horizontalAperture",
            camera.camera.horizontal_aperture(),
            expected.horizontal_aperture_mm,
        ),
        (
            "verticalAperture",
            camera.camera.vertical_aperture(),
            expected.vertical_aperture_mm,
        ),
    ] {
        if !is_reported(value, expected) && (value - expected).abs() > PRINTED_MM {
            findings.push(differs(name, value, expected));
        }
    }
    let (focus_distance, clipping_range) = match known.sensor {
        Some(sensor) => (sensor.spec.focus_distance, sensor.spec.clipping_range_m),
        None => (
            known.camera.spec.focus_distance,
            known.camera.spec.clipping_range_m,
        ),
    };
    if let Some(value) = camera.camera.prim.number("focusDistance")
        && !same(value, focus_distance)
    {
        findings.push(differs("focusDistance", value, focus_distance));
    }
    let unit = scene.meters_per_unit();
    let (near, far) = camera.camera.clipping_range();
    if camera.camera.prim.pair("clippingRange").is_some()
        && !(same(near * unit, clipping_range.0) && same(far * unit, clipping_range.1))
    {
        findings.push(CATALOG_VALUE.at(
            path,
            format!(
                "clippingRange is ({}, {}) m, but {model} has ({}, {})",
                num(near * unit),
                num(far * unit),
                num(clipping_range.0),
                num(clipping_range.1)
            ),
        ));
    }
}

pub(super) fn depth_rules(sensor: &CheckedDepthSensor<'_>, findings: &mut Vec<Finding>) {
    let Some(known) = sensor.known else { return };
    let spec = &known.spec;
    let parameters = Parameters::of(sensor);
    let [standard, extended] = [false, true].map(|is_extended| spec.attributes(is_extended));
    let path = &sensor.prim.path;
    for row in Attributes::rows().filter(|row| row.about.kind == Kind::Number) {
        let name = row.about.name;
        let value = parameters.get(name);
        let [expected, extended] = [&standard, &extended].map(|attributes| (row.numbers)(attributes)[0]);
        // The focal length and a noiseMean of 0, a deliberate choice, have their own rules.
        let has_own_rule = name == "focalLengthPixel" || (name == "noiseMean" && value == 0.0);
        if has_own_rule || same(value, expected) || same(value, extended) {
            continue;
        }
        let authored = if parameters.authored(name).is_some() {
            ""
        } else {
            " (schema default)"
        };
        findings.push(CATALOG_VALUE.with_remedy(
            path,
            format!(
                "{name} is {}{authored}, but the catalog has {}",
                num(value),
                brief(expected)
            ),
            format!("set it to {}, or check against the right model", brief(expected)),
        ));
    }
    focal_length(path, known, parameters.get("focalLengthPixel"), findings);
}

/// Checks `focalLengthPixel`, which may deviate from the model's value by as much as calibrations do.
fn focal_length(path: &str, known: &TwinDepthSensor, value: f64, findings: &mut Vec<Finding>) {
    let expected = known.spec.focal_length_px;
    if same(value, expected) {
        return;
    }
    let off = value / expected - 1.0;
    let message = format!(
        "focalLengthPixel is {}, {:+.2} % from the nominal {}",
        num(value),
        off * 100.0,
        brief(expected)
    );
    findings.push(CATALOG_VALUE.at_or_note(off.abs() <= CALIBRATED, path, message));
}

/// Reports missing cameras and depth sensors of a model, as a note if the model was only recognised.
pub(super) fn scene_rules(scene: &CheckedScene<'_>, model: Option<&Twin>, findings: &mut Vec<Finding>) {
    let mut twins: Vec<&Twin> = model.into_iter().collect();
    for camera in &scene.cameras {
        if let Some(known) = camera.known
            && !twins.iter().any(|twin| twin.device.id == known.twin.device.id)
        {
            twins.push(known.twin);
        }
    }
    if scene.cameras.is_empty() {
        return;
    }
    for twin in twins {
        let cameras = twin.cameras.iter().map(|camera| camera.spec.prim.as_str());
        let sensors = twin.depth_sensors.iter().map(|sensor| sensor.spec.prim.as_str());
        let missing: Vec<&str> = cameras
            .chain(sensors)
            .filter(|name| {
                !scene.cameras.iter().any(|camera| {
                    let here = camera.camera.prim.name();
                    here == *name || here == PrimNames::Isaac.of(name)
                })
            })
            .collect();
        if missing.is_empty() {
            continue;
        }
        findings.push(CATALOG_MISSING.at_or_note(
            model.is_none(),
            "/",
            format!(
                "{} has {}, but the file does not",
                twin.device.name,
                missing.join(", ")
            ),
        ));
    }
}

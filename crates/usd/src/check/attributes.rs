use oaktwin_base::diagnostic::{Finding, Level, nearest};

use super::rule::Rule;
use super::scene::{CheckedCamera, CheckedDepthSensor, Generation};
use crate::depth_sensor::attribute_types;
use crate::nvidia::{OUTLIER_REMOVAL, PRODUCT_NAMESPACE};
use crate::stage::AttributeValue;

pub(super) const CAMERA_TYPE: Rule = Rule {
    code: "camera-type",
    level: Level::Warning,
    what: "a camera attribute's type differs from OpenUSD's schema: OpenUSD then uses the schema's fallback instead of \
           the value",
    remedy: "author it with the schema's type",
};
pub(super) const DEPTH_ATTRIBUTE_UNKNOWN: Rule = Rule {
    code: "depth-attribute-unknown",
    level: Level::Warning,
    what: "an attribute in a depth sensor's namespace is not in the schema and has no effect",
    remedy: "correct its name, or remove it",
};
pub(super) const OUTLIER_REMOVAL_RANGE: Rule = Rule {
    code: "outlier-removal-range",
    level: Level::Warning,
    what: "`outlierRemovalRange` is authored, which is not an attribute but Isaac Sim 5.x's label for \
           `outlierRemovalEnabled`",
    remedy: "author `int outlierRemovalEnabled = 3` for Isaac Sim 5.1, `bool outlierRemovalEnabled = 1` for 6.x",
};
pub(super) const DEPTH_ATTRIBUTE_TYPE: Rule = Rule {
    code: "depth-attribute-type",
    level: Level::Warning,
    what: "a depth attribute's type differs from the schema",
    remedy: "author it with the schema's type",
};
pub(super) const OUTLIER_REMOVAL_TYPE: Rule = Rule {
    code: "outlier-removal-type",
    level: Level::Note,
    what: "the type of `outlierRemovalEnabled` depends on the Isaac Sim version: int in 5.x, bool in 6.x",
    remedy: "",
};

/// The optical attributes of `UsdGeomCamera`.
const CAMERA_TYPES: [(&str, &str); 11] = [
    ("focalLength", "float"),
    ("horizontalAperture", "float"),
    ("verticalAperture", "float"),
    ("horizontalApertureOffset", "float"),
    ("verticalApertureOffset", "float"),
    ("clippingRange", "float2"),
    ("focusDistance", "float"),
    ("fStop", "float"),
    ("projection", "token"),
    ("stereoRole", "token"),
    ("exposure", "float"),
];

pub(super) fn camera_rules(camera: &CheckedCamera<'_>, findings: &mut Vec<Finding>) {
    for (name, expected) in CAMERA_TYPES {
        if let Some(attribute) = camera.camera.prim.attributes.get(name)
            && attribute.type_name != expected
        {
            findings.push(CAMERA_TYPE.with_remedy(
                camera.path(),
                format!(
                    "{name} has type {}, so OpenUSD uses the schema's fallback instead of its value",
                    attribute.type_name
                ),
                format!("author it as `{expected}`"),
            ));
        }
    }
}

pub(super) fn depth_rules(sensor: &CheckedDepthSensor<'_>, findings: &mut Vec<Finding>) {
    let path = &sensor.prim.path;
    let namespace = sensor.generation.namespace();
    for (name, attribute) in sensor.prim.in_namespace(namespace) {
        let full = format!("{namespace}{name}");
        if name == "outlierRemovalRange" {
            findings.push(OUTLIER_REMOVAL_RANGE.at(
                path,
                format!(
                    "{full} is not an attribute but Isaac Sim 5.x's label for {namespace}{OUTLIER_REMOVAL}"
                ),
            ));
            continue;
        }
        let Some((_, expected)) = attribute_types().into_iter().find(|(known, _)| *known == name) else {
            findings.push(unknown(sensor.generation, path, &full, name));
            continue;
        };
        if name == OUTLIER_REMOVAL {
            outlier_removal(path, &full, &attribute.type_name, findings);
        } else if attribute.type_name != *expected {
            findings.push(DEPTH_ATTRIBUTE_TYPE.with_remedy(
                path,
                format!("{full} has type {}", attribute.type_name),
                format!("author it as `{expected}`"),
            ));
        }
        if let Some(AttributeValue::Int(mode)) =
            attribute.value.as_ref().filter(|_| name == "rgbDepthOutputMode")
            && !(0..=7).contains(mode)
        {
            findings.push(super::depth::DEPTH_VALUE.with_remedy(
                path,
                format!("{full} is {mode}"),
                "set it to one of 0 (colour) to 7 (disparity)",
            ));
        }
    }
}

fn unknown(generation: Generation, path: &str, full: &str, name: &str) -> Finding {
    if generation == Generation::Camera {
        return DEPTH_ATTRIBUTE_UNKNOWN.note(
            path,
            format!(
                "{full} is not among the attributes that ovrtx documents; its complete list is not public"
            ),
        );
    }
    let near = nearest(name, attribute_types().into_iter().map(|(known, _)| known));
    let remedy = match near.first() {
        Some(near) => format!("rename it to {PRODUCT_NAMESPACE}{near}, or remove it"),
        None => "remove it".to_owned(),
    };
    DEPTH_ATTRIBUTE_UNKNOWN.with_remedy(
        path,
        format!("{full} is not an attribute of the depth sensor and has no effect"),
        remedy,
    )
}

fn outlier_removal(path: &str, full: &str, type_name: &str, findings: &mut Vec<Finding>) {
    findings.push(match type_name {
        "int" => OUTLIER_REMOVAL_TYPE.note(
            path,
            format!("{full} is an int: a range in pixels in Isaac Sim 5.x; 6.x reads it as enabled"),
        ),
        "bool" => OUTLIER_REMOVAL_TYPE.note(
            path,
            format!("{full} is a bool, for Isaac Sim 6.x; 5.x reads it as a range of 1 px"),
        ),
        other => DEPTH_ATTRIBUTE_TYPE.with_remedy(
            path,
            format!("{full} has type {other}"),
            "author it as `int` for Isaac Sim 5.x, as `bool` for 6.x",
        ),
    });
}

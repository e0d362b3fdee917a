use oaktwin_base::diagnostic::{Finding, Level};

use super::rule::Rule;
use super::scene::{CheckedScene, Generation};
use crate::lens;
use crate::nvidia::{CAMERA_NAMESPACE, CAMERA_SCHEMA, PRODUCT_NAMESPACE, PRODUCT_SCHEMA, SENSOR_SCHEMA};
use crate::stage::Prim;

pub(super) const SCHEMA_MISSING: Rule = Rule {
    code: "schema-missing",
    level: Level::Error,
    what: "a schema's attributes are authored but have no effect, since apiSchemas does not list the schema",
    remedy: "add the schema to the prim's apiSchemas",
};
pub(super) const SCHEMA_WRONG_PRIM: Rule = Rule {
    code: "schema-wrong-prim",
    level: Level::Error,
    what: "a sensor or lens schema is applied to a prim of an unsupported type",
    remedy: "move the schema and its attributes to a prim of the right type",
};
pub(super) const SCHEMA_CONFLICT: Rule = Rule {
    code: "schema-conflict",
    level: Level::Error,
    what: "two sensor schemas apply to one camera, so the model produces no output",
    remedy: "keep one of them",
};
pub(super) const OVRTX_SCHEMA: Rule = Rule {
    code: "ovrtx-schema",
    level: Level::Note,
    what: "the depth sensor uses ovrtx's schema, which Isaac Sim does not read; its attribute list is not public",
    remedy: "",
};

struct Family {
    schema: fn(&str) -> bool,
    /// The name used in messages if none is applied.
    name: &'static str,
    namespace: &'static str,
    prim_type: &'static str,
}

const FAMILIES: [Family; 3] = [
    Family {
        schema: |name| name == PRODUCT_SCHEMA,
        name: PRODUCT_SCHEMA,
        namespace: PRODUCT_NAMESPACE,
        prim_type: "RenderProduct",
    },
    Family {
        schema: |name| name == CAMERA_SCHEMA,
        name: CAMERA_SCHEMA,
        namespace: CAMERA_NAMESPACE,
        prim_type: "Camera",
    },
    Family {
        schema: |name| name.starts_with("OmniLensDistortion"),
        name: "OmniLensDistortionOpenCvPinholeAPI (or another lens schema)",
        namespace: lens::NAMESPACE,
        prim_type: "Camera",
    },
];

pub(super) fn rules(scene: &CheckedScene<'_>, findings: &mut Vec<Finding>) {
    let stage = scene.stage;
    let cameras = stage.cameras.iter().map(|camera| &camera.prim);
    let products = stage.products.iter().map(|product| &product.prim);
    for prim in cameras.chain(products).chain(&stage.others) {
        for family in &FAMILIES {
            family_rules(prim, family, findings);
        }
    }
    conflicts(scene, findings);
    for sensor in &scene.depth_sensors {
        if sensor.generation == Generation::Camera {
            findings.push(OVRTX_SCHEMA.note(&sensor.prim.path, OVRTX_SCHEMA.what));
        }
    }
}

fn family_rules(prim: &Prim, family: &Family, findings: &mut Vec<Finding>) {
    let applied = prim.api_schemas.iter().find(|name| (family.schema)(name));
    let attribute = prim.in_namespace(family.namespace).next();
    let is_type = prim.type_name == family.prim_type;
    let type_name = if prim.type_name.is_empty() {
        "untyped"
    } else {
        &prim.type_name
    };
    match (applied, attribute) {
        (Some(schema), _) if !is_type => findings.push(SCHEMA_WRONG_PRIM.with_remedy(
            &prim.path,
            format!("{schema} has no effect on a prim of type {type_name}"),
            format!("move it and its attributes to the {}", family.prim_type),
        )),
        (None, Some((name, _))) if !is_type => findings.push(SCHEMA_WRONG_PRIM.with_remedy(
            &prim.path,
            format!(
                "{}{name} has no effect on a prim of type {type_name}",
                family.namespace
            ),
            format!(
                "move it to the {}, with {} in its apiSchemas",
                family.prim_type, family.name
            ),
        )),
        (None, Some((name, _))) => findings.push(SCHEMA_MISSING.with_remedy(
            &prim.path,
            format!(
                "{}{name} is authored, but its schema is not in apiSchemas",
                family.namespace
            ),
            format!("add {} to apiSchemas", family.name),
        )),
        _ => {}
    }
}

fn conflicts(scene: &CheckedScene<'_>, findings: &mut Vec<Finding>) {
    for camera in &scene.cameras {
        let prim = &camera.camera.prim;
        if !prim.has_api(CAMERA_SCHEMA) {
            continue;
        }
        let other = prim
            .api_schemas
            .iter()
            .find(|name| name.starts_with("OmniSensor") && *name != CAMERA_SCHEMA && *name != SENSOR_SCHEMA);
        if let Some(other) = other {
            findings.push(SCHEMA_CONFLICT.at(
                &prim.path,
                format!("{CAMERA_SCHEMA} and {other} apply to one camera, so the model produces no output"),
            ));
        }
        for product in &scene.stage.products {
            let targets = product.cameras.iter().any(|target| target.path == prim.path);
            if targets && product.prim.has_api(PRODUCT_SCHEMA) {
                findings.push(SCHEMA_CONFLICT.at(
                    &prim.path,
                    format!(
                        "{CAMERA_SCHEMA} applies to the camera and {PRODUCT_SCHEMA} to its product {}",
                        product.prim.path
                    ),
                ));
            }
        }
    }
}

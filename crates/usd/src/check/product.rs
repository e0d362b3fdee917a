use oaktwin_base::diagnostic::{Finding, Level};

use super::rule::Rule;
use crate::nvidia::{PRODUCT_NAMESPACE, PRODUCT_SCHEMA};
use crate::stage::RenderProduct;

pub(super) const PRODUCT_CAMERA: Rule = Rule {
    code: "product-camera",
    level: Level::Error,
    what: "a render product has no camera, several cameras or a missing one: Isaac Sim's template lookup skips it",
    remedy: "give its `camera` relationship exactly one target, a Camera",
};
pub(super) const PRODUCT_RESOLUTION: Rule = Rule {
    code: "product-resolution",
    level: Level::Warning,
    what: "a depth product's resolution is missing, of the wrong type or not positive",
    remedy: "author `uniform int2 resolution = (width, height)`, the size of the sensor's image",
};

pub(super) fn rules(product: &RenderProduct, findings: &mut Vec<Finding>) {
    let prim = &product.prim;
    let path = &prim.path;
    let is_depth = prim.has_api(PRODUCT_SCHEMA) || prim.in_namespace(PRODUCT_NAMESPACE).next().is_some();
    match &product.cameras[..] {
        [] => findings.push(PRODUCT_CAMERA.at(path, "the render product has no camera")),
        [target] => match target.type_name.as_deref() {
            Some("Camera") => {}
            Some(type_name) => findings.push(PRODUCT_CAMERA.at(
                path,
                format!(
                    "its camera {} has type {}, not Camera",
                    target.path,
                    if type_name.is_empty() { "none" } else { type_name }
                ),
            )),
            None => {
                findings.push(PRODUCT_CAMERA.at(path, format!("its camera {} does not exist", target.path)));
            }
        },
        several => {
            let paths: Vec<&str> = several.iter().map(|target| target.path.as_str()).collect();
            findings.push(PRODUCT_CAMERA.at(
                path,
                format!(
                    "the render product has {} cameras: {}",
                    several.len(),
                    paths.join(", ")
                ),
            ));
        }
    }
    if product.resolution().is_some() {
        return;
    }
    match prim.attributes.get("resolution") {
        Some(attribute) => findings.push(PRODUCT_RESOLUTION.at(
            path,
            format!(
                "resolution is not a pair of positive integers (type {})",
                attribute.type_name
            ),
        )),
        None if is_depth => findings.push(PRODUCT_RESOLUTION.at(
            path,
            "resolution is not authored; Isaac Sim 5.1 takes the sensor's resolution from it",
        )),
        None => {}
    }
}

//! From the USD library's stage to our plain values.

use std::collections::BTreeMap;

use oaktwin_diagnostic::{Finding, Level};
use openusd::usd::{self, PrimPredicate};
use openusd::{pcp, sdf};

use super::error::one_line;
use super::inspect::Inspected;
use super::locate::failing_line;
use super::resolver::InspectingResolver;
use super::{Attribute, Prim, RenderProduct, SceneCamera, Stage, StageError, StageMetadata, Target, Value};
use crate::nvidia::{CAMERA_NAMESPACE, PRODUCT_NAMESPACE};

/// What marks a prim of another type as one that a rule may want to see.
const SENSOR_NAMESPACES: [&str; 3] = [PRODUCT_NAMESPACE, CAMERA_NAMESPACE, "omni:lensdistortion:"];

/// Opens and composes `path` and takes out what concerns cameras.
pub(super) fn extract(file: &str, path: &str, layer: Inspected) -> Result<Stage, StageError> {
    let failed = |error: &dyn std::fmt::Display| {
        let reason = format!("{error:#}");
        let line = std::str::from_utf8(&layer.bytes).ok().and_then(failing_line);
        StageError::new(
            file,
            line.map(|line| format!("line {line}")).unwrap_or_default(),
            format!(
                "cannot be read as USD: {}",
                one_line(reason.trim_start_matches("failed to parse USDA layer: "))
            ),
            "repair it there, or export it again",
        )
    };
    let stage = usd::Stage::builder()
        .resolver(InspectingResolver::new())
        .open(path)
        .map_err(|error| failed(&error))?;
    let mut paths = Vec::new();
    stage
        .traverse(PrimPredicate::DEFAULT_PROXIES, |path| paths.push(path.clone()))
        .map_err(|error| failed(&error))?;
    let mut out = Stage {
        file: file.to_owned(),
        metadata: metadata(&stage),
        cameras: Vec::new(),
        products: Vec::new(),
        others: Vec::new(),
        overridden_cameras: Vec::new(),
        findings: layer.findings,
    };
    for path in paths {
        let prim = stage.prim(path);
        let type_name = type_name(&prim).unwrap_or_default();
        match type_name.as_str() {
            "Camera" => out.cameras.push(SceneCamera {
                prim: plain_prim(&prim, type_name),
            }),
            "RenderProduct" => {
                let targets = prim.relationship("camera").targets().unwrap_or_default();
                out.products.push(RenderProduct {
                    prim: plain_prim(&prim, type_name),
                    cameras: targets
                        .iter()
                        .map(|target| plain_target(&stage, target))
                        .collect(),
                });
            }
            _ if concerns_sensors(&prim) => out.others.push(plain_prim(&prim, type_name)),
            _ => {}
        }
    }
    if out.cameras.is_empty() {
        out.overridden_cameras = overridden_cameras(&stage);
    }
    let mut composition: Vec<Finding> = stage
        .composition_errors()
        .iter()
        .map(composition_finding)
        .collect();
    composition.sort_by(|a, b| (&a.place, &a.message).cmp(&(&b.place, &b.message)));
    composition.dedup();
    out.findings.append(&mut composition);
    Ok(out)
}

fn metadata(stage: &usd::Stage) -> StageMetadata {
    let field = |name: &str| stage.stage_metadata(name).ok().flatten().map(plain_value);
    let text = |value| match value {
        Value::Text(text) => Some(text),
        _ => None,
    };
    StageMetadata {
        up_axis: field("upAxis").and_then(text),
        meters_per_unit: field("metersPerUnit").and_then(|value| value.number()),
        default_prim: stage.default_prim().map(|name| name.as_str().to_owned()),
    }
}

fn type_name(prim: &usd::Prim) -> Option<String> {
    Some(prim.type_name().ok()??.as_str().to_owned())
}

fn api_schemas(prim: &usd::Prim) -> Vec<String> {
    let tokens = prim.api_schemas().unwrap_or_default();
    tokens.iter().map(|token| token.as_str().to_owned()).collect()
}

fn concerns_sensors(prim: &usd::Prim) -> bool {
    let schema = |name: &String| name.starts_with("OmniSensor") || name.starts_with("OmniLensDistortion");
    let names = prim.property_names().unwrap_or_default();
    let namespaced = names.iter().any(|name| {
        SENSOR_NAMESPACES
            .iter()
            .any(|prefix| name.as_str().starts_with(prefix))
    });
    namespaced || api_schemas(prim).iter().any(schema)
}

fn plain_prim(prim: &usd::Prim, type_name: String) -> Prim {
    let attributes: BTreeMap<String, Attribute> = prim
        .attributes()
        .unwrap_or_default()
        .iter()
        .filter_map(|attribute| {
            let path = attribute.path().to_string();
            let (_, name) = path.rsplit_once('.')?;
            Some((name.to_owned(), plain_attribute(attribute)))
        })
        .collect();
    Prim {
        path: prim.path().to_string(),
        type_name,
        api_schemas: api_schemas(prim),
        attributes,
    }
}

fn plain_attribute(attribute: &usd::Attribute) -> Attribute {
    let type_name = attribute
        .type_name()
        .ok()
        .flatten()
        .map(|name| name.as_str().to_owned())
        .unwrap_or_default();
    let default = attribute.get::<sdf::Value>().ok().flatten();
    let times = attribute.time_sample_times().unwrap_or_default();
    let value = default.or_else(|| {
        let first = usd::TimeCode::new(*times.first()?);
        attribute.get_at::<sdf::Value>(first).ok().flatten()
    });
    Attribute {
        type_name,
        value: value
            .filter(|value| !matches!(value, sdf::Value::None | sdf::Value::ValueBlock))
            .map(plain_value),
        animated: !times.is_empty(),
    }
}

fn plain_target(stage: &usd::Stage, target: &sdf::Path) -> Target {
    let prim = stage.prim(target.clone());
    let exists = prim.is_valid().unwrap_or(false);
    Target {
        path: target.to_string(),
        type_name: exists.then(|| type_name(&prim).unwrap_or_default()),
    }
}

/// Overrides without a definition, which OpenUSD's traversal leaves out.
fn overridden_cameras(stage: &usd::Stage) -> Vec<String> {
    let mut all = Vec::new();
    if stage
        .traverse(PrimPredicate::ALL, |path| all.push(path.clone()))
        .is_err()
    {
        return Vec::new();
    }
    all.into_iter()
        .filter(|path| {
            let prim = stage.prim(path.clone());
            let optical = |name: &str| matches!(name, "focalLength" | "horizontalAperture");
            let names = prim.property_names().unwrap_or_default();
            !prim.is_defined().unwrap_or(true) && names.iter().any(|name| optical(name.as_str()))
        })
        .map(|path| path.to_string())
        .collect()
}

fn composition_finding(error: &pcp::Error) -> Finding {
    use pcp::Error as E;
    let said = |arc: &pcp::ArcType| format!("{arc:?}").to_lowercase();
    let mut level = Level::Warning;
    let mut remedy = "put the file where the path says, or correct the path; what it holds was not checked";
    let (place, message) = match error {
        E::UnresolvedLayer {
            asset_path,
            arc,
            site_path,
            ..
        } => {
            let message = if let Some(url) = url(asset_path) {
                remedy = "download it beside the file and reference it there; what it holds was not checked";
                format!("the {} @{url}@ is not on this machine", said(arc))
            } else {
                format!("the {} @{asset_path}@ cannot be found", said(arc))
            };
            (site_path.to_string(), message)
        }
        E::MalformedLayer {
            asset_path,
            arc,
            site_path,
            reason,
            ..
        } => {
            // Materials hold no cameras.
            let message = if asset_path.ends_with(".mtlx") {
                level = Level::Note;
                remedy = "";
                format!("the {} @{asset_path}@ is MaterialX and was not read", said(arc))
            } else if reason.contains("no file format registered") {
                format!("the {} @{asset_path}@ is no USD layer", said(arc))
            } else {
                format!("the {} @{asset_path}@ cannot be read: {reason}", said(arc))
            };
            (site_path.to_string(), message)
        }
        E::UnresolvedPrimPath {
            arc,
            target_layer,
            prim_path,
            site_path,
            ..
        } => (
            site_path.to_string(),
            format!("the {} @{target_layer}@ has no prim <{prim_path}>", said(arc)),
        ),
        E::MissingDefaultPrim {
            layer_id,
            arc,
            site_path,
        }
        | E::InvalidDefaultPrim {
            layer_id,
            arc,
            site_path,
        } => {
            remedy = "name the prim in the reference, or give that layer a defaultPrim";
            (
                site_path.to_string(),
                format!(
                    "the {} @{layer_id}@ names no prim, and the layer has no default prim",
                    said(arc)
                ),
            )
        }
        E::ArcCycle(chain) => {
            remedy = "remove one of them; OpenUSD ignores the last";
            (
                chain.composing.to_string(),
                "references or inherits lead back to themselves".to_owned(),
            )
        }
        other => ("composition".to_owned(), other.to_string()),
    };
    Finding::new("composition", level, place, one_line(&message), remedy)
}

/// The address in an asset path that the library took for a file's, with the slash back that it dropped.
fn url(asset_path: &str) -> Option<String> {
    ["https:/", "http:/", "omniverse:/"]
        .into_iter()
        .find_map(|scheme| {
            let (_, rest) = asset_path.split_once(scheme)?;
            Some(format!("{scheme}/{}", rest.trim_start_matches('/')))
        })
}

fn plain_value(value: sdf::Value) -> Value {
    use sdf::Value as V;
    let floats = |components: &[f32]| Value::Floats(components.iter().map(|c| f64::from(*c)).collect());
    match value {
        V::Bool(v) => Value::Bool(v),
        V::Uchar(v) => Value::Int(v.into()),
        V::Int(v) => Value::Int(v.into()),
        V::Uint(v) => Value::Int(v.into()),
        V::Int64(v) => Value::Int(v),
        V::Uint64(v) => i64::try_from(v).map_or_else(|_| Value::Other("Uint64".to_owned()), Value::Int),
        V::Half(v) => Value::Float(v.to_f64()),
        V::Float(v) => Value::Float(v.into()),
        V::Double(v) => Value::Float(v),
        V::TimeCode(v) => Value::Float(v.value()),
        V::String(v) => Value::Text(v),
        V::Token(v) => Value::Text(v.as_str().to_owned()),
        V::AssetPath(v) => Value::Text(v.authored_path),
        V::TokenVec(v) => Value::Texts(v.iter().map(|token| token.as_str().to_owned()).collect()),
        V::StringVec(v) => Value::Texts(v),
        V::IntVec(v) => Value::Ints(v.into_iter().map(i64::from).collect()),
        V::Vec2i(v) => Value::Ints(vec![v.x.into(), v.y.into()]),
        V::Vec3i(v) => Value::Ints(vec![v.x.into(), v.y.into(), v.z.into()]),
        V::Vec2f(v) => floats(&[v.x, v.y]),
        V::Vec3f(v) => floats(&[v.x, v.y, v.z]),
        V::Vec4f(v) => floats(&[v.x, v.y, v.z, v.w]),
        V::Vec2d(v) => Value::Floats(vec![v.x, v.y]),
        V::Vec3d(v) => Value::Floats(vec![v.x, v.y, v.z]),
        V::FloatVec(v) => floats(&v),
        V::DoubleVec(v) => Value::Floats(v),
        other => Value::Other(<&'static str>::from(&other).to_owned()),
    }
}

//! Converts the USD library's prims and values to plain ones.

use std::collections::BTreeMap;

use openusd::{sdf, usd};

use super::reader::{Reader, Record};
use super::{Attribute, AttributeValue, Prim, RelationshipTarget};

/// Returns a prim's type.
pub(super) fn type_name(prim: &usd::Prim) -> Option<String> {
    Some(prim.type_name().ok()??.as_str().to_owned())
}

/// Returns the API schemas applied to a prim.
pub(super) fn api_schemas(prim: &usd::Prim) -> Vec<String> {
    let tokens = prim.api_schemas().unwrap_or_default();
    tokens.iter().map(|token| token.as_str().to_owned()).collect()
}

/// Converts the prim composed at `record` with all its attributes; its scene path is `path`.
pub(super) fn plain_prim(reader: &Reader, record: &Record, path: &str) -> Prim {
    let prim = reader.stage.prim(record.path.clone());
    let attributes: BTreeMap<String, Attribute> = prim
        .attributes()
        .unwrap_or_default()
        .iter()
        .filter_map(|attribute| {
            let path = attribute.path().to_string();
            let (_, name) = path.rsplit_once('.')?;
            Some((name.to_owned(), plain_attribute(reader, attribute)))
        })
        .collect();
    Prim {
        path: path.to_owned(),
        type_name: record.type_name.as_str().to_owned(),
        api_schemas: api_schemas(&prim),
        attributes,
    }
}

fn plain_attribute(reader: &Reader, attribute: &usd::Attribute) -> Attribute {
    let type_name = attribute
        .type_name()
        .ok()
        .flatten()
        .map(|name| name.as_str().to_owned())
        .unwrap_or_default();
    Attribute {
        type_name,
        value: reader.resolved(attribute).map(plain_value),
        animated: !attribute.time_sample_times().unwrap_or_default().is_empty(),
    }
}

/// Converts the targets of the relationship `name` of the prim composed at `record`, whose scene path is `path`.
pub(super) fn plain_targets(
    reader: &Reader,
    record: &Record,
    path: &str,
    name: &str,
) -> Vec<RelationshipTarget> {
    let prim = reader.stage.prim(record.path.clone());
    let targets = prim.relationship(name).targets().unwrap_or_default();
    let targets = targets.iter().map(|target| RelationshipTarget {
        path: scene_path(target.as_str(), record.path.as_str(), path),
        ..plain_target(&reader.stage, target)
    });
    targets.collect()
}

/// Returns the scene path of `target`, to which a prim composed at `composed` refers, whose scene path is `path`: what
/// instances share is composed below a prototype.
fn scene_path(target: &str, composed: &str, path: &str) -> String {
    let after_slash = composed.get(1..).unwrap_or_default();
    let root_end = after_slash.find('/').map_or(composed.len(), |end| end + 1);
    let (prototype, below) = composed.split_at(root_end);
    let of_instance = path
        .strip_suffix(below)
        .zip(target.strip_prefix(prototype))
        .filter(|(_, rest)| rest.is_empty() || rest.starts_with(['/', '.']));
    match of_instance {
        Some((instance, rest)) if instance != prototype => format!("{instance}{rest}"),
        _ => target.to_owned(),
    }
}

/// Converts the target of a relationship.
fn plain_target(stage: &usd::Stage, target: &sdf::Path) -> RelationshipTarget {
    let prim = stage.prim(target.clone());
    let exists = prim.is_valid().unwrap_or(false);
    RelationshipTarget {
        path: target.to_string(),
        type_name: exists.then(|| type_name(&prim).unwrap_or_default()),
    }
}

/// Converts a value to one of the plain types.
pub(super) fn plain_value(value: sdf::Value) -> AttributeValue {
    use sdf::Value as V;
    let floats =
        |components: &[f32]| AttributeValue::Floats(components.iter().map(|c| f64::from(*c)).collect());
    match value {
        V::Bool(v) => AttributeValue::Bool(v),
        V::Uchar(v) => AttributeValue::Int(v.into()),
        V::Int(v) => AttributeValue::Int(v.into()),
        V::Uint(v) => AttributeValue::Int(v.into()),
        V::Int64(v) => AttributeValue::Int(v),
        V::Uint64(v) => i64::try_from(v).map_or_else(
            |_| AttributeValue::Other("Uint64".to_owned()),
            AttributeValue::Int,
        ),
        V::Half(v) => AttributeValue::Float(v.to_f64()),
        V::Float(v) => AttributeValue::Float(v.into()),
        V::Double(v) => AttributeValue::Float(v),
        V::TimeCode(v) => AttributeValue::Float(v.value()),
        V::String(v) => AttributeValue::Text(v),
        V::Token(v) => AttributeValue::Text(v.as_str().to_owned()),
        V::AssetPath(v) => AttributeValue::Text(v.authored_path),
        V::TokenVec(v) => AttributeValue::Texts(v.iter().map(|token| token.as_str().to_owned()).collect()),
        V::StringVec(v) => AttributeValue::Texts(v),
        V::IntVec(v) => AttributeValue::Ints(v.into_iter().map(i64::from).collect()),
        V::Vec2i(v) => AttributeValue::Ints(vec![v.x.into(), v.y.into()]),
        V::Vec3i(v) => AttributeValue::Ints(vec![v.x.into(), v.y.into(), v.z.into()]),
        V::Vec2f(v) => floats(&[v.x, v.y]),
        V::Vec3f(v) => floats(&[v.x, v.y, v.z]),
        V::Vec4f(v) => floats(&[v.x, v.y, v.z, v.w]),
        V::Vec2d(v) => AttributeValue::Floats(vec![v.x, v.y]),
        V::Vec3d(v) => AttributeValue::Floats(vec![v.x, v.y, v.z]),
        V::FloatVec(v) => floats(&v),
        V::DoubleVec(v) => AttributeValue::Floats(v),
        other => AttributeValue::Other(<&'static str>::from(&other).to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::scene_path;

    #[test]
    fn targets_inside_prototypes_are_those_of_the_instance() {
        for (target, composed, path, expected) in [
            (
                "/__Prototype_1/Cam",
                "/__Prototype_1/Product",
                "/W/R/Product",
                "/W/R/Cam",
            ),
            (
                "/__Prototype_1",
                "/__Prototype_1/a/Product",
                "/W/R/a/Product",
                "/W/R",
            ),
            (
                "/__Prototype_12/Cam",
                "/__Prototype_1/Product",
                "/W/R/Product",
                "/__Prototype_12/Cam",
            ),
            ("/W/Cam", "/W/Product", "/W/Product", "/W/Cam"),
        ] {
            assert_eq!(scene_path(target, composed, path), expected);
        }
    }
}

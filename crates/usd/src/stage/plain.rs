//! Converts the USD library's prims and values to plain ones.

use std::collections::BTreeMap;

use openusd::{sdf, usd};

use super::{Attribute, Prim, Target, Value};

/// Returns a prim's type.
pub(super) fn type_name(prim: &usd::Prim) -> Option<String> {
    Some(prim.type_name().ok()??.as_str().to_owned())
}

/// Returns the API schemas applied to a prim.
pub(super) fn api_schemas(prim: &usd::Prim) -> Vec<String> {
    let tokens = prim.api_schemas().unwrap_or_default();
    tokens.iter().map(|token| token.as_str().to_owned()).collect()
}

/// Converts a prim with all its attributes.
pub(super) fn plain_prim(prim: &usd::Prim, type_name: String) -> Prim {
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

/// Converts the target of a relationship.
pub(super) fn plain_target(stage: &usd::Stage, target: &sdf::Path) -> Target {
    let prim = stage.prim(target.clone());
    let exists = prim.is_valid().unwrap_or(false);
    Target {
        path: target.to_string(),
        type_name: exists.then(|| type_name(&prim).unwrap_or_default()),
    }
}

/// Converts a value to one of the plain types.
pub(super) fn plain_value(value: sdf::Value) -> Value {
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

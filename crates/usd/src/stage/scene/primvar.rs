use oaktwin_scene::polygon::{Interpolation, Primvar};
use openusd::sdf::{Path, Value};

use super::super::reader::{Reader, Record};
use super::super::value::{ints, text};
use super::context::Context;

/// Returns a primvar of a prim or an inherited one. Only constant primvars are inherited.
pub(super) fn primvar<T>(
    reader: &Reader,
    prim: &Record,
    context: &Context,
    name: &str,
    convert: impl Fn(Value) -> Option<Vec<T>>,
) -> Option<Primvar<T>> {
    if prim.has(name)
        && let Some(own) = attribute(reader, &prim.path, name, Interpolation::Constant, &convert)
    {
        return Some(own);
    }
    let ancestor = context.ancestor_with(name)?;
    attribute(reader, ancestor, name, Interpolation::Constant, &convert)
        .filter(|inherited| inherited.interpolation == Interpolation::Constant)
}

/// Returns an attribute with its interpolation and indices.
pub(super) fn attribute<T>(
    reader: &Reader,
    prim: &Path,
    name: &str,
    fallback: Interpolation,
    convert: impl Fn(Value) -> Option<Vec<T>>,
) -> Option<Primvar<T>> {
    let values = convert(reader.attribute_value(prim, name)?)?;
    let interpolation = prim
        .append_property(name)
        .ok()
        .and_then(|path| reader.field(&path, "interpolation"))
        .and_then(text);
    let interpolation = match interpolation.as_deref() {
        Some("constant") => Interpolation::Constant,
        Some("uniform") => Interpolation::Uniform,
        Some("varying" | "vertex") => Interpolation::Vertex,
        Some("faceVarying") => Interpolation::FaceVarying,
        _ => fallback,
    };
    let indices = reader
        .attribute_value(prim, &format!("{name}:indices"))
        .and_then(ints);
    Some(Primvar {
        interpolation,
        values,
        indices,
    })
}

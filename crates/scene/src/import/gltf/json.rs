//! Parses the JSON of a glTF file and repairs what older exporters get wrong.

use std::collections::BTreeSet;

use serde_json::{Map, Value, json};

use crate::import::error::Fault;
use crate::import::text;

pub(super) const OLD_VERSION_REMEDY: &str =
    "convert it to glTF 2.0, for example with `gltf-pipeline -i OLD.gltf -o NEW.glb`";

pub(super) fn old_version(place: &str, version: &str) -> Fault {
    let message = format!("is glTF {version}; only glTF 2.0 is supported");
    Fault::new(place, message, OLD_VERSION_REMEDY)
}

/// Parses the JSON and checks its version.
pub(super) fn parse(bytes: &[u8]) -> Result<Value, Fault> {
    let bytes = text::decoded(bytes);
    let parsed = serde_json::from_slice(&bytes).or_else(|error| {
        // Python writes NaN and Infinity, which JSON does not have.
        serde_json::from_slice(&without_special_numbers(&bytes)).map_err(|_| error)
    });
    let mut root: Value = parsed.map_err(|error| Fault::damaged("JSON", error.to_string()))?;
    let Some(members) = root.as_object_mut() else {
        return Err(Fault::damaged("JSON", "is not an object"));
    };
    let version = match members.get("asset").and_then(|asset| asset.get("version")) {
        Some(Value::String(version)) => Some(version.clone()),
        Some(Value::Number(number)) => Some(number.to_string()),
        // The lists of glTF 1.0 are objects, and its first files have no version.
        _ if ["meshes", "nodes", "accessors"]
            .iter()
            .any(|&list| members.get(list).is_some_and(Value::is_object)) =>
        {
            Some("1.0".into())
        }
        _ => None,
    };
    match version {
        Some(version) if version != "2" && !version.starts_with("2.") => {
            Err(old_version("asset.version", &version))
        }
        _ => {
            members.insert("asset".into(), json!({ "version": "2.0" }));
            tidy(&mut root);
            repair(&mut root);
            Ok(root)
        }
    }
}

/// Replaces `NaN`, `Infinity` and `-Infinity` outside strings by `null`.
fn without_special_numbers(bytes: &[u8]) -> Vec<u8> {
    let mut plain = Vec::with_capacity(bytes.len());
    let (mut rest, mut in_string) = (bytes, false);
    while let Some(&byte) = rest.first() {
        let special = [&b"NaN"[..], b"Infinity", b"-Infinity"]
            .into_iter()
            .find(|word| !in_string && rest.starts_with(word));
        let (copied, length) = match special {
            Some(word) => (&b"null"[..], word.len()),
            None if in_string && byte == b'\\' => (&rest[..rest.len().min(2)], 2),
            None => (&rest[..1], 1),
        };
        in_string ^= byte == b'"';
        plain.extend_from_slice(copied);
        rest = &rest[length.min(rest.len())..];
    }
    plain
}

/// Removes `null`, extras and negative indices, and converts numbers such as `3.0` to integers.
fn tidy(value: &mut Value) {
    match value {
        Value::Array(list) => list.iter_mut().for_each(tidy),
        Value::Object(members) => {
            members.remove("extras");
            members.retain(|name, member| !member.is_null() && !is_absent_index(name, member));
            for (name, member) in members {
                tidy(member);
                if name == "name" && !member.is_string() {
                    *member = Value::String(member.to_string());
                }
            }
        }
        Value::Number(number) => {
            let float = number.as_f64().filter(|_| number.is_f64());
            #[allow(clippy::cast_possible_truncation, reason = "whole, and small enough")]
            if let Some(whole) = float.filter(|x| x.fract() == 0.0 && x.abs() < 1e15) {
                *value = Value::from(whole as i64);
            }
        }
        _ => {}
    }
}

/// Whether a member is a negative index, by which some exporters mean that there is none.
fn is_absent_index(name: &str, value: &Value) -> bool {
    const INDICES: [&str; 9] = [
        "bufferView",
        "camera",
        "indices",
        "material",
        "mesh",
        "sampler",
        "scene",
        "skin",
        "source",
    ];
    INDICES.contains(&name) && value.as_f64().is_some_and(|index| index < 0.0)
}

/// Adds required members that older exporters leave out, and removes what is not read.
fn repair(root: &mut Value) {
    for camera in objects(root, "cameras") {
        for (kind, defaults) in [
            ("perspective", &[("yfov", 0.0), ("znear", 0.01)][..]),
            (
                "orthographic",
                &[("xmag", 1.0), ("ymag", 1.0), ("zfar", 100.0), ("znear", 0.0)],
            ),
        ] {
            let Some(lens) = camera.get_mut(kind).and_then(Value::as_object_mut) else {
                continue;
            };
            for &(name, number) in defaults {
                lens.entry(name).or_insert(json!(number));
            }
            camera.entry("type").or_insert(json!(kind));
        }
    }
    for view in objects(root, "bufferViews") {
        view.entry("buffer").or_insert(json!(0));
        view.retain(|name, value| name != "byteStride" || *value != 0);
    }
    for scene in objects(root, "scenes") {
        scene.entry("nodes").or_insert(json!([]));
    }
    for material in objects(root, "materials") {
        if let Some(Value::Array(factor)) = material.get_mut("emissiveFactor") {
            factor.resize(3, json!(0));
        }
        let factor = material
            .get_mut("pbrMetallicRoughness")
            .and_then(|pbr| pbr.get_mut("baseColorFactor"));
        if let Some(Value::Array(factor)) = factor {
            factor.resize(4, json!(1));
        }
    }
    for texture in objects(root, "textures") {
        let alternative = ["KHR_texture_basisu", "EXT_texture_webp"]
            .iter()
            .find_map(|name| texture.get("extensions")?.get(name)?.get("source").cloned());
        if let Some(source) = alternative {
            texture.entry("source").or_insert(source);
        }
    }
}

/// The objects in a list of the root.
pub(super) fn objects<'a>(
    root: &'a mut Value,
    list: &str,
) -> impl Iterator<Item = &'a mut Map<String, Value>> {
    let list = root.get_mut(list).and_then(Value::as_array_mut);
    list.into_iter().flatten().filter_map(Value::as_object_mut)
}

/// The names of all extensions that a file lists or has.
pub(super) fn extension_names(root: &Value) -> BTreeSet<String> {
    let mut names = BTreeSet::new();
    for list in ["extensionsUsed", "extensionsRequired"] {
        let list = root.get(list).and_then(Value::as_array);
        names.extend(
            list.into_iter()
                .flatten()
                .filter_map(Value::as_str)
                .map(String::from),
        );
    }
    let mut rest = vec![root];
    while let Some(value) = rest.pop() {
        match value {
            Value::Array(list) => rest.extend(list.iter().filter(|item| item.is_array() || item.is_object())),
            Value::Object(members) => {
                if let Some(Value::Object(extensions)) = members.get("extensions") {
                    names.extend(extensions.keys().cloned());
                }
                rest.extend(
                    members
                        .values()
                        .filter(|item| item.is_array() || item.is_object()),
                );
            }
            _ => {}
        }
    }
    names
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn special_numbers_become_null() {
        let text = br#"{"a":[NaN,-Infinity,Infinity,1],"NaN \" NaN":"x\\","b":NaN}"#;
        assert_eq!(
            String::from_utf8(without_special_numbers(text)).unwrap(),
            r#"{"a":[null,null,null,1],"NaN \" NaN":"x\\","b":null}"#
        );
    }
}

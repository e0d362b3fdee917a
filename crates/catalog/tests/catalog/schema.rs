//! The schemas in the repository agree with the code, and the built-in files are valid by them.
#![expect(clippy::unwrap_used, reason = "helpers of tests")]

use std::path::Path;

use serde_json::Value;

#[test]
fn the_files_are_current() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("schema");
    for (name, text) in oaktwin_catalog::schema_files() {
        let kept = std::fs::read_to_string(folder.join(name)).unwrap_or_default();
        assert!(
            kept == text,
            "crates/catalog/schema/{name} is out of date; run `cargo xtask schema`"
        );
    }
}

#[test]
fn the_page_of_models_is_current() {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/manual/reference/models.md");
    let kept = std::fs::read_to_string(page).unwrap_or_default();
    assert!(
        kept == oaktwin_catalog::models_page(),
        "docs/manual/reference/models.md is out of date; run `cargo xtask schema`"
    );
}

/// Every key of the file is in the schema, and every key that the schema requires is in the file.
#[test]
fn the_builtin_files_fit() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("data");
    for (folder, schema) in [
        ("sensors", oaktwin_catalog::sensor_schema()),
        ("devices", oaktwin_catalog::device_schema()),
        ("imus", oaktwin_catalog::inertial_part_schema()),
    ] {
        for entry in std::fs::read_dir(root.join(folder)).unwrap() {
            let path = entry.unwrap().path();
            let file: Value = toml::from_str(&std::fs::read_to_string(&path).unwrap()).unwrap();
            fits(&file, &schema, &schema, &path.display().to_string());
        }
    }
}

fn fits(value: &Value, schema: &Value, root: &Value, place: &str) {
    // An optional table is `anyOf` it and null.
    let schema = schema["anyOf"].get(0).unwrap_or(schema);
    let schema = match schema["$ref"].as_str() {
        Some(reference) => root.pointer(reference.trim_start_matches('#')).unwrap(),
        None => schema,
    };
    if let Some(object) = value.as_object() {
        for required in schema["required"].as_array().into_iter().flatten() {
            assert!(
                object.contains_key(required.as_str().unwrap()),
                "{place}: no {required}"
            );
        }
        for (key, value) in object {
            let place = format!("{place}.{key}");
            match schema["properties"].get(key) {
                Some(schema) => fits(value, schema, root, &place),
                None => assert!(
                    schema["additionalProperties"].is_object(),
                    "{place}: not in the schema"
                ),
            }
        }
    }
    for (i, item) in value.as_array().into_iter().flatten().enumerate() {
        if schema["items"].is_object() {
            fits(item, &schema["items"], root, &format!("{place}.{i}"));
        }
    }
}

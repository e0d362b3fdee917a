//! The manual's page of recipes, from the schema.

use std::fmt::Write;

use serde_json::Value;

use super::schema;

/// The tables of a recipe: how they are written, and the definition in the schema.
const TABLES: [(&str, &str); 20] = [
    ("", ""),
    ("scene_options", "SceneRule"),
    ("[objects]", "ObjectRule"),
    ("objects.look", "Appearance"),
    ("[looks]", "LookRule"),
    ("light", "LightRule"),
    ("light.sun", "Sun"),
    ("light.sky", "Sky"),
    ("light.lamps", "Lamps"),
    ("camera", "CameraRule"),
    ("camera.sphere", "SpherePlacement"),
    ("camera.box", "BoxPlacement"),
    ("camera.imu", "ImuRule"),
    ("camera.motion", "MotionRule"),
    ("unit", "UnitRule"),
    ("unit.drift", "DriftRule"),
    ("sensor", "SensorRule"),
    ("output", "OutputRule"),
    ("objects.region", "Region"),
    ("light.lamps.region", "Region"),
];

/// Returns the manual's page of recipes, which `cargo xtask schema` writes.
#[must_use]
pub fn page() -> String {
    let schema = schema();
    let mut page = "# Recipes\n\nThe keys of a recipe for `oaktwin generate`. [Data sets](../datasets.md) has examples.\n\n\
        A *quantity* is a number or a distribution that it is drawn from: `{ uniform = [LOW, HIGH] }`, `{ log_uniform = [LOW, HIGH] }`, \
        `{ normal = [MEAN, DEVIATION] }` (cut at three standard deviations) or `{ choice = [A, B, …] }`. *Texts* are one text or a list. \
        Files are relative to the recipe. `oaktwin generate --schema` prints the JSON schema.\n"
        .to_owned();
    for (table, definition) in TABLES {
        let described = if definition.is_empty() {
            &schema
        } else {
            &schema["$defs"][definition]
        };
        let title = if table.is_empty() {
            "Top level".to_owned()
        } else {
            format!("`[{table}]`")
        };
        let _ = write!(page, "\n## {title}\n\n{}\n\n", line(described));
        page.push_str("| key | value | default | meaning |\n|---|---|---|---|\n");
        for (key, value) in described["properties"].as_object().into_iter().flatten() {
            let _ = writeln!(
                page,
                "| `{key}` | {} | {} | {} |",
                kind(value),
                default(value),
                line(value)
            );
        }
    }
    page
}

/// The description on one line.
fn line(value: &Value) -> String {
    let text = value["description"].as_str().unwrap_or_default();
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The type of a value in words.
fn kind(value: &Value) -> String {
    if let Some(names) = value["enum"].as_array() {
        let names: Vec<String> = names
            .iter()
            .filter_map(Value::as_str)
            .map(|name| format!("`{name}`"))
            .collect();
        return names.join(", ");
    }
    let mut options = value["anyOf"].as_array().into_iter().flatten();
    let reference = value["$ref"]
        .as_str()
        .or_else(|| options.find_map(|option| option["$ref"].as_str()));
    match reference.map(|path| path.trim_start_matches("#/$defs/")) {
        Some("Quantity") => return "quantity".to_owned(),
        Some("Texts") => return "texts".to_owned(),
        Some("Target") => return "name or point".to_owned(),
        Some(_) => return "table".to_owned(),
        None => {}
    }
    let name = value["type"].as_str().or_else(|| value["type"][0].as_str());
    match name {
        Some("array") if value["items"]["$ref"] == "#/$defs/Quantity" => {
            format!("{} quantities", value["minItems"])
        }
        Some("array") if value["items"]["$ref"].is_string() => "list of tables".to_owned(),
        Some("array") => {
            let count = value["minItems"].as_u64().unwrap_or_default();
            format!("{count} numbers")
        }
        Some("integer") => "whole number".to_owned(),
        Some("boolean") => "`true`, `false`".to_owned(),
        Some("object") => "table".to_owned(),
        Some("string") => "text".to_owned(),
        _ => "number".to_owned(),
    }
}

/// The default as TOML; a table's default is in its own section.
fn default(value: &Value) -> String {
    match &value["default"] {
        Value::Null => String::new(),
        Value::Array(list) if list.is_empty() => String::new(),
        Value::Object(table)
            if table
                .keys()
                .any(|key| !["uniform", "log_uniform", "normal", "choice"].contains(&key.as_str())) =>
        {
            String::new()
        }
        Value::Object(table) if table.is_empty() => String::new(),
        other => format!("`{}`", toml(other)),
    }
}

fn toml(value: &Value) -> String {
    match value {
        Value::Object(table) => {
            let entries: Vec<String> = table
                .iter()
                .map(|(key, value)| format!("{key} = {}", toml(value)))
                .collect();
            format!("{{ {} }}", entries.join(", "))
        }
        Value::Array(list) => format!("[{}]", list.iter().map(toml).collect::<Vec<_>>().join(", ")),
        Value::Number(number) => number
            .as_f64()
            .map_or_else(String::new, |number| number.to_string()),
        other => other.to_string(),
    }
}

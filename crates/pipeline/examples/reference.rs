//! Writes what is generated from the tables of parameters, options and names: the reference page of the manual, the JSON schema,
//! and parts of the Python package. `cargo xtask schema` runs it, and a test checks that the files are up to date.

#[path = "reference/python.rs"]
mod python;

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use oaktwin_depth::parameters::{GROUPS, Kind, Listing, Platform};
use serde_json::{Map, Value, json};

fn main() -> std::io::Result<()> {
    for (path, text) in files()? {
        std::fs::create_dir_all(path.parent().unwrap_or(&path))?;
        std::fs::write(path, text)?;
    }
    Ok(())
}

/// The generated files: path and text.
pub(crate) fn files() -> std::io::Result<Vec<(PathBuf, String)>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut files = python::files(&root)?;
    files.push((root.join("docs/manual/reference/parameters.md"), page()));
    files.push((
        root.join("crates/base/schema/parameters.schema.json"),
        format!("{:#}\n", schema()),
    ));
    Ok(files)
}

fn page() -> String {
    let mut out = "# Parameters\n\nThe program prints these tables with `oaktwin params GROUP`, Python with \
                   `oaktwin.parameters(GROUP)`. Names are `DepthAI`'s or NVIDIA's where they have the parameter. Where the \
                   platforms differ, RVC2's default comes first, then RVC4's.\n"
        .to_owned();
    for group in GROUPS {
        let _ = write!(out, "\n## {}\n\n{}.\n", group.name, group.about);
        let [rvc2, rvc4] = [Platform::Rvc2, Platform::Rvc4].map(|platform| group.list(platform));
        let mut table = "";
        for (row, other) in rvc2.iter().zip(&rvc4) {
            if row.table != table {
                table = row.table;
                if table != group.name {
                    let _ = write!(out, "\n### {table}\n");
                }
                out += "\n| name | default | range | source | |\n|---|---|---|---|---|\n";
            }
            let default = match row.default == other.default {
                true => row.default.clone(),
                false => format!("{} / {}", row.default, other.default),
            };
            let about = &row.about;
            let platform = about
                .platform
                .map(|platform| format!(" {} only.", platform.title()));
            let _ = writeln!(
                out,
                "| `{}` | {default} | {} | {} | {}{} |",
                about.name,
                about.values_text(),
                about.source,
                about.doc.replace('|', "\\|"),
                platform.unwrap_or_default(),
            );
        }
    }
    out
}

fn schema() -> Value {
    let groups = GROUPS.iter().map(|group| {
        let rows = group.list(Platform::default());
        let properties: Map<String, Value> = rows.iter().map(|row| (key(group.name, row), property(row))).collect();
        let schema = json!({
            "description": group.about, "type": "object", "properties": properties, "additionalProperties": false,
        });
        (group.name.to_owned(), schema)
    });
    let definitions: Map<String, Value> = groups.collect();
    json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "Parameters of oaktwin",
        "$defs": definitions,
    })
}

/// The name of a property: a filter's settings have its name in front.
fn key(group: &str, row: &Listing) -> String {
    match group {
        "filters" => format!("{}:{}", row.table.trim_end_matches(" filter"), row.about.name),
        _ => row.about.name.to_owned(),
    }
}

fn property(row: &Listing) -> Value {
    let about = &row.about;
    let mut property = Map::new();
    property.insert("description".to_owned(), about.doc.into());
    let kind = match about.kind {
        Kind::Choice(_) | Kind::Text(_) => "string",
        kind => kind.name(),
    };
    property.insert("type".to_owned(), kind.into());
    if let Kind::Choice(names) = about.kind {
        property.insert("enum".to_owned(), names.into());
    }
    if matches!(about.kind, Kind::Integer | Kind::Number) {
        match about.min {
            f64::MIN => None,
            f64::MIN_POSITIVE => property.insert("exclusiveMinimum".to_owned(), 0.into()),
            min => property.insert("minimum".to_owned(), min.into()),
        };
        if about.max < f64::MAX {
            property.insert("maximum".to_owned(), about.max.into());
        }
    }
    property.insert(
        "default".to_owned(),
        serde_json::from_str(&row.default).unwrap_or_else(|_| row.default.clone().into()),
    );
    Value::Object(property)
}

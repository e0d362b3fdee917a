//! No output contains NaN or infinity, except where the manual says so.

use std::fs;
use std::path::Path;

use oaktwin::image::npy::{self, Layout, Values};
use serde_json::Value;

use crate::fit::{FAR, OPTICS, record};
use crate::program::{EXAMPLE, Program};
use crate::render::program;

/// Ground truth of a pixel that sees nothing.
const INFINITE: [&str; 2] = ["distance_to_image_plane", "distance_to_camera"];
/// The errors of points that nothing measures.
const WITHOUT_VALUE: [&str; 1] = ["errors"];

/// Whether a text is a number that is not finite, as any of the formats writes it.
fn is_not_finite(text: &str) -> bool {
    let text = text
        .trim()
        .trim_start_matches(['+', '-', '.'])
        .to_ascii_lowercase();
    matches!(text.as_str(), "nan" | "inf" | "infinity")
}

fn in_json(value: &Value, place: &str, found: &mut Vec<String>) {
    match value {
        Value::Array(items) => {
            for (index, item) in items.iter().enumerate() {
                in_json(item, &format!("{place}[{index}]"), found);
            }
        }
        Value::Object(entries) => {
            for (key, item) in entries {
                in_json(item, &format!("{place}.{key}"), found);
            }
        }
        Value::String(text) if is_not_finite(text) => found.push(format!("{place}: {text}")),
        Value::Number(number) if number.as_f64().is_none_or(|number| number.abs() > 1e30) => {
            found.push(format!("{place}: {number}"));
        }
        _ => {}
    }
}

fn in_array(name: &str, bytes: &[u8], found: &mut Vec<String>) {
    // Records, such as boxes, are read by their own tests.
    let Ok(layout) = Layout::parse(bytes) else {
        return;
    };
    let numbers: Vec<f64> = match layout.number.values(&bytes[layout.data_offset..]) {
        Values::F32(numbers) => numbers.into_iter().map(f64::from).collect(),
        Values::F64(numbers) => numbers,
        _ => return,
    };
    let is_of = |names: &[&str]| names.iter().any(|one| name.contains(one));
    let is_wrong = |number: &f64| match number {
        number if number.is_finite() => false,
        number if number.is_nan() => !is_of(&WITHOUT_VALUE),
        number => *number < 0.0 || !is_of(&INFINITE),
    };
    found.extend(
        numbers
            .iter()
            .find(|number| is_wrong(number))
            .map(|number| format!("{name}: {number}")),
    );
}

/// Returns the numbers of a file that are not finite.
fn in_file(name: &str, path: &Path) -> Vec<String> {
    let mut found = Vec::new();
    let bytes = fs::read(path).unwrap();
    let text = || String::from_utf8_lossy(&bytes);
    match path.extension().and_then(|extension| extension.to_str()) {
        Some("npy") => in_array(name, &bytes, &mut found),
        Some("json") => {
            let value: Value =
                serde_json::from_slice(&bytes).unwrap_or_else(|error| panic!("{name}: {error}"));
            in_json(&value, name, &mut found);
        }
        Some("toml" | "csv" | "xml" | "urdf" | "xacro" | "sdf" | "yaml" | "txt" | "svg") => {
            // Comments of TOML and YAML are words.
            let lines = text();
            let lines = lines
                .lines()
                .map(|line| match line.trim_start().starts_with('#') {
                    true => "",
                    false => line,
                });
            for (number, line) in (1..).zip(lines) {
                let mut words = line.split(|letter: char| " ,;=\"'<>()[]{}:\t".contains(letter));
                found.extend(
                    words
                        .find(|word| is_not_finite(word))
                        .map(|_| format!("{name}:{number}: {line}")),
                );
            }
        }
        _ => {}
    }
    found
}

/// Runs a command that may have findings, and keeps its standard output.
fn keep(program: &Program, name: &str, command: &str) {
    let words: Vec<&str> = command
        .split_whitespace()
        .map(|word| if word == "EXAMPLE" { EXAMPLE } else { word })
        .collect();
    let ended = program.run(&words);
    assert!(ended.code <= 1, "{command}: {}", ended.stderr);
    program.put(name, ended.stdout);
}

#[test]
fn outputs_are_finite() {
    let program = program();
    let room = "room.usda --model oak4-d --resolution 160x100 --look-at 0 -2 0.5 0 0 0.25";
    keep(
        &program,
        "render.json",
        &format!(
            "render {room} -o render --json --annotators rgb,distance_to_image_plane,distance_to_camera,normals,\
             semantic_segmentation,instance_id_segmentation,bounding_box_2d_tight,pointcloud,\
             depth_sensor_distance,depth_sensor_reason,camera_params"
        ),
    );
    keep(
        &program,
        "sense.json",
        "sense render/distance_to_image_plane_0000.npy --model oak4-d -o sense --json",
    );
    keep(
        &program,
        "coverage.json",
        &format!("coverage {room} --region /World/Box --samples 200 -o coverage --json"),
    );
    keep(
        &program,
        "accuracy.json",
        "accuracy oak4-d --distances 0.3,2,60 --captures 1 --devices 2 --json",
    );
    keep(
        &program,
        "far.json",
        "accuracy oak4-d --distances 60 --captures 1 --devices 1 --param dropout=1 --json",
    );
    for (folder, distances) in [("many", &FAR[..]), ("one", &[2.3])] {
        record(&program, folder, distances);
        let optics = OPTICS.join(" ");
        let command =
            format!("fit {folder} --model oak4-d {optics} -o {folder}.toml --plot {folder}.svg --json");
        keep(&program, &format!("fit_{folder}.json"), &command);
    }
    program.put(
        "flat.csv",
        "distance_m,depth_error_percent\n1,0\n2,0\n3,0\n4,0\n5,0\n6,0\n",
    );
    keep(
        &program,
        "flat.json",
        "fit flat.csv --model oak4-d -o flat.toml --json",
    );
    for format in ["urdf", "sdf", "drake", "mjcf", "webots", "blender"] {
        keep(
            &program,
            &format!("export_{format}.json"),
            &format!("export oak4-d --to {format} -o robot_{format} --json"),
        );
    }
    keep(&program, "show.json", "show oak-d-tof --json");
    keep(&program, "models.json", "models --json");
    keep(&program, "calibration.json", "calibration show EXAMPLE --json");
    keep(&program, "check.json", "check room.usda --json");
    keep(
        &program,
        "population.json",
        "population oak4-d --units 2 -o population --json",
    );
    let mut found = Vec::new();
    let mut files = 0;
    for name in program.names() {
        let path = program.path(&name);
        if path.is_file() {
            files += 1;
            found.extend(in_file(&name, &path));
        }
    }
    assert!(files > 40, "{files} files");
    assert!(found.is_empty(), "{found:#?}");
}

#[test]
fn the_checker_finds_what_is_not_finite() {
    let program = Program::new();
    let array = npy::encode(&[2], &[1.0f32, f32::NAN]).unwrap();
    let infinite = npy::encode(&[2], &[1.0f32, f32::INFINITY]).unwrap();
    for (name, bytes, count) in [
        ("a.npy", array, 1),
        ("b.npy", infinite.clone(), 1),
        ("distance_to_camera_0000.npy", infinite, 0),
        ("a.json", b"{\"a\": [1, \"NaN\"], \"b\": 1e300}".to_vec(), 2),
        ("a.csv", b"a,b\n1,-inf\n".to_vec(), 1),
        ("a.toml", b"# inf\na = [nan, 1]\n".to_vec(), 1),
        ("a.urdf", b"<origin xyz=\"0 NaN 0\"/>\n<inform/>".to_vec(), 1),
    ] {
        let path = program.put(name, bytes);
        assert_eq!(in_file(name, &path).len(), count, "{name}");
    }
}

//! What can be taken away from the page.

use std::collections::BTreeMap;
use std::io::{Cursor, Read};

use serde_json::{Value, json};

use super::super::program::Program;
use super::super::render::program;
use super::client::{Server, frame, request, send, state};
use super::server;

/// Asks for a file of a state.
pub(super) fn export(server: &Server, state: &Value, what: &str, more: &Value) -> Vec<u8> {
    let mut request = json!({"what": what, "scene": "first", "state": state, "size": [320, 200]});
    let more = more.as_object().cloned().unwrap_or_default();
    request.as_object_mut().unwrap().extend(more);
    let (status, body) = server.request("POST", "/api/export", request.to_string().as_bytes());
    assert_eq!(status, 200, "{what}: {}", String::from_utf8_lossy(&body));
    body
}

/// Runs the exported command line and compares the measured depth with the page's.
fn check_command(program: &Program, server: &Server, state: &Value) -> String {
    let shown = export(
        server,
        state,
        "image",
        &json!({"format": "npy", "image": "sensor"}),
    );
    let command = String::from_utf8(export(server, state, "command", &json!({}))).unwrap();
    for line in command.lines() {
        let words = line.strip_prefix("oaktwin ").unwrap().split(' ');
        program.good(&words.collect::<Vec<_>>());
    }
    let written = std::fs::read(program.path("oak/depth_sensor_distance_0000.npy")).unwrap();
    assert!(written == shown, "{command}");
    command
}

#[test]
fn exports_reproduce_the_page() {
    let program = program();
    let server = server(&program);
    for (engine, (name, value)) in [
        ("stereo-noise", ("bias", "0.4")),
        ("stereo-matching", ("bias", "0.2")),
    ] {
        let mut state = state();
        state["engine"] = json!(engine);
        state["seed"] = json!(7);
        state["deviceSeed"] = json!(3);
        state["filters"] = json!(["spatial:alpha=0.6"]);
        state["parameters"][name] = json!(value);
        check_command(&program, &server, &state);

        let toml = export(&server, &state, "parameters", &json!({}));
        program.put("own.toml", toml);
        program.good(&[
            "render",
            "crate.obj",
            "--model",
            "OAK4-D",
            "--up",
            "z",
            "--look-at",
            "0",
            "-2",
            "0.5",
            "0",
            "0",
            "0.5",
            "--params",
            "own.toml",
        ]);
        let asset = export(&server, &state, "asset", &json!({"format": "usda"}));
        assert!(asset.starts_with(b"#usda 1.0"));
        let numbers = export(&server, &state, "statistics", &json!({"format": "json"}));
        let numbers: Value = serde_json::from_slice(&numbers).unwrap();
        assert!(numbers["oaks"][0]["fillRate"].as_f64().unwrap() > 0.0);
    }
}

#[test]
fn exports_reproduce_the_light_of_the_projector() {
    let program = program();
    let server = server(&program);
    let shown = |projector: f64| {
        let mut state = state();
        state["model"] = json!("OAK-D-Pro-PoE");
        state["parameters"] = json!({});
        state["projector"] = json!(projector);
        state["ambient"] = json!(0.3);
        let numbers = export(&server, &state, "statistics", &json!({"format": "json"}));
        let numbers: Value = serde_json::from_slice(&numbers).unwrap();
        (numbers["oaks"][0]["fillRate"].as_f64().unwrap(), state)
    };
    let ((dark, _), (lit, state)) = (shown(0.0), shown(0.7));
    assert!(lit > dark + 0.2, "{dark} and {lit}");
    let command = check_command(&program, &server, &state);
    assert!(command.contains("--projector 0.7 --ambient 0.3"), "{command}");
    let script = String::from_utf8(export(&server, &state, "python", &json!({}))).unwrap();
    assert!(script.contains("projector=0.7, ambient=0.3"), "{script}");
}

#[test]
fn exports_reproduce_a_unit_of_the_population_that_has_drifted() {
    let program = program();
    let server = server(&program);
    let mut page = server.page();
    let mut images = Vec::new();
    for (id, (engine, population, drift)) in (1..).zip([
        ("stereo-noise", json!(5), json!({})),
        (
            "stereo-noise",
            json!(5),
            json!({"yaw": "0.3", "pitch": "-0.2", "roll": "0"}),
        ),
        ("stereo-noise", json!(6), json!({"yaw": "0.3", "pitch": "-0.2"})),
        ("stereo-noise", Value::Null, json!({"baseline": "50"})),
        (
            "stereo-matching",
            json!(5),
            json!({"yaw": "0.3", "pitch": "-0.2"}),
        ),
    ]) {
        let mut state = state();
        state["engine"] = json!(engine);
        (state["populationSeed"], state["drift"]) = (population.clone(), drift.clone());
        let command = check_command(&program, &server, &state);
        assert_eq!(
            command.contains("oaktwin population OAK4-D"),
            !population.is_null()
        );
        let is_drifted = drift != json!({});
        assert_eq!(command.contains("--drift "), is_drifted, "{command}");
        let python = String::from_utf8(export(&server, &state, "python", &json!({}))).unwrap();
        assert_eq!(
            python.contains("device.population(1, seed="),
            !population.is_null(),
            "{python}"
        );
        assert_eq!(python.contains(", drift=\""), is_drifted, "{python}");

        send(&mut page, &request(id, &state));
        let frame = frame(&mut page);
        let findings = frame.header["findings"].to_string();
        assert_eq!(
            findings.contains("\"spread\""),
            !population.is_null(),
            "{findings}"
        );
        images.push(frame.image("sensor").unwrap());
    }
    for (i, image) in images.iter().enumerate() {
        assert!(!images[..i].contains(image), "image {i} equals an earlier one");
    }
}

#[test]
fn descriptions_for_robots_are_those_of_the_command() {
    let program = program();
    let server = server(&program);
    let catalog = server.get("/api/catalog");
    let formats = catalog["robotFormats"].as_array().unwrap();
    assert_eq!(formats.len(), 6);
    for format in formats {
        let name = format["name"].as_str().unwrap();
        let archive = export(&server, &state(), "robot", &json!({"format": name}));
        let mut archive = zip::ZipArchive::new(Cursor::new(archive)).unwrap();
        let mut files = BTreeMap::new();
        for index in 0..archive.len() {
            let mut file = archive.by_index(index).unwrap();
            let mut bytes = Vec::new();
            file.read_to_end(&mut bytes).unwrap();
            files.insert(file.name().to_owned(), bytes);
        }
        let written = program.good(&["export", "OAK4-D", "--to", name, "-o", name, "--json"]);
        let written: Value = serde_json::from_str(&written).unwrap();
        let paths = written["files"].as_array().unwrap();
        assert_eq!(files.len(), paths.len(), "{name}: {:?}", files.keys());
        for path in paths {
            let path = path.as_str().unwrap();
            let expected = std::fs::read(program.path(path)).unwrap();
            let inside = path.strip_prefix(&format!("{name}/")).unwrap();
            assert!(files[inside] == expected, "{path}");
        }
    }
    let request =
        json!({"what": "robot", "scene": "first", "state": state(), "size": null, "format": "urdff"});
    let (status, answer) = server.post("/api/export", request.to_string().as_bytes());
    assert_eq!((status, &answer["field"]), (422, &json!("format")), "{answer}");
}

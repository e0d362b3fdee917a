//! The units of mesh files, and the names of files in errors.

use serde_json::{Value, json};

use super::super::render::program;
use super::server;

#[test]
fn dropped_meshes_are_read_in_the_given_units() {
    let program = program();
    let server = server(&program);
    let mesh = std::fs::read(program.path("crate.obj")).unwrap();
    let read = |query: &str| server.post(&format!("/api/scenes?name=a.obj{query}"), &mesh);
    let size = |info: &Value| info["bounds"][1][0].as_f64().unwrap() - info["bounds"][0][0].as_f64().unwrap();
    let (_, metres) = read("");
    assert_eq!((&metres["scale"], &metres["up"]), (&json!(1.0), &json!("y")));
    let (_, inches) = read("&scale=0.0254&up=z");
    assert_eq!((&inches["scale"], &inches["up"]), (&json!(0.0254), &json!("z")));
    assert!((size(&inches) - 0.0254 * size(&metres)).abs() < 1e-9, "{inches}");
    assert_ne!(inches["id"], metres["id"]);
    assert_eq!(read("&scale=0.0254&up=z").1["id"], inches["id"]);
    for (query, field) in [("&scale=0", "scale"), ("&scale=-1", "scale"), ("&up=x", "up")] {
        let (status, answer) = read(query);
        assert_eq!(
            (status, &answer["field"]),
            (422, &json!(field)),
            "{query}: {answer}"
        );
    }
}

#[test]
fn units_of_the_command_line_need_a_scene() {
    let program = program();
    for (arguments, needle) in [
        (&["studio", "--scale", "0.001"][..], "SCENE"),
        (&["studio", "--up", "z"], "SCENE"),
        (
            &["studio", "crate.obj", "--scale", "0"],
            "--scale: must be a finite number > 0",
        ),
    ] {
        let ended = program.run(arguments);
        assert_eq!(ended.code, 2, "{arguments:?}: {}", ended.stderr);
        assert!(ended.stderr.contains(needle), "{arguments:?}: {}", ended.stderr);
    }
}

#[test]
fn errors_name_files_as_the_page_knows_them() {
    let program = program();
    let server = server(&program);
    let document = json!({
        "asset": {"version": "2.0"},
        "buffers": [{"uri": "points.bin", "byteLength": 36}],
    });
    let (status, answer) = server.post("/api/scenes?name=a.gltf", document.to_string().as_bytes());
    let error = answer["error"].as_str().unwrap();
    assert_eq!(status, 422, "{answer}");
    assert!(
        error.starts_with("a.gltf: ") && error.contains("points.bin"),
        "{error}"
    );
    assert!(!error.contains("oaktwin-studio-"), "{error}");
}

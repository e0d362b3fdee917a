//! Frames of trajectories and of animated scenes, and sessions that have them.

use serde_json::{Value, json};

use super::super::program::Program;
use super::super::render::program;
use super::client::{Server, state};
use super::exports::export;

/// A plate that moves away from the OAK and turns.
const STAGE: &str = r#"#usda 1.0
(
    metersPerUnit = 1
    upAxis = "Z"
    startTimeCode = 0
    endTimeCode = 20
    timeCodesPerSecond = 20
)
def Mesh "Plate"
{
    int[] faceVertexCounts = [4]
    int[] faceVertexIndices = [0, 1, 2, 3]
    point3f[] points = [(-2, 0, -2), (2, 0, -2), (2, 0, 2), (-2, 0, 2)]
    double3 xformOp:translate.timeSamples = { 0: (0, 0, 0.5), 20: (0, 2, 0.5) }
    float xformOp:rotateZ.timeSamples = { 0: 0, 20: 25 }
    uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:rotateZ"]
}
"#;

/// Poses 0.2 s apart along the x axis, with the rotation of the state.
fn path(state: &Value) -> String {
    let quaternion = state["pose"]["quaternion"].as_array().unwrap();
    let quaternion: Vec<String> = quaternion.iter().map(Value::to_string).collect();
    let line = |k: u32| format!("{} 0.{k} -2 0.5 {}\n", f64::from(k) / 5.0, quaternion.join(" "));
    (0..6).map(line).collect()
}

/// Runs the exported command, and returns it with the depth that it measures and the page's.
fn both(program: &Program, server: &Server, state: &Value, more: &Value) -> (String, Vec<u8>, Vec<u8>) {
    let mut image = json!({"format": "npy", "image": "sensor"});
    image
        .as_object_mut()
        .unwrap()
        .extend(more.as_object().cloned().unwrap());
    let shown = export(server, state, "image", &image);
    let command = String::from_utf8(export(server, state, "command", more)).unwrap();
    for line in command.lines().filter(|line| !line.starts_with('#')) {
        let words = line.strip_prefix("oaktwin ").unwrap().split(' ');
        program.good(&words.collect::<Vec<_>>());
    }
    let name = format!(
        "oak/depth_sensor_distance_{:04}.npy",
        state["frame"].as_u64().unwrap_or(0)
    );
    (command, std::fs::read(program.path(&name)).unwrap(), shown)
}

#[test]
fn frames_are_those_of_the_command() {
    let program = program();
    program.put("plate.usda", STAGE);
    let server = Server::start(&program, &["plate.usda"]);
    let animation = &server.get("/api/scenes/first")["animation"];
    let expected = json!({"first": 0.0, "last": 20.0, "codesPerSecond": 20.0, "step": 1.0});
    assert_eq!(*animation, expected);
    let mut own = state();
    // A plain surface has no texture.
    own["parameters"] = json!({"confidenceThreshold": "0"});
    let (_, _, opened) = both(&program, &server, &own, &json!({}));
    // The second time reuses the renderer of an earlier one.
    let mut seen = vec![opened];
    for code in ["12.0", "3.0", "7.0", "16.0"] {
        let at = json!({"scene": format!("first@{code}")});
        let (command, written, shown) = both(&program, &server, &own, &at);
        assert!(command.contains(&format!("--time {code} ")), "{command}");
        assert!(written == shown && !seen.contains(&shown), "{command}");
        seen.push(shown);
    }

    program.put("path.txt", path(&own));
    let (status, dropped) = server.post("/api/trajectories?name=path.txt", path(&own).as_bytes());
    assert_eq!(status, 200, "{dropped}");
    assert_eq!(
        server.get(&format!("/api/trajectories/{}", dropped["id"].as_str().unwrap())),
        dropped
    );
    for (frame, time) in [(3, None), (5, Some(20.0)), (2, Some(8.0))] {
        let mut moved = own.clone();
        (moved["pose"], moved["frame"]) = (dropped["poses"][frame].clone(), json!(frame));
        let mut more = json!({"trajectory": dropped["id"]});
        if let Some(time) = time {
            more["scene"] = json!(format!("first@{time:?}"));
            more["codes"] = json!([0.0, 4.0]);
        }
        let (command, written, shown) = both(&program, &server, &moved, &more);
        assert!(command.contains("--trajectory path.txt"), "{command}");
        assert!(written == shown && !seen.contains(&shown), "{command}");
        // The same place has other noise in another frame.
        moved["frame"] = json!(0);
        let mut image = more.clone();
        (image["format"], image["image"]) = (json!("npy"), json!("sensor"));
        assert!(export(&server, &moved, "image", &image) != shown, "frame {frame}");
        seen.push(shown);
    }
    let mut elsewhere = own;
    elsewhere["frame"] = json!(1);
    let request = json!({"what": "command", "scene": "first", "state": elsewhere, "size": null});
    let (status, answer) = server.post("/api/export", request.to_string().as_bytes());
    assert_eq!((status, &answer["field"]), (422, &json!("frame")), "{answer}");
    for scene in ["first@nan", "first@", "first@1e999"] {
        let request = json!({"what": "command", "scene": scene, "state": state(), "size": null});
        let (status, answer) = server.post("/api/export", request.to_string().as_bytes());
        assert_eq!((status, &answer["field"]), (422, &json!("time")), "{answer}");
    }
}

#[test]
fn a_session_has_an_animated_scene_and_its_trajectory() {
    let program = program();
    let server = Server::start(&program, &["crate.obj"]);
    let (_, scene) = server.post("/api/scenes?name=plate.usda", STAGE.as_bytes());
    let (_, dropped) = server.post("/api/trajectories?name=path.txt", path(&state()).as_bytes());
    let request = json!({"document": {"a": 1}, "display": {}, "scene": scene["id"], "calibrations": [], "trajectory": dropped["id"]});
    let (status, session) = server.request("POST", "/api/session/save", request.to_string().as_bytes());
    assert_eq!(status, 200, "{}", String::from_utf8_lossy(&session));
    drop(server);
    let server = Server::start(&program, &["crate.obj"]);
    let (status, opened) = server.post("/api/session/open?name=plate.oaktwin", &session);
    assert_eq!(status, 200, "{opened}");
    assert_eq!((&opened["scene"], &opened["trajectory"]), (&scene, &dropped));
    assert_eq!(opened["document"], json!({"a": 1}));
    let at = json!({"scene": format!("{}@12.0", scene["id"].as_str().unwrap()), "format": "npy", "image": "sensor"});
    assert!(!export(&server, &state(), "image", &at).is_empty());
    let (status, answer) = server.post(
        "/api/session/open?name=half.oaktwin",
        &session[..session.len() / 2],
    );
    let error = answer["error"].as_str().unwrap();
    assert!(
        status == 422 && error.starts_with("half.oaktwin: is not a session"),
        "{answer}"
    );
}

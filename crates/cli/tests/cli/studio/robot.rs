//! A robot in the scene of the page.

use serde_json::{Value, json};

use super::super::program::Program;
use super::super::render::program;
use super::client::{Server, state};

const ARM: &str = include_str!("../../../../../examples/robots/gripper.urdf");

/// A server whose scene has the robot, in front of the crate.
pub(super) fn server(program: &Program) -> Server {
    program.put("arm.urdf", ARM);
    let pose = [
        "0",
        "-1",
        "0",
        "0",
        "0",
        "0.7071067811865476",
        "0.7071067811865476",
    ];
    let start = ["crate.obj", "--up", "z", "--robot", "arm.urdf", "--robot-pose"];
    Server::start(program, &[&start[..], &pose].concat())
}

pub(super) fn posted(server: &Server, path: &str, request: &Value) -> Vec<u8> {
    let (status, body) = server.request("POST", path, request.to_string().as_bytes());
    assert_eq!(status, 200, "{path}: {}", String::from_utf8_lossy(&body));
    body
}

#[test]
fn the_exported_command_has_the_posture() {
    let program = program();
    let server = server(&program);
    let first = server.get("/api/scenes/first");
    let joints: Vec<&str> = (first["robot"]["joints"].as_array().unwrap().iter())
        .map(|joint| joint["name"].as_str().unwrap())
        .collect();
    assert_eq!(joints, ["turn", "shoulder", "elbow", "grip"]);
    let scene = "first~0.1,0.5,1.2,0.03";
    let posed = server.get(&format!("/api/scenes/{scene}"));
    assert_eq!(posed["robot"]["joints"][1]["position"], 0.5);
    assert_ne!(
        posed["robot"]["links"][4]["pose"],
        first["robot"]["links"][4]["pose"]
    );
    // Where the upper arm is depends on the posture; the crate is where it was.
    let bounds = |info: &Value, name: &str| -> Value {
        let objects = info["objects"].as_array().unwrap();
        let found = objects
            .iter()
            .find(|object| object["path"].as_str().unwrap().contains(name));
        found.unwrap()["bounds"].clone()
    };
    assert_ne!(bounds(&posed, "/arm/upper/"), bounds(&first, "/arm/upper/"));
    assert_eq!(bounds(&posed, "rate"), bounds(&first, "rate"));

    // The OAK is in the hand.
    let mut state = state();
    state["pose"] = posed["robot"]["links"][4]["pose"].clone();
    let export = |what: &str, scene: &str, more: &Value| {
        let mut request = json!({"what": what, "scene": scene, "state": state, "size": [160, 100]});
        request
            .as_object_mut()
            .unwrap()
            .extend(more.as_object().cloned().unwrap());
        posted(&server, "/api/export", &request)
    };
    let shown = export("image", scene, &json!({"format": "npy", "image": "depth"}));
    assert_ne!(
        shown,
        export("image", "first", &json!({"format": "npy", "image": "depth"}))
    );
    let command = String::from_utf8(export("command", scene, &json!({}))).unwrap();
    let (table, render) = command.trim().split_once('\n').unwrap();
    assert_eq!(
        table,
        "printf '%s\\n' turn,shoulder,elbow,grip 0.1,0.5,1.2,0.03 > posture.csv"
    );
    program.put("posture.csv", "turn,shoulder,elbow,grip\n0.1,0.5,1.2,0.03\n");
    program.good(
        &render
            .strip_prefix("oaktwin ")
            .unwrap()
            .split(' ')
            .collect::<Vec<_>>(),
    );
    let written = std::fs::read(program.path("oak/distance_to_image_plane_0000.npy")).unwrap();
    assert!(written == shown, "{command}");
}

#[test]
fn the_exported_command_has_a_trajectory_beside_the_robot() {
    let program = program();
    let server = server(&program);
    let mut state = state();
    let numbers = state["pose"]["quaternion"].as_array().unwrap().iter();
    let turn: Vec<String> = numbers.map(Value::to_string).collect();
    let path: String = (0..3)
        .map(|k| format!("{k} 0.{k} -2 0.5 {}\n", turn.join(" ")))
        .collect();
    program.put("path.txt", path.as_str());
    let (_, dropped) = server.post("/api/trajectories?name=path.txt", path.as_bytes());
    (state["pose"], state["frame"]) = (dropped["poses"][2].clone(), json!(2));
    let scene = "first~0.1,0.5,1.2,0.03";
    let request = |what: &str| {
        json!({"what": what, "scene": scene, "state": state, "size": [160, 100], "trajectory": dropped["id"],
               "format": if what == "image" { json!("npy") } else { Value::Null }, "image": "sensor"})
    };
    let shown = posted(&server, "/api/export", &request("image"));
    let command = String::from_utf8(posted(&server, "/api/export", &request("command"))).unwrap();
    let render = command
        .lines()
        .find(|line| line.starts_with("oaktwin render"))
        .unwrap();
    assert!(
        render.contains("--joints posture.csv") && render.contains("--trajectory path.txt"),
        "{command}"
    );
    program.put("posture.csv", "turn,shoulder,elbow,grip\n0.1,0.5,1.2,0.03\n");
    program.good(&render.split(' ').skip(1).collect::<Vec<_>>());
    let written = std::fs::read(program.path("oak/depth_sensor_distance_0002.npy")).unwrap();
    assert!(written == shown, "{command}");
}

#[test]
fn the_coverage_has_the_share_of_the_own_robot() {
    let program = program();
    let server = server(&program);
    let share = |scene: &str, pose: Option<&Value>| {
        let mut state = state();
        if let Some(pose) = pose {
            state["pose"] = pose.clone();
        }
        let region = json!({"minimum": [-9, -9, -9], "maximum": [9, 9, 9]});
        let asked = json!({"scene": scene, "states": [state], "region": region, "toleranceMm": null});
        let answer: Value = serde_json::from_slice(&posted(&server, "/api/coverage", &asked)).unwrap();
        assert_eq!(answer["together"]["ownRobot"], Value::Null);
        answer["poses"][0]["ownRobot"].as_f64().unwrap()
    };
    // From the edge of the hand, half of the view is its inside; from the room, the arm is small.
    let hand = server.get("/api/scenes/first")["robot"]["links"][4]["pose"].clone();
    let (near, far) = (share("first", Some(&hand)), share("first", None));
    assert!(near > 0.3 && far > 0.0 && far < near, "{near} {far}");
    assert_ne!(share("first~0,1.2,2.2,0", None), far);
}

#[test]
fn wrong_postures_and_robots_are_rejected() {
    let program = program();
    let server = server(&program);
    for (id, expected) in [
        (
            "first~0,0,3,0",
            "elbow is 3 rad, outside its limits; give 0.2 to 2.6 rad",
        ),
        ("first~0,0", "a posture of arm has 4 numbers"),
        ("first~0,0,nan,0", "a posture of arm has 4 numbers"),
    ] {
        let (status, body) = server.request("GET", &format!("/api/scenes/{id}"), &[]);
        let body = String::from_utf8(body).unwrap();
        assert!(status == 404 && body.contains(expected), "{id}: {status} {body}");
    }
    let (status, answer) = server.post("/api/robots?name=b.urdf&scene=first", ARM.as_bytes());
    assert_eq!(status, 422);
    assert!(
        answer["error"]
            .as_str()
            .unwrap()
            .contains("has a robot already, arm"),
        "{answer}"
    );

    let plain = Server::start(&program, &["crate.obj"]);
    let (status, info) = plain.post("/api/robots?name=b.urdf&scene=first", ARM.as_bytes());
    assert_eq!((status, &info["robot"]["name"]), (200, &json!("arm")), "{info}");
    for (text, expected) in [
        ("<robot/>".to_owned(), "no link is the base"),
        (
            ARM.replace("<box size=\"0.06 0.06 0.3\"/>", "<mesh filename = '/etc/a.stl'/>"),
            "names other files",
        ),
        (
            "<mujoco><include file='/etc/passwd'/></mujoco>".to_owned(),
            "names other files",
        ),
    ] {
        let (status, answer) = plain.post("/api/robots?name=b.urdf&scene=first", text.as_bytes());
        assert_eq!(status, 422, "{answer}");
        assert!(answer["error"].as_str().unwrap().contains(expected), "{answer}");
    }
}

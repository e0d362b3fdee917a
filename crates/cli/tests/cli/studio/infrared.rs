//! Reflectances in the infrared, which are a part of the scene's id.

use serde_json::{Value, json};

use super::super::program::Program;
use super::super::render::program;
use super::client::{Server, request, send, state, text};
use super::exports::export;

const ARM: &str = include_str!("../../../../../examples/robots/gripper.urdf");

/// A labelled plate that moves away from the OAK.
const STAGE: &str = r#"#usda 1.0
(
    metersPerUnit = 1
    upAxis = "Z"
    startTimeCode = 0
    endTimeCode = 20
    timeCodesPerSecond = 20
)
def Mesh "Plate" (
    prepend apiSchemas = ["SemanticsAPI:Semantics"]
)
{
    int[] faceVertexCounts = [4]
    int[] faceVertexIndices = [0, 1, 2, 3]
    point3f[] points = [(-2, 0, -2), (2, 0, -2), (2, 0, 2), (-2, 0, 2)]
    color3f[] primvars:displayColor = [(0.6, 0.6, 0.6)]
    string semantic:Semantics:params:semanticType = "class"
    string semantic:Semantics:params:semanticData = "wall"
    double3 xformOp:translate.timeSamples = { 0: (0, 0, 0.5), 20: (0, 2, 0.5) }
    uniform token[] xformOpOrder = ["xformOp:translate"]
}
"#;

/// An OAK with time of flight, whose noise depends on how much light returns.
fn own() -> Value {
    let mut own = state();
    (own["model"], own["sensor"]) = (json!("OAK-D-ToF"), json!("depth_tof"));
    (own["engine"], own["parameters"]) = (json!("time-of-flight"), json!({}));
    own
}

fn started(arguments: &[&str]) -> (Program, Server) {
    let program = program();
    program.put("plate.usda", STAGE);
    program.put("arm.urdf", ARM);
    let server = Server::start(&program, &[&["plate.usda"], arguments].concat());
    (program, server)
}

/// Runs the exported command, compares what it measures with the page, and returns it with the depth.
fn check(program: &Program, server: &Server, scene: &str) -> (String, Vec<u8>) {
    let at = |more: Value| {
        let mut all = json!({"scene": scene});
        let more = more.as_object().cloned().unwrap();
        all.as_object_mut().unwrap().extend(more);
        all
    };
    let shown = export(
        server,
        &own(),
        "image",
        &at(json!({"format": "npy", "image": "sensor"})),
    );
    let command = String::from_utf8(export(server, &own(), "command", &at(json!({})))).unwrap();
    program.put("posture.csv", "turn,shoulder,elbow,grip\n0.1,0.5,1.2,0.03\n");
    let render = command.lines().last().unwrap().strip_prefix("oaktwin ").unwrap();
    program.good(&render.split(' ').collect::<Vec<_>>());
    let written = std::fs::read(program.path("oak/depth_sensor_distance_0000.npy")).unwrap();
    assert!(written == shown, "{command}");
    (command, shown)
}

#[test]
fn frames_are_those_of_the_command_at_any_time() {
    let (program, server) = started(&[]);
    let first = server.get("/api/scenes/first");
    assert_eq!(first["infrared"], json!(["wall"]));
    let mut seen = Vec::new();
    for (scene, options) in [
        ("first", ""),
        ("first;wall=0.05", "--infrared wall=0.05"),
        ("first;wall=0.9", "--infrared wall=0.9"),
        ("first@12.0", "--time 12.0"),
        ("first;wall=0.05@12.0", "--infrared wall=0.05 --time 12.0"),
    ] {
        let (command, shown) = check(&program, &server, scene);
        assert!(command.contains(options), "{command}");
        assert!(!seen.contains(&shown), "{scene}");
        seen.push(shown);
    }
    let script = export(&server, &own(), "python", &json!({"scene": "first;wall=0.05"}));
    let script = String::from_utf8(script).unwrap();
    assert!(
        script.contains(r#"Scene.open("plate.usda", infrared={"wall": 0.05})"#),
        "{script}"
    );
    let info = server.get("/api/scenes/first%3Bwall%3D0.05");
    assert_eq!(info["id"], "first;wall=0.05");
    assert_eq!(info["animation"], first["animation"]);
}

#[test]
fn frames_are_those_of_the_command_with_a_robot_and_in_a_session() {
    let (program, server) = started(&["--robot", "arm.urdf"]);
    let scene = "first;wall=0.05~0.1,0.5,1.2,0.03";
    let (command, dark) = check(&program, &server, scene);
    assert!(
        command.contains("--infrared wall=0.05 --robot arm.urdf"),
        "{command}"
    );
    assert_ne!(dark, check(&program, &server, "first~0.1,0.5,1.2,0.03").1);
    // A list of postures stays the same one.
    let list = |scene: &str| {
        let path = format!("/api/motions?name=a.csv&scene={}", scene.replace(';', "%3B"));
        server.post(&path, b"turn\n0\n0.5\n").1["id"].clone()
    };
    assert_eq!(list(scene), list("first"));
    let saved = json!({"document": {"scene": scene}, "display": null, "scene": scene, "calibrations": [],
                       "trajectory": null, "motion": list(scene)});
    let (status, session) = server.request("POST", "/api/session/save", saved.to_string().as_bytes());
    assert_eq!(status, 200, "{}", String::from_utf8_lossy(&session));
    let other = Server::start(&program, &["plate.usda", "--robot", "arm.urdf"]);
    let (status, opened) = other.post("/api/session/open?name=a.oaktwin", &session);
    assert_eq!((status, &opened["scene"]["id"]), (200, &json!(scene)), "{opened}");
}

#[test]
fn a_dropped_robot_leaves_the_reflectances() {
    let (program, server) = started(&[]);
    let path = "/api/robots?name=arm.urdf&scene=first%3Bwall%3D0.05";
    let (status, placed) = server.post(path, ARM.as_bytes());
    let id = placed["id"].as_str().unwrap();
    assert_eq!(status, 200, "{placed}");
    assert!(id.ends_with("-first;wall=0.05"), "{id}");
    check(&program, &server, &format!("{id}~0.1,0.5,1.2,0.03"));
}

#[test]
fn wrong_names_and_values_are_rejected() {
    let (_program, server) = started(&[]);
    let mut page = server.page();
    for (id, (reflectance, expected)) in (1..).zip([
        (
            "wal=0.5",
            "plate.usda: --infrared wal: no material and no label has this name; did you mean 'wall'?",
        ),
        (
            "wall=2",
            "plate.usda: --infrared wall: a reflectance of 2 is out of range; give 0 to 1",
        ),
        (
            "wall=NaN",
            "plate.usda: --infrared wall: a reflectance of NaN is out of range; give 0 to 1",
        ),
        (
            "wall",
            "'wall' is not NAME=REFLECTANCE; open the page without its link",
        ),
    ]) {
        let path = format!("/api/scenes/first%3B{}", reflectance.replace('=', "%3D"));
        let (status, body) = server.request("GET", &path, &[]);
        let answer: Value = serde_json::from_slice(&body).unwrap();
        assert_eq!((status, answer["error"].as_str().unwrap()), (404, expected));
        let mut asked = request(id, &own());
        asked["scene"] = json!(format!("first;{reflectance}"));
        send(&mut page, &asked);
        let answer = text(&mut page);
        assert_eq!(answer["error"], expected, "{answer}");
    }
}

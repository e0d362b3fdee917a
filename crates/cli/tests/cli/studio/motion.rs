//! The coverage over the postures of a robot.

use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2};

use serde_json::{Value, json};

use super::super::program::Program;
use super::super::render::program;
use super::client::{Server, state};
use super::robot::{posted, server};

/// Looks to the crate, past it, and to its own base.
const LIST: &str = "shoulder_deg,elbow,grip\n10,1.6,0.04\n-20,1.5,0\n45,2.4,0.04\n";

/// The posture in which the page shows the robot.
const SHOULDER: f64 = 0.5;
const ELBOW: f64 = 1.2;

fn scene() -> String {
    format!("first~0,{SHOULDER},{ELBOW},0.03")
}

/// What is measured by an OAK on the hand, which looks along the gripper.
fn asked(server: &Server, motion: &Value) -> Value {
    let (scene, mut state) = (scene(), state());
    let hand = server.get(&format!("/api/scenes/{scene}"))["robot"]["links"][4]["pose"].clone();
    // The base faces y, and the joints turn about x.
    let (sin, cos) = (SHOULDER + ELBOW).sin_cos();
    let place = |axis: usize| hand["position"][axis].as_f64().unwrap();
    let (half_sin, half_cos) = ((SHOULDER + ELBOW - FRAC_PI_2) / 2.0).sin_cos();
    let quaternion = [-half_sin, half_sin, half_cos, half_cos].map(|number| number * FRAC_1_SQRT_2);
    state["pose"] = json!({
        "position": [place(0), place(1) + 0.05 * cos + 0.03 * sin, place(2) - 0.05 * sin + 0.03 * cos],
        "quaternion": quaternion,
    });
    state["parameters"] = json!({ "confidenceThreshold": "0" });
    let region = json!({"minimum": [-1, -1, -1], "maximum": [1, 1, 1]});
    json!({"scene": scene, "motion": motion["id"], "mount": "hand", "state": state, "region": region, "toleranceMm": 50})
}

fn dropped(server: &Server, scene: &str, list: &str) -> Value {
    let (status, motion) = server.post(
        &format!("/api/motions?name=poses.csv&scene={scene}"),
        list.as_bytes(),
    );
    assert_eq!(status, 200, "{motion}");
    motion
}

/// The lines of the answer.
fn lines(server: &Server, asked: &Value) -> Vec<Value> {
    let body = asked.to_string();
    // An answer to HTTP 1.0 is not divided into chunks.
    let head = format!(
        "POST /api/motions/coverage HTTP/1.0\r\nHost: 127.0.0.1:{}\r\nContent-Length: {}\r\n\r\n",
        server.port,
        body.len()
    );
    let (status, _, answer) = server.raw(&head, body.as_bytes());
    let text = String::from_utf8(answer).unwrap();
    assert_eq!(status, 200, "{text}");
    text.lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect()
}

/// Runs the command that the page exports, and returns the table that it writes.
fn table(program: &Program, server: &Server, asked: &Value) -> (String, String) {
    let command = String::from_utf8(posted(server, "/api/motions/command", asked)).unwrap();
    let run = command.lines().last().unwrap().strip_prefix("oaktwin ").unwrap();
    program.good(&run.split(' ').collect::<Vec<_>>());
    let table = std::fs::read_to_string(program.path("motion/coverage.csv")).unwrap();
    (command, table)
}

#[test]
fn the_page_and_the_command_measure_the_same_over_a_motion() {
    let program = program();
    let server = server(&program);
    program.put("poses.csv", LIST);
    let motion = dropped(&server, &scene(), LIST);
    assert_eq!(motion["atRest"], json!(["turn"]));
    assert_eq!(
        motion["postures"][1],
        json!([0.0, (-20.0_f64).to_radians(), 1.5, 0.0])
    );
    assert_eq!(
        server.get(&format!("/api/motions/{}", motion["id"].as_str().unwrap())),
        motion
    );

    let asked = asked(&server, &motion);
    let said = lines(&server, &asked);
    let (last, before) = said.split_last().unwrap();
    let progress = |done: u32| json!({"type": "progress", "done": done, "total": 3});
    assert_eq!(before, [0, 1, 2, 3].map(progress));
    let (command, table) = table(&program, &server, &asked);
    assert_eq!(last["csv"], table.as_str(), "{command}");
    assert!(
        command.starts_with(
            "printf '%s\\n' shoulder_deg,elbow,grip 10,1.6,0.04 -20,1.5,0 45,2.4,0.04 > poses.csv\n"
        ),
        "{command}"
    );

    // The page has the numbers of the table.
    let mut rows = table.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let header = rows.next().unwrap();
    let cell = |row: &[&str], name: &str| -> f64 {
        let place = header.iter().position(|column| *column == name).unwrap();
        row[place].parse().unwrap_or(0.0)
    };
    let all = rows.next().unwrap();
    assert_eq!(last["together"]["measured"], cell(&all, "measured"));
    let postures = last["postures"].as_array().unwrap();
    for (posture, row) in postures.iter().zip(rows) {
        assert_eq!(posture["seen"], cell(&row, "seen"));
        assert_eq!(posture["ownRobot"], cell(&row, "own_robot"));
        assert_eq!(posture["hiddenByRobot"], cell(&row, "hidden_by_robot"));
        let hidden = posture["hiddenByRobot"].as_f64().unwrap();
        assert!(hidden <= posture["lost"]["hidden"].as_f64().unwrap_or(0.0));
    }
    let together = last["together"]["seen"].as_f64().unwrap();
    let seen: Vec<f64> = postures
        .iter()
        .map(|posture| posture["seen"].as_f64().unwrap())
        .collect();
    assert!(
        seen.iter().all(|seen| *seen <= together) && together > 0.0,
        "{seen:?} {together}"
    );
    assert!(
        postures
            .iter()
            .any(|posture| posture["hiddenByRobot"].as_f64().unwrap() > 0.0),
        "{postures:?}"
    );

    // An OAK that stays in the room sees the robot move.
    let mut fixed = asked.clone();
    fixed["mount"] = Value::Null;
    fixed["state"]["pose"] = state()["pose"].clone();
    let said = lines(&server, &fixed);
    assert_eq!(
        said.last().unwrap()["csv"],
        self::table(&program, &server, &fixed).1.as_str()
    );
}

#[test]
fn lists_that_are_none_of_the_robots_postures_are_rejected() {
    let program = program();
    let server = server(&program);
    let many = format!("elbow\n{}", "1\n".repeat(1001));
    let long = format!("elbow\n{}", "1.000\n".repeat(1_000_000));
    for (list, expected) in [
        ("", "poses.csv: line 1: there are no positions"),
        ("elbow\n", "there are no positions"),
        ("ellbow\n1\n", "no joint 'ellbow' moves; did you mean 'elbow'"),
        (
            "elbow,grip\n1,0\n1\n",
            "poses.csv: line 3: 1 values, but 2 columns",
        ),
        ("elbow\nnan\n", "elbow: 'nan' is not a finite number"),
        (
            "elbow\n3\n",
            "elbow is 3 rad, outside its limits; give 0.2 to 2.6 rad",
        ),
        ("elbow\n\u{0}\n", "is not a finite number"),
        (
            &many,
            "has 1001 postures, more than the 1000 that the page measures; drop a part of it, or use `oaktwin coverage --joints`",
        ),
    ] {
        let (status, answer) = server.post("/api/motions?name=poses.csv&scene=first", list.as_bytes());
        let error = answer["error"].as_str().unwrap();
        assert!(status == 422 && error.contains(expected), "{status} {error}");
    }
    let (status, answer) = server.post("/api/motions?name=poses.csv&scene=first", long.as_bytes());
    assert_eq!(status, 413, "{answer}");
    assert!(
        answer["error"].as_str().unwrap().contains("drop a part of it"),
        "{answer}"
    );

    let motion = dropped(&server, "first", LIST);
    let good = asked(&server, &motion);
    for (key, value, expected) in [
        ("motion", json!("x"), "no list of postures 'x'"),
        ("mount", json!("foot"), "the robot has no link 'foot'"),
        ("region", json!({"object": "/Nothing"}), "/Nothing"),
        ("toleranceMm", json!(-1), "-1 mm is out of range"),
    ] {
        let mut wrong = good.clone();
        wrong[key] = value;
        let said = lines(&server, &wrong);
        let error = said.last().unwrap()["error"].as_str().unwrap();
        assert!(error.contains(expected), "{error}");
    }
    let plain = Server::start(&program, &["crate.obj"]);
    let (status, answer) = plain.post("/api/motions?name=poses.csv&scene=first", LIST.as_bytes());
    assert!(
        status == 422 && answer["error"].as_str().unwrap().contains("has no robot"),
        "{answer}"
    );
}

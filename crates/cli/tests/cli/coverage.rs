//! `coverage`: whole outputs, files, bad inputs, interruption.

use std::fmt::Write;

use crate::program::{EXAMPLE, Program};

const ROOM: &str = include_str!("fixtures/room.usda");
const CRATE: &str = include_str!("fixtures/crate.obj");

/// Of a textureless box, from two heights.
const BOX: &str = "coverage room.usda --region /World/Box --model oak4-d --resolution 320x200 --samples 1000 \
                   --param confidenceThreshold=0 --look-at 0 -2 1 0 0 0.25";

fn program() -> Program {
    let program = Program::new();
    program.put("room.usda", ROOM);
    program.put("crate.obj", CRATE);
    program
}

fn words(command: &str) -> Vec<&str> {
    let words = command.split_whitespace();
    words
        .map(|word| if word == "EXAMPLE" { EXAMPLE } else { word })
        .collect()
}

#[test]
fn the_ranking_of_two_heights() {
    let program = program();
    let heights = format!("{BOX} --height 0.25,1.5 --model oak-d-tof");
    let text = program.good(&words(&heights));
    insta::assert_snapshot!(text);
    let alone = format!("{heights} --threads 1");
    assert_eq!(program.good(&words(&alone)), text);
}

#[test]
fn the_sensor_of_a_stage_is_compared_without_a_model() {
    let program = program();
    let text = program.good(&words(
        "coverage room.usda --region-box -1 -1 0.1 1 1 1 --samples 500",
    ));
    // The camera in front of the box sees one of its four sides above 0.1 m and its top.
    assert!(text.contains("/Render/Depth"), "{text}");
    assert!(text.contains("in the scene"), "{text}");
    assert!(text.contains("within -1 -1 0.1 to 1 1 1 m"), "{text}");
    // Four sides of 0.5 m × 0.4 m and the top of 0.25 m².
    assert!(text.contains("1.050 m² of surface"), "{text}");
}

#[test]
fn files_contain_what_json_does() {
    let program = program();
    let arguments = format!("{BOX} --height 0.25:1:0.25 -o out --json");
    let json: serde_json::Value = serde_json::from_str(&program.good(&words(&arguments))).unwrap();
    let file = std::fs::read_to_string(program.path("out/coverage.json")).unwrap();
    let mut file: serde_json::Value = serde_json::from_str(&file).unwrap();
    file["files"] = json["files"].clone();
    assert_eq!(file, json);

    let candidates = json["candidates"].as_array().unwrap();
    assert_eq!(candidates.len(), 4);
    for candidate in candidates {
        let number = |name: &str| candidate[name].as_f64().unwrap();
        let lost: f64 = candidate["lost"]
            .as_object()
            .unwrap()
            .values()
            .filter_map(serde_json::Value::as_f64)
            .sum();
        assert!((number("measured") + lost - 1.0).abs() < 1e-9, "{candidate}");
        assert!(number("seen") >= number("measured"));
        assert_eq!(candidate["position_m"][2].as_f64(), Some(number("height_m")));
    }
    let csv = std::fs::read_to_string(program.path("out/coverage.csv")).unwrap();
    let lines: Vec<Vec<&str>> = csv.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!(lines.len(), 5);
    let measured = lines[0].iter().position(|name| *name == "measured").unwrap();
    let best = json["ranking"][0].as_u64().unwrap();
    let best = &candidates[usize::try_from(best).unwrap()];
    assert_eq!(lines[1][measured].parse::<f64>().ok(), best["measured"].as_f64());
    assert!(lines.iter().all(|line| line.len() == lines[0].len()));
    let picture = std::fs::read(program.path("out/coverage.png")).unwrap();
    assert!(picture.starts_with(b"\x89PNG"));
}

#[test]
fn a_report_compares_day_and_night() {
    let program = program();
    let command = "coverage room.usda --region /World/Box --model oak-d-tof --model oak-d-lite --resolution 160x100 --samples 300 \
                   --look-at 0 -2 1 0 0 0.25 --height 0.6,1.2 --report out";
    let text = program.good(&words(command));
    assert!(text.contains("By day") && text.contains("By night"), "{text}");
    let csv = std::fs::read_to_string(program.path("out/report.csv")).unwrap();
    let lines: Vec<Vec<&str>> = csv.lines().map(|line| line.split(',').collect()).collect();
    let column = |name: &str| lines[0].iter().position(|other| *other == name).unwrap();
    let measured = |light: &str, model: &str| {
        let rows = lines
            .iter()
            .filter(|line| line[0] == light && line[column("model")] == model);
        let shares: Vec<f64> = rows
            .map(|line| line[column("measured")].parse().unwrap())
            .collect();
        assert_eq!(shares.len(), 2, "{light} {model}: a row for each height");
        shares[0].max(shares[1])
    };
    // Time of flight has its own light; a passive pair sees nothing in the dark.
    assert_eq!(measured("day", "OAK-D ToF"), measured("night", "OAK-D ToF"));
    assert!(measured("night", "OAK-D ToF") > 0.3);
    assert!(measured("night", "OAK-D Lite") < 0.1);
    let html = std::fs::read_to_string(program.path("out/report.html")).unwrap();
    let pictures: Vec<&str> = html
        .split("src=\"")
        .skip(1)
        .filter_map(|rest| rest.split('"').next())
        .collect();
    assert_eq!(pictures.len(), 4, "each model in each light");
    for picture in pictures {
        let bytes = std::fs::read(program.path("out").join(picture)).unwrap();
        assert!(bytes.starts_with(b"\x89PNG"), "{picture}");
    }
    for option in ["--ambient 0.5", "--json", "-o other"] {
        let ended = program.run(&words(&format!("{command}2 {option}")));
        assert_eq!(ended.code, 2, "{option}");
        assert!(ended.stderr.contains("cannot be used with"), "{}", ended.stderr);
        assert!(!program.path("out2").exists(), "{option}");
    }
}

#[test]
fn poses_of_a_file_are_compared() {
    let program = program();
    program.put(
        "poses.txt",
        "0 0 -2 0.5 0 0 0.70710678 0.70710678\n1 0 -2 0.5 0 0 0 1\n",
    );
    let arguments = "coverage room.usda --region /World/Box --model oak4-d --resolution 320x200 --samples 500 --poses poses.txt --json";
    let json: serde_json::Value = serde_json::from_str(&program.good(&words(arguments))).unwrap();
    assert_eq!(json["ranking"], serde_json::json!([0, 1]));
    assert_eq!(json["candidates"][1]["lost"]["outside_view"], 1.0);
    assert_eq!(json["candidates"][0]["name"], "pose 0");
}

#[test]
fn invalid_requests_are_rejected() {
    let program = program();
    program.put("empty.txt", "");
    program.put("file", "");
    let many = "0 0 0 1 0 0 0 1\n".repeat(101);
    program.put("many.txt", many);
    let place = "--model oak4-d --look-at 0 -2 1 0 0 0.25";
    let runs = [
        format!("room.usda --region /World/Bax {place}"),
        format!("room.usda --region box {place}"),
        format!("room.usda --region /World/Left {place}"),
        format!("room.usda --region-box 5 5 5 6 6 6 {place}"),
        format!("room.usda --region-box 1 0 0 -1 1 1 {place}"),
        format!("room.usda --region-box 0 0 nan 1 1 1 {place}"),
        format!("room.usda --samples 0 {place}"),
        format!("room.usda --samples 2000000 {place}"),
        format!("room.usda --resolution 0x40 {place}"),
        format!("room.usda --sensor tof {place}"),
        format!("room.usda --engine time-of-flight {place}"),
        format!("room.usda --projector 1 {place}"),
        format!("room.usda {place} --height 1,x"),
        format!("room.usda {place} --height -inf"),
        format!("room.usda {place} --tilt 0:120:10"),
        format!("room.usda {place} --height 0:9999:1 --tilt 0:90:0.01"),
        format!("room.usda --calibration EXAMPLE --model oak-d-pro-poe {place}"),
        "room.usda --model oak4-d".to_owned(),
        "room.usda --model oak5 --pose 0 0 0 0 0 0 1".to_owned(),
        "room.usda --model oak4-d --pose 0 0 0 0 0 0 2".to_owned(),
        "room.usda --model oak4-d --look-at 0 0 1 0 0 1".to_owned(),
        "room.usda --model oak4-d --poses empty.txt".to_owned(),
        "room.usda --model oak4-d --poses many.txt --height 1:100:1".to_owned(),
        "room.usda --calibration EXAMPLE".to_owned(),
        "crate.obj".to_owned(),
        "no.usda".to_owned(),
        format!("room.usda {place} -o file"),
        format!("room.usda {place} -o file/folder"),
    ];
    let mut all = String::new();
    for run in runs {
        let arguments = format!("coverage {run}");
        let _ = write!(
            all,
            "$ oaktwin {arguments}\n{}",
            program.refused(&words(&arguments))
        );
    }
    insta::assert_snapshot!(all);
}

#[cfg(unix)]
#[test]
fn ctrl_c_keeps_the_complete_candidates() {
    let program = program();
    let arguments = format!("{BOX} --height 0.1:50:0.01 -o out --json");
    let start = std::time::Instant::now();
    let ended = program.interrupted(&words(&arguments), |_| start.elapsed().as_secs_f64() > 1.5);
    assert_eq!(ended.code, 130, "{}", ended.stderr);
    // On a busy machine, the candidate in flight may take longer than an interrupted program waits for.
    let Some(rest) = ended.stderr.strip_prefix("interrupted: ") else {
        return;
    };
    if rest.starts_with("unfinished") {
        return;
    }
    let complete: usize = rest.split(' ').next().unwrap().parse().unwrap();
    assert!(rest.contains(" of 4991 candidates are complete"), "{rest}");
    let json: serde_json::Value = serde_json::from_str(&ended.stdout).unwrap();
    assert_eq!(json["interrupted"], true);
    assert_eq!(json["candidates"].as_array().map(Vec::len), Some(complete));
    assert_eq!(program.path("out/coverage.csv").exists(), complete > 0);
}

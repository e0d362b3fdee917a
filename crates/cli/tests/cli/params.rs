//! `params`: the tables of parameters.

use crate::program::Program;

#[test]
fn the_groups_and_one_engine() {
    let program = Program::new();
    let mut all = String::new();
    for arguments in [
        &["params"][..],
        &["params", "stereo-noise"],
        &["params", "STEREO_NOISE", "--platform", "rvc4"],
        &["params", "time-of-flight", "--model", "oak-d-tof"],
    ] {
        all += &format!("$ oaktwin {}\n{}\n", arguments.join(" "), program.good(arguments));
    }
    insta::assert_snapshot!(all);
}

#[test]
fn json_has_every_parameter() {
    let program = Program::new();
    let all: serde_json::Value = serde_json::from_str(&program.good(&["params", "--json"])).unwrap();
    let groups = all.as_array().unwrap();
    let names: Vec<&str> = groups.iter().filter_map(|group| group["name"].as_str()).collect();
    assert!(
        names.starts_with(&["stereo-noise", "stereo-matching"]),
        "{names:?}"
    );
    let text = program.good(&["params", "imager", "--json"]);
    let imager: serde_json::Value = serde_json::from_str(&text).unwrap();
    let same = groups.iter().find(|group| group["name"] == "imager").unwrap();
    assert_eq!(&imager, same);
    insta::assert_snapshot!(text);
}

#[test]
fn wrong_names() {
    let program = Program::new();
    let mut all = String::new();
    for arguments in [
        &["params", "stereo-nose"][..],
        &["params", "kinect"],
        &["params", "imager", "--platform", "rvc3"],
        &["params", "stereo-noise", "--model", "oak4"],
    ] {
        let ended = program.run(arguments);
        assert_eq!((ended.code, ended.stdout.as_str()), (2, ""));
        all += &ended.stderr;
    }
    insta::assert_snapshot!(all);
}

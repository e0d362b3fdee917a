//! Snapshots of complete outputs.

use std::io::Read;
use std::process::Stdio;

use crate::program::{EXAMPLE, Program};

#[test]
fn help_of_every_command() {
    let program = Program::new();
    let mut all = String::new();
    for command in [
        &[][..],
        &["demo"],
        &["models"],
        &["show"],
        &["compare"],
        &["calibration", "show"],
        &["calibration", "export"],
        &["calibration", "import"],
        &["asset"],
        &["render"],
        &["sense"],
        &["stereo"],
        &["accuracy"],
        &["coverage"],
        &["check"],
    ] {
        let mut arguments = command.to_vec();
        arguments.push("--help");
        all += &format!(
            "$ oaktwin {}\n{}\n",
            arguments.join(" "),
            program.good(&arguments)
        );
    }
    insta::assert_snapshot!(all);
}

#[test]
fn models() {
    insta::assert_snapshot!(Program::new().good(&["models"]));
}

#[test]
fn show_a_model() {
    insta::assert_snapshot!(Program::new().good(&[
        "show",
        "OAK4-D Wide",
        "--provenance",
        "--lens",
        "fisheye"
    ]));
}

/// The lines about the inertial unit.
fn about_imu(program: &Program, arguments: &[&str]) -> String {
    let out = program.good(arguments);
    let lines = out
        .lines()
        .filter(|line| line.contains("IMU") || line.contains("imu"));
    format!(
        "$ oaktwin {}\n{}\n",
        arguments.join(" "),
        lines.collect::<Vec<_>>().join("\n")
    )
}

#[test]
fn the_axes_of_the_inertial_unit() {
    let program = Program::new();
    program.put(
        "unit.json",
        program.good(&["calibration", "export", "OAK4-D", "--to", "depthai"]),
    );
    let mut all = String::new();
    for arguments in [
        &["show", "OAK-D", "--provenance"][..],
        &["show", "OAK-D", "--imu-frame", "board-file"],
        &["show", "OAK-D LR"],
        &["show", "OAK-D Lite", "--imu-frame", "board-file"],
        &[
            "show",
            "OAK-D Pro PoE",
            "--calibration",
            EXAMPLE,
            "--imu-frame",
            "driver",
        ],
        &["calibration", "show", "unit.json"],
        &["calibration", "show", EXAMPLE],
    ] {
        all += &about_imu(&program, arguments).replace(EXAMPLE, "EXAMPLE");
    }
    insta::assert_snapshot!(all);
}

#[test]
fn show_a_unit() {
    insta::assert_snapshot!(Program::new().good(&["show", "oak d pro poe", "--calibration", EXAMPLE]));
}

#[test]
fn show_the_sensor_of_two_depths() {
    insta::assert_snapshot!(Program::new().good(&["show", "oak_d_tof"]));
}

#[test]
fn compare() {
    let program = Program::new();
    insta::assert_snapshot!(
        "compare_markdown",
        program.good(&["compare", "--format", "markdown"])
    );
    insta::assert_snapshot!("compare_text", program.good(&["compare", "oak4-d", "oak-d-tof"]));
}

#[test]
fn prints_valid_json() {
    let program = Program::new();
    for arguments in [
        &["models", "--json"][..],
        &["show", "oak4d", "--json"],
        &["compare", "--format", "json"],
        &["calibration", "show", EXAMPLE, "--json"],
        &["asset", "oak4d", "-o", "a.usd", "--json"],
        &["check", "a.usd", "--json"],
    ] {
        let text = program.good(arguments);
        serde_json::from_str::<serde_json::Value>(&text).expect("JSON");
    }
}

#[test]
fn calibration() {
    let program = Program::new();
    insta::assert_snapshot!(program.good(&["calibration", "show", EXAMPLE]));
}

#[test]
fn completions_and_manual_pages() {
    let program = Program::new();
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        assert!(
            program.good(&["completions", shell]).contains("calibration"),
            "{shell}"
        );
    }
    assert!(program.good(&["man"]).contains(".TH oaktwin"));
    assert!(program.good(&["man", "calibration", "export"]).contains("kalibr"));
    assert!(program.good(&["man", "render"]).contains("trajectory"));
    assert!(
        program
            .good(&["completions", "bash"])
            .contains("oaktwin__subcmd__render")
    );
}

#[test]
fn closed_pipe_is_not_an_error() {
    let program = Program::new();
    let mut child = program
        .command(&["compare"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let mut message = String::new();
    child.stderr.take().unwrap().read_to_string(&mut message).unwrap();
    assert_eq!((child.wait().unwrap().code(), message.as_str()), (Some(0), ""));
}

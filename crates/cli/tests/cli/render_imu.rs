//! `render --imu`: the samples of the inertial sensor along a trajectory.

use std::collections::BTreeMap;
use std::fs;

use crate::program::Program;

const CRATE: &str = include_str!("fixtures/crate.obj");

fn program() -> Program {
    let program = Program::new();
    program.put("crate.obj", CRATE);
    program.put(
        "path.txt",
        "10.5 0 -2 0.5 0 0 0.7071 0.7071\n10.75 0 -1.5 0.5 0 0 0.7071 0.7071\n",
    );
    program
}

const RENDER: [&str; 11] = [
    "render",
    "crate.obj",
    "--up",
    "z",
    "--resolution",
    "16x10",
    "--model",
    "oak-d-pro-poe",
    "--trajectory",
    "path.txt",
    "--imu",
];

fn run(program: &Program, more: &[&str]) -> String {
    program.good(&[&RENDER[..], more].concat())
}

fn csv(program: &Program, name: &str) -> String {
    fs::read_to_string(program.path(name)).unwrap()
}

/// The board file's axes are turned by a quarter about z: x is the driver's y.
#[test]
fn the_axes_of_samples_can_be_the_board_files() {
    let program = program();
    run(&program, &["driver.csv", "--seed", "1"]);
    run(
        &program,
        &["board.csv", "--seed", "1", "--imu-frame", "board-file"],
    );
    let mean = |name: &str| -> [f64; 3] {
        let text = csv(&program, name);
        let rows: Vec<Vec<f64>> = text
            .lines()
            .filter(|line| !line.starts_with('#'))
            .map(|line| line.split(',').skip(4).map(|n| n.parse().unwrap()).collect())
            .collect();
        [0, 1, 2].map(|axis| rows.iter().map(|row| row[axis]).sum::<f64>() / rows.len() as f64)
    };
    let (driver, board) = (mean("driver.csv"), mean("board.csv"));
    let expected = [driver[1], -driver[0], driver[2]];
    for (found, expected) in board.into_iter().zip(expected) {
        assert!((found - expected).abs() < 0.05, "{board:?} {driver:?}");
    }
    assert!(driver[0].abs() > 5.0, "{driver:?}");
}

#[test]
fn samples_are_those_of_the_motion() {
    let program = program();
    let said = run(&program, &["imu.csv", "--annotators", "distance_to_image_plane"]);
    assert!(
        said.contains("imu.csv  101 samples of the BNO086 at 400 Hz\n"),
        "{said}"
    );
    let text = csv(&program, "imu.csv");
    let rows: Vec<Vec<f64>> = text
        .lines()
        .skip(1)
        .map(|line| line.split(',').map(|word| word.parse().unwrap()).collect())
        .collect();
    assert_eq!(rows.len(), 101);
    assert_eq!((rows[0][0], rows[100][0]), (10.5e9, 10.75e9));
    // Straight ahead at constant speed: gravity alone, along x of the sensor.
    let mean = |column: usize| rows.iter().map(|row| row[column]).sum::<f64>() / 101.0;
    for (column, expected) in [(1, 0.0), (2, 0.0), (3, 0.0), (4, 9.806_65), (5, 0.0), (6, 0.0)] {
        assert!(
            (mean(column) - expected).abs() < 0.03,
            "{column}: {}",
            mean(column)
        );
    }
}

#[test]
fn a_euroc_sequence_has_cameras_poses_and_samples() {
    let program = program();
    let imu = "seq/000000/mav0/imu0/data.csv";
    run(&program, &[imu, "--writer", "euroc", "-o", "seq"]);
    let rows = |name: &str| csv(&program, name).lines().count() - 1;
    assert_eq!(rows(imu), 101);
    // The samples begin with the images.
    assert!(
        csv(&program, imu)
            .lines()
            .nth(1)
            .unwrap()
            .starts_with("1500000010500000000,")
    );
    for name in ["cam0/data.csv", "state_groundtruth_estimate0/data.csv"] {
        let name = format!("seq/000000/mav0/{name}");
        assert_eq!(rows(&name), 2);
        let times: Vec<String> = csv(&program, &name)
            .lines()
            .skip(1)
            .map(|line| line.split(',').next().unwrap().to_owned())
            .collect();
        assert_eq!(times, ["1500000010500000000", "1500000010750000000"], "{name}");
    }
    assert!(
        program
            .path("seq/000000/mav0/cam0/data/1500000010750000000.png")
            .exists()
    );
    assert!(
        program
            .path("seq/000000/mav0/depth0/data/1500000010750000000.png")
            .exists()
    );
    assert!(csv(&program, "seq/000000/mav0/cam0/sensor.yaml").ends_with("rate_hz: 4.000000\n"));
}

#[test]
fn samples_depend_on_seed_rate_and_part_only() {
    let program = program();
    let depth = ["--annotators", "distance_to_image_plane"];
    run(&program, &[&["a.csv"][..], &depth].concat());
    run(
        &program,
        &[
            "b.csv",
            "--annotators",
            "rgb,depth_sensor_distance",
            "--camera",
            "depth",
        ],
    );
    run(&program, &[&["c.csv", "--seed", "1"][..], &depth].concat());
    let said = run(
        &program,
        &[&["d.csv", "--imu-part", "bmi270", "--imu-rate", "50"][..], &depth].concat(),
    );
    assert!(
        said.contains("d.csv  13 samples of the BMI270 at 50 Hz"),
        "{said}"
    );
    assert_eq!(csv(&program, "a.csv"), csv(&program, "b.csv"));
    assert_ne!(csv(&program, "a.csv"), csv(&program, "c.csv"));
    // The seed alone requests no depth sensor.
    let json = run(&program, &["e.csv", "--seed", "1", "--json"]);
    assert_eq!(csv(&program, "c.csv"), csv(&program, "e.csv"));
    let report: serde_json::Value = serde_json::from_str(&json).unwrap();
    assert_eq!(report["imu"]["samples"], 101);
    assert_eq!(report["imu"]["part"], "BNO086");
    assert!(report["cameras"][0].get("depth_sensor").is_none(), "{json}");
}

#[test]
fn recordings_have_the_samples_before_their_frames() {
    let program = program();
    run(&program, &["imu.csv", "--record", "a.mcap"]);
    let file = fs::read(program.path("a.mcap")).unwrap();
    let (mut counts, mut times) = (BTreeMap::<String, usize>::new(), Vec::new());
    for message in mcap::MessageStream::new(&file).unwrap() {
        let message = message.unwrap();
        *counts.entry(message.channel.topic.clone()).or_default() += 1;
        times.push(message.log_time);
        if message.channel.topic == "/imu/data_raw" {
            let schema = message.channel.schema.as_ref().unwrap();
            assert_eq!(schema.name, "sensor_msgs/msg/Imu");
        }
    }
    assert_eq!(counts["/imu/data_raw"], 101);
    assert!(times.is_sorted(), "samples and frames are interleaved");
}

#[test]
fn invalid_requests_are_rejected() {
    let program = program();
    program.put("one.txt", "0 0 0 0 0 0 0 1\n");
    program.put("twice.txt", "0 0 0 0 0 0 0 1\n1 0 0 0 0 0 0 1\n1 1 0 0 0 0 0 1\n");
    program.put("back.txt", "0 0 0 0 0 0 0 1\n-1 0 0 0 0 0 0 1\n");
    program.put("zero.txt", "0 0 0 0 0 0 0 1\n1 0 0 0 0 0 0 0\n");
    program.put("ages.txt", "0 0 0 0 0 0 0 1\n1700000000 0 0 0 0 0 0 1\n");
    program.put(
        "untimed.json",
        r#"[{"position": [0, 0, 0], "orientation": [0, 0, 0, 1]}, {"position": [0, 0, 0], "orientation": [0, 0, 0, 1]}]"#,
    );
    let oak = ["render", "crate.obj", "--model", "oak4-d"];
    let mut all = String::new();
    for more in [
        &["--look-at", "1", "0", "0", "0", "0", "0", "--imu", "imu.csv"][..],
        &["--trajectory", "one.txt", "--imu", "imu.csv"],
        &["--trajectory", "twice.txt", "--imu", "imu.csv"],
        &["--trajectory", "back.txt", "--imu", "imu.csv"],
        &["--trajectory", "zero.txt", "--imu", "imu.csv"],
        &["--trajectory", "ages.txt", "--imu", "imu.csv"],
        &["--trajectory", "untimed.json", "--imu", "imu.csv"],
        &["--trajectory", "path.txt", "--imu", "imu.csv", "--imu-rate", "0"],
        &["--trajectory", "path.txt", "--imu", "imu.csv", "--imu-rate", "-5"],
        &[
            "--trajectory",
            "path.txt",
            "--imu",
            "imu.csv",
            "--imu-rate",
            "nan",
        ],
        &[
            "--trajectory",
            "path.txt",
            "--imu",
            "imu.csv",
            "--imu-part",
            "BMI27",
        ],
        &["--trajectory", "path.txt", "--imu", "no/imu.csv"],
        &["--trajectory", "path.txt", "--imu", "."],
        &["--trajectory", "path.txt", "--imu", "path.txt"],
    ] {
        let said = program.refused(&[&oak[..], more].concat());
        all += &format!("{}\n{said}\n", more.join(" "));
    }
    assert!(!program.path("imu.csv").exists());
    insta::assert_snapshot!(all);
}

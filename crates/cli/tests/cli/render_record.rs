//! `render --record`: what is in the file, what is refused, what is left behind.

use std::collections::BTreeMap;
use std::fs;

use crate::program::Program;

const ROOM: &str = include_str!("fixtures/room.usda");
const CRATE: &str = include_str!("fixtures/crate.obj");

const OAK: [&str; 5] = ["render", "crate.obj", "--model", "oak4-d", "--trajectory"];

fn program() -> Program {
    let program = Program::new();
    program.put("room.usda", ROOM);
    program.put("crate.obj", CRATE);
    program.put(
        "path.txt",
        "10.5 0 -2 0.5 0 0 0.7071 0.7071\n10.75 0 -1.5 0.5 0 0 0.7071 0.7071\n",
    );
    program.put("undone.txt", "0 0 -2 0.5 0 0 0 1\n-1 0 -2 0.5 0 0 0 1\n");
    program
}

/// Returns the number of messages of each topic, and all times.
fn messages(program: &Program, name: &str) -> (BTreeMap<String, usize>, Vec<u64>) {
    let file = fs::read(program.path(name)).unwrap();
    let (mut counts, mut times) = (BTreeMap::new(), Vec::new());
    for message in mcap::MessageStream::new(&file).unwrap() {
        let message = message.unwrap();
        *counts.entry(message.channel.topic.clone()).or_default() += 1;
        times.push(message.log_time);
    }
    times.dedup();
    (counts, times)
}

fn counts<const N: usize>(expected: [(&str, usize); N]) -> BTreeMap<String, usize> {
    expected.map(|(topic, count)| (topic.to_owned(), count)).into()
}

#[test]
fn a_trajectory_of_an_oak() {
    let program = program();
    let more = |file| {
        let annotators = "rgb,pointcloud,depth_sensor_distance";
        let own = [
            "path.txt",
            "--resolution",
            "64x40",
            "--annotators",
            annotators,
            "--record",
            file,
            "--engine",
            "single-view",
        ];
        [&OAK[..], &own].concat()
    };
    let said = program.good(&more("a.mcap"));
    let bytes = fs::metadata(program.path("a.mcap")).unwrap().len();
    assert_eq!(
        said,
        format!("OAK4-D/Camera_pseudo_depth, 64x40, 2 frames\na.mcap  {bytes} bytes\n")
    );
    let expected = counts([
        ("/Camera_pseudo_depth/camera_info", 2),
        ("/Camera_pseudo_depth/depth", 2),
        ("/Camera_pseudo_depth/depth_points", 2),
        ("/Camera_pseudo_depth/measured", 2),
        // Isaac Sim's sensor sees from its left imager.
        ("/Camera_pseudo_depth/measured_camera_info", 2),
        ("/Camera_pseudo_depth/measured_points", 2),
        ("/Camera_pseudo_depth/rgb", 2),
        ("/tf", 2),
        ("/tf_static", 1),
    ]);
    assert_eq!(
        messages(&program, "a.mcap"),
        (expected, vec![10_500_000_000, 10_750_000_000])
    );
    assert_eq!(
        program.names(),
        ["a.mcap", "crate.obj", "path.txt", "room.usda", "undone.txt"]
    );
    program.good(&more("b.mcap"));
    let read = |name: &str| fs::read(program.path(name)).unwrap();
    assert!(read("a.mcap") == read("b.mcap"), "the same bytes");
}

#[test]
fn several_cameras_beside_a_folder() {
    let program = program();
    let run = [
        &OAK[..4],
        &[
            "--camera",
            "left",
            "--camera",
            "right",
            "--resolution",
            "64x40",
            "--annotators",
        ],
        &[
            "distance_to_image_plane,normals",
            "--look-at",
            "0",
            "-2",
            "0.5",
            "0",
            "0",
            "0",
        ],
        &["--record", "a.mcap", "-o", "out", "--json"],
    ]
    .concat();
    let report: serde_json::Value = serde_json::from_str(&program.good(&run)).unwrap();
    assert_eq!(report["recording"]["path"], "a.mcap");
    assert_eq!(report["output"], "out");
    assert_eq!(report["findings"][0]["code"], "not-recorded");
    let names: Vec<&str> = report["cameras"]
        .as_array()
        .unwrap()
        .iter()
        .map(|camera| camera["folder"].as_str().unwrap().rsplit_once('/').unwrap().1)
        .collect();
    let topics = [
        (format!("/{}/camera_info", names[0]), 1),
        (format!("/{}/camera_info", names[1]), 1),
        (format!("/{}/depth", names[0]), 1),
        (format!("/{}/depth", names[1]), 1),
        ("/tf".to_owned(), 1),
        ("/tf_static".to_owned(), 1),
    ];
    assert_eq!(messages(&program, "a.mcap").0, BTreeMap::from(topics));
    assert_eq!(report["files"].as_array().unwrap().len(), 1 + 2 * 2);
}

#[test]
fn a_camera_of_the_scene_without_a_folder() {
    let program = program();
    let run = [
        "render",
        "room.usda",
        "--camera",
        "/World/Left",
        "--record",
        "a.mcap",
        "--json",
    ];
    let ended = program.run(&run);
    let report: serde_json::Value =
        serde_json::from_str(&ended.stdout).unwrap_or_else(|_| panic!("{}", ended.stderr));
    assert_eq!(report["output"], serde_json::Value::Null);
    assert_eq!(report["cameras"][0]["folder"], serde_json::Value::Null);
    let (counts, times) = messages(&program, "a.mcap");
    assert_eq!(times, [0]);
    assert_eq!(counts["/Left/rgb"], 1);
}

#[test]
fn invalid_requests_are_rejected() {
    let program = program();
    fs::create_dir(program.path("folder.mcap")).unwrap();
    let mut all = String::new();
    let mut try_out = |arguments: &[&str]| {
        all += &format!(
            "$ oaktwin {}\n{}",
            arguments.join(" "),
            program.refused(arguments)
        );
    };
    let room = ["render", "room.usda", "--record"];
    for name in ["a.bag", "a", "no/a.mcap", "folder.mcap", "room.usda/a.mcap"] {
        try_out(&[&room[..], &[name]].concat());
    }
    try_out(&[&room[..], &["a.mcap", "--png16"]].concat());
    try_out(&[&room[..], &["a.mcap", "--annotators", "rgb,normals", "--strict"]].concat());
    try_out(&[&OAK[..], &["undone.txt", "--record", "a.mcap"]].concat());
    insta::assert_snapshot!(all);
}

#[test]
fn rrd_names_the_format_to_use() {
    let refused = program().refused(&["render", "room.usda", "--record", "a.rrd"]);
    assert_eq!(
        refused,
        "error: a.rrd: the format of Rerun is not written; name an .mcap file, which Rerun opens too\n"
    );
}

#[cfg(target_os = "linux")]
#[test]
fn a_recording_that_becomes_too_large_leaves_nothing() {
    let program = program();
    let before = program.names();
    let ended = program.run_with_small_files(&["render", "room.usda", "--record", "a.mcap"]);
    let message = ended.stderr;
    assert_eq!(ended.code, 2, "{message}");
    assert!(
        message.starts_with("error: a.mcap: ") && message.lines().count() == 1,
        "{message}"
    );
    assert_eq!(program.names(), before);
}

#[cfg(unix)]
#[test]
fn ctrl_c_leaves_nothing() {
    let program = program();
    program.put("long.txt", "0 -2 0 0.5 0 0 0 1\n".repeat(20_000));
    let before = program.names();
    let begun = |program: &Program| {
        let is_begun = |name: &String| {
            name.ends_with(".part") && fs::metadata(program.path(name)).is_ok_and(|file| file.len() > 0)
        };
        program.names().iter().any(is_begun)
    };
    let arguments = [
        &OAK[..],
        &["long.txt", "--record", "a.mcap", "--resolution", "64x40"],
    ]
    .concat();
    let ended = program.interrupted(&arguments, begun);
    let message = ended.stderr;
    assert_eq!(ended.code, 130, "{message}");
    // The second, if the machine is so busy that the frame in flight takes longer than an interrupted program waits for.
    let messages = [
        "interrupted: a.mcap was not written\n",
        "interrupted: unfinished files were removed\n",
    ];
    assert!(
        messages.iter().any(|expected| message.starts_with(expected)),
        "{message}"
    );
    assert_eq!(program.names(), before);
}

//! `coverage` and `render` with a robot in the scene.

use std::fmt::Write;

use crate::program::Program;

const ROOM: &str = include_str!("fixtures/room.usda");
const ARM: &str = include_str!("../../../../examples/robots/gripper.urdf");

/// Two looks at the box, and one past it.
const POSES: &str = "shoulder,elbow,grip\n0.3,1.6,0.04\n-0.2,1.5,0\n-0.6,2.2,0.04\n";

const COVERAGE: &str = "coverage room.usda --region /World/Box --robot arm.urdf --joints poses.csv \
                        --robot-pose -1.2 0 0.2 0 0 0 1 --mount hand --model oak-d-sr --resolution 160x100 --samples 500 \
                        --param confidenceThreshold=0 --pose 0.05 0 0.03 0 -0.7071067811865476 0 0.7071067811865476";

/// An OAK that passes by the box and looks at it.
const PATH: &str = "0 -1.2 0 0.4 0 0 0 1\n0.1 -1.2 0.05 0.4 0 0 0 1\n";

fn program() -> Program {
    let program = Program::new();
    program.put("room.usda", ROOM);
    program.put("arm.urdf", ARM);
    program.put("poses.csv", POSES);
    program
}

fn words(command: &str) -> Vec<&str> {
    command.split_whitespace().collect()
}

#[test]
fn coverage_over_a_motion() {
    let program = program();
    let text = program.good(&words(&format!("{COVERAGE} -o out")));
    insta::assert_snapshot!(text);
    insta::assert_snapshot!(
        "the_table_of_a_motion",
        std::fs::read_to_string(program.path("out/coverage.csv")).unwrap()
    );
    for picture in ["out/coverage.png", "out/own_robot.png"] {
        assert!(program.path(picture).is_file(), "{picture}");
    }
}

#[test]
fn the_robot_is_in_its_own_way() {
    let program = program();
    let measured = |command: &str| -> serde_json::Value {
        serde_json::from_str(&program.good(&words(&format!("{command} --json")))).unwrap()
    };
    let with = measured(COVERAGE);
    let postures = with["mounts"][0]["postures"].as_array().unwrap();
    assert_eq!(postures.len(), 3);
    let own = |posture: usize| &postures[posture]["own_robot"];
    for posture in 0..3 {
        let links = own(posture)["links"].as_array().unwrap();
        let sum: f64 = links.iter().map(|link| link[1].as_f64().unwrap()).sum();
        assert!((sum - own(posture)["share"].as_f64().unwrap()).abs() < 1e-12);
    }
    // The open fingers are in the image of every posture.
    assert!(own(0)["links"].to_string().contains("left_finger"), "{}", own(0));
    // Without shapes, nothing is in the way.
    let bare: String = ARM.lines().filter(|line| !line.contains("<visual>")).collect();
    program.put("bare.urdf", bare);
    let without = measured(&COVERAGE.replace("arm.urdf", "bare.urdf"));
    for posture in without["mounts"][0]["postures"].as_array().unwrap() {
        assert_eq!(
            posture["own_robot"],
            serde_json::json!({"share": 0.0, "links": [], "hides": 0.0})
        );
        assert_eq!(posture["occluders"], serde_json::json!([]));
    }
    let seen = |coverage: &serde_json::Value| coverage["mounts"][0]["together"]["seen"].as_f64().unwrap();
    assert!(seen(&with) <= seen(&without));
    // All postures together measure at least what the best one does.
    let together = with["mounts"][0]["together"]["measured"].as_f64().unwrap();
    for posture in postures {
        assert!(posture["measured"].as_f64().unwrap() <= together);
    }
}

#[test]
fn mounts_are_ranked_over_the_motion() {
    let program = program();
    let mounts = "0 0.05 0 0.03 0 -0.7071067811865476 0 0.7071067811865476\n\
                  0 -0.05 0 0.03 0 0.7071067811865476 0 0.7071067811865476\n";
    program.put("mounts.txt", mounts);
    let (base, _) = COVERAGE.split_once(" --pose").unwrap();
    let said = program.good(&words(&format!("{base} --poses mounts.txt --json")));
    let json: serde_json::Value = serde_json::from_str(&said).unwrap();
    assert_eq!(json["mounts"].as_array().unwrap().len(), 2);
    // The second one looks backwards.
    assert_eq!(json["ranking"], serde_json::json!([0, 1]));
    assert_eq!(json["mounts"][1]["together"]["lost"]["outside_view"], 1.0);
}

#[test]
fn a_frame_for_each_posture() {
    let program = program();
    let render = "render room.usda --robot arm.urdf --robot-pose -1.2 0 0.2 0 0 0 1 --mount hand --model oak-d-sr \
                  --pose 0.05 0 0.03 0 -0.7071067811865476 0 0.7071067811865476 --camera left --resolution 160x100 \
                  --annotators distance_to_image_plane,camera_params,instance_id_segmentation";
    program.good(&words(&format!("{render} --joints poses.csv -o all")));
    program.put("last.csv", "elbow,grip,shoulder\n2.2,0.04,-0.6\n");
    program.good(&words(&format!("{render} --joints last.csv -o last")));
    let read = |path: &str| std::fs::read(program.path(path)).unwrap();
    for file in ["distance_to_image_plane_NUMBER.npy", "camera_params_NUMBER.json"] {
        let of = |number: &str| file.replace("NUMBER", number);
        assert_eq!(
            read(&format!("all/{}", of("0002"))),
            read(&format!("last/{}", of("0000"))),
            "{file}"
        );
        assert_ne!(
            read(&format!("all/{}", of("0000"))),
            read(&format!("all/{}", of("0001")))
        );
    }
    let labels = String::from_utf8(read("all/instance_id_segmentation_mapping_0000.json")).unwrap();
    assert!(labels.contains("/arm/left_finger/visual_0"), "{labels}");
}

#[test]
fn the_robot_stands_still_along_a_trajectory() {
    let program = program();
    program.put("path.txt", PATH);
    program.put("one.csv", "shoulder,elbow,grip\n0.3,1.6,0.04\n");
    let render = "render room.usda --robot arm.urdf --robot-pose -0.5 0 0.2 0 0 0 1 --joints one.csv --model oak-d-sr \
                  --camera left --resolution 160x100 --annotators distance_to_image_plane,instance_id_segmentation";
    program.good(&words(&format!("{render} --trajectory path.txt -o along")));
    program.good(&words(&format!(
        "{render} --pose -1.2 0.05 0.4 0 0 0 1 -o second"
    )));
    let read = |path: &str| std::fs::read(program.path(path)).unwrap();
    let frame =
        |folder: &str, number: u32| read(&format!("{folder}/distance_to_image_plane_{number:04}.npy"));
    assert_eq!(frame("along", 1), frame("second", 0));
    assert_ne!(frame("along", 0), frame("along", 1));
    let labels = String::from_utf8(read("along/instance_id_segmentation_mapping_0001.json")).unwrap();
    assert!(labels.contains("/arm/upper/visual_0"), "{labels}");
}

#[test]
fn invalid_requests_are_rejected() {
    let program = program();
    program.put("empty.csv", "");
    program.put("unknown.csv", "shoulder,elbw\n0,1\n");
    program.put("limits.csv", "shoulder,elbow\n0,1\n0,3\n");
    program.put("ragged.csv", "shoulder,elbow\n0,1\n0\n");
    program.put("nan.csv", "shoulder\nnan\n");
    program.put("path.txt", PATH);
    program.put("broken.urdf", "<robot><link name='a'/></robot");
    program.put(
        "mesh.urdf",
        ARM.replace(
            "<box size=\"0.06 0.06 0.3\"/>",
            "<mesh filename=\"meshes/upper.stl\"/>",
        ),
    );
    let place = "--robot arm.urdf --mount hand --model oak4-d";
    let runs = [
        format!("coverage room.usda {place} --joints empty.csv"),
        format!("coverage room.usda {place} --joints unknown.csv"),
        format!("coverage room.usda {place} --joints limits.csv"),
        format!("coverage room.usda {place} --joints ragged.csv"),
        format!("coverage room.usda {place} --joints nan.csv"),
        format!("coverage room.usda {place} --joints no.csv"),
        format!("coverage room.usda {place} --region /arm/base"),
        "coverage room.usda --robot arm.urdf --mount hnd --model oak4-d".to_owned(),
        "coverage room.usda --robot broken.urdf --mount hand --model oak4-d".to_owned(),
        "coverage room.usda --robot mesh.urdf --mount hand --model oak4-d".to_owned(),
        "coverage room.usda --robot no.urdf --mount hand --model oak4-d".to_owned(),
        "coverage room.usda --robot room.usda --mount hand --model oak4-d".to_owned(),
        format!("coverage room.usda {place} --robot-pose 0 0 0 0 0 0 2"),
        format!("render room.usda {place} --trajectory path.txt"),
        "render room.usda --robot arm.urdf --joints poses.csv --model oak4-d --trajectory path.txt"
            .to_owned(),
        format!("render room.usda {place} --frames 0:10"),
    ];
    let mut all = String::new();
    for run in runs {
        let _ = write!(all, "$ oaktwin {run}\n{}", program.refused(&words(&run)));
    }
    insta::assert_snapshot!(all);
}

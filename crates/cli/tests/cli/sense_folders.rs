//! `oaktwin sense` on folders of frames.

use std::fs;

use super::sense::{array, depth, read};
use crate::program::Program;

/// `sense` on rendered ground truth writes what `render` writes.
#[test]
fn a_folder_of_ours_gains_what_render_would_have_written() {
    let program = Program::new();
    program.put("room.usda", include_str!("fixtures/room.usda"));
    let oak = [
        "--model",
        "oak-d-pro-poe",
        "--look-at",
        "-2",
        "0",
        "1",
        "0",
        "0",
        "0",
        "--resolution",
        "160x100",
        "--engine",
        "single-view",
    ];
    let render = |output: &str, annotators: &str| {
        let arguments = ["render", "room.usda", "-o", output, "--annotators", annotators];
        program.good(&[&arguments, &oak[..]].concat());
    };
    render("truth", "rgb,distance_to_image_plane,camera_params");
    render(
        "sensed",
        "depth_sensor_distance,depth_sensor_point_cloud_position,depth_sensor_imager",
    );
    let printed = program.good(&[
        "sense",
        "truth",
        "--model",
        "oak-d-pro-poe",
        "--engine",
        "single-view",
        "--outputs",
        "depth_sensor_point_cloud_position,depth_sensor_imager",
    ]);
    insta::assert_snapshot!(printed);
    for name in ["depth_sensor_distance_0000.npy", "depth_sensor_imager_0000.npy"] {
        let (ours, renders) = (
            program.path("truth").join(name),
            program.path("sensed").join(name),
        );
        assert!(fs::read(ours).unwrap() == fs::read(renders).unwrap(), "{name}");
    }
    // Range is z along the rays of the folder's camera, up to rounding.
    render("range", "rgb,distance_to_camera,camera_params");
    program.good(&["sense", "range", "--model", "oak-d-pro-poe"]);
    program.good(&["sense", "truth", "--model", "oak-d-pro-poe", "-o", "z"]);
    let (a, b) = (
        read(&program, "range/depth_sensor_distance_0000.npy").1,
        read(&program, "z/depth_sensor_distance_0000.npy").1,
    );
    let differ = a
        .iter()
        .zip(&b)
        .filter(|(a, b)| (**a - **b).abs() > 0.02 * **b)
        .count();
    assert!(differ < a.len() / 200, "{differ} of {}", a.len());
}

#[test]
fn several_cameras_each_in_their_folders() {
    let program = Program::new();
    let one = depth(32, 20);
    for (camera, prim) in [
        ("Camera_pseudo_depth_stereo", true),
        ("Camera_pseudo_depth_tof", true),
        ("Camera_left", false),
    ] {
        let folder = format!("set/{camera}/distance_to_image_plane");
        fs::create_dir_all(program.path(&folder)).unwrap();
        program.put(
            &format!("{folder}/distance_to_image_plane_0003.npy"),
            array(&[20, 32], &one),
        );
        let _ = prim;
    }
    let ended = program.run(&["sense", "set", "--model", "oak-d-tof", "-o", "out"]);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    insta::assert_snapshot!(format!("{}{}", ended.stdout, ended.stderr));
}

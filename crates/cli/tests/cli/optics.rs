//! `--lens fisheye` with a calibration that has no distortion: every command keeps the calibration's pinhole.

use std::fs;

use serde_json::{Value, json};

use crate::program::{EXAMPLE, Program};
use crate::sense::array;

const MODEL: &str = "oak-d-pro-w-poe";

/// The shipped calibration, changed to a wide model whose cameras have no distortion.
fn undistorted() -> String {
    let mut calibration: Value = serde_json::from_slice(&fs::read(EXAMPLE).unwrap()).unwrap();
    calibration["productName"] = json!("OAK-D-PRO-W-POE");
    for camera in calibration["cameraData"].as_array_mut().unwrap() {
        camera[1]["distortionCoeff"] = json!(vec![0.0; 14]);
    }
    calibration.to_string()
}

#[test]
fn calibrated_pinholes_stay_pinholes_in_every_command() {
    let program = Program::new();
    program.put("unit.json", undistorted());
    program.put("wall.obj", "v 1 -2 -2\nv 1 2 -2\nv 1 2 2\nv 1 -2 2\nf 1 2 3 4\n");
    program.put("depth.npy", array(&[80, 128], &[3f32].repeat(80 * 128)));
    let outputs = |lens: &str| {
        let run = |arguments: &str| {
            let unit = format!("--calibration unit.json --force --lens {lens}");
            let arguments = format!("{arguments} {unit}");
            program.good(&arguments.split(' ').collect::<Vec<_>>())
        };
        run(&format!("asset {MODEL} -o {lens}.usda"));
        run(&format!(
            "render wall.obj --up z --model {MODEL} --camera left --pose 0 0 0 0 0 0 1 --resolution 128x80 -o {lens}"
        ));
        run(&format!(
            "sense depth.npy --model {MODEL} --align left --align-size 128x80 -o {lens}"
        ));
        let shown: Value = serde_json::from_str(&run(&format!("show {MODEL} --json"))).unwrap();
        assert_eq!(shown["cameras"][1]["lens"], "pinhole", "{lens}");
        [
            "distance_to_image_plane_0000",
            "depth_sensor_distance_aligned_left",
        ]
        .map(|name| format!("{lens}/{name}.npy"))
        .into_iter()
        .chain([format!("{lens}.usda")])
        .map(|name| fs::read(program.path(&name)).unwrap())
        .collect::<Vec<_>>()
    };
    assert!(outputs("fisheye") == outputs("pinhole"));
}

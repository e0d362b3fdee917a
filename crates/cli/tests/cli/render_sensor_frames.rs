//! The depth sensor over several frames of `oaktwin render`, and `oaktwin sense` on the rendered files.

use std::fs;

use oaktwin::catalog::Catalog;
use oaktwin::image::{npy, png};
use oaktwin::sensor::{self, DepthShot, SINGLE_VIEW, STEREO_NOISE, SensorOptions};

use super::render_sensor::{array, program};
use crate::program::Program;

/// Renders two frames of a static scene; their sensor's distances.
fn two_frames(program: &Program, more: &[&str]) -> [Vec<f32>; 2] {
    program.put("path.tum", "0 -2 0 1 0 0 0 1\n1 -2 0 1 0 0 0 1\n");
    let fixed = [
        "render",
        "crate.obj",
        "-o",
        "out",
        "--model",
        "oak-d-pro-poe",
        "--trajectory",
        "path.tum",
        "--resolution",
        "160x100",
        "--annotators",
        "rgb,distance_to_image_plane,camera_params,depth_sensor_distance",
    ];
    program.good(&[&fixed[..], more].concat());
    ["0000", "0001"].map(|number| array(program, &format!("out/depth_sensor_distance_{number}.npy")).1)
}

#[test]
fn frames_differ_by_their_noise_alone() {
    let program = program();
    let stereo = ["--engine", "stereo-noise"];
    let [first, second] = two_frames(&program, &stereo);
    assert!(first != second);
    let [first, second] = two_frames(&program, &[&stereo[..], &["--param", "jitter=0"]].concat());
    assert!(first == second && first.iter().any(|z| *z > 0.0));
}

/// What is rendered, sensed by the library: the files hold all that it takes.
#[test]
fn the_files_hold_what_the_sensor_saw() {
    let program = program();
    for (name, engine) in [("single-view", &SINGLE_VIEW), ("stereo-noise", &STEREO_NOISE)] {
        let rendered = two_frames(&program, &["--engine", name, "--seed", "9"]);
        let catalog = Catalog::builtin();
        let twin = catalog.nominal(catalog.device("OAK-D Pro PoE").unwrap());
        let options = SensorOptions {
            engine: Some(engine.into()),
            seed: 9,
            ..SensorOptions::default()
        };
        let (mut sensor, _) = sensor::sensor(&twin, &twin.depth_sensors[0], &options).unwrap();
        for (frame, rendered) in rendered.iter().enumerate() {
            let depth =
                fs::read(program.path(&format!("out/distance_to_image_plane_000{frame}.npy"))).unwrap();
            let depth = npy::decode(&depth).unwrap().into_f32_image().unwrap();
            let rgb = fs::read(program.path(&format!("out/rgb_000{frame}.png"))).unwrap();
            let rgb = png::decode::<[u8; 4]>(&rgb).unwrap();
            let mut shot = DepthShot::new((&depth).into()).with_rgb((&rgb).into()).unwrap();
            shot.frame = frame as u64;
            let sensed = sensor.capture(shot, &[]).unwrap().distance.0;
            assert!(sensed.pixels() == rendered, "{name}, frame {frame}");
        }
    }
}

/// `sense` on what was rendered: the very bytes, also of the filters that remember earlier frames.
#[test]
fn sensing_what_was_rendered_gives_the_same_bytes() {
    for engine in [
        &["single-view"][..],
        &["stereo-noise"],
        &["stereo-noise", "--preset", "robotics", "--filter", "temporal"],
    ] {
        let program = program();
        let sensor = [&["--seed", "9", "--engine"], engine].concat();
        two_frames(&program, &sensor);
        let files = ["0000", "0001"].map(|number| format!("out/depth_sensor_distance_{number}.npy"));
        let rendered = files.each_ref().map(|file| {
            let bytes = fs::read(program.path(file)).unwrap();
            fs::remove_file(program.path(file)).unwrap();
            bytes
        });
        // The few pixels of a small image may land on the same places in both frames.
        assert!(
            engine[0] == "single-view" || rendered[0] != rendered[1],
            "{engine:?}"
        );
        program.good(&[&["sense", "out", "--model", "oak-d-pro-poe"], &sensor[..]].concat());
        for (file, rendered) in files.iter().zip(rendered) {
            assert!(
                fs::read(program.path(file)).unwrap() == rendered,
                "{engine:?}, {file}"
            );
        }
    }
}

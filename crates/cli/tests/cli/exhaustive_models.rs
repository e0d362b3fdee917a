//! Every command with every model of the catalog.

use oaktwin::catalog::{Catalog, DepthKind, Device, Source, Sourced};
use oaktwin::image::{Image, png};

use crate::program::Program;

/// A wall 1.5 m in front of the origin.
const WALL: &str = "v 1.5 5 -5\nv 1.5 -5 -5\nv 1.5 -5 5\nv 1.5 5 5\nf 1 2 3 4\n";
const PLACE: [&str; 4] = ["--pose", "0", "0", "0"];

fn has(device: &Device, kind: DepthKind) -> bool {
    device.depth_sensors.iter().any(|sensor| sensor.kind == kind)
}

fn render<'a>(model: &'a str, output: &'a str, more: &[&'a str]) -> Vec<&'a str> {
    let place = [&PLACE[..], &["0", "0", "0", "1"]].concat();
    let fixed = [
        "render",
        "wall.obj",
        "--up",
        "z",
        "--model",
        model,
        "--resolution",
        "48x32",
        "-o",
        output,
    ];
    [&fixed[..], &place, more].concat()
}

fn program() -> Program {
    let program = Program::new();
    program.put("wall.obj", WALL);
    for side in ["left.png", "right.png"] {
        program.put(side, png::encode(&Image::filled(48, 32, 90u8)).unwrap());
    }
    program
}

#[test]
fn shows_compares_and_writes_assets() {
    let program = program();
    program.good(&["asset", "all", "-o", "assets", "--format", "usdz", "--rigid-body"]);
    for device in Catalog::builtin().devices() {
        let id = device.id.as_str();
        let shown = program.good(&["show", id, "--provenance"]);
        assert!(shown.starts_with(&format!("{} ({id})\n", device.name)), "{shown}");
        for note in &device.notes {
            assert!(shown.contains(&note.text), "{id}: {}", note.topic);
        }
        let is_assumed = device
            .cameras
            .iter()
            .any(|camera| camera.source_of("hfov_deg") == Source::Estimate);
        let marks = shown
            .lines()
            .filter(|line| line.starts_with("  field of view") && line.contains("(estimate)"));
        assert_eq!(marks.count() > 0, is_assumed, "{shown}");
        program.good(&["show", id, "--json"]);
        assert!(program.good(&["compare", id, "oak4-d"]).contains(&device.name));
        let checked = program.good(&["check", &format!("assets/{id}.usdz")]);
        assert!(checked.contains("0 errors, 0 warnings"), "{checked}");
        assert!(checked.contains(&device.name), "{checked}");
    }
}

#[test]
fn renders_and_senses() {
    let program = program();
    for device in Catalog::builtin().devices() {
        let id = device.id.as_str();
        let all = program.good(&render(id, id, &["--annotators", "rgb,distance_to_image_plane"]));
        let Some(first) = device.depth_sensors.first() else {
            assert!(all.contains("Camera_rgb_"), "{all}");
            let expected = format!(
                "{} has no depth sensor; choose a model with one: OAK-D Pro PoE, ",
                device.name
            );
            let z = program
                .names()
                .into_iter()
                .find(|name| name.starts_with(id) && name.ends_with(".npy"));
            for command in [
                vec!["sense", z.as_deref().unwrap(), "--model", id, "-o", "no"],
                vec!["accuracy", id],
                render(id, "no", &["--annotators", "depth_sensor_distance"]),
                render(id, "no", &["--engine", "stereo-matching"]),
            ] {
                let error = program.refused(&command);
                let expected = match command.last() {
                    Some(&"stereo-matching") => "choose a model with a stereo pair: OAK-D Pro PoE, ",
                    Some(&"depth_sensor_distance") => "choose a model with one: OAK-D Pro PoE, ",
                    _ => &expected,
                };
                assert!(error.contains(expected), "{error}");
            }
            continue;
        };
        program.good(&render(
            id,
            &format!("{id}_sensed"),
            &["--annotators", "depth_sensor_distance"],
        ));
        let sensed = program.run(&["sense", id, "--model", id, "-o", &format!("{id}_later")]);
        assert_eq!(sensed.code, 0, "{}", sensed.stderr);
        let is_foreign = device.manufacturer != "Luxonis";
        assert_eq!(
            sensed.stderr.contains("note[foreign-processing]"),
            is_foreign,
            "{}",
            sensed.stderr
        );
        let measured = program.run(&[
            "accuracy",
            id,
            "--distances",
            "1.5",
            "--captures",
            "1",
            "--devices",
            "1",
        ]);
        let is_published = device.accuracy.iter().any(|table| table.sensor == first.kind);
        if !has(device, DepthKind::Tof) {
            assert_eq!(
                measured
                    .stdout
                    .contains("Published accuracy: none for this sensor"),
                !is_published,
                "{id}: {}{}",
                measured.stdout,
                measured.stderr
            );
        }
    }
}

#[test]
fn matches_the_pairs_of_stereo_models() {
    let program = program();
    for device in Catalog::builtin().devices() {
        let id = device.id.as_str();
        let matching = [
            "--engine",
            "stereo-matching",
            "--annotators",
            "depth_sensor_distance",
        ];
        let stereo = ["stereo", "left.png", "right.png", "--model", id, "-o", "depth"];
        if !has(device, DepthKind::Stereo) {
            for command in [render(id, "no", &matching), stereo.to_vec()] {
                let error = program.refused(&command);
                assert!(error.contains("choose a model with a stereo pair: "), "{error}");
            }
            continue;
        }
        program.run(&stereo);
        for sensor in device
            .depth_sensors
            .iter()
            .filter(|sensor| sensor.kind == DepthKind::Stereo)
        {
            let output = format!("{id}_{}", sensor.prim);
            let camera = ["--camera", sensor.prim.as_str()];
            program.good(&render(id, &output, &[&matching[..], &camera].concat()));
        }
    }
}

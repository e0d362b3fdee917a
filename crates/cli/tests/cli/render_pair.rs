//! `render --engine stereo-matching`: what the two cameras take, and what is matched in it.

use std::fmt::Write;
use std::fs;

use oaktwin::image::npy::{self, Values};
use oaktwin::image::{Image, png};

use crate::program::{EXAMPLE, Program};

const OAK: [&str; 11] = [
    "render",
    "wall.obj",
    "--resolution",
    "320x200",
    "--look-at",
    "0",
    "0",
    "0",
    "1",
    "0",
    "0",
];
const PRO: [&str; 4] = ["--model", "oak-d-pro-poe", "--engine", "stereo-matching"];

/// A wall of random squares 1.5 m ahead, and a blank one.
fn program() -> Program {
    let program = Program::new();
    let wall =
        "v 1.5 -2 -2\nv 1.5 2 -2\nv 1.5 2 2\nv 1.5 -2 2\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n";
    program.put("wall.obj", format!("mtllib wall.mtl\nusemtl squares\n{wall}"));
    program.put("blank.obj", wall);
    program.put("wall.mtl", "newmtl squares\nmap_Kd squares.png\n");
    let grey = (0..200u32 * 200).map(|at| {
        let mixed = at.wrapping_mul(0x9E37_79B1);
        let mixed = (mixed ^ (mixed >> 15)).wrapping_mul(0x2C1B_3C6D);
        [(mixed >> 24) as u8; 3]
    });
    let squares = Image::new(200, 200, grey.collect()).unwrap();
    program.put("squares.png", png::encode(&squares).unwrap());
    program
}

fn render<'a>(more: &[&'a str]) -> Vec<&'a str> {
    [&OAK[..], &PRO, &["--up", "z"], more].concat()
}

/// The finding about a blank wall.
fn blank<'a>(more: &[&'a str]) -> Vec<&'a str> {
    let mut arguments = render(more);
    arguments[1] = "blank.obj";
    arguments
}

fn depth(program: &Program, name: &str) -> Vec<f32> {
    let array = npy::decode(&fs::read(program.path(name)).unwrap()).unwrap();
    assert_eq!(array.shape, [200, 320]);
    let Values::F32(values) = array.values else {
        panic!("not float32")
    };
    values
}

/// The share of all pixels that are measured within 5 %.
fn right(depth: &[f32]) -> f64 {
    depth.iter().filter(|z| (**z / 1.5 - 1.0).abs() < 0.05).count() as f64 / depth.len() as f64
}

const SENSED: &str = "depth_sensor_distance_0000.npy";

#[test]
fn the_pair_is_what_stereo_matches() {
    let program = program();
    let text = program.good(&render(&["-o", "out", "--pair"]));
    let names: Vec<String> = program
        .names()
        .into_iter()
        .filter(|name| name.starts_with("out"))
        .collect();
    insta::assert_snapshot!(format!("{text}{}", names.join("\n")));
    let own = depth(&program, &format!("out/{SENSED}"));
    assert!(right(&own) > 0.8, "{}", right(&own));
    let stereo = |name: &str, more: &[&str]| {
        let pair = ["left", "right"].map(|side| format!("{name}{side}_0000.png"));
        let arguments = [
            "stereo",
            &pair[0],
            &pair[1],
            "--model",
            "oak-d-pro-poe",
            "-o",
            "matched",
        ];
        program.good(&[&arguments[..], more].concat());
        let [file] = fs::read_dir(program.path("matched"))
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .filter(|name| name.contains("depth_sensor_distance"))
            .collect::<Vec<_>>()
            .try_into()
            .unwrap();
        let found = depth(&program, &format!("matched/{file}"));
        fs::remove_dir_all(program.path("matched")).unwrap();
        found
    };
    assert_eq!(stereo("out/rectified_", &[]), own);
    assert_eq!(stereo("out/", &["--raw"]), own);
    // And so it is with ten bits and a unit whose images must be rectified.
    let ten = ["--imager", "bits=10", "--calibration", EXAMPLE];
    program.good(&render(&[&ten[..], &["-o", "ten", "--pair"]].concat()));
    let image: Image<u16> = png::decode(&fs::read(program.path("ten/left_0000.png")).unwrap()).unwrap();
    assert!(image.pixels().iter().any(|&number| number > 255) && image.pixels().iter().all(|&n| n < 1024));
    let own = depth(&program, &format!("ten/{SENSED}"));
    assert!(right(&own) > 0.4, "{}", right(&own));
    assert_eq!(stereo("ten/", &["--calibration", EXAMPLE]), own);
}

#[test]
fn light_and_parameters() {
    let program = program();
    let sensed = |arguments: &[&str]| {
        program.good(&[arguments, &["-o", "out"]].concat());
        depth(&program, &format!("out/{SENSED}"))
    };
    // So dark that only noise remains.
    let dark = sensed(&render(&["--ambient", "0"]));
    assert!(right(&dark) < 0.05, "{}", right(&dark));
    let night = ["--ambient", "0.05"];
    let (without, with) = (
        sensed(&blank(&night)),
        sensed(&blank(&[&night[..], &["--projector", "1"]].concat())),
    );
    assert!(
        right(&without) < 0.3 && right(&with) > 0.5,
        "{} {}",
        right(&without),
        right(&with)
    );

    program.put(
        "p.toml",
        "engine = \"stereo-matching\"\n[parameters]\npaths = 8\nsubpixelFractionalBits = 3\n",
    );
    let mut by_file = [&OAK[..], &["--up", "z", "--model", "oak-d-pro-poe"]].concat();
    by_file.extend(["--params", "p.toml"]);
    let named = render(&["--param", "paths=8", "--param", "subpixelFractionalBits=3"]);
    let (by_file, named) = (sensed(&by_file), sensed(&named));
    assert_eq!(by_file, named);
    assert_ne!(by_file, sensed(&render(&[])));
}

#[test]
fn recorded_without_a_folder() {
    let program = program();
    program.good(&render(&["--record", "walk.mcap"]));
    assert!(fs::metadata(program.path("walk.mcap")).unwrap().len() > 10_000);
    assert!(!program.names().iter().any(|name| name.contains("oaktwin-render")));
}

/// A sensor's option without a word on what to write is a wish for what the sensor reports.
#[test]
fn options_of_the_sensor_apply() {
    let program = program();
    program.good(&[&OAK[..], &["--model", "oak4-d", "--seed", "3", "-o", "out"]].concat());
    assert!(program.names().contains(&format!("out/{SENSED}")));
    let unheard = ["--annotators", "rgb", "--param", "paths=8", "-o", "rgb"];
    let ended = program.run(&render(&unheard));
    insta::assert_snapshot!(format!(
        "{}{}exit code {}",
        ended.stderr, ended.stdout, ended.code
    ));
}

#[test]
fn invalid_requests_are_rejected() {
    let program = program();
    let mut all = String::new();
    let others: [&[&str]; 4] = [
        &[
            "--model",
            "oak4-d",
            "--engine",
            "stereo-matching",
            "--projector",
            "1",
        ],
        &["--model", "oak-d-pro-poe", "--ambient", "0.5"],
        &[
            "--model",
            "oak-d-pro-poe",
            "--engine",
            "single-view",
            "--projector",
            "1",
        ],
        &[
            "--model",
            "oak-d-pro-poe",
            "--engine",
            "stereo-noise",
            "--imager",
            "bits=10",
        ],
    ];
    let runs: [&[&str]; 8] = [
        &["--projector", "2"],
        &["--projector", "-1"],
        &["--ambient", "nan"],
        &["--imager", "bits=9"],
        &["--imager", "fulwell=9"],
        &["--pair", "--record", "walk.mcap"],
        &["--param", "path=8"],
        &["--sweep", "bias=0,1"],
    ];
    let all_runs = others
        .map(|run| [&OAK[..], run].concat())
        .into_iter()
        .chain(runs.map(render));
    for arguments in all_runs {
        let _ = write!(
            all,
            "$ oaktwin {}\n{}",
            arguments.join(" "),
            program.refused(&arguments)
        );
    }
    insta::assert_snapshot!(all);
}

#[test]
fn each_of_several_pairs_can_be_chosen() {
    let program = program();
    let model = ["--model", "oak-d-lr", "--engine", "stereo-matching", "--up", "z"];
    for (sensor, baseline) in [
        ("Camera_pseudo_depth", "150.0 mm"),
        ("Camera_pseudo_depth_100mm", "100.0 mm"),
        ("Camera_pseudo_depth_50mm", "50.0 mm"),
    ] {
        program.good(&[&OAK[..], &model, &["--camera", sensor, "-o", sensor, "--pair"]].concat());
        let own = depth(&program, &format!("{sensor}/{SENSED}"));
        assert!(right(&own) > 0.6, "{sensor}: {}", right(&own));
        let pair = ["left", "right"].map(|side| format!("{sensor}/{side}_0000.png"));
        let matched = format!("{sensor}_matched");
        let arguments = [
            "stereo", &pair[0], &pair[1], "--model", "oak-d-lr", "--sensor", sensor, "-o", &matched,
        ];
        let said = program.good(&arguments);
        assert!(said.contains(&format!("baseline {baseline}")), "{said}");
        let found = depth(&program, &format!("{matched}/depth_sensor_distance_0000.npy"));
        assert_eq!(found, own, "{sensor}");
    }
    let all = program.refused(&[&OAK[..], &model, &["-o", "all"]].concat());
    assert!(
        all.contains("have different stereo pairs; choose one of them"),
        "{all}"
    );
    let unknown = program.refused(&[
        "stereo",
        "a.png",
        "b.png",
        "--model",
        "oak-d-lr",
        "--sensor",
        "Camera_pseudo_depth_60mm",
    ]);
    assert!(
        unknown.contains("did you mean 'Camera_pseudo_depth_50mm'"),
        "{unknown}"
    );
    let light = program.refused(&[
        "stereo",
        "a.png",
        "b.png",
        "--model",
        "oak-d-tof",
        "--sensor",
        "tof",
    ]);
    assert!(
        light.contains("is not a stereo pair; choose Camera_pseudo_depth_stereo"),
        "{light}"
    );
}

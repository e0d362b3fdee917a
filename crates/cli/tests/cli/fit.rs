//! `fit`: whole outputs, bad recordings, exit codes, and its file read by the others.

use std::fmt::Write;
use std::fs;

use oaktwin::image::{Image, npy, png};

use crate::program::Program;

const SIDE: [u32; 2] = [60, 160];
const SHAPE: [usize; 2] = [SIDE[0] as usize, SIDE[1] as usize];

/// The optics of a small matcher with the disparities of a real one.
pub(crate) const OPTICS: [&str; 6] = ["--stereo-width", "160", "--focal-px", "800", "--region", "25"];

/// What a device reports of a board: its disparity off by −0.2 px and by locking, and noise from frame to frame that
/// any program makes, the same over squares of 3×3 px.
fn frames(distance_m: f64, count: u32) -> Vec<f32> {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "metres")]
    let own = (distance_m * 1000.0) as u32;
    let disparity = 60.0 / distance_m - 0.2;
    let locked = disparity - 0.1 * (std::f64::consts::TAU * disparity).sin();
    let mut values = Vec::new();
    for frame in 0..count {
        for y in 0..SIDE[0] {
            for x in 0..SIDE[1] {
                let mut hash = ((x / 3) * 73_856_093)
                    ^ ((y / 3) * 19_349_663)
                    ^ (frame + 16 * own).wrapping_mul(83_492_791);
                for _ in 0..3 {
                    hash = (hash ^ (hash >> 15)).wrapping_mul(0x2c1b_3c6d);
                    hash ^= hash >> 12;
                }
                // Uniform, of a standard deviation of 0.05 px.
                let noise = (f64::from(hash) / f64::from(u32::MAX) - 0.5) * 0.05 * 12f64.sqrt();
                let measured = ((locked + noise) * 32.0).round() / 32.0;
                #[expect(clippy::cast_possible_truncation, reason = "whole millimetres")]
                values.push(((60.0 / measured * 1000.0).round() / 1000.0) as f32);
            }
        }
    }
    values
}

/// A folder of recordings at these distances.
pub(crate) fn record(program: &Program, folder: &str, distances: &[f64]) {
    fs::create_dir(program.path(folder)).unwrap();
    let mut table = "file,distance_m\n".to_owned();
    for (i, &distance) in distances.iter().enumerate() {
        let shape = [4, SHAPE[0], SHAPE[1]];
        let bytes = npy::encode(&shape, &frames(distance, 4)).unwrap();
        program.put(&format!("{folder}/{i}.npy"), bytes);
        let _ = writeln!(table, "{i}.npy,{distance}");
    }
    program.put(&format!("{folder}/distances.csv"), table);
}

pub(crate) const FAR: [f64; 10] = [1.6, 1.9, 2.3, 2.6, 3.1, 3.4, 3.7, 4.3, 4.9, 5.6];

#[test]
fn a_recording() {
    let program = Program::new();
    record(&program, "unit", &FAR);
    let arguments = [&["fit", "unit", "--model", "oak-d-pro-poe"], &OPTICS[..]].concat();
    let text = program.good(&[&arguments[..], &["-o", "unit.toml", "--plot", "unit.svg"]].concat());
    let file = fs::read_to_string(program.path("unit.toml")).unwrap();
    insta::assert_snapshot!(format!("{text}\n{file}"));
    let svg = fs::read_to_string(program.path("unit.svg")).unwrap();
    assert!(
        svg.contains("95 % of the curve") && svg.contains("Residuals of the fitted curve"),
        "{svg}"
    );
    let json = program.good(&[&arguments[..], &["--json", "--threads", "1"]].concat());
    for key in [
        "\"name\": \"pixelLocking\"",
        "\"confidence_interval_95\"",
        "\"r_squared\"",
        "\"passed\": true",
    ] {
        assert!(json.contains(key), "{key}: {json}");
    }
}

/// Fitted parameters are used by other commands, and named ones override them.
#[test]
fn parameters_are_read_by_the_others() {
    let program = Program::new();
    let file = "engine = \"stereo-noise\"\n[parameters]\nbias = -0.25\npixelLocking = 0\njitter = 0\n";
    program.put("p.toml", file);
    let accuracy = ["accuracy", "oak4-d", "--distances", "2,5", "--captures", "1"];
    let by_file = program.run(&[&accuracy[..], &["--params", "p.toml"]].concat());
    let named = [
        "--param",
        "bias=-0.25",
        "--param",
        "pixelLocking=0",
        "--param",
        "jitter=0",
    ];
    let by_name = program.run(&[&accuracy[..], &named].concat());
    assert_eq!(
        (by_file.stdout, by_file.code),
        (by_name.stdout.clone(), by_name.code)
    );
    let both = program.run(&[&accuracy[..], &["--params", "p.toml", "--param", "bias=0"]].concat());
    assert_ne!(both.stdout, by_name.stdout);

    let depth = npy::encode(&[100, 160], &[3f32; 16_000]).unwrap();
    program.put("depth.npy", depth);
    let sense = ["sense", "depth.npy", "--model", "oak4-d"];
    program.good(&[&sense[..], &["-o", "a", "--params", "p.toml"]].concat());
    program.good(&[&sense[..], &["-o", "b"], &named].concat());
    let read = |name: &str| fs::read(program.path(name).join("depth_sensor_distance.npy")).unwrap();
    assert_eq!(read("a"), read("b"));
}

#[test]
fn an_uninformative_recording_ends_with_findings() {
    let program = Program::new();
    record(&program, "one", &[2.3]);
    let ended = program.run(&[&["fit", "one", "--model", "oak4-d"], &OPTICS[..]].concat());
    assert_eq!(ended.code, 1, "{}", ended.stderr);
    insta::assert_snapshot!(format!("{}{}", ended.stdout, ended.stderr));
}

#[test]
fn distances_that_no_device_measures_are_refused() {
    let program = Program::new();
    for (distance, expected) in [
        ("0", "line 3: distance_m: 0 is not above 0"),
        ("1e-300", "is nearer than 0.001 m"),
        ("nan", "is not a finite number"),
    ] {
        program.put(
            "curve.csv",
            format!("distance_m,depth_error_percent\n1,2\n{distance},2\n"),
        );
        let refused = program.refused(&["fit", "curve.csv", "--model", "oak4-d"]);
        assert!(
            refused.contains("curve.csv") && refused.contains(expected),
            "{refused}"
        );
    }
}

/// What `sense` makes of walls at these distances, with its own errors.
fn record_tof(program: &Program, folder: &str, distances: &[f64]) {
    fs::create_dir(program.path(folder)).unwrap();
    let mut table = "file,distance_m\n".to_owned();
    for (i, &distance) in distances.iter().enumerate() {
        #[expect(clippy::cast_possible_truncation, reason = "metres")]
        let wall = npy::encode(&[4, 48, 64], &[distance as f32; 4 * 48 * 64]).unwrap();
        program.put("depth.npy", wall);
        let seed = i.to_string();
        // So few pixels would mix much of the corners between walls.
        let own = [
            "--param",
            "bias=0.003",
            "--param",
            "wigglingResidual=0.01",
            "--param",
            "pixelMixing=0",
        ];
        let sense = [
            "sense",
            "depth.npy",
            "--model",
            "oak-d-tof",
            "--input-kind",
            "z",
            "-o",
            "sensed",
            "--seed",
            &seed,
        ];
        program.good(&[&sense[..], &own].concat());
        let bytes = fs::read(program.path("sensed").join("depth_sensor_distance.npy")).unwrap();
        fs::remove_dir_all(program.path("sensed")).unwrap();
        program.put(&format!("{folder}/{i}.npy"), bytes);
        let _ = writeln!(table, "{i}.npy,{distance}");
    }
    program.put(&format!("{folder}/distances.csv"), table);
}

#[test]
fn a_recording_of_time_of_flight() {
    let program = Program::new();
    record_tof(
        &program,
        "tof",
        &[0.5, 0.65, 0.8, 1.0, 1.25, 1.5, 1.9, 2.3, 2.75, 3.2, 3.7, 4.2],
    );
    let arguments = ["fit", "tof", "--model", "OAK-D-ToF", "--region", "40"];
    let text = program.good(&[&arguments[..], &["-o", "unit.toml", "--plot", "unit.svg"]].concat());
    let file = fs::read_to_string(program.path("unit.toml")).unwrap();
    insta::assert_snapshot!(format!("{text}\n{file}"));
    let svg = fs::read_to_string(program.path("unit.svg")).unwrap();
    assert!(
        svg.contains("95 % of the curve") && svg.contains("error of depth [mm], positive if too far"),
        "{svg}"
    );
    let json = program.good(&[&arguments[..], &["--json", "--threads", "1"]].concat());
    assert!(
        json.contains("\"unit\": \"m\"") && !json.contains("baseline_m"),
        "{json}"
    );
    // Fitted parameters are used by other commands.
    let sense = ["sense", "depth.npy", "--model", "oak-d-tof", "--input-kind", "z"];
    program.good(&[&sense[..], &["-o", "a", "--params", "unit.toml"]].concat());
    let values = file
        .lines()
        .filter_map(|line| Some(line.split_once("  #")?.0.replace(' ', "")));
    let values: Vec<String> = values.collect();
    assert_eq!(values.len(), 4, "{file}");
    let named: Vec<&str> = values.iter().flat_map(|value| ["--param", value]).collect();
    program.good(&[&sense[..], &["-o", "b"], &named].concat());
    program.good(&[&sense[..], &["-o", "c"]].concat());
    let read = |name: &str| fs::read(program.path(name).join("depth_sensor_distance.npy")).unwrap();
    assert_eq!(read("a"), read("b"));
    assert_ne!(read("a"), read("c"));
}

#[test]
fn invalid_requests_for_time_of_flight_are_rejected() {
    let program = Program::new();
    record_tof(&program, "tof", &[0.7, 2.3]);
    let mut all = String::new();
    let runs: [&[&str]; 5] = [
        &["--fit", "focal"],
        &["--param", "enableOpticalCorrection=false"],
        &["--param", "signal=0"],
        &["--sensor", "tof", "--engine", "stereo-noise"],
        &["--params", "tof/distances.csv"],
    ];
    for run in runs {
        let arguments = [&["fit", "tof", "--model", "oak-d-tof"], run].concat();
        let _ = write!(
            all,
            "$ oaktwin {}\n{}",
            arguments.join(" "),
            program.refused(&arguments)
        );
    }
    let few = ["fit", "tof", "--model", "oak-d-tof", "--region", "60"];
    let ended = program.run(&few);
    assert_eq!(ended.code, 1, "{}", ended.stderr);
    insta::assert_snapshot!(format!("{all}{}{}", ended.stdout, ended.stderr));
}

#[test]
fn invalid_requests_are_rejected() {
    let program = Program::new();
    record(&program, "good", &[1.6, 2.3]);
    let table = |name: &str, text: &str| {
        fs::create_dir(program.path(name)).unwrap();
        let array = npy::encode(&[2, SHAPE[0], SHAPE[1]], &frames(2.0, 2)).unwrap();
        program.put(&format!("{name}/near.npy"), array);
        program.put(
            &format!("{name}/far.npy"),
            npy::encode(&[20, 30], &[4f32; 600]).unwrap(),
        );
        program.put(
            &format!("{name}/zero.npy"),
            npy::encode(&SHAPE, &[0f32; 9600]).unwrap(),
        );
        program.put(
            &format!("{name}/grey8.png"),
            png::encode(&Image::filled(30, 20, 7u8)).unwrap(),
        );
        program.put(&format!("{name}/distances.csv"), text);
    };
    let tables = [
        ("empty-table", ""),
        ("columns", "name,distance\nnear.npy,2\n"),
        ("unknown", "file,distance_m\nneer.npy,2\n"),
        ("negative", "file,distance_m\nnear.npy,-2\n"),
        ("nan", "file,distance_m\nnear.npy,NaN\n"),
        ("twice", "file,distance_m\nnear.npy,2\nnear.npy,3\n"),
        ("nameless", "file,distance_m\n,2\n"),
        ("sizes", "file,distance_m\nnear.npy,2\nfar.npy,4\n"),
        ("same-distance-sizes", "file,distance_m\nnear.npy,2\nfar.npy,2\n"),
        ("zeros", "file,distance_m\nzero.npy,2\n"),
        ("grey8", "file,distance_m\ngrey8.png,2\n"),
        ("parent", "file,distance_m\n.,2\n"),
    ];
    for (name, text) in tables {
        table(name, text);
    }
    fs::create_dir(program.path("nothing")).unwrap();
    program.put("curve.csv", "distance_m,depth_error_percent\n1,0.4\n2,0.5\n");
    program.put(
        "unknown.toml",
        "engine = \"stereo-noise\"\n[parameters]\njiter = 0.1\n",
    );
    program.put("other.toml", "engine = \"single-view\"\n[parameters]\n");
    program.put("no.toml", "bias: 1\n");
    let mut all = String::new();
    let mut refuse = |arguments: &[&str]| {
        let arguments = [&["fit"], arguments, &["--model", "oak4-d"]].concat();
        let _ = write!(
            all,
            "$ oaktwin {}\n{}",
            arguments.join(" "),
            program.refused(&arguments)
        );
    };
    for (name, _) in tables {
        refuse(&[name]);
    }
    let runs: [&[&str]; 15] = [
        &["nothing"],
        &["missing"],
        &["curve.csv", "good"],
        &["curve.csv", "--from", "-1"],
        &["good", "--region", "0"],
        &["good", "--depth-scale", "0"],
        &["good", "--focal-px", "-3"],
        &["good", "--engine", "single-view"],
        &["good", "--sensor", "tof"],
        &["good", "-o", "no/folder.toml"],
        &["good", "-o", "good"],
        &["good", "--plot", "a.jpg"],
        &["good", "--params", "unknown.toml"],
        &["good", "--params", "no.toml"],
        &["good", "--params", "other.toml", "--engine", "stereo-noise"],
    ];
    for run in runs {
        refuse(run);
    }
    insta::assert_snapshot!(all);
}

/// The place of an edge that moves irregularly.
fn place(t: f64) -> f64 {
    (4.4 * t).sin() + 0.6 * (7.1 * t + 0.4).sin()
}

fn track(samples: u32, every_s: f64, of: impl Fn(f64) -> (f64, f64)) -> String {
    let mut text = "time_s,position\n".to_owned();
    for sample in 0..samples {
        let (time_s, position) = of(f64::from(sample) * every_s);
        let _ = writeln!(text, "{time_s:.6},{position:.4}");
    }
    text
}

#[test]
fn a_latency() {
    let program = Program::new();
    program.put("encoder.csv", track(6000, 1e-3, |t| (t, place(t))));
    let late = |t: f64| (t + 0.0437, 320.0 - 150.0 * place(t));
    program.put("camera.csv", track(170, 1.0 / 30.0, late));
    let arguments = ["fit", "--latency", "camera.csv", "encoder.csv"];
    insta::assert_snapshot!(program.good(&arguments));
    let json = program.good(&[&arguments[..], &["--json"]].concat());
    for key in [
        "\"latency_s\": 0.0437",
        "\"confidence_interval_95\"",
        "\"passed\": true",
    ] {
        assert!(json.contains(key), "{key}: {json}");
    }
    // The other files are no recordings of it.
    for (options, expected) in [
        (
            &["camera.csv"][..],
            "error: --latency: 1 file given; give the camera's and the reference's\n",
        ),
        (
            &["camera.csv", "encoder.csv", "--longest", "0"],
            "error: --longest 0: is out of range; give seconds above 0, up to 60\n",
        ),
        (
            &["camera.csv", "encoder.csv", "--longest", "6"],
            "camera.csv: has 0 images while the reference was recorded",
        ),
        (&["camera.csv", "absent.csv"], "absent.csv"),
    ] {
        let refused = program.refused(&[&["fit", "--latency"], options].concat());
        assert!(refused.contains(expected), "{options:?}: {refused}");
    }
    for (arguments, expected) in [
        (&["fit", "camera.csv"][..], "--model <MODEL>"),
        (
            &[
                "fit",
                "--latency",
                "camera.csv",
                "encoder.csv",
                "--model",
                "oak4-d",
            ],
            "cannot be used with",
        ),
    ] {
        let ended = program.run(arguments);
        assert!(
            ended.code == 2 && ended.stderr.contains(expected),
            "{}",
            ended.stderr
        );
    }
}

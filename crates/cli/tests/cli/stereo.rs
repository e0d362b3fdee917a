//! `stereo`: pairs of images to depth.

use std::fs;

use oaktwin::image::npy::{self, Values};
use oaktwin::image::{Image, png};

use crate::program::{EXAMPLE, Ended, Program};

const SIZE: (u32, u32) = (320, 120);
/// px
const DISPARITY: u32 = 20;

/// Random grey, two pixels a square, moved to the left.
fn noise(by: u32, down: u32) -> Image<u8> {
    let grey = |x: u32, y: u32| {
        let mixed = (x / 2).wrapping_mul(0x9E37_79B1) ^ (y / 2).wrapping_mul(0x85EB_CA77);
        let mixed = (mixed ^ (mixed >> 15)).wrapping_mul(0x2C1B_3C6D);
        (mixed >> 24) as u8
    };
    let pixels = (0..SIZE.1).flat_map(|y| (0..SIZE.0).map(move |x| grey(x + by, y + 16 - down)));
    Image::new(SIZE.0, SIZE.1, pixels.collect()).unwrap()
}

fn program() -> Program {
    let program = Program::new();
    let put =
        |name: &str, image: &Image<u8>| fs::write(program.path(name), png::encode(image).unwrap()).unwrap();
    put("left.png", &noise(0, 0));
    put("right.png", &noise(DISPARITY, 0));
    put("lower.png", &noise(DISPARITY, 4));
    put("flat.png", &Image::filled(SIZE.0, SIZE.1, 90));
    put("small.png", &Image::filled(10, 10, 90));
    let ten = noise(0, 0).map(|&grey| u16::from(grey) << 2);
    fs::write(program.path("ten_left.png"), png::encode(&ten).unwrap()).unwrap();
    let ten = noise(DISPARITY, 0).map(|&grey| u16::from(grey) << 8);
    program.put("ten_right.png", png::encode(&ten).unwrap());
    program
}

fn floats(program: &Program, name: &str) -> Vec<f32> {
    let array = npy::decode(&fs::read(program.path(name)).unwrap()).unwrap();
    let Values::F32(values) = array.values else {
        panic!("not float32")
    };
    assert_eq!(array.shape, [SIZE.1 as usize, SIZE.0 as usize]);
    values
}

/// A calibration whose right camera is placed nowhere.
fn without_pair(calibration: &str) -> String {
    let mut json: serde_json::Value = serde_json::from_str(calibration).unwrap();
    for camera in json["cameraData"].as_array_mut().unwrap() {
        camera[1]["extrinsics"]["toCameraSocket"] = (-1).into();
    }
    json["stereoRectificationData"]["leftCameraSocket"] = (-1).into();
    json["stereoRectificationData"]["rightCameraSocket"] = (-1).into();
    json.to_string()
}

/// A rig of two or three cameras, of no model.
fn rig(calibration: &str, has_pair: bool) -> String {
    let mut json: serde_json::Value = serde_json::from_str(calibration).unwrap();
    json["productName"] = "OAK-FFC-3P".into();
    json["boardName"] = "DM1090FFC".into();
    if !has_pair {
        json["stereoRectificationData"] = serde_json::json!({});
    }
    json.to_string()
}

const PLAIN: [&str; 4] = ["--fx", "300", "--baseline", "0.075"];

fn stereo<'a>(left: &'a str, right: &'a str, more: &[&'a str]) -> Vec<&'a str> {
    [&["stereo", left, right, "-o", "out"], &PLAIN[..], more].concat()
}

fn text(run: &Ended) -> String {
    format!("{}{}exit code {}\n\n", run.stderr, run.stdout, run.code)
}

#[test]
fn depth_and_other_outputs() {
    let program = program();
    let more = [
        "--disparity",
        "--confidence",
        "--rectified-images",
        "--png16",
        "--preview",
        "--ply",
    ];
    let run = program.run(&stereo("left.png", "right.png", &more));
    insta::assert_snapshot!(text(&run));
    let (distance, disparity) = (
        floats(&program, "out/depth_sensor_distance.npy"),
        floats(&program, "out/disparity.npy"),
    );
    let middle = SIZE.0 as usize * 60 + 160;
    assert!((disparity[middle] - 20.0).abs() < 0.25, "{}", disparity[middle]);
    assert!((distance[middle] - 300.0 * 0.075 / disparity[middle]).abs() < 1e-3);
    let right = disparity.iter().filter(|d| (**d - 20.0).abs() < 0.25).count();
    assert!(right as f64 / disparity.len() as f64 > 0.85, "{right}");
    assert!(
        disparity
            .iter()
            .zip(&distance)
            .all(|(d, z)| (*d > 0.0) == (*z > 0.0))
    );
    let same = fs::read(program.path("out/rectified_left.png")).unwrap();
    assert_eq!(png::decode::<u8>(&same).unwrap(), noise(0, 0));
}

#[test]
fn two_folders_are_a_sequence() {
    let program = program();
    for folder in ["l", "r"] {
        fs::create_dir(program.path(folder)).unwrap();
    }
    for i in [1, 2, 10] {
        fs::copy(program.path("left.png"), program.path(&format!("l/left_{i}.png"))).unwrap();
        let right = if i == 10 { "flat.png" } else { "right.png" };
        fs::copy(program.path(right), program.path(&format!("r/right_{i}.png"))).unwrap();
    }
    let run = program.run(&stereo("l", "r", &["--filter", "temporal"]));
    insta::assert_snapshot!(text(&run));
    // The state of the frames before the last one remains.
    let last = floats(&program, "out/depth_sensor_distance_10.npy");
    let kept = last.iter().filter(|z| **z > 0.0).count();
    assert!(kept > last.len() / 2, "{kept}");
}

#[test]
fn what_is_wrong_with_a_pair() {
    let program = program();
    let mut turned = noise(0, 0).into_pixels();
    turned.reverse();
    let turned = Image::new(SIZE.0, SIZE.1, turned).unwrap();
    for (name, image) in [
        ("turned.png", &turned),
        ("dot.png", &Image::filled(1, 1, 90)),
        ("narrow.png", &Image::filled(60, 40, 90)),
        ("bright.png", &Image::filled(SIZE.0, SIZE.1, 255)),
    ] {
        program.put(name, png::encode(image).unwrap());
    }
    program.put("float.npy", npy::encode(&[2, 3], &[0f32; 6]).unwrap());
    program.put("none.npy", npy::encode(&[0, 3], &[0u8; 0]).unwrap());
    program.put("deep.npy", npy::encode(&[5, 2, 7], &[0u8; 70]).unwrap());
    program.put("cut.png", &fs::read(program.path("left.png")).unwrap()[..900]);
    program.put("words.png", "nothing to see");
    let calibration = fs::read_to_string(EXAMPLE).unwrap();
    let named = calibration.replacen("OAK-D-PRO-POE", "OAK-D Prism", 1);
    assert_ne!(named, calibration);
    program.put("other.json", named);
    program.put("alone.json", without_pair(&calibration));
    let mut all = String::new();
    for arguments in [
        stereo("right.png", "left.png", &[]),
        stereo("left.png", "lower.png", &[]),
        stereo("flat.png", "flat.png", &[]),
        stereo("left.png", "flat.png", &[]),
        stereo("left.png", "left.png", &[]),
        stereo("left.png", "turned.png", &[]),
        stereo("left.png", "right.png", &["--filter", "threshold:min=9,max=10"]),
        stereo("dot.png", "dot.png", &[]),
        stereo("narrow.png", "narrow.png", &[]),
        stereo("bright.png", "bright.png", &[]),
        stereo("float.npy", "float.npy", &[]),
        stereo("none.npy", "none.npy", &[]),
        stereo("deep.npy", "deep.npy", &[]),
        stereo("cut.png", "cut.png", &[]),
        stereo("words.png", "words.png", &[]),
        stereo("left.png", "small.png", &[]),
        stereo("left.png", "ten_right.png", &[]),
        stereo("left.png", "nope.png", &[]),
        stereo("left.png", ".", &[]),
        stereo("left.png", "right.png", &["--param", "pathz=8"]),
        stereo("left.png", "right.png", &["--param", "bias=1"]),
        stereo("left.png", "right.png", &["--preset", "robotic"]),
        stereo("left.png", "right.png", &["--param", "disparityShift=2000"]),
        vec!["stereo", "left.png", "right.png"],
        vec![
            "stereo",
            "left.png",
            "right.png",
            "--fx",
            "300",
            "--baseline",
            "75",
        ],
        [&["stereo", "left.png", "right.png", "-o", "left.png"], &PLAIN[..]].concat(),
        [&["stereo", "left.png", "right.png", "-o", "no/such"], &PLAIN[..]].concat(),
        vec!["stereo", "left.png", "right.png", "--model", "oak-d-pr"],
        vec!["stereo", "left.png", "right.png", "--calibration", "words.png"],
        vec!["stereo", "left.png", "right.png", "--calibration", "other.json"],
        vec!["stereo", "left.png", "right.png", "--calibration", "alone.json"],
        vec!["stereo", "left.png", "right.png", "--fx", "-3", "--baseline", "1"],
    ] {
        all += &text(&program.run(&arguments));
    }
    insta::assert_snapshot!(all);
}

/// The rectified images of a rig have the focal length of its right camera, as on RVC2.
#[test]
fn a_rig_needs_no_model() {
    let program = program();
    let calibration = fs::read_to_string(EXAMPLE).unwrap();
    program.put("rig.json", rig(&calibration, true));
    program.put("three.json", rig(&calibration, false));
    let json: serde_json::Value = serde_json::from_str(&calibration).unwrap();
    let camera = |socket: u64| {
        let cameras = json["cameraData"].as_array().unwrap();
        &cameras.iter().find(|camera| camera[0] == socket).unwrap()[1]
    };
    let t = &camera(1)["extrinsics"]["translation"];
    let squares = ["x", "y", "z"].map(|axis| t[axis].as_f64().unwrap().powi(2));
    let baseline_m = squares.iter().sum::<f64>().sqrt() / 100.0;
    let fx = camera(2)["intrinsicMatrix"][0][0].as_f64().unwrap() * f64::from(SIZE.0) / 1280.0;
    let expected = fx * baseline_m / f64::from(DISPARITY);
    let mut all = String::new();
    for (file, more) in [
        ("rig.json", &[][..]),
        ("three.json", &["--pair", "CAM_B", "CAM_C"]),
        ("three.json", &["--pair", "cam_b", "cam_c", "--platform", "rvc4"]),
        ("three.json", &[]),
        ("three.json", &["--pair", "CAM_C", "CAM_B"]),
        ("three.json", &["--pair", "CAM_B", "CAM_B"]),
        ("three.json", &["--pair", "CAM_B", "CAM_E"]),
        ("three.json", &["--pair", "CAM_B", "right"]),
        ("three.json", &["--pair", "CAM_B", "CAM_C", "--model", "OAK-D"]),
        ("three.json", &["--pair", "CAM_B", "CAM_C", "--lens", "fisheye"]),
    ] {
        let arguments = [
            "stereo",
            "left.png",
            "right.png",
            "-o",
            "out",
            "--rectified",
            "--calibration",
            file,
        ];
        let run = program.run(&[&arguments[..], more].concat());
        all += &text(&run);
        if run.code == 0 {
            let distance = floats(&program, "out/depth_sensor_distance.npy");
            let middle = f64::from(distance[SIZE.0 as usize * 60 + 160]);
            assert!((middle / expected - 1.0).abs() < 0.01, "{middle} {expected}");
        }
    }
    insta::assert_snapshot!(all);
}

#[test]
fn sixteen_bits_are_those_of_a_camera_of_ten() {
    let program = program();
    let ten = noise(DISPARITY, 0).map(|&grey| u16::from(grey) << 2);
    fs::write(program.path("ten_right.png"), png::encode(&ten).unwrap()).unwrap();
    assert_eq!(
        program
            .run(&stereo("ten_left.png", "ten_right.png", &["--disparity"]))
            .code,
        0
    );
    let disparity = floats(&program, "out/ten_disparity.npy");
    assert!((disparity[SIZE.0 as usize * 60 + 160] - 20.0).abs() < 0.25);
}

/// A vertical offset of a row or two is reported at the size of a device's images.
#[test]
fn small_vertical_offsets() {
    let program = program();
    for (down, way) in [(1, "1 px lower"), (2, "2 px lower"), (5, "5 px lower")] {
        program.put("moved.png", png::encode(&noise(DISPARITY, down)).unwrap());
        let run = program.run(&stereo("left.png", "moved.png", &[]));
        assert!(run.code == 1 && run.stderr.contains(way), "{}", run.stderr);
    }
}

#[cfg(unix)]
#[test]
fn an_interrupted_sequence_is_whole_as_far_as_it_went() {
    let program = program();
    fs::create_dir(program.path("pairs")).unwrap();
    for side in ["left", "right"] {
        let first = program.path(&format!("pairs/{side}_0.png"));
        fs::copy(program.path(&format!("{side}.png")), &first).unwrap();
        for i in 1..2000 {
            fs::hard_link(&first, program.path(&format!("pairs/{side}_{i}.png"))).unwrap();
        }
    }
    let ended = program.interrupted(&stereo("pairs", "pairs", &[]), |program| {
        program.path("out/depth_sensor_distance_2.npy").exists()
    });
    let message = ended.stderr;
    assert_eq!(ended.code, 130, "{message}");
    assert!(message.starts_with("interrupted: "), "{message}");
    let written: Vec<String> = program
        .names()
        .into_iter()
        .filter(|name| name.starts_with("out/") && name.ends_with(".npy"))
        .collect();
    assert!(
        message.contains(&format!("interrupted: {} pairs are complete", written.len())),
        "{message}"
    );
    for name in written {
        floats(&program, &name);
    }
}

#[test]
fn aligned_depth_is_the_devices() {
    let program = program();
    let aligned = |model: &str, depth: &[&str]| {
        let pair = ["stereo", "left.png", "right.png", "--model", model, "-o", "out"];
        let run = program.run(&[&pair, &["--align", "rgb", "--align-size", "320x120"][..], depth].concat());
        assert_eq!(run.code, 0, "{}", run.stderr);
        let distance = floats(&program, "out/depth_sensor_distance.npy");
        (
            floats(&program, "out/depth_sensor_distance_aligned_rgb.npy"),
            distance,
        )
    };
    let own = |(aligned, distance): &(Vec<f32>, Vec<f32>)| {
        aligned
            .iter()
            .filter(|z| **z > 0.0 && distance.contains(z))
            .count()
    };
    let count = |(aligned, _): &(Vec<f32>, Vec<f32>)| aligned.iter().filter(|&&z| z > 0.0).count();
    let rvc2 = aligned("oak-d-pro", &[]);
    assert!(count(&rvc2) > 10_000, "{}", count(&rvc2));
    assert_eq!(own(&rvc2), count(&rvc2));
    let turned = aligned("oak-d-pro", &["--align-depth", "geometric"]);
    assert_eq!(count(&turned), count(&rvc2));
    let rvc4 = aligned("oak4-d", &[]);
    assert_eq!(rvc4, aligned("oak4-d", &["--align-depth", "geometric"]));
    // Other makers' cameras are not known.
    let run = program.run(&stereo("left.png", "right.png", &["--align", "rgb"]));
    assert_eq!(run.code, 2);
    assert!(
        run.stderr
            .contains("--align: the other cameras are unknown; set --model"),
        "{}",
        run.stderr
    );
}

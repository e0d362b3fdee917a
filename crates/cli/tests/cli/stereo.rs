//! `stereo`: pairs of images to depth.

use std::fs;

use oaktwin::image::npy::{self, Values};
use oaktwin::image::{Image, png};

use crate::program::{Ended, Program};

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

const PLAIN: [&str; 4] = ["--fx", "300", "--baseline", "0.075"];

fn stereo<'a>(left: &'a str, right: &'a str, more: &[&'a str]) -> Vec<&'a str> {
    [&["stereo", left, right, "-o", "out"], &PLAIN[..], more].concat()
}

fn text(run: &Ended) -> String {
    format!("{}{}exit code {}\n\n", run.stderr, run.stdout, run.code)
}

#[test]
fn depth_and_what_else_is_asked_for() {
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
    // What was seen in the two before the last stays.
    let last = floats(&program, "out/depth_sensor_distance_10.npy");
    let kept = last.iter().filter(|z| **z > 0.0).count();
    assert!(kept > last.len() / 2, "{kept}");
}

#[test]
fn what_is_wrong_with_a_pair() {
    let program = program();
    let mut all = String::new();
    for arguments in [
        stereo("right.png", "left.png", &[]),
        stereo("left.png", "lower.png", &[]),
        stereo("flat.png", "flat.png", &[]),
        stereo("left.png", "small.png", &[]),
        stereo("left.png", "ten_right.png", &[]),
        stereo("left.png", "nope.png", &[]),
        stereo("left.png", ".", &[]),
        stereo("left.png", "right.png", &["--param", "pathz=8"]),
        stereo("left.png", "right.png", &["--param", "bias=1"]),
        stereo("left.png", "right.png", &["--preset", "robotic"]),
        vec!["stereo", "left.png", "right.png"],
        vec!["stereo", "left.png", "right.png", "--fx", "-3", "--baseline", "1"],
    ] {
        all += &text(&program.run(&arguments));
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

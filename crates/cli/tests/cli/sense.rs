//! `sense`: depth images from anywhere, in every form, and what is made of them.

use std::fs;
use std::io::Write;
use std::process::Stdio;

use oaktwin::image::npy::{self, NpyElement, Values};
use oaktwin::image::{Image, exr, pfm, png};

use crate::program::{EXAMPLE, Program};

/// A wall at 2 m and, before it, a thing at 1 m.
pub(crate) fn depth(width: u32, height: u32) -> Vec<f32> {
    let thing = |x: u32, y: u32| (x > width / 2 && x < width * 3 / 4) && y > height / 3;
    let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    pixels.map(|(x, y)| if thing(x, y) { 1.0 } else { 2.0 }).collect()
}

pub(crate) fn array<T: NpyElement>(shape: &[usize], values: &[T]) -> Vec<u8> {
    npy::encode(shape, values).unwrap()
}

/// An array of another kind or order than ours: its header by hand.
pub(crate) fn foreign(descr: &str, is_fortran: bool, shape: &str, data: &[u8]) -> Vec<u8> {
    let order = if is_fortran { "True" } else { "False" };
    let dict = format!("{{'descr': '{descr}', 'fortran_order': {order}, 'shape': {shape}, }}\n");
    let mut file = b"\x93NUMPY\x01\x00".to_vec();
    file.extend(u16::try_from(dict.len()).unwrap().to_le_bytes());
    file.extend(dict.bytes());
    file.extend(data);
    file
}

pub(crate) fn read(program: &Program, name: &str) -> (Vec<usize>, Vec<f32>) {
    let bytes = fs::read(program.path(name)).unwrap_or_else(|_| panic!("{name}: {:?}", program.names()));
    values(&bytes)
}

fn values(bytes: &[u8]) -> (Vec<usize>, Vec<f32>) {
    let array = npy::decode(bytes).unwrap();
    let Values::F32(values) = array.values else {
        panic!("not float32")
    };
    (array.shape, values)
}

const SIZE: (u32, u32) = (64, 40);

#[test]
fn a_closed_pipe_is_not_an_error() {
    let program = Program::new();
    // More than a pipe holds.
    program.put("depth.npy", array(&[800, 1280], &vec![2.0f32; 800 * 1280]));
    let mut child = program
        .command(&["sense", "-", "--model", "oak4-d", "--input-kind", "z"])
        .stdin(fs::File::open(program.path("depth.npy")).unwrap())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let ended = child.wait_with_output().unwrap();
    let message = String::from_utf8_lossy(&ended.stderr).into_owned();
    assert_eq!((ended.status.code(), message.as_str()), (Some(0), ""));
}

/// The same scene in every format gives the same result.
#[test]
fn every_form_of_the_same_depth() {
    let program = Program::new();
    let (width, height) = SIZE;
    let metres = depth(width, height);
    let image = Image::new(width, height, metres.clone()).unwrap();
    let millimetres = image.map(|z| if *z > 1.5 { 2000u16 } else { 1000 });
    let shape = [40, 64];
    let doubles: Vec<f64> = metres.iter().map(|&z| f64::from(z)).collect();
    let bytes = |each: fn(f32) -> Vec<u8>| metres.iter().flat_map(|&z| each(z)).collect::<Vec<u8>>();
    let half = |z: f32| if z > 1.5 { 0x4000u16 } else { 0x3C00 };
    let columns: Vec<u8> = (0..64usize)
        .flat_map(|x| (0..40usize).map(move |y| (x, y)))
        .flat_map(|(x, y)| metres[y * 64 + x].to_le_bytes())
        .collect();
    for (name, file) in [
        ("f32.npy", array(&shape, &metres)),
        ("f32c.npy", array(&[40, 64, 1], &metres)),
        ("f64.npy", array(&shape, &doubles)),
        ("u16.npy", array(&shape, millimetres.pixels())),
        (
            "f16.npy",
            foreign(
                "<f2",
                false,
                "(40, 64)",
                &metres
                    .iter()
                    .flat_map(|&z| half(z).to_le_bytes())
                    .collect::<Vec<u8>>(),
            ),
        ),
        (
            "big.npy",
            foreign(">f4", false, "(40, 64)", &bytes(|z| z.to_be_bytes().to_vec())),
        ),
        ("fortran.npy", foreign("<f4", true, "(40, 64)", &columns)),
        ("a.png", png::encode(&millimetres).unwrap()),
        ("a.exr", exr::encode(&image).unwrap()),
        ("a.pfm", pfm::encode(&image)),
    ] {
        fs::create_dir(program.path("in")).unwrap();
        program.put(&format!("in/{name}"), file);
        let input = format!("in/{name}");
        program.good(&[
            "sense",
            &input,
            "--model",
            "oak4-d",
            "--input-kind",
            "z",
            "-o",
            "out",
        ]);
        let stem = name.split_once('.').unwrap().0;
        let (shape, values) = read(&program, &format!("out/{stem}_depth_sensor_distance.npy"));
        assert_eq!(shape, [40, 64], "{name}");
        let measured = values.iter().filter(|&&z| z > 0.0).count();
        assert!(measured > 1500, "{name}: {measured}");
        assert!(
            values
                .iter()
                .all(|&z| z == 0.0 || (0.9..1.1).contains(&z) || (1.8..2.2).contains(&z))
        );
        let (_, first) = values_of_first(&program, &values);
        assert_eq!(values, first, "{name}");
        fs::remove_dir_all(program.path("in")).unwrap();
        fs::remove_dir_all(program.path("out")).unwrap();
    }
}

/// The result of the first form, kept in the folder.
fn values_of_first(program: &Program, now: &[f32]) -> (Vec<usize>, Vec<f32>) {
    let kept = program.path("first.npy");
    if !kept.exists() {
        fs::write(&kept, array(&[now.len(), 1], now)).unwrap();
    }
    read(program, "first.npy")
}

#[test]
fn what_is_no_surface_is_not_measured() {
    let program = Program::new();
    let mut metres = depth(64, 40);
    let wrong = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 0.0, -1.0];
    let row = 5 * 64;
    for (i, value) in wrong.into_iter().enumerate() {
        metres[row + 20 + i] = value;
    }
    program.put("depth.npy", array(&[40, 64], &metres));
    for engine in ["single-view", "stereo-noise"] {
        program.good(&[
            "sense",
            "depth.npy",
            "--model",
            "oak4-d",
            "--engine",
            engine,
            "--param",
            if engine == "single-view" {
                "outlierRemovalEnabled=0"
            } else {
                "jitter=0"
            },
            "-o",
            engine,
        ]);
        let (_, values) = read(&program, &format!("{engine}/depth_sensor_distance.npy"));
        assert!(values.iter().all(|z| z.is_finite() && *z >= 0.0));
        let holes = values[row + 10..row + 35].iter().filter(|&&z| z == 0.0).count();
        assert!(holes >= 4, "{engine}: {:?}", &values[row..row + 64]);
    }
}

#[test]
fn batches_stay_batches_and_frames_are_items() {
    let program = Program::new();
    let one = depth(32, 20);
    program.put("depth.npy", array(&[3, 20, 32], &one.repeat(3)));
    let run = |more: &[&str], output: &str| {
        program.good(&[&["sense", "depth.npy", "--model", "oak4-d", "-o", output], more].concat());
        read(&program, &format!("{output}/depth_sensor_distance.npy"))
    };
    let (shape, values) = run(&[], "side");
    assert_eq!(shape, [3, 20, 32]);
    let image = |i: usize| &values[i * 640..(i + 1) * 640];
    assert!(image(0) != image(1) && image(1) != image(2));
    // The same on any number of threads.
    for threads in ["1", "2", "8"] {
        assert_eq!(run(&["--threads", threads], threads).1, values);
    }
    // The first is the image alone; as a sequence, the others are frames of it.
    program.put("depth_0000.npy", array(&[20, 32], &one));
    program.put("depth_0001.npy", array(&[20, 32], &one));
    program.good(&[
        "sense",
        "depth_0001.npy",
        "depth_0000.npy",
        "--model",
        "oak4-d",
        "-o",
        "files",
    ]);
    assert_eq!(read(&program, "files/depth_sensor_distance_0000.npy").1, image(0));
    let (_, frames) = run(&["--sequence"], "frames");
    assert_eq!(frames[..640], *image(0));
    assert_eq!(
        read(&program, "files/depth_sensor_distance_0001.npy").1,
        frames[640..1280]
    );
    assert_ne!(frames[640..1280], *image(1));
    // Without a filter that remembers, no frame depends on another.
    program.good(&["sense", "depth_0001.npy", "--model", "oak4-d", "-o", "alone"]);
    assert_eq!(
        read(&program, "alone/depth_sensor_distance_0001.npy").1,
        frames[640..1280]
    );
    // With it they do, in the order of their numbers, whichever way they are given.
    for (output, order) in [
        ("t1", ["depth_0000.npy", "depth_0001.npy"]),
        ("t2", ["depth_0001.npy", "depth_0000.npy"]),
    ] {
        program.good(&[
            "sense", order[0], order[1], "--model", "oak4-d", "--filter", "temporal", "-o", output,
        ]);
    }
    let remembered = read(&program, "t1/depth_sensor_distance_0001.npy").1;
    assert_ne!(remembered, frames[640..1280]);
    assert_eq!(read(&program, "t2/depth_sensor_distance_0001.npy").1, remembered);
}

#[test]
fn a_pipe_gives_an_array() {
    let program = Program::new();
    let one = depth(32, 20);
    let through = |input: &[u8], more: &[&str]| {
        let mut child = program
            .command(&[&["sense", "-", "--model", "oak4-d", "--input-kind", "z"], more].concat())
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        child.stdin.take().unwrap().write_all(input).unwrap();
        let ended = child.wait_with_output().unwrap();
        let stderr = String::from_utf8(ended.stderr).unwrap();
        assert!(ended.status.success(), "{stderr}");
        (values(&ended.stdout), stderr)
    };
    let ((shape, values), said) = through(&array(&[2, 20, 32], &one.repeat(2)), &[]);
    assert_eq!(shape, [2, 20, 32]);
    assert!(said.contains("own-size"), "{said}");
    let ((shape, single), _) = through(&pfm::encode(&Image::new(32, 20, one.clone()).unwrap()), &[]);
    assert_eq!((shape, &single[..]), (vec![20, 32], &values[..640]));
    let ((shape, _), _) = through(
        &array(&[20, 32], &one),
        &["--align", "rgb", "--align-size", "96x54"],
    );
    assert_eq!(shape, [54, 96]);
    // The same into files.
    let mut child = program
        .command(&[
            "sense",
            "-",
            "--model",
            "oak4-d",
            "--input-kind",
            "z",
            "-o",
            "out",
            "--json",
        ])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    child
        .stdin
        .take()
        .unwrap()
        .write_all(&array(&[20, 32], &one))
        .unwrap();
    let ended = child.wait_with_output().unwrap();
    assert!(String::from_utf8(ended.stdout).unwrap().contains("\"images\": 1"));
    assert_eq!(read(&program, "out/depth_sensor_distance.npy").1, values[..640]);
    assert!(program.names().iter().all(|name| !name.contains(".part")));
}

#[test]
fn every_output() {
    let program = Program::new();
    program.put("depth_7.npy", array(&[40, 64], &depth(64, 40)));
    program.put(
        "rgb.png",
        png::encode(&Image::filled(64, 40, [10u8, 200, 30])).unwrap(),
    );
    let ended = program.run(&[
        "sense", "depth_7.npy", "--rgb", "rgb.png", "--model", "oak-d-pro-w-poe", "--engine", "single-view", "--param",
        "rgbDepthOutputMode=3", "--param", "confidenceThreshold=1", "--png16", "--preview", "--pointcloud",
        "--pointcloud-frame", "ros", "--align", "rgb", "--align-size", "96x54", "--outputs",
        "depth_sensor_point_cloud_position,depth_sensor_point_cloud_color,depth_sensor_imager,depth_sensor_output_visualization",
        "-o", "out",
    ]);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    insta::assert_snapshot!(format!("{}{}", ended.stdout, ended.stderr));
    let ply = fs::read(program.path("out/depth_sensor_point_cloud_7.ply")).unwrap();
    let text = String::from_utf8_lossy(&ply);
    assert!(text.contains("property float x") && text.contains("property uchar red"));
    // x is forward: the thing at 1 m, the wall at 2 m.
    let data = &ply[text.find("end_header\n").unwrap() + 11..];
    assert!(!data.is_empty() && data.len().is_multiple_of(15));
    for point in data.chunks_exact(15) {
        let x = f32::from_le_bytes(point[..4].try_into().unwrap());
        assert!(x == 1.0 || x == 2.0, "{x}");
        assert_eq!(point[12..], [10, 200, 30]);
    }
    let (shape, aligned) = read(&program, "out/depth_sensor_distance_aligned_rgb_7.npy");
    assert_eq!(shape, [54, 96]);
    assert!(aligned.iter().filter(|&&z| z > 0.0).count() > 2000);
    let millimetres = fs::read(program.path("out/depth_sensor_distance_millimetres_7.png")).unwrap();
    assert_eq!(png::decode::<u16>(&millimetres).unwrap().width(), 64);
}

#[test]
fn images_of_another_view_are_used_as_they_are_or_resampled() {
    let program = Program::new();
    program.put("depth.npy", array(&[40, 64], &depth(64, 40)));
    let mut all = String::new();
    for more in [
        &["--hfov", "60"][..],
        &["--hfov", "90", "--resample"],
        &["--fx", "40", "--preset", "robotics"],
    ] {
        let ended = program.run(
            &[
                &["sense", "depth.npy", "--model", "oak-d-pro-poe", "-o", "out"],
                more,
            ]
            .concat(),
        );
        assert_eq!(ended.code, 0, "{}", ended.stderr);
        let shape = read(&program, "out/depth_sensor_distance.npy").0;
        all += &format!(
            "$ {}\n{}{}{shape:?}\n",
            more.join(" "),
            ended.stdout,
            ended.stderr
        );
    }
    insta::assert_snapshot!(all);
}

#[test]
fn a_unit_aligns_by_its_own_calibration() {
    let program = Program::new();
    program.put("depth.npy", array(&[80, 128], &[3f32].repeat(80 * 128)));
    let run = |more: &[&str], output: &str| {
        let arguments = [
            "sense",
            "depth.npy",
            "--model",
            "oak-d-pro-poe",
            "--align",
            "rgb",
            "--align-size",
            "192x108",
        ];
        program.good(&[&arguments, more, &["-o", output]].concat());
        read(
            &program,
            &format!("{output}/depth_sensor_distance_aligned_rgb.npy"),
        )
        .1
    };
    let nominal = run(&[], "nominal");
    let unit = run(&["--calibration", EXAMPLE], "unit");
    assert_ne!(nominal, unit);
    for aligned in [nominal, unit] {
        let seen: Vec<f32> = aligned.into_iter().filter(|&z| z > 0.0).collect();
        assert!(seen.len() > 192 * 108 * 8 / 10, "{}", seen.len());
        assert!(seen.iter().all(|z| (2.7..3.3).contains(z)));
    }
    let nearest = run(&["--align-fill", "nearest"], "nearest");
    assert!(nearest.iter().filter(|&&z| z > 0.0).count() < 128 * 80);
}

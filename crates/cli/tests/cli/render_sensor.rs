//! `render`: what depth sensors report.

use std::fmt::Write;
use std::fs;

use oaktwin::image::{npy, png};
use serde_json::Value;

use crate::program::Program;

const ROOM: &str = include_str!("fixtures/room.usda");
const CRATE: &str = include_str!("fixtures/crate.obj");

/// All outputs of a depth sensor.
const ALL: &str = "depth_sensor_distance,depth_sensor_point_cloud_position,depth_sensor_point_cloud_color,\
                   depth_sensor_imager,depth_sensor_output_visualization";

/// A sensor that holds in a room of a few metres, 64 px wide.
const PRODUCT: &str = "
        float omni:rtx:post:depthSensor:baselineMM = 100
        float omni:rtx:post:depthSensor:confidenceThreshold = 1
        float omni:rtx:post:depthSensor:focalLengthPixel = 64
        float omni:rtx:post:depthSensor:sensorSizePixel = 64
        float omni:rtx:post:depthSensor:noiseMean = 0
        bool omni:rtx:post:depthSensor:outlierRemovalEnabled = 0
";

pub(crate) fn program() -> Program {
    let program = Program::new();
    program.put("room.usda", ROOM);
    program.put("crate.obj", CRATE);
    program.put("sensor.usda", with(PRODUCT));
    program
}

/// The room whose render product says this too.
fn with(attributes: &str) -> String {
    ROOM.replace(
        "rel camera = </World/Left>",
        &format!("rel camera = </World/Left>{attributes}"),
    )
}

pub(crate) fn array(program: &Program, name: &str) -> (Vec<usize>, Vec<f32>) {
    let array = npy::decode(&fs::read(program.path(name)).unwrap()).unwrap();
    let shape = array.shape.clone();
    let flat = npy::Array {
        shape: vec![1, shape.iter().product()],
        ..array
    };
    (shape, flat.into_f32_image().unwrap().into_pixels())
}

#[test]
fn everything_that_a_sensor_reports() {
    let program = program();
    let arguments = [
        "render",
        "sensor.usda",
        "-o",
        "out",
        "--annotators",
        ALL,
        "--ply",
        "--png16",
    ];
    let ended = program.run(&arguments);
    assert_eq!(
        (ended.code, ended.stdout.as_str()),
        (0, "out  /Render/Depth, 64x40, 1 frame\n")
    );
    insta::assert_snapshot!(format!("{}\n{}", program.names().join("\n"), ended.stderr));

    let (shape, distance) = array(&program, "out/depth_sensor_distance_0000.npy");
    assert_eq!(shape, [40, 64]);
    // 0.1 · 64 / 2 = 3.2 px to the right: the box's front, 2 m away.
    let row = &distance[20 * 64..21 * 64];
    let front: Vec<usize> = (0..64).filter(|&x| (row[x] - 2.0).abs() < 1e-5).collect();
    let (shape, positions) = array(&program, "out/depth_sensor_point_cloud_position_0000.npy");
    assert_eq!(shape, [40, 64, 4]);
    for &x in &front {
        let point = &positions[(20 * 64 + x) * 4..][..4];
        // Where it was seen, 3 px to the left, in USD's axes.
        let expected = (x as f32 - 3.0 + 0.5 - 32.0) / 64.0 * 2.0;
        assert!((point[0] - expected).abs() < 1e-5, "{point:?} for {expected}");
        assert!((point[2] + 2.0).abs() < 1e-5 && point[3] == 1.0, "{point:?}");
    }
    assert_eq!((front.first(), front.last()), (Some(&27), Some(&42)));
    assert!(row[..3].iter().chain(&row[20..27]).any(|z| *z == 0.0));
}

#[test]
fn only_what_was_asked_for_is_written() {
    let program = program();
    program.good(&[
        "render",
        "room.usda",
        "-o",
        "out",
        "--annotators",
        "depth_sensor_imager",
    ]);
    assert_eq!(
        program.names(),
        [
            "crate.obj",
            "out",
            "out/depth_sensor_imager_0000.npy",
            "out/metadata.txt",
            "room.usda",
            "sensor.usda"
        ]
    );
    // The same is measured whatever is written beside it.
    let distance = |folder: &str, annotators: &str| {
        program.good(&["render", "room.usda", "-o", folder, "--annotators", annotators]);
        fs::read(program.path(&format!("{folder}/depth_sensor_distance_0000.npy"))).unwrap()
    };
    assert_eq!(distance("a", "depth_sensor_distance"), distance("b", "all"));
}

#[test]
fn parameters_are_the_stages_then_the_schemas_then_the_flags() {
    let program = program();
    let parameters = |arguments: &[&str]| -> Value {
        let fixed = [
            "render",
            "--annotators",
            "depth_sensor_distance",
            "--json",
            "-o",
            "out",
        ];
        let printed = program.good(&[&fixed[..], arguments].concat());
        let report: Value = serde_json::from_str(&printed).unwrap();
        report["cameras"][0]["depth_sensor"].clone()
    };
    let said = |arguments: &[&str], name: &str| {
        parameters(arguments)["parameters"][name]
            .as_str()
            .unwrap()
            .to_owned()
    };
    assert_eq!(said(&["room.usda"], "confidenceThreshold"), "0.95");
    assert_eq!(said(&["room.usda", "--isaac", "6"], "confidenceThreshold"), "0.7");
    // A bool is of Isaac Sim 6.
    assert_eq!(said(&["sensor.usda"], "maxDisparityPixel"), "110");
    assert_eq!(said(&["sensor.usda"], "noiseMean"), "0");
    let newer = "\n        bool omni:rtx:post:depthSensor:outlierRemovalEnabled = 1\n";
    program.put("newer.usda", with(newer));
    assert_eq!(said(&["newer.usda"], "confidenceThreshold"), "0.7");
    assert_eq!(said(&["newer.usda"], "outlierRemovalEnabled"), "1");
    assert_eq!(
        said(&["sensor.usda", "--param", "noise-mean=0.5"], "noiseMean"),
        "0.5"
    );
    let oak = [
        "crate.obj",
        "--model",
        "oak4-d",
        "--look-at",
        "-2",
        "0",
        "1",
        "0",
        "0",
        "0",
    ];
    assert_eq!(parameters(&oak)["engine"], "stereo-noise");
    let isaac = [&oak[..], &["--engine", "single-view"]].concat();
    assert_eq!(said(&isaac, "baselineMM"), "75");
    let stereo = parameters(&["sensor.usda", "--engine", "stereo-noise"]);
    assert_eq!(
        (&stereo["engine"], &stereo["parameters"]["baseline"]),
        (&"stereo-noise".into(), &"0.1".into())
    );
}

#[test]
fn suspicious_attributes_of_a_stage_are_reported() {
    let program = program();
    program.put(
        "odd.usda",
        with(
            "
        double omni:rtx:post:depthSensor:baselineMM = 80
        float omni:rtx:post:depthSensor:maxDistanc = 4
        float omni:rtx:post:depthSensor:noiseSigma.timeSamples = { 0: 0.5, 1: 0.6 }
        bool omni:rtx:post:depthSensor:enabled = 0
",
        ),
    );
    let ended = program.run(&[
        "render",
        "odd.usda",
        "-o",
        "out",
        "--annotators",
        "depth_sensor_distance",
    ]);
    assert_eq!(ended.code, 0);
    insta::assert_snapshot!(ended.stderr);
}

#[test]
fn invalid_requests_are_rejected() {
    let program = program();
    let wrong = |name: &str, attribute: &str| {
        let attribute = format!("\n        {attribute}\n");
        program.put(
            name,
            with(&attribute.replace("SENSOR", "omni:rtx:post:depthSensor")),
        );
    };
    wrong("text.usda", "string SENSOR:baselineMM = \"75\"");
    wrong("mode.usda", "int SENSOR:rgbDepthOutputMode = 8");
    wrong("range.usda", "float SENSOR:confidenceThreshold = 1.5");
    wrong("zero.usda", "float SENSOR:focalLengthPixel = 0");
    let distance = ["--annotators", "depth_sensor_distance"];
    let look = ["--look-at", "-2", "0", "1", "0", "0", "0"];
    let runs: [&[&str]; 19] = [
        &["room.usda", "--annotators", "depth_sensor_distanc"],
        &["room.usda", "--annotators", "DepthSensorDistance"],
        &[&["room.usda", "--camera", "Right"], &distance[..]].concat(),
        &[
            &["crate.obj", "--model", "oak4-d", "--camera", "left"],
            &look[..],
            &distance,
        ]
        .concat(),
        &[&["text.usda"], &distance[..]].concat(),
        &[&["mode.usda"], &distance[..]].concat(),
        &[&["range.usda"], &distance[..]].concat(),
        &[&["zero.usda"], &distance[..]].concat(),
        &[&["room.usda", "--param", "maxDistanc=2"], &distance[..]].concat(),
        &[&["room.usda", "--param", "maxDistance=far"], &distance[..]].concat(),
        &[
            &[
                "room.usda",
                "--param",
                "minDistance=9",
                "--param",
                "maxDistance=8",
            ],
            &distance[..],
        ]
        .concat(),
        &[&["room.usda", "--filter", "sharpen"], &distance[..]].concat(),
        &["room.usda", "--sweep", "maxDistance"],
        &["room.usda", "--sweep", "maxDistance=2,"],
        &["room.usda", "--sweep", "maxDistance=2,near"],
        &["room.usda", "--sweep", "maximalDistance=2,4"],
        &["room.usda", "--sweep", "engine=stereo"],
        &[
            "room.usda",
            "--sweep",
            "maxDistance=2",
            "--sweep",
            "minDistance=1",
            "--sweep",
            "seed=1",
        ],
        &["room.usda", "--camera", "Right", "--sweep", "maxDistance=2,4"],
    ];
    let mut all = String::new();
    for arguments in runs {
        let refused = program.refused(&[&["render"], arguments].concat());
        let _ = write!(all, "$ oaktwin render {}\n{refused}", arguments.join(" "));
    }
    insta::assert_snapshot!(all);
}

#[test]
fn a_camera_without_a_sensor_beside_one_with() {
    let program = program();
    let both = [
        "render",
        "room.usda",
        "-o",
        "out",
        "--camera",
        "Right",
        "--camera",
        "Depth",
    ];
    let named = program.run(&[&both[..], &["--annotators", "depth_sensor_distance"]].concat());
    assert_eq!(named.code, 0, "{}", named.stderr);
    assert!(
        named.stderr.contains("note[no-depth-sensor]: /World/Right: "),
        "{}",
        named.stderr
    );
    assert!(
        program
            .path("out/Depth/depth_sensor_distance/depth_sensor_distance_0000.npy")
            .is_file()
    );
    let all = program.run(&[&both[..], &["--annotators", "all"]].concat());
    assert!(
        all.code == 0 && !all.stderr.contains("no-depth-sensor"),
        "{}",
        all.stderr
    );
    let alone = [
        "render",
        "room.usda",
        "-o",
        "alone",
        "--camera",
        "Right",
        "--annotators",
        "all",
    ];
    assert_eq!(program.run(&alone).code, 0);
}

#[test]
fn a_sweep_is_one_picture() {
    let program = program();
    let sheet = |folder: &str, more: &[&str]| {
        let fixed = [
            "render",
            "sensor.usda",
            "--annotators",
            "camera_params",
            "-o",
            folder,
        ];
        program.good(&[&fixed[..], more].concat());
        fs::read(program.path(&format!("{folder}/sweep_0000.png"))).unwrap()
    };
    let one = sheet("one", &["--sweep", "maxDistance=2,2.5,8"]);
    let table = ["--sweep", "maxDistance=2,2.5,8", "--sweep", "minDistance=0.1,1.5"];
    let two = sheet("two", &table);
    let size = |bytes: &[u8]| {
        let picture = png::decode::<[u8; 3]>(bytes).unwrap();
        (picture.width(), picture.height())
    };
    assert!(size(&one).0 > 3 * 64 && size(&one).1 > 2 * 40);
    assert!(size(&two).0 > size(&one).0 && size(&two).1 >= size(&one).1);
    for threads in ["1", "8"] {
        assert!(sheet(threads, &[&table[..], &["--threads", threads]].concat()) == two);
    }
    // Two engines beside each other, and the camera's folder where there are several.
    program.good(&[
        "render",
        "sensor.usda",
        "-o",
        "many",
        "--camera",
        "Depth",
        "--camera",
        "Right",
        "--sweep",
        "engine=single-view,stereo-noise",
    ]);
    assert!(program.path("many/Depth/sweep/sweep_0000.png").is_file());
    assert!(!program.path("many/Right/sweep").exists());
}

#[test]
fn the_same_bytes_on_any_number_of_threads() {
    let program = program();
    let written = |threads: &str| -> Vec<Vec<u8>> {
        program.good(&[
            "render",
            "crate.obj",
            "-o",
            threads,
            "--model",
            "oak4-d",
            "--look-at",
            "-2",
            "0",
            "1",
            "0",
            "0",
            "0",
            "--resolution",
            "320x200",
            "--annotators",
            ALL,
            "--engine",
            "single-view",
            "--threads",
            threads,
        ]);
        let names = program.names().into_iter();
        let names = names.filter(|name| name.starts_with(&format!("{threads}/")));
        names.map(|name| fs::read(program.path(&name)).unwrap()).collect()
    };
    let one = written("1");
    assert_eq!(one.len(), 6);
    for threads in ["2", "8"] {
        assert!(written(threads) == one, "{threads} threads");
    }
}

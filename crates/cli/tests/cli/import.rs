//! `calibration import`: from an export and back, options, and errors that `--force` ignores.

use std::fs;

use crate::program::{EXAMPLE, Program};

#[test]
fn exports_import_without_options() {
    let program = Program::new();
    for (format, files) in [
        ("ros", &["left.yaml", "right.yaml", "rgb.yaml"][..]),
        ("opencv", &["left.yml", "right.yml", "rgb.yml", "stereo.yml"]),
        ("kalibr", &["camchain.yaml", "imu.yaml"]),
    ] {
        program.good(&[
            "calibration",
            "export",
            EXAMPLE,
            "--to",
            format,
            "-o",
            &format!("{format}/"),
        ]);
        let files: Vec<String> = files.iter().map(|name| format!("{format}/{name}")).collect();
        let mut arguments = vec!["calibration", "import"];
        arguments.extend(files.iter().map(String::as_str));
        let out = format!("{format}.json");
        arguments.extend(["--model", "OAK-D-Pro-PoE", "-o", &out]);
        program.good(&arguments);
        program.good(&["calibration", "show", &out]);
        let shown = program.good(&["show", "OAK-D-Pro-PoE", "--calibration", &out]);
        assert!(shown.contains("74.58"), "{format}: {shown}");
    }
}

#[test]
fn the_result_is_never_written_over_an_input() {
    let program = Program::new();
    program.good(&[
        "calibration",
        "export",
        EXAMPLE,
        "--to",
        "kalibr",
        "-o",
        "camchain.yaml",
    ]);
    let before = fs::read(program.path("camchain.yaml")).unwrap();
    let error = program.refused(&["calibration", "import", "camchain.yaml", "-o", "camchain.yaml"]);
    assert!(error.contains("is an input"), "{error}");
    assert_eq!(fs::read(program.path("camchain.yaml")).unwrap(), before);
}

#[test]
fn another_unit_of_length_is_an_error() {
    let program = Program::new();
    program.good(&[
        "calibration",
        "export",
        EXAMPLE,
        "--to",
        "kalibr",
        "-o",
        "camchain.yaml",
    ]);
    let import = [
        "calibration",
        "import",
        "camchain.yaml",
        "--unit",
        "mm",
        "-o",
        "out.json",
    ];
    let error = program.refused(&import);
    assert!(error.contains("--unit") && error.contains("--force"), "{error}");
    assert!(!program.path("out.json").exists());
    let checked = [&import[..], &["--model", "OAK-D-Pro-PoE"]].concat();
    let error = program.refused(&checked);
    assert!(error.contains("the baseline is 0.07 mm"), "{error}");
    program.good(&[&import[..], &["--force"]].concat());
    for wrong in [["--camera", "front=left"], ["--size", "wide"]] {
        let error = program.refused(&[&import[..3], &wrong].concat());
        assert!(error.contains(wrong[0]), "{error}");
    }
}

/// A calibration whose lenses Kalibr cannot represent.
#[test]
fn sizes_that_the_model_does_not_have() {
    let program = Program::new();
    program.good(&["calibration", "export", EXAMPLE, "--to", "ros", "-o", "ros/"]);
    let sized = |name: &str, width: &str, height: &str| {
        let text = fs::read_to_string(program.path(&format!("ros/{name}.yaml"))).unwrap();
        let text = text
            .replace("image_width: 1280", &format!("image_width: {width}"))
            .replace("image_height: 800", &format!("image_height: {height}"));
        program.put(&format!("{name}.yaml"), text);
    };
    let mut all = String::new();
    for (left, right) in [
        (["1920", "1200"], ["1920", "1200"]),
        (["1280", "800"], ["640", "400"]),
        (["1000", "1000"], ["1000", "1000"]),
        (["0", "800"], ["0", "800"]),
        (["1280", "-800"], ["1280", "-800"]),
    ] {
        sized("left", left[0], left[1]);
        sized("right", right[0], right[1]);
        let run = program.run(&[
            "calibration",
            "import",
            "left.yaml",
            "right.yaml",
            "--model",
            "OAK-D Pro PoE",
            "-o",
            "cal.json",
        ]);
        all += &format!(
            "{} and {}\n{}exit code {}\n\n",
            left.join("x"),
            right.join("x"),
            run.stderr,
            run.code
        );
    }
    insta::assert_snapshot!(all);
}

#[test]
fn a_lens_that_a_format_cannot_represent_is_an_error() {
    let program = Program::new();
    let mut calibration: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(EXAMPLE).unwrap()).unwrap();
    calibration["cameraData"][0][1]["distortionCoeff"] =
        serde_json::json!([0.0, 0.0, 0.2, 0.2, 0.0, 0.0, 0.0, 0.0, 0.3, 0.0, -0.3]);
    program.put("odd.json", calibration.to_string());
    let export = [
        "calibration",
        "export",
        "odd.json",
        "--to",
        "kalibr",
        "-o",
        "camchain.yaml",
    ];
    let error = program.refused(&export);
    assert!(
        error.contains("the residual is") && error.contains("--force"),
        "{error}"
    );
    assert!(!program.path("camchain.yaml").exists());
    program.good(&[&export[..], &["--force"]].concat());
}

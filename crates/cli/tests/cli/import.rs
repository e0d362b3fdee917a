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

//! Bad input: each refused in one line that names file, place and remedy; nothing left behind.

use std::fmt::Write;
use std::fs;

use crate::program::{EXAMPLE, Program};

/// Files that are nobody's calibration, asset or catalog.
fn spoil(program: &Program) -> Vec<&'static str> {
    let example = fs::read(EXAMPLE).unwrap();
    program.put("empty", "");
    program.put("truncated", &example[..example.len() / 2]);
    program.put("binary", (0..=255u8).cycle().take(5000).collect::<Vec<_>>());
    program.put("latin1", b"{\"productName\": \"caf\xe9\"}");
    program.put("array", "[1, 2, 3]");
    program.put(
        "nan",
        String::from_utf8(example)
            .unwrap()
            .replacen("\"version\": 7", "\"version\": NaN", 1),
    );
    fs::create_dir(program.path("folder")).unwrap();
    vec![
        "empty",
        "truncated",
        "binary",
        "latin1",
        "array",
        "nan",
        "folder",
        "missing",
    ]
}

#[test]
fn files_that_are_none() {
    let program = Program::new();
    let mut all = String::new();
    for name in spoil(&program) {
        for arguments in [
            &["calibration", "show", name][..],
            &["calibration", "export", name, "--to", "ros"],
            &["calibration", "import", name],
            &["show", "oak4-d", "--calibration", name],
            &["asset", "oak4-d", "--calibration", name, "-o", "x.usd"],
            &[
                "asset",
                "oak-d-pro-poe",
                "--calibration",
                EXAMPLE,
                "--over",
                name,
                "-o",
                "x.usda",
            ],
            &["check", name],
            &["models", "--catalog", name],
        ] {
            let error = program.refused(arguments);
            assert!(error.contains(name), "{arguments:?}: {error}");
            let _ = write!(
                all,
                "$ oaktwin {}\n{error}",
                arguments.join(" ").replace(EXAMPLE, "EXAMPLE")
            );
        }
    }
    insta::assert_snapshot!(all);
}

#[test]
fn errors_of_a_calibration_are_on_standard_error() {
    let program = Program::new();
    let text = fs::read_to_string(EXAMPLE).unwrap();
    let mut calibration: serde_json::Value = serde_json::from_str(&text).unwrap();
    calibration["cameraData"][0][1]["width"] = serde_json::json!(9999);
    program.put("bad.json", calibration.to_string());
    for more in [&[][..], &["--json"]] {
        let ended = program.run(&[&["calibration", "show", "bad.json"], more].concat());
        assert_eq!(ended.code, 2, "{}", ended.stdout);
        assert!(!ended.stdout.is_empty());
        assert!(ended.stderr.starts_with("error: bad.json: "), "{}", ended.stderr);
        assert_eq!(ended.stderr.lines().count(), 1, "{}", ended.stderr);
    }
}

#[test]
fn a_hundred_megabytes_of_nothing() {
    let program = Program::new();
    let big = fs::File::create(program.path("big")).unwrap();
    big.set_len(100 << 20).unwrap();
    for arguments in [&["calibration", "show", "big"][..], &["check", "big"]] {
        assert!(program.refused(arguments).contains("big: "), "{arguments:?}");
    }
    fs::rename(program.path("big"), program.path("big.toml")).unwrap();
    program.refused(&["models", "--catalog", "."]);
}

#[test]
fn invalid_names_and_options() {
    let program = Program::new();
    let mut all = String::new();
    for arguments in [
        &["show", "OAK-D Pro POW"][..],
        &["show", "kinect"],
        &["compare", "oak4-d", "oak5"],
        &["asset", "oakdd", "-o", "x.usd"],
        &["asset", "all", "--calibration", EXAMPLE, "-o", "x"],
        &["asset", "oak4-d", "-o", "x.obj"],
        &["asset", "oak4-d", "-o", "x.usda", "--format", "usdz"],
        &["asset", "oak4-d", "--lens", "fisheye", "-o", "x.usd"],
        &["asset", "oak-d-tof", "--extended-disparity", "-o", "x.usd"],
        &["asset", "oak-d-tof", "--calibration", EXAMPLE, "-o", "x.usd"],
        &["calibration", "export", "oak-9", "--to", "ros"],
        &["man", "calibratoin"],
    ] {
        let _ = write!(
            all,
            "$ oaktwin {}\n{}",
            arguments.join(" ").replace(EXAMPLE, "EXAMPLE"),
            program.refused(arguments)
        );
    }
    insta::assert_snapshot!(all);
}

#[cfg(target_os = "linux")]
#[test]
fn outputs_that_cannot_be_written() {
    use std::os::unix::fs::symlink;

    let program = Program::new();
    program.put("file", "kept");
    program.put("readonly.usd", "kept");
    let mut permissions = fs::metadata(program.path("readonly.usd")).unwrap().permissions();
    permissions.set_readonly(true);
    fs::set_permissions(program.path("readonly.usd"), permissions).unwrap();
    symlink("loop.usd", program.path("loop.usd")).unwrap();
    let mut all = String::new();
    for output in [
        "no/folder/x.usd",
        "file/x.usd",
        "readonly.usd",
        "loop.usd",
        "/dev/full",
        "/proc/x.usd",
    ] {
        let arguments = ["asset", "oak4-d", "--format", "usd", "-o", output];
        let _ = write!(
            all,
            "$ oaktwin {}\n{}",
            arguments.join(" "),
            program.refused(&arguments)
        );
    }
    let _ = write!(all, "{}", program.refused(&["asset", "all", "-o", "file"]));
    insta::assert_snapshot!(all);
    assert_eq!(fs::read_to_string(program.path("readonly.usd")).unwrap(), "kept");

    // Through a link to a file, and to a folder.
    fs::create_dir(program.path("real")).unwrap();
    symlink("real", program.path("linked")).unwrap();
    symlink("real/target.usd", program.path("link.usd")).unwrap();
    program.good(&["asset", "oak4-d", "-o", "linked"]);
    program.good(&["asset", "oak4-d", "-o", "link.usd"]);
    assert!(program.path("real/oak4_d.usd").is_file() && program.path("real/target.usd").is_file());
    assert!(program.path("link.usd").is_symlink());
}

#[test]
fn an_input_is_never_written_over() {
    let program = Program::new();
    let copy = program.put("cal.json", fs::read(EXAMPLE).unwrap());
    let error = program.refused(&[
        "calibration",
        "export",
        "cal.json",
        "--to",
        "depthai",
        "-o",
        "cal.json",
    ]);
    assert!(error.contains("cal.json: is an input"), "{error}");
    assert_eq!(fs::read(copy).unwrap(), fs::read(EXAMPLE).unwrap());
}

#[test]
fn a_users_catalog_adds_a_model_and_its_mistakes_have_lines() {
    let program = Program::new();
    let builtin = concat!(env!("CARGO_MANIFEST_DIR"), "/../catalog/data/devices/oak4_d.toml");
    let text = fs::read_to_string(builtin).unwrap();
    let own = text
        .replace("\"oak4_d\"", "\"my_cam\"")
        .replace("\"OAK4-D\"", "\"My Cam\"");
    let own: String = own
        .lines()
        .map(|line| {
            if line.starts_with("aliases") {
                "aliases = []\n".to_owned()
            } else {
                format!("{line}\n")
            }
        })
        .collect();
    fs::create_dir(program.path("catalog")).unwrap();
    program.put("catalog/my_cam.toml", &own);
    assert!(
        program
            .good(&["models", "--catalog", "catalog"])
            .contains("My Cam")
    );
    program.good(&["asset", "my cam", "--catalog", "catalog", "-o", "x.usd"]);
    let checked = program.run(&["check", "x.usd", "--catalog", "catalog"]);
    assert_eq!(checked.code, 0, "{}", checked.stdout);

    for (from, to, expected) in [
        ("hfov_deg = 68.0", "hfov_rad = 1.2", "hfov_deg"),
        ("hfov_deg = 68.0", "", "hfov_deg"),
        (
            "sensor = \"IMX586\"",
            "sensor = \"IMX587\"",
            "did you mean 'IMX582'?",
        ),
        ("hfov_deg = 68.0", "hfov_deg = \"wide\"", "expected a number"),
        ("hfov_deg = 68.0", "hfov_deg = nan", "finite"),
    ] {
        program.put("catalog/my_cam.toml", own.replacen(from, to, 1));
        let error = program.refused(&["models", "--catalog", "catalog"]);
        assert!(
            error.contains("my_cam.toml:") && error.contains(expected),
            "{error}"
        );
    }
}

#[test]
fn paths_that_look_like_options_are_unchanged() {
    let program = Program::new();
    fs::create_dir(program.path("run--time")).unwrap();
    for arguments in [
        &["render", "run--time/scene.usd"][..],
        &[
            "sense",
            "run--time/with -o/scene.npy",
            "--model",
            "oak4-d",
            "--input-kind",
            "z",
            "-o",
            "out",
        ],
    ] {
        let error = program.refused(arguments);
        assert!(error.contains(arguments[1]), "{error}");
    }
}

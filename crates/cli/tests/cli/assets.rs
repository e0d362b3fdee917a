//! Tests of assets: output paths, and that `check` accepts assets with every option.

use std::fs;

use crate::program::{EXAMPLE, Program};

const STEMS: [&str; 5] = [
    "oak4_d",
    "oak4_d_wide",
    "oak_d_pro_poe",
    "oak_d_pro_w_poe",
    "oak_d_tof",
];

#[test]
fn assets_are_reproducible_in_every_format() {
    let program = Program::new();
    for format in ["usda", "usd", "usdz"] {
        for folder in ["one", "two"] {
            program.good(&["asset", "all", "-o", folder, "--format", format]);
        }
        for stem in STEMS {
            let name = format!("{stem}.{format}");
            let read = |folder: &str| fs::read(program.path(folder).join(&name)).unwrap();
            assert_eq!(read("one"), read("two"), "{name}");
        }
    }
    assert_eq!(
        fs::read(program.path("one/oak4_d.usd")).unwrap(),
        fs::read(program.path("one/oak4_d.usda")).unwrap()
    );
}

#[test]
fn writes_a_single_asset_to_a_file_or_folder() {
    let program = Program::new();
    assert_eq!(
        program.good(&["asset", "OAK4-D", "-o", "mine.usdz"]),
        "mine.usdz\n"
    );
    assert_eq!(&fs::read(program.path("mine.usdz")).unwrap()[..2], b"PK");
    assert_eq!(
        program.good(&["asset", "OAK4-D", "-o", "folder"]),
        "folder/oak4_d.usd\n"
    );
    assert_eq!(
        program.good(&["asset", "OAK4-D", "-o", "folder", "--format", "usda"]),
        "folder/oak4_d.usda\n"
    );
    assert_eq!(
        program.names(),
        ["folder", "folder/oak4_d.usd", "folder/oak4_d.usda", "mine.usdz"]
    );
}

/// `check` prints findings that differ only in their cameras as one line; its JSON has one for each camera.
#[test]
fn check_groups_findings_of_several_cameras() {
    let program = Program::new();
    program.good(&["asset", "OAK4-D", "-o", "x.usd"]);
    let text = program.good(&["check", "x.usd"]);
    let lines: Vec<&str> = text
        .lines()
        .filter(|line| line.starts_with("note[legacy-distortion]"))
        .collect();
    let json: serde_json::Value = serde_json::from_str(&program.good(&["check", "x.usd", "--json"])).unwrap();
    let findings = json["findings"].as_array().unwrap().iter();
    let places: Vec<&str> = findings
        .filter(|finding| finding["code"] == "legacy-distortion")
        .map(|finding| finding["place"].as_str().unwrap())
        .collect();
    assert!(places.len() > 1, "{places:?}");
    assert_eq!(lines.len(), 1, "{text}");
    assert!(
        lines[0].starts_with(&format!("note[legacy-distortion]: {}: ", places.join(", "))),
        "{}",
        lines[0]
    );
}

/// `check` reports neither warnings nor errors for any asset that the program writes.
#[test]
fn exhaustive_options_of_assets_are_accepted_by_check() {
    let program = Program::new();
    let options: [&[&str]; 8] = [
        &[],
        &["--isaac", "6"],
        &["--isaac", "6", "--legacy-distortion"],
        &["--target", "ovrtx"],
        &["--rigid-body"],
        &["--no-body"],
        &["--extended-disparity"],
        &["--lens", "fisheye"],
    ];
    let mut written = 0;
    for stem in STEMS {
        for option in options {
            let wide = stem.contains("w_") || stem.ends_with("wide");
            if (option.contains(&"fisheye") && !wide)
                || (option.contains(&"--extended-disparity") && stem.contains("tof"))
            {
                program.refused(&[&["asset", stem, "-o", "no.usd"], option].concat());
                continue;
            }
            program.good(&[&["asset", stem, "-o", "x.usd"], option].concat());
            let checked = program.run(&["check", "x.usd"]);
            assert_eq!(checked.code, 0, "{stem} {option:?}: {}", checked.stdout);
            written += 1;
        }
    }
    assert_eq!(written, 5 * 8 - 3 - 1);
    for offsets in ["openusd", "document", "zero"] {
        program.good(&[
            "asset",
            "oak-d-pro-poe",
            "--calibration",
            EXAMPLE,
            "--aperture-offsets",
            offsets,
            "-o",
            "x.usd",
        ]);
        let checked = program.run(&["check", "x.usd"]);
        assert_eq!(checked.code, 0, "{offsets}: {}", checked.stdout);
    }
}

#[test]
fn writes_overrides_on_an_asset_in_another_folder() {
    let program = Program::new();
    program.good(&["asset", "oak-d-pro-poe", "-o", "vendor/"]);
    let over = [
        "asset",
        "oak-d-pro-poe",
        "--calibration",
        EXAMPLE,
        "--over",
        "vendor/oak_d_pro_poe.usd",
    ];
    fs::create_dir(program.path("mine")).unwrap();
    program.good(&[&over[..], &["-o", "mine/unit.usda"]].concat());
    assert!(
        fs::read_to_string(program.path("mine/unit.usda"))
            .unwrap()
            .contains("@../vendor/oak_d_pro_poe.usd@")
    );
    let checked = program.run(&["check", "mine/unit.usda"]);
    assert_eq!(checked.code, 0, "{}", checked.stdout);
    // Neither the base itself nor another model's asset is accepted.
    assert!(
        program
            .refused(&[&over[..], &["-o", "vendor/oak_d_pro_poe.usd"]].concat())
            .contains("is an input")
    );
    program.good(&["asset", "oak4-d", "-o", "vendor/"]);
    let other = [
        "asset",
        "oak-d-tof",
        "--calibration",
        EXAMPLE,
        "--force",
        "--over",
        "vendor/oak4_d.usd",
        "-o",
        "x.usda",
    ];
    program.refused(&other);
}

#[test]
fn demo_writes_assets_a_unit_and_a_room() {
    let program = Program::new();
    let printed = program.good(&["demo"]);
    for name in [
        "oak_d_pro_poe.usd",
        "oak_d_pro_w_poe.usd",
        "oak4_d.usd",
        "oak4_d_wide.usd",
        "oak_d_tof.usd",
        "example_calibration.json",
        "oak_d_pro_poe_unit.usd",
        "demo_room.png",
    ] {
        assert!(
            program.path("oaktwin-demo").join(name).is_file() && printed.contains(name),
            "{name}"
        );
    }
    assert!(printed.contains("Close-Range Accuracy"));
    for stem in STEMS {
        for name in [
            "rgb_0000.png",
            "distance_to_image_plane_0000.npy",
            "distance_to_image_plane_preview_0000.png",
        ] {
            let path = program.path("oaktwin-demo/demo_room").join(stem).join(name);
            assert!(path.is_file(), "{}", path.display());
        }
    }
    program.good(&["check", "oaktwin-demo/oak_d_pro_poe_unit.usd"]);
}

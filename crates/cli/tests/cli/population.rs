//! `population`, and the drift of a pair since its calibration.

use serde_json::Value;

use crate::program::Program;

fn words(line: &str) -> Vec<&str> {
    line.split_whitespace().collect()
}

#[test]
fn units_are_calibrations_of_their_model() {
    let program = Program::new();
    let out = program.good(&words("population OAK-D-Pro-PoE -n 3 --seed 5 -o units --json"));
    let report: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(
        (&report["basis"], &report["spread"]["units"]),
        (&"measured".into(), &4.into())
    );
    let unit = &report["units"][2];
    assert_eq!(unit["file"], "oak_d_pro_poe_000002.json");
    let shown = program.good(&words("calibration show units/oak_d_pro_poe_000002.json --json"));
    let shown: Value = serde_json::from_str(&shown).unwrap();
    assert_eq!(
        shown["cameras"][1]["camera_matrix"][0][0],
        unit["left_focal_length_px"]
    );
    let table = std::fs::read_to_string(program.path("units/units.csv")).unwrap();
    assert_eq!(table.lines().count(), 4);
    // A unit does not depend on how many there are.
    program.good(&words("population OAK-D-Pro-PoE -n 5 --seed 5 -o more"));
    let [few, more] = ["units", "more"]
        .map(|folder| std::fs::read(program.path(&format!("{folder}/oak_d_pro_poe_000002.json"))).unwrap());
    assert_eq!(few, more);
    program.good(&words(
        "asset OAK-D-Pro-PoE --calibration units/oak_d_pro_poe_000000.json -o unit.usd",
    ));
}

#[test]
fn bad_inputs_are_explained() {
    let program = Program::new();
    program.put("file", "");
    program.good(&words("population OAK4-D -n 1 -o own"));
    for (line, expected) in [
        ("population OAK-D-Por-PoE -o units", "did you mean"),
        ("population OAK-D -n 2 -o file", "file"),
        (
            "accuracy OAK4-D --drift yawn=1",
            "drift: yawn: unknown parameter of drift; did you mean 'yaw'?",
        ),
        (
            "accuracy OAK4-D --population --calibration own/oak4_d_000000.json",
            "units are drawn around the nominal device; remove it, or the calibration",
        ),
        ("accuracy OAK4-D --drift yaw", "write NAME=VALUE"),
        (
            "accuracy OAK4-D --drift yaw=99",
            "expected a number from -50 to 50 mrad",
        ),
    ] {
        let error = program.refused(&words(line));
        assert!(error.contains(expected), "{line}: {error}");
    }
    let zero = program.run(&words("population OAK-D -n 0 -o units"));
    assert!(
        zero.code == 2 && zero.stderr.contains("1..=100000"),
        "{}",
        zero.stderr
    );
    let noted = program.run(&words(
        "accuracy OAK-D-ToF --sensor tof --drift yaw=1 --distances 1 --devices 1",
    ));
    assert!(
        noted.stderr.contains("has no stereo pair that drifts"),
        "{}",
        noted.stderr
    );
}

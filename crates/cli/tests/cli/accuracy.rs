//! `accuracy`: whole outputs, bad inputs, exit codes. What is snapshot has no noise.

use std::fmt::Write;

use crate::program::Program;

const QUIET: [&str; 6] = [
    "--param",
    "bias=-0.1",
    "--param",
    "jitter=0",
    "--distances",
    "1,3.9,7:9:1,12",
];

#[test]
fn one_device() {
    let program = Program::new();
    let arguments = [&["accuracy", "oak-d-pro-poe"], &QUIET[..], &["--captures", "2"]].concat();
    insta::assert_snapshot!(program.good(&arguments));
}

#[test]
fn the_median_of_many_devices() {
    let program = Program::new();
    let arguments = [
        "accuracy",
        "oak4-d-wide",
        "--devices",
        "7",
        "--distances",
        "1,4",
        "--captures",
        "1",
    ];
    let text = program.good(&arguments);
    assert!(text.contains("the median of 7 devices (seeds 0 to 6)"), "{text}");
    assert!(
        text.contains("an estimate in the parameter sheet; nothing is published"),
        "{text}"
    );
    assert!(
        text.contains("Inside the published accuracy at all 2 distances."),
        "{text}"
    );
    assert!(text.lines().all(|line| line.chars().count() <= 130), "{text}");
    let rows = text.lines().skip_while(|line| !line.starts_with("Distance"));
    assert!(rows.take(5).all(|line| line.chars().count() <= 100), "{text}");
    assert_eq!(
        text,
        program.good(&[&arguments[..], &["--threads", "1"]].concat())
    );
}

#[test]
fn outside_of_a_band_is_a_finding() {
    let program = Program::new();
    let arguments = [
        "accuracy",
        "oak4-d",
        "--param",
        "bias=-1",
        "--distances",
        "3,20",
        "--captures",
        "1",
    ];
    let ended = program.run(&arguments);
    assert_eq!(ended.code, 1, "{}", ended.stderr);
    assert!(
        ended
            .stdout
            .contains("OUTSIDE the published accuracy at 1 of 1 distance: 3.00 m."),
        "{}",
        ended.stdout
    );
    assert!(ended.stdout.contains("no band"), "{}", ended.stdout);
}

#[test]
fn both_interpretations_are_reported() {
    let program = Program::new();
    let text = program.good(&[
        "accuracy",
        "oak-d-tof",
        "--engine",
        "single-view",
        "--distances",
        "0.2,5",
    ]);
    for expected in [
        "Output of this sensor. Depth copied",
        "Alternative interpretation. Depth recomputed",
        "would be outside at 2 of 2",
        "8.75",
        "218.82",
    ] {
        assert!(text.contains(expected), "{expected}: {text}");
    }
}

/// A table as a spreadsheet writes it: quoted fields with commas, quotes and line breaks.
#[test]
fn measurements_with_quoted_commas() {
    let program = Program::new();
    program.put(
        "plain.csv",
        "distance_m,depth_error_percent\n1,0.4\n3.9,1.2\n8,2.1\n",
    );
    program.put(
        "quoted.csv",
        "\"remark, by hand\",\"distance_m\",depth_error_percent\r\n\"wall, white\",\"1\",0.4\r\n\"a \"\"grey\"\" wall,\nindoors\",3.9,\"1.2\"\r\n,8,2.1\r\n",
    );
    let measured = |file: &str| {
        let arguments = [
            "accuracy",
            "oak-d-pro-poe",
            "--captures",
            "1",
            "--measured",
            file,
            "--json",
        ];
        let json = program.good(&[&arguments[..], &QUIET[..]].concat());
        let report: serde_json::Value = serde_json::from_str(&json).unwrap();
        report["measured"]["points"].clone()
    };
    let plain = measured("plain.csv");
    assert_eq!(plain.as_array().map(Vec::len), Some(3), "{plain}");
    assert_eq!(measured("quoted.csv"), plain);
}

#[test]
fn json_and_plots_beside_measurements() {
    let program = Program::new();
    program.put(
        "unit.csv",
        "distance_m,depth_error_percent\n1,0.4\n3.9,1.2\n8,2.1\n",
    );
    let arguments = [
        &["accuracy", "oak-d-pro-poe"],
        &QUIET[..],
        &[
            "--captures",
            "1",
            "--region",
            "2",
            "--measured",
            "unit.csv",
            "--from",
            "2",
            "--json",
        ],
    ]
    .concat();
    let json = program.good(&[&arguments[..], &["--plot", "a.svg"]].concat());
    assert_eq!(
        json,
        program.good(&[&arguments[..], &["--plot", "a.PNG"]].concat())
    );
    for key in [
        "\"distance_m\": 3.9",
        "\"error_percent\"",
        "\"fill_rate\": 1.0",
        "\"plane_fit_rms_mm\"",
        "\"compared_points\": 2",
        "\"r_squared\"",
        "\"passed\": true",
        "\"verdict\": \"inside\"",
    ] {
        assert!(json.contains(key), "{key}: {json}");
    }
    let svg = std::fs::read_to_string(program.path("a.svg")).unwrap();
    assert!(
        svg.contains("true distance [m]") && svg.contains("the vendor&apos;s accuracy"),
        "{svg}"
    );
    assert!(
        std::fs::read(program.path("a.PNG"))
            .unwrap()
            .starts_with(b"\x89PNG")
    );
}

#[test]
fn invalid_requests_are_rejected() {
    let program = Program::new();
    program.put("empty.csv", "");
    program.put("columns.csv", "distance,error\n1,2\n");
    program.put("semicolons.csv", "distance_m;depth_error_percent\n1;2\n");
    program.put("nan.csv", "distance_m,depth_error_percent\n1,2\n2,NaN\n");
    program.put("binary.csv", [0xffu8, 0xfe, 0x00]);
    let mut all = String::new();
    let runs: [&[&str]; 20] = [
        &["oak5"],
        &["oak4-d", "--distances", "0"],
        &["oak4-d", "--distances", "-1"],
        &["oak4-d", "--distances", "1,nan"],
        &["oak4-d", "--distances", "70"],
        &["oak4-d", "--distances", "1:9"],
        &["oak4-d", "--plot", "a.jpg"],
        &[
            "oak4-d",
            "--distances",
            "1",
            "--devices",
            "1",
            "--plot",
            "no/folder.svg",
        ],
        &["oak4-d", "--devices", "0"],
        &["oak4-d", "--captures", "0"],
        &["oak4-d", "--region", "0"],
        &["oak4-d", "--focal-px", "-5"],
        &["oak4-d", "--stereo-width", "0"],
        &["oak4-d", "--sensor", "tof"],
        &["oak-d-tof", "--engine", "stereo-noise"],
        &["oak4-d", "--measured", "empty.csv"],
        &["oak4-d", "--measured", "columns.csv"],
        &["oak4-d", "--measured", "semicolons.csv"],
        &["oak4-d", "--measured", "nan.csv"],
        &["oak4-d", "--measured", "binary.csv"],
    ];
    for arguments in runs {
        let arguments = [&["accuracy"], arguments].concat();
        let _ = write!(
            all,
            "$ oaktwin {}\n{}",
            arguments.join(" "),
            program.refused(&arguments)
        );
    }
    insta::assert_snapshot!(all);
}

/// The vendor's figures: below 1 % indoors and 2 % outdoors, and below 0.1 % of the distance over time.
#[test]
fn time_of_flight_indoors_and_outdoors() {
    let program = Program::new();
    for (light, most) in [("indoor", 1.0), ("outdoor", 2.0)] {
        let light = format!("ambient={light}");
        let arguments = [
            "accuracy",
            "oak-d-tof",
            "--param",
            &light,
            "--devices",
            "5",
            "--json",
        ];
        let json = program.good(&[&arguments[..], &["--distances", "0.2,0.7,2,5"]].concat());
        let report: serde_json::Value = serde_json::from_str(&json).unwrap();
        let rows = report["distances"].as_array().unwrap();
        assert_eq!(rows.len(), 4);
        for row in rows {
            let number = |name: &str| row[name].as_f64().unwrap();
            assert!(number("error_percent") < most, "{light}: {row}");
            assert!(number("precision_mm") < number("distance_m"), "{light}: {row}");
            assert!(number("fill_rate") > 0.7, "{light}: {row}");
        }
    }
}

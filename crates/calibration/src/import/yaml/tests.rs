use super::*;
use crate::raw::Raw;
use proptest::prelude::*;

fn json(text: &str) -> String {
    let root = parse(text.as_bytes(), "x.yaml").unwrap();
    let raw = Raw {
        name: String::new(),
        root,
    };
    raw.to_text().split_whitespace().collect()
}

fn refused(text: &str) -> String {
    parse(text.as_bytes(), "x.yaml").unwrap_err().to_string()
}

#[test]
fn reads_what_pyyaml_writes() {
    let text = "# a comment\ncam0:\n  T_cam_imu:\n  - [1.0, 0.0]\n  - [0.0, 1.0e-3] # another\n  cam_overlaps: [1]\n  empty:\n  rostopic: /cam0/image_raw\ncam1:\n  rows:\n  - - 1.0\n    - 2.0\n  - - 3.0\n    - 4.0\n  items:\n    - name: a\n      size: 2\n    -\n      name: 'it''s'\n";
    assert_eq!(
        json(text),
        "{\"cam0\":{\"T_cam_imu\":[[1.0,0.0],[0.0,1.0e-3]],\"cam_overlaps\":[1],\"empty\":null,\"rostopic\":\"/cam0/image_raw\"},\
         \"cam1\":{\"rows\":[[1.0,2.0],[3.0,4.0]],\"items\":[{\"name\":\"a\",\"size\":2},{\"name\":\"it's\"}]}}"
    );
}

#[test]
fn reads_what_opencv_writes() {
    let text = "%YAML:1.0\n---\ncalibration_time: \"Thu 26 Nov: 12:00 # noon\"\nM1: !!opencv-matrix\n   rows: 1\n   cols: 3\n   dt: d\n   data: [ 1., -2.5e+02,\n       .5 ]\n";
    assert_eq!(
        json(text),
        "{\"calibration_time\":\"Thu26Nov:12:00#noon\",\"M1\":{\"rows\":1,\"cols\":3,\"dt\":\"d\",\"data\":[1.,-2.5e+02,.5]}}"
    );
    let flow = "{ \"M1\": { \"type_id\": \"opencv-matrix\", \"data\": [ 1.0 ] } }";
    assert_eq!(
        json(flow),
        "{\"M1\":{\"type_id\":\"opencv-matrix\",\"data\":[1.0]}}"
    );
}

#[test]
fn ends_with_the_first_document() {
    assert_eq!(json("---\na: 1\n---\nb: 2\n"), "{\"a\":1}");
}

#[test]
fn errors_name_the_line() {
    for (text, line, what) in [
        ("", 1, "empty"),
        ("# only a comment\n", 1, "empty"),
        ("a: 1\nb: [1, 2\n", 2, "not closed; the file may be truncated"),
        ("a: 1\nb\n", 2, "is missing after the key"),
        ("a: &x 1\n", 1, "anchor"),
        ("a: |\n  text\n", 1, "anchor"),
        ("a: \"x\n", 1, "quote"),
        ("a: [1 2, [3]\n  ]\nb: {c 1}\n", 3, "is missing"),
        ("a: [1,\n\n 2]]\n", 3, "unexpected"),
        ("a: 1\na: 2\n", 2, "repeated"),
        ("a: 1\n   b: 2\n", 2, "indentation"),
        ("a:\n\tb: 2\n", 2, "tab"),
        ("a\u{0}: 1\n", 1, "control character"),
    ] {
        let error = refused(text);
        assert!(
            error.starts_with(&format!("x.yaml: line {line}: ")) && error.contains(what),
            "{text:?}: {error}"
        );
    }
    assert!(
        parse(b"a: 1\nb: \xff\n", "x.yaml")
            .unwrap_err()
            .to_string()
            .contains("line 2: not UTF-8")
    );
    assert!(refused(&"[".repeat(100_000)).contains("not closed"));
    assert!(refused(&format!("{}{}", "[".repeat(10_000), "]".repeat(10_000))).contains("nested deeper"));
    assert!(refused(&"- ".repeat(10_000)).contains("nested deeper"));
}

proptest! {
    #[test]
    fn never_panics(text in r#"[\[\]{}:,"' \n#&a-c0-9.!%-]{0,80}"#) {
        let _ = parse(text.as_bytes(), "x");
    }
}

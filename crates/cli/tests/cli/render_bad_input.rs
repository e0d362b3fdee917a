//! What `render` refuses: in one line, before anything is written.

use std::fmt::Write;
use std::fs;

use crate::program::{EXAMPLE, Program};

const ROOM: &str = include_str!("fixtures/room.usda");
const CRATE: &str = include_str!("fixtures/crate.obj");

fn program() -> Program {
    let program = Program::new();
    program.put("room.usda", ROOM);
    program.put("crate.obj", CRATE);
    program
}

fn all_refused(program: &Program, runs: &[&[&str]]) -> String {
    let mut all = String::new();
    for arguments in runs {
        let arguments = [&["render"], *arguments].concat();
        let _ = write!(
            all,
            "$ oaktwin {}\n{}",
            arguments.join(" ").replace(EXAMPLE, "EXAMPLE"),
            program.refused(&arguments)
        );
    }
    all
}

/// The words of a command; `EXAMPLE` is the path of the example calibration.
fn words(command: &'static str) -> Vec<&'static str> {
    let words = command.split(' ');
    words
        .map(|word| if word == "EXAMPLE" { EXAMPLE } else { word })
        .collect()
}

#[test]
fn invalid_options() {
    let program = program();
    let runs = [
        "room.usda --annotators rgb,distance_to_image",
        "room.usda --annotators xyz",
        "room.usda --camera Lefft",
        "room.usda --camera xyz",
        "room.usda --resolution 0x40",
        "room.usda --resolution 64",
        "room.usda --resolution 4x-4",
        "room.usda --resolution 65536x65536",
        "room.usda --up z",
        "room.usda --scale 2",
        "room.usda --time nan",
        "crate.obj --scale 0",
        "room.usda --lens fisheye",
        "room.usda --calibration EXAMPLE",
        "crate.obj --model oak4-d",
        "crate.obj --model oak5 --pose 0 0 0 0 0 0 1",
        "crate.obj --model oak4-d --look-at -2 0 1 0 0 0 --lens fisheye",
        "crate.obj --model oak4-d --look-at -2 0 1 0 0 0 --camera lefft",
        "crate.obj --model oak4-d --look-at -2 0 1 0 0 0 5",
        "crate.obj --model oak4-d --pose 0 0 0 0 0 0 2",
        "crate.obj --model oak4-d --pose 0 nan 0 0 0 0 1",
        "crate.obj --model oak4-d --look-at 1 2 3 1 2 3",
        "crate.obj --up z --model oak4-d --look-at 0 0 3 0 0 0",
        "room.usda --infrared Cratee=0.5",
        "room.usda --infrared Crate=1.5",
        "room.usda --rgb-imager readNois=1",
        "room.usda --rgb-imager readNoise=-1",
        "room.usda --strict --annotators normals --rgb-imager on",
    ];
    let runs = runs.map(words);
    let runs: Vec<&[&str]> = runs.iter().map(Vec::as_slice).collect();
    let all = all_refused(&program, &runs);
    insta::assert_snapshot!(all);
}

#[test]
fn invalid_scenes() {
    let program = program();
    program.put("empty.usda", "#usda 1.0\n");
    program.put("nothing.usda", "");
    program.put("garbage.usdc", (0..=255u8).cycle().take(5000).collect::<Vec<_>>());
    program.put("text.txt", "x");
    program.put("noname", "x");
    fs::create_dir(program.path("folder.usd")).unwrap();
    fs::create_dir(program.path("folder")).unwrap();
    program.put(
        "flat.usda",
        ROOM.replace("float focalLength = 20", "float focalLength = 0"),
    );
    program.put(
        "ortho.usda",
        ROOM.replace("float focalLength = 20", "token projection = \"orthographic\""),
    );
    insta::assert_snapshot!(all_refused(
        &program,
        &[
            &["missing.usda"],
            &["empty.usda"],
            &["nothing.usda"],
            &["garbage.usdc"],
            &["text.txt"],
            &["noname"],
            &["folder"],
            &["folder.usd"],
            &["crate.obj"],
            &["flat.usda"],
            &["ortho.usda", "--camera", "Left"],
        ]
    ));
}

#[test]
fn invalid_trajectories() {
    let program = program();
    program.put("empty.txt", "");
    program.put("comments.txt", "# nothing\n");
    program.put("short.txt", "0 0 0 0 0 0 0 1\n1 2 3\n");
    program.put("word.txt", "0 0 0 zero 0 0 0 1\n");
    program.put("long.txt", "0 0 0 0 0 0 0 2\n");
    program.put("binary.txt", [0xffu8, 0xfe, 0x00]);
    program.put("cut.json", "[{\"position\": [0, 0");
    program.put("key.json", "[{\"pos\": [0, 0, 0]}]");
    let runs: Vec<Vec<&str>> = [
        "missing.txt",
        "empty.txt",
        "comments.txt",
        "short.txt",
        "word.txt",
        "long.txt",
        "binary.txt",
        "cut.json",
        "key.json",
        ".",
    ]
    .into_iter()
    .map(|path| vec!["crate.obj", "--model", "oak4-d", "--trajectory", path])
    .collect();
    let runs: Vec<&[&str]> = runs.iter().map(Vec::as_slice).collect();
    let mut all = all_refused(&program, &runs);
    program.put("good.txt", "0 0 0 0 0 0 0 1\n");
    all += &all_refused(
        &program,
        &[&[
            "room.usda",
            "--camera",
            "Left",
            "--camera",
            "Right",
            "--trajectory",
            "good.txt",
        ]],
    );
    insta::assert_snapshot!(all);
}

#[cfg(target_os = "linux")]
#[test]
fn outputs_that_cannot_be_written() {
    let program = program();
    program.put("file", "kept");
    insta::assert_snapshot!(all_refused(
        &program,
        &[
            &["room.usda", "-o", "file"],
            &["room.usda", "-o", "file/below"],
            &["room.usda", "-o", "/dev/full"],
            &["room.usda", "-o", "/proc/x"],
        ]
    ));
    assert_eq!(fs::read_to_string(program.path("file")).unwrap(), "kept");
}

#[cfg(target_os = "linux")]
#[test]
fn an_image_that_does_not_fit_in_memory_reports_its_size() {
    let program = program();
    let error = program.refused(&[
        "render",
        "room.usda",
        "--annotators",
        "all",
        "--resolution",
        "46340x46340",
    ]);
    assert!(error.contains("848.0 GiB of memory needed"), "{error}");
}

//! What needs more memory than there is, is refused before it is begun.

use std::fs;

use oaktwin::image::{Image, png};

use crate::program::Program;
use crate::render::program;

const VIEW: &str = "--model oak4-d --look-at -2 0 1 0 0 0 --annotators distance_to_image_plane -o out";

fn refused(program: &Program, command: &str) -> String {
    program.refused(&command.split(' ').collect::<Vec<_>>())
}

#[test]
fn large_frames() {
    let program = program();
    let message = refused(
        &program,
        &format!("render crate.obj --resolution 8000x6000 {VIEW} --memory-limit 100M"),
    );
    assert!(
        message.starts_with("error: OAK4-D/Camera_pseudo_depth: images of 8000x6000: "),
        "{message}"
    );
    assert!(
        message.contains(" of memory needed, ") && message.contains("raise --memory-limit"),
        "{message}"
    );
}

#[test]
fn images_that_grow_when_they_are_decoded() {
    let program = Program::new();
    let file = png::encode(&Image::filled(6000, 6000, 1000u16)).unwrap();
    assert!(file.len() < 1 << 20);
    program.put("z.png", file);
    // Decoded, 69 MiB.
    for (limit, place) in [
        ("100M", "z.png: PNG: header: 6000 × 6000 pixels: "),
        ("400M", "z.png: images of 6000x6000: "),
    ] {
        let command = format!("sense z.png --model oak4-d --input-kind z -o out --memory-limit {limit}");
        let message = refused(&program, &command);
        assert!(message.starts_with(&format!("error: {place}")), "{message}");
        assert!(message.contains("raise --memory-limit"), "{message}");
    }
    program.put("left.png", png::encode(&Image::filled(3000, 3000, 90u8)).unwrap());
    let message = refused(
        &program,
        "stereo left.png left.png --model oak4-d -o out --memory-limit 500M",
    );
    assert!(
        message.starts_with("error: left.png: images of 3000x3000: 1.1 GiB of memory needed"),
        "{message}"
    );
}

#[test]
fn large_textures_are_left_out() {
    let program = program();
    program.put(
        "large.png",
        png::encode(&Image::filled(6000, 6000, [0u8, 0, 200])).unwrap(),
    );
    program.put("crate.mtl", "newmtl blue\nmap_Kd large.png\n");
    let cube = fs::read_to_string(program.path("crate.obj")).unwrap();
    let cube: String = cube.lines().map(|line| format!("{line}\n")).collect();
    program.put(
        "blue.obj",
        format!(
            "mtllib crate.mtl\nusemtl blue\nvt 0 0\n{}",
            cube.replace("\nf ", "\nusemtl blue\nf ")
        ),
    );
    let command =
        "render blue.obj --model oak4-d --look-at -2 0 1 0 0 0 --annotators rgb -o out --resolution 64x40";
    let mut arguments: Vec<&str> = command.split(' ').collect();
    arguments.extend(["--memory-limit", "120M"]);
    let ended = program.run(&arguments);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    let message = "warning[texture-missing]: large.png: the texture cannot be read (PNG: header: 6000 × 6000 \
                   pixels: ";
    assert!(ended.stderr.contains(message), "{}", ended.stderr);
    assert!(ended.stderr.contains("raise --memory-limit"), "{}", ended.stderr);
}

#[test]
fn subdivision_stops_before_memory_ends() {
    let program = Program::new();
    program.put(
        "cube.usda",
        r#"#usda 1.0
( upAxis = "Z" metersPerUnit = 1 )
def Mesh "Cube" {
    int[] faceVertexCounts = [4, 4, 4, 4, 4, 4]
    int[] faceVertexIndices = [0, 1, 3, 2, 4, 6, 7, 5, 0, 4, 5, 1, 2, 3, 7, 6, 0, 2, 6, 4, 1, 5, 7, 3]
    point3f[] points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0), (0, 0, 1), (1, 0, 1), (0, 1, 1), (1, 1, 1)]
}
"#,
    );
    let command = format!("render cube.usda --resolution 64x40 {VIEW} --subdivide 8 --memory-limit 110M");
    let ended = program.run(&command.split(' ').collect::<Vec<_>>());
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    let message = ended.stderr;
    assert!(
        message.contains("warning[mesh-subdivision]: /Cube: subdivided 7 times instead of 8: "),
        "{message}"
    );
    assert!(message.contains("raise --memory-limit"), "{message}");
}

#[test]
fn invalid_sizes() {
    let program = program();
    let ended = program.run(&["models", "--memory-limit", "plenty"]);
    assert_eq!(ended.code, 2);
    assert!(ended.stderr.contains("such as 4G"), "{}", ended.stderr);
}

#[cfg(target_os = "linux")]
#[test]
fn a_good_stage_is_not_blamed_for_a_lack_of_memory() {
    let program = program();
    let script = "ulimit -v 200000; exec \"$0\" check room.usda";
    let mut command = std::process::Command::new("bash");
    command.args(["-c", script, env!("CARGO_BIN_EXE_oaktwin")]);
    let output = command.current_dir(program.folder()).output().unwrap();
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(
        message.contains("not enough memory for the stack of its reader"),
        "{message}"
    );
}

//! `oaktwin render` when it is interrupted, its pipe is closed, or its files become too large.

use std::process::Stdio;

use super::render::program;

#[cfg(unix)]
#[test]
fn ctrl_c_leaves_whole_files_only() {
    let program = program();
    program.put("long.txt", "0 -2 0 0.5 0 0 0 1\n".repeat(20_000));
    let arguments = "render crate.obj --model oak4-d --trajectory long.txt -o out --resolution 64x40";
    let arguments: Vec<&str> = arguments.split(' ').collect();
    let ended = program.interrupted(&arguments, |program| {
        program.path("out/distance_to_image_plane_0003.npy").exists()
    });
    let message = ended.stderr;
    assert_eq!(ended.code, 130, "{message}");
    let counted = message
        .strip_prefix("interrupted: ")
        .and_then(|rest| rest.split_once(" of 20000 frames are complete in out"));
    // On a busy machine, the frame in flight may take longer than an interrupted program waits for.
    let Some((frames, _)) = counted else {
        assert_eq!(message, "interrupted: unfinished files were removed\n");
        return;
    };
    let frames: usize = frames.parse().unwrap();
    assert!(frames >= 4, "{message}");
    let depths: Vec<String> = program
        .names()
        .into_iter()
        .filter(|name| name.contains("distance_to_image_plane"))
        .collect();
    assert_eq!(depths.len(), frames);
    for name in depths {
        assert_eq!(super::render::depth(&program, &name).0, (64, 40));
    }
    assert!(!program.names().iter().any(|name| name.ends_with(".part")));
}

#[test]
fn a_closed_pipe_is_no_error() {
    let program = program();
    let mut child = program
        .command(&["render", "room.usda", "-o", "out"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert_eq!(
        (
            output.status.code(),
            String::from_utf8(output.stderr).unwrap().as_str()
        ),
        (Some(0), "")
    );
}

#[cfg(target_os = "linux")]
#[test]
fn a_file_that_becomes_too_large_leaves_nothing_half() {
    let program = program();
    let ended = program.run_with_small_files(&["render", "room.usda", "-o", "out"]);
    let message = ended.stderr;
    assert_eq!(ended.code, 2, "{message}");
    assert!(
        message.contains("out/") && message.contains("would be larger"),
        "{message}"
    );
    assert!(!program.names().iter().any(|name| name.ends_with(".part")));
}

//! Files appear whole or not at all, however the program ends.

#[cfg(unix)]
use std::fs;

#[cfg(unix)]
use crate::program::Ended;
use crate::program::Program;
use crate::render::program;

const CRATE: &str = "crate.obj --model oak4-d --look-at -2 0 1 0 0 0";

fn words(text: &str) -> Vec<&str> {
    text.split(' ').collect()
}

fn parts(program: &Program) -> Vec<String> {
    let names = program.names().into_iter();
    names.filter(|name| name.ends_with(".part")).collect()
}

/// Ends the program while it makes one large frame; the files that it completed are whole.
#[cfg(unix)]
fn ended_by(signals: &[&str]) -> Ended {
    let program = program();
    let command = format!("render {CRATE} --resolution 3840x2400 --annotators all -o out");
    let ended = program.signalled(signals, &words(&command), |program| {
        program.path("out/metadata.txt").exists()
    });
    assert_eq!(parts(&program), [""; 0]);
    for name in program.names().iter().filter(|name| name.ends_with(".npy")) {
        oaktwin::image::npy::decode(&fs::read(program.path(name)).unwrap()).unwrap();
    }
    ended
}

#[cfg(unix)]
#[test]
fn signals_end_a_large_frame_without_unfinished_files() {
    for (signal, code) in [("INT", 130), ("TERM", 143), ("HUP", 129)] {
        if signal == "HUP" && ignores_hangups() {
            println!("skipped: hangups are ignored here");
            continue;
        }
        let ended = ended_by(&[signal]);
        assert_eq!(ended.code, code, "{signal}: {}", ended.stderr);
        assert_eq!(ended.stderr, "interrupted: unfinished files were removed\n");
    }
}

/// Whether programs started here outlive their terminal, as after `nohup`; only Linux tells.
#[cfg(unix)]
fn ignores_hangups() -> bool {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let ignored = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    ignored.is_none_or(|mask| u64::from_str_radix(mask.trim(), 16).unwrap() & 1 != 0)
}

#[cfg(unix)]
#[test]
fn a_second_signal_ends_the_program() {
    let ended = ended_by(&["INT", "INT"]);
    assert_eq!(ended.code, 130);
    assert_eq!(ended.stderr, "interrupted: unfinished files were removed\n");
}

#[cfg(target_os = "linux")]
#[test]
fn files_larger_than_the_limit_are_reported() {
    let program = program();
    let ended = program.run_with_small_files(&words(&format!("render {CRATE} -o out")));
    assert_eq!(ended.code, 2, "{}", ended.stderr);
    assert!(
        ended.stderr.contains("would be larger than files may be here"),
        "{}",
        ended.stderr
    );
    assert_eq!(parts(&program), [""; 0]);
}

#[cfg(unix)]
#[test]
fn what_a_killed_program_left_is_removed_by_the_next() {
    let program = program();
    program.put("long.txt", "0 -2 0 0.5 0 0 0 1\n".repeat(20_000));
    let recording =
        "render crate.obj --model oak4-d --trajectory long.txt --record a.mcap --resolution 64x40";
    let ended = program.signalled(&["KILL"], &words(recording), |program| {
        let part = |name: &String| {
            let path = program.path(name);
            name.ends_with(".part") && fs::metadata(path).is_ok_and(|file| file.len() > 100_000)
        };
        program.names().iter().any(part)
    });
    assert_eq!(ended.code, -9);
    assert_eq!(parts(&program).len(), 1);
    assert!(!program.path("a.mcap").exists());
    // In use by nobody, but not one of ours.
    program.put(".a.mcap.part", "of another program");
    program.good(&words(&format!(
        "render {CRATE} --resolution 64x40 --record b.mcap"
    )));
    assert_eq!(parts(&program), [".a.mcap.part"]);
}

/// Containers, whose programs all have the process number 1.
#[cfg(target_os = "linux")]
#[test]
fn programs_with_one_process_number_do_not_disturb_each_other() {
    use std::process::{Command, Stdio};

    let program = program();
    let contained = |arguments: &str| {
        let mut command = Command::new("unshare");
        command.args(["--user", "--map-root-user", "--pid", "--fork"]);
        command.arg(env!("CARGO_BIN_EXE_oaktwin")).args(words(arguments));
        command.current_dir(program.folder());
        command
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .stdin(Stdio::null());
        command
    };
    match contained("models").output() {
        Ok(output) if output.status.success() => {}
        _ => return println!("skipped: process namespaces are not available"),
    }
    let command = format!("render {CRATE} --resolution 640x400 --record a.mcap -o out");
    let running: Vec<_> = (0..4).map(|_| contained(&command).spawn().unwrap()).collect();
    for child in running {
        let output = child.wait_with_output().unwrap();
        assert!(
            output.status.success(),
            "{}",
            String::from_utf8_lossy(&output.stderr)
        );
    }
    assert_eq!(parts(&program), [""; 0]);
    let written = fs::read(program.path("a.mcap")).unwrap();
    program.good(&words(&format!(
        "render {CRATE} --resolution 640x400 --record alone.mcap"
    )));
    assert_eq!(written, fs::read(program.path("alone.mcap")).unwrap());
}

#[test]
fn names_of_the_maximum_length_are_written() {
    let program = program();
    let name = format!("{}.mcap", "n".repeat(250));
    program.good(&words(&format!(
        "render {CRATE} --resolution 64x40 --record {name}"
    )));
    assert!(program.path(&name).exists());
}

#[cfg(target_os = "linux")]
#[test]
fn help_that_cannot_be_written_is_an_error() {
    for argument in ["--help", "--version", "man"] {
        let program = Program::new();
        let full = fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
        let output = program.command(&[argument]).stdout(full).output().unwrap();
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{argument}: {message}");
        assert!(
            message.contains("standard output: cannot be written"),
            "{message}"
        );
    }
}

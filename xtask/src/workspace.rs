//! The checkout, and the commands that run in it.

use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::io::{BufRead, BufReader, Read, Seek, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};

use serde_json::Value;

use crate::processor;

/// The folder of the workspace.
pub(crate) fn root() -> &'static Path {
    let xtask = Path::new(env!("CARGO_MANIFEST_DIR"));
    xtask.parent().unwrap_or(xtask)
}

/// The folder for builds and Python environments.
pub(crate) fn target() -> PathBuf {
    match std::env::var_os("CARGO_TARGET_DIR") {
        Some(folder) => root().join(folder),
        None => root().join("target"),
    }
}

/// Returns a command for cargo in the folder of the workspace.
pub(crate) fn cargo() -> Command {
    let mut command = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.current_dir(root());
    command
}

/// Returns a command as it would be typed, with the variables that it sets.
pub(crate) fn shown(command: &Command) -> String {
    let variables = command
        .get_envs()
        .filter_map(|(name, value)| Some((name, value?)));
    let variables = variables.map(|(name, value)| format!("{}={}", name.display(), quoted(value)));
    let program = Path::new(command.get_program());
    let program = match program.file_name() {
        Some(name) if name == "cargo" => name,
        _ => program.as_os_str(),
    };
    let words = std::iter::once(program).chain(command.get_args()).map(quoted);
    variables.chain(words).collect::<Vec<_>>().join(" ")
}

fn quoted(word: &OsStr) -> String {
    let word = word.to_string_lossy();
    if word.is_empty() || word.contains([' ', '\'', '"', '$', '*', '<', '>']) {
        format!("'{}'", word.replace('\'', r"'\''"))
    } else {
        word.into_owned()
    }
}

/// Runs a command. An error names it.
pub(crate) fn check(command: &mut Command) -> Result<(), String> {
    let child = command.spawn().map_err(|error| not_started(command, &error))?;
    succeeded(command, wait(command, child)?)
}

/// Runs a command and returns its standard output. An error contains both output streams.
pub(crate) fn output(command: &mut Command) -> Result<String, String> {
    let failed = |error: std::io::Error| format!("{}: {error}", shown(command));
    // A file and not a pipe, which would have to be read at the same time.
    let errors = tempfile::tempfile().map_err(failed)?;
    let shared = errors.try_clone().map_err(failed)?;
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(shared);
    let mut child = command.spawn().map_err(|error| not_started(command, &error))?;
    let failed = |error: std::io::Error| format!("{}: {error}", shown(command));
    let mut bytes = Vec::new();
    if let Some(stdout) = &mut child.stdout {
        stdout.read_to_end(&mut bytes).map_err(failed)?;
    }
    let status = processor::wait(child).map_err(failed)?;
    let text = String::from_utf8_lossy(&bytes).into_owned();
    if status.success() {
        return Ok(text);
    }
    let mut said = Vec::new();
    let mut errors = errors;
    let read = errors.rewind().and_then(|()| errors.read_to_end(&mut said));
    read.map_err(failed)?;
    Err(format!(
        "{}: {status}\n{text}{}",
        shown(command),
        String::from_utf8_lossy(&said)
    ))
}

/// Runs a command, passes on its standard output, and calls `handle` with each line.
pub(crate) fn watch(command: &mut Command, mut handle: impl FnMut(&str)) -> Result<ExitStatus, String> {
    each_line(command, |line| {
        let mut console = std::io::stdout().lock();
        // A closed console must not stop the tests.
        let _ = console.write_all(line).and_then(|()| console.flush());
        handle(String::from_utf8_lossy(line).trim_end());
    })
}

/// Runs a command, and calls `handle` with each line of its standard output.
fn each_line(command: &mut Command, mut handle: impl FnMut(&[u8])) -> Result<ExitStatus, String> {
    let mut child = command
        .stdout(Stdio::piped())
        .spawn()
        .map_err(|error| not_started(command, &error))?;
    if let Some(stdout) = child.stdout.take() {
        let mut lines = BufReader::new(stdout);
        let mut line = Vec::new();
        // Bytes and not `lines()`: a test may print what is not UTF-8.
        while lines.read_until(b'\n', &mut line).is_ok_and(|read| read > 0) {
            handle(&line);
            line.clear();
        }
    }
    wait(command, child)
}

fn wait(command: &Command, child: Child) -> Result<ExitStatus, String> {
    processor::wait(child).map_err(|error| format!("{}: {error}", shown(command)))
}

fn succeeded(command: &Command, status: ExitStatus) -> Result<(), String> {
    match status.success() {
        true => Ok(()),
        false => Err(format!("{}: {status}", shown(command))),
    }
}

fn not_started(command: &Command, error: &std::io::Error) -> String {
    format!("{}: cannot be started: {error}", shown(command))
}

/// The name of the native module of the Python package among what cargo built.
pub(crate) const MODULE: &str = "_oaktwin";

/// Runs `cargo build` with these arguments, and returns the programs and the native module that it built by name.
pub(crate) fn build(arguments: &[&str]) -> Result<BTreeMap<String, PathBuf>, String> {
    let mut command = cargo();
    command
        .arg("build")
        .args(arguments)
        .arg("--message-format=json-render-diagnostics");
    command.stdin(Stdio::null());
    let mut built = BTreeMap::new();
    // The diagnostics go to the console as they come; only the messages are read.
    let status = each_line(&mut command, |line| {
        let Ok(message) = serde_json::from_slice::<Value>(line) else {
            return;
        };
        let is_test = message["profile"]["test"] == true;
        let module = (message["target"]["name"] == MODULE).then(|| &message["filenames"][0]);
        let path = module.unwrap_or(&message["executable"]).as_str();
        if let (Some(name), Some(path), false) = (message["target"]["name"].as_str(), path, is_test) {
            built.insert(name.to_owned(), PathBuf::from(path));
        }
    })?;
    succeeded(&command, status)?;
    Ok(built)
}

/// Returns what `cargo metadata` says with these arguments about the locked dependencies.
pub(crate) fn metadata(arguments: &[&str]) -> Result<Value, String> {
    let mut command = cargo();
    command
        .args(["metadata", "--format-version", "1", "--locked"])
        .args(arguments);
    serde_json::from_str(&output(&mut command)?).map_err(|error| format!("cargo metadata: {error}"))
}

/// Builds `oaktwin` with everything in it, and returns its path. Built with the workspace, it shares what the tests and the
/// package have compiled; a package on its own selects other features of its dependencies, and compiles them again.
pub(crate) fn oaktwin(profile: &str) -> Result<PathBuf, String> {
    build_program("oaktwin", &["--workspace", "--profile", profile])
}

/// Builds a program with additional arguments, and returns its path.
pub(crate) fn build_program(name: &str, arguments: &[&str]) -> Result<PathBuf, String> {
    build(&[arguments, &["--bin", name]].concat())?
        .remove(name)
        .ok_or_else(|| format!("cargo built no program named {name}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shows_a_command_as_it_is_typed() {
        let mut command = Command::new("/somewhere/bin/cargo");
        command
            .args(["test", "a b", ""])
            .env("RUSTDOCFLAGS", "-D warnings")
            .env_remove("PYTHONPATH");
        assert_eq!(shown(&command), "RUSTDOCFLAGS='-D warnings' cargo test 'a b' ''");
    }

    #[test]
    fn names_a_command_that_does_not_exist() {
        let error = check(&mut Command::new("no-such-program-here")).unwrap_err();
        assert!(
            error.starts_with("no-such-program-here: cannot be started"),
            "{error}"
        );
    }
}

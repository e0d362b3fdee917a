//! The checkout, and the commands that run in it.

use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, ExitStatus, Stdio};

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
    let status = command.status().map_err(|error| not_started(command, &error))?;
    if status.success() {
        Ok(())
    } else {
        Err(format!("{}: {status}", shown(command)))
    }
}

/// Runs a command and returns its standard output. An error contains both output streams.
pub(crate) fn output(command: &mut Command) -> Result<String, String> {
    let output = command
        .stdin(Stdio::null())
        .output()
        .map_err(|error| not_started(command, &error))?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    if output.status.success() {
        return Ok(text);
    }
    let errors = String::from_utf8_lossy(&output.stderr);
    Err(format!(
        "{}: {}\n{}{}",
        shown(command),
        output.status,
        text,
        errors
    ))
}

/// Runs a command, prints its standard output, and calls `see` with each line.
pub(crate) fn watch(command: &mut Command, mut see: impl FnMut(&str)) -> Result<ExitStatus, String> {
    let mut child = command
        .stdout(Stdio::piped())
        .spawn()
        .map_err(|error| not_started(command, &error))?;
    if let Some(stdout) = child.stdout.take() {
        let mut lines = BufReader::new(stdout);
        let mut line = Vec::new();
        // Bytes and not `lines()`: a test may print what is not UTF-8.
        while lines.read_until(b'\n', &mut line).is_ok_and(|read| read > 0) {
            let mut console = std::io::stdout().lock();
            // A closed console must not stop the tests.
            let _ = console.write_all(&line).and_then(|()| console.flush());
            see(String::from_utf8_lossy(&line).trim_end());
            line.clear();
        }
    }
    child
        .wait()
        .map_err(|error| format!("{}: {error}", shown(command)))
}

fn not_started(command: &Command, error: &std::io::Error) -> String {
    format!("{}: cannot be started: {error}", shown(command))
}

/// Runs `cargo build` with these arguments, and returns the programs that it built by name.
pub(crate) fn build(arguments: &[&str]) -> Result<BTreeMap<String, PathBuf>, String> {
    let mut command = cargo();
    command
        .arg("build")
        .args(arguments)
        .arg("--message-format=json-render-diagnostics");
    // The diagnostics go to the console as they come; only the messages are read.
    command.stderr(Stdio::inherit());
    let messages = output(&mut command)?;
    let mut programs = BTreeMap::new();
    for line in messages.lines() {
        let Ok(message) = serde_json::from_str::<serde_json::Value>(line) else {
            continue;
        };
        if let (Some(name), Some(path)) = (message["target"]["name"].as_str(), message["executable"].as_str())
        {
            programs.insert(name.to_owned(), PathBuf::from(path));
        }
    }
    Ok(programs)
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

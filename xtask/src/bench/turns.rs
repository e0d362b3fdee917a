//! The programs that take turns, and the lines of JSON in which they report their times.

use std::path::PathBuf;
use std::process::Command;

use serde_json::Value;

use super::median;
use crate::python::{self, Environment};
use crate::workspace;

/// Builds one of our benchmark programs with optimizations, without the rest of the workspace, which takes minutes to
/// compile.
pub(super) fn program(name: &str) -> Result<PathBuf, String> {
    let package = [
        "--release",
        "--package",
        "oaktwin-testkit",
        "--no-default-features",
    ];
    workspace::build_program(name, &package)
}

/// A script of the oracles and the Python that runs it.
pub(super) struct Script {
    python: PathBuf,
    script: PathBuf,
}

impl Script {
    /// Returns the script run in an environment, which is created if it is missing.
    pub(super) fn new(environment: &Environment, name: &str) -> Result<Self, String> {
        Ok(Self {
            python: environment.ready()?,
            script: workspace::root().join("tests/oracles").join(name),
        })
    }

    /// Returns the command, to which arguments are added.
    pub(super) fn command(&self) -> Command {
        let mut command = python::isolated(&self.python);
        command.arg(&self.script);
        command
    }
}

/// Elapsed and processor time per frame in seconds, and peak memory.
#[derive(Default)]
pub(super) struct Times {
    wall: Vec<f64>,
    cpu: Vec<f64>,
    pub(super) peak_bytes: f64,
}

/// The measurements of one turn.
pub(super) fn lines(text: &str) -> Vec<Value> {
    text.lines()
        .filter_map(|line| serde_json::from_str(line).ok())
        .collect()
}

impl Times {
    /// Reads the measurements in a line, one or several.
    pub(super) fn take(&mut self, line: &Value) {
        let numbers = |key: &str| match &line[key] {
            Value::Array(list) => list.iter().filter_map(Value::as_f64).collect(),
            number => number.as_f64().into_iter().collect::<Vec<_>>(),
        };
        self.wall.extend(numbers("wall_s"));
        self.cpu.extend(numbers("cpu_s"));
        self.peak_bytes = self.peak_bytes.max(line["peak_bytes"].as_f64().unwrap_or(0.0));
    }

    /// Elapsed and processor time.
    pub(super) fn medians(self) -> (f64, f64) {
        (median(self.wall), median(self.cpu))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_of_one_frame_and_of_many() {
        let mut times = Times::default();
        let said = "compiling\n{\"wall_s\": [3, 1], \"cpu_s\": [4, 6], \"peak_bytes\": 9}\n{\"wall_s\": 2, \"cpu_s\": 8}\n";
        let lines = lines(said);
        assert_eq!(lines.len(), 2);
        for line in &lines {
            times.take(line);
        }
        assert_eq!(times.peak_bytes, 9.0);
        assert_eq!(times.medians(), (2.0, 6.0));
    }
}

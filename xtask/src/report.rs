//! The steps of a run, their times and their outcomes.

use std::process::{Command, ExitCode};
use std::time::{Duration, Instant};

use crate::counts::Counts;
use crate::workspace;

enum Outcome {
    Passed,
    Failed(String),
    Skipped(String),
}

struct Step {
    name: String,
    time: Duration,
    outcome: Outcome,
}

/// The steps so far.
#[derive(Default)]
pub(crate) struct Report {
    steps: Vec<Step>,
    counts: Counts,
}

impl Report {
    /// Runs a step, prints its name and time, and returns its result unless it failed.
    pub(crate) fn step<T>(&mut self, name: &str, work: impl FnOnce() -> Result<T, String>) -> Option<T> {
        println!("\n-- {name}");
        let start = Instant::now();
        let result = work();
        let time = start.elapsed();
        let (value, outcome) = match result {
            Ok(value) => (Some(value), Outcome::Passed),
            Err(message) => (None, Outcome::Failed(message)),
        };
        match &outcome {
            Outcome::Failed(message) => println!("-- {name}: FAILED after {}: {message}", seconds(time)),
            _ => println!("-- {name}: {}", seconds(time)),
        }
        self.steps.push(Step {
            name: name.to_owned(),
            time,
            outcome,
        });
        value
    }

    /// Runs a command as a step, and adds the test counts that `counts` reads from its output.
    pub(crate) fn command(
        &mut self,
        name: &str,
        command: &mut Command,
        counts: fn(&str) -> Option<Counts>,
    ) -> bool {
        let mut sum = Counts::default();
        let see = |line: &str| sum += counts(line).unwrap_or_default();
        let result = self.step(name, || match workspace::watch(command, see)? {
            status if status.success() => Ok(()),
            status => Err(format!("{}: {status}", workspace::shown(command))),
        });
        // So that the closing line never reads as a success: a step that failed without naming a test counts as one.
        sum.failed = if result.is_none() {
            sum.failed.max(1)
        } else {
            sum.failed
        };
        self.counts += sum;
        result.is_some()
    }

    /// Counts the failure of a step outside [`Self::command`].
    pub(crate) fn count_failure(&mut self) {
        self.counts.failed += 1;
    }

    /// Records a skipped step and its reason.
    pub(crate) fn skip(&mut self, name: &str, reason: impl Into<String>) {
        let reason = reason.into();
        println!("\n-- {name}: skipped: {reason}");
        self.counts.skipped += 1;
        self.steps.push(Step {
            name: name.to_owned(),
            time: Duration::ZERO,
            outcome: Outcome::Skipped(reason),
        });
    }

    /// Prints the failures, the summary and, as the last line, the counts.
    pub(crate) fn finish(self) -> ExitCode {
        let mut ran = Vec::new();
        let mut skipped = Vec::new();
        let mut failures = Vec::new();
        for step in &self.steps {
            match &step.outcome {
                Outcome::Passed => ran.push(format!("{} ({})", step.name, seconds(step.time))),
                Outcome::Failed(message) => {
                    ran.push(format!("{} (FAILED, {})", step.name, seconds(step.time)));
                    // The full message was printed with the step.
                    let message = message.lines().next().unwrap_or_default();
                    failures.push(format!("FAILED: {}: {message}", step.name));
                }
                Outcome::Skipped(reason) => skipped.push(format!("{} ({reason})", step.name)),
            }
        }
        println!();
        for failure in &failures {
            println!("{failure}");
        }
        let or_nothing = |list: Vec<String>| {
            if list.is_empty() {
                "nothing".to_owned()
            } else {
                list.join(", ")
            }
        };
        println!("ran: {}; skipped: {}", or_nothing(ran), or_nothing(skipped));
        println!("{}", self.counts);
        if failures.is_empty() && self.counts.failed == 0 {
            ExitCode::SUCCESS
        } else {
            ExitCode::FAILURE
        }
    }
}

fn seconds(time: Duration) -> String {
    format!("{:.1} s", time.as_secs_f64())
}

//! The steps of a run, their times and their outcomes.

use std::fmt;
use std::process::{Command, ExitCode};
use std::time::{Duration, Instant};

use crate::counts::Counts;
use crate::{processor, workspace};

enum Outcome {
    Passed,
    Failed(String),
    Skipped(String),
}

struct Step {
    name: String,
    time: Time,
    outcome: Outcome,
}

/// The elapsed time and the processor time of a step.
#[derive(Clone, Copy, Default)]
struct Time {
    wall: Duration,
    processor: Duration,
}

/// The steps so far.
#[derive(Default)]
pub(crate) struct TestReport {
    steps: Vec<Step>,
    counts: Counts,
}

impl TestReport {
    /// Runs a step and returns its result, or `None` if it failed, which counts as a failed test.
    pub(crate) fn step<T>(&mut self, name: &str, work: impl FnOnce() -> Result<T, String>) -> Option<T> {
        let result = self.timed(name, work);
        self.counts.failed += u64::from(result.is_none());
        result
    }

    /// Runs a step, prints its name and time, and returns its result unless it failed.
    fn timed<T>(&mut self, name: &str, work: impl FnOnce() -> Result<T, String>) -> Option<T> {
        println!("\n-- {name}");
        let (start, used) = (Instant::now(), processor::used());
        let result = work();
        let time = Time {
            wall: start.elapsed(),
            processor: processor::used().saturating_sub(used),
        };
        let (value, outcome) = match result {
            Ok(value) => (Some(value), Outcome::Passed),
            Err(message) => (None, Outcome::Failed(message)),
        };
        match &outcome {
            Outcome::Failed(message) => println!("-- {name}: FAILED after {time}: {message}"),
            _ => println!("-- {name}: {time}"),
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
        let result = self.timed(name, || match workspace::watch(command, see)? {
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

    /// Records a skipped step and its reason.
    pub(crate) fn skip(&mut self, name: &str, reason: impl Into<String>) {
        let reason = reason.into();
        println!("\n-- {name}: skipped: {reason}");
        self.counts.skipped += 1;
        self.steps.push(Step {
            name: name.to_owned(),
            time: Time::default(),
            outcome: Outcome::Skipped(reason),
        });
    }

    /// Prints the failures, the summary and, as the last line, the counts.
    pub(crate) fn finish(self) -> ExitCode {
        let (mut ran, mut skipped) = (Vec::new(), Vec::new());
        let mut failures = Vec::new();
        for step in &self.steps {
            match &step.outcome {
                Outcome::Passed => ran.push((step.name.clone(), step.time)),
                Outcome::Failed(message) => {
                    ran.push((format!("{} (FAILED)", step.name), step.time));
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
        let total = ran.iter().fold(Time::default(), |sum, (_, time)| Time {
            wall: sum.wall + time.wall,
            processor: sum.processor + time.processor,
        });
        ran.push(("total".to_owned(), total));
        let width = ran.iter().map(|(name, _)| name.len()).max().unwrap_or_default();
        for (name, time) in &ran {
            println!("{name:width$}  {time}");
        }
        if !skipped.is_empty() {
            println!("skipped: {}", skipped.join(", "));
        }
        println!("{}", self.counts);
        if failures.is_empty() && self.counts.failed == 0 {
            ExitCode::SUCCESS
        } else {
            ExitCode::FAILURE
        }
    }
}

impl fmt::Display for Time {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [wall, processor] = [self.wall, self.processor].map(|time| time.as_secs_f64());
        write!(f, "{wall:7.1} s")?;
        if processor > 0.0 {
            write!(f, ", {processor:7.1} s of processor time")?;
        }
        Ok(())
    }
}

//! Counts of passed, failed and skipped tests, read from the test runners' output.

use std::fmt;
use std::ops::AddAssign;

/// Test counts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Counts {
    pub(crate) passed: u64,
    pub(crate) failed: u64,
    pub(crate) skipped: u64,
}

impl AddAssign for Counts {
    fn add_assign(&mut self, other: Self) {
        self.passed += other.passed;
        self.failed += other.failed;
        self.skipped += other.skipped;
    }
}

impl fmt::Display for Counts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{} passed, {} failed, {} skipped",
            self.passed, self.failed, self.skipped
        )
    }
}

/// Reads a closing line of `cargo test`: `test result: ok. 3 passed; 0 failed; 1 ignored; …`. Tests excluded by name count
/// as skipped.
pub(crate) fn of_cargo_test(line: &str) -> Option<Counts> {
    let (_, figures) = line.strip_prefix("test result: ")?.split_once(". ")?;
    let filtered_out = figures
        .split("; ")
        .filter_map(figure)
        .find(|(_, word)| *word == "filtered");
    let mut counts = sum(figures.split("; "));
    counts.skipped += filtered_out.map_or(0, |(number, _)| number);
    Some(counts)
}

/// The same for a run of tests selected by name, where those excluded ran before.
pub(crate) fn of_filtered_cargo_test(line: &str) -> Option<Counts> {
    let (_, figures) = line.strip_prefix("test result: ")?.split_once(". ")?;
    Some(sum(figures.split("; ")))
}

/// Reads a line of pytest's summary of skipped tests, `SKIPPED [2] file.py:3: reason`; those whose reason names the
/// variable of the test data count as failed.
pub(crate) fn of_data_skipped_by_pytest(line: &str, variable: &str) -> Option<Counts> {
    let (number, reason) = line.strip_prefix("SKIPPED [")?.split_once(']')?;
    reason.contains(variable).then_some(Counts {
        failed: number.parse().ok()?,
        ..Counts::default()
    })
}

/// Reads a line of the summary of Node's test runner: `ℹ pass 3` or `# pass 3`.
pub(crate) fn of_node_test(line: &str) -> Option<Counts> {
    let (word, number) = line.trim_start_matches(['ℹ', '#', ' ']).split_once(' ')?;
    let number = number.trim().parse().ok()?;
    let mut counts = Counts::default();
    match word {
        "pass" => counts.passed = number,
        "fail" | "cancelled" => counts.failed = number,
        "skipped" | "todo" => counts.skipped = number,
        _ => return None,
    }
    line.starts_with(['ℹ', '#']).then_some(counts)
}

/// Reads the closing line of `pytest`: `=== 2 failed, 3 passed, 1 skipped in 0.1s ===`, or that without the bars.
pub(crate) fn of_pytest(line: &str) -> Option<Counts> {
    let (figures, time) = line.trim_matches(['=', ' ']).rsplit_once(" in ")?;
    let seconds = time.split_whitespace().next()?.strip_suffix('s')?;
    seconds.parse::<f64>().ok()?;
    let parts = || figures.split(", ");
    if figures != "no tests ran" && !parts().all(|part| figure(part).is_some()) {
        return None;
    }
    Some(sum(parts()))
}

fn sum<'a>(parts: impl Iterator<Item = &'a str>) -> Counts {
    let mut counts = Counts::default();
    for (number, word) in parts.filter_map(figure) {
        match word {
            "passed" | "xpassed" => counts.passed += number,
            "failed" | "error" | "errors" => counts.failed += number,
            "skipped" | "ignored" | "xfailed" => counts.skipped += number,
            // Measured, filtered out, deselected, warnings: not results.
            _ => {}
        }
    }
    counts
}

/// Splits `3 passed` into (3, "passed"), and `4 filtered out` into (4, "filtered").
fn figure(part: &str) -> Option<(u64, &str)> {
    let mut words = part.split_whitespace();
    Some((words.next()?.parse().ok()?, words.next()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn counts(passed: u64, failed: u64, skipped: u64) -> Option<Counts> {
        Some(Counts {
            passed,
            failed,
            skipped,
        })
    }

    #[test]
    fn reads_the_counts_of_cargo_test() {
        let line =
            "test result: ok. 12 passed; 0 failed; 3 ignored; 0 measured; 4 filtered out; finished in 0.01s";
        assert_eq!(of_cargo_test(line), counts(12, 0, 7));
        assert_eq!(of_filtered_cargo_test(line), counts(12, 0, 3));
        let line = "test result: FAILED. 1 passed; 2 failed; 0 ignored; 0 measured; 0 filtered out; finished in 1.5s";
        assert_eq!(of_cargo_test(line), counts(1, 2, 0));
        assert_eq!(of_cargo_test("test lens::tests::round_trip ... ok"), None);
        assert_eq!(of_cargo_test("running 3 tests"), None);
    }

    #[test]
    fn reads_the_counts_of_pytest() {
        assert_eq!(of_pytest("12 passed in 0.50s"), counts(12, 0, 0));
        let line =
            "==== 1 failed, 2 passed, 3 skipped, 4 deselected, 1 warning, 2 errors in 75.01s (0:01:15) ====";
        assert_eq!(of_pytest(line), counts(2, 3, 3));
        assert_eq!(of_pytest("no tests ran in 0.01s"), counts(0, 0, 0));
        assert_eq!(of_pytest("tests/oracles/test_x.py ..s. [100%]"), None);
        assert_eq!(of_pytest("wrote five assets in 3 ms"), None);
        assert_eq!(of_pytest("SKIPPED [1] x.py:3: not in 24.5s"), None);
        let line = "SKIPPED [2] x.py:3: DATA is not set";
        assert_eq!(of_data_skipped_by_pytest(line, "DATA"), counts(0, 2, 0));
        assert_eq!(of_data_skipped_by_pytest(line, "OTHER"), None);
    }

    #[test]
    fn reads_the_summary_of_node() {
        let counts = |line| of_node_test(line).map(|counts| (counts.passed, counts.failed, counts.skipped));
        assert_eq!(counts("ℹ pass 12"), Some((12, 0, 0)));
        assert_eq!(counts("# fail 2"), Some((0, 2, 0)));
        assert_eq!(counts("ℹ skipped 1"), Some((0, 0, 1)));
        assert_eq!(counts("ℹ tests 15"), None);
        assert_eq!(counts("pass 3"), None);
    }
}

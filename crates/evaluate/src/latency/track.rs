use std::path::Path;

use oaktwin_files::FileError;

use crate::table::{self, TableProblem, wrong};

const COLUMNS: [&str; 2] = ["time_s", "position"];

/// Positions over time.
#[derive(Clone, Debug, PartialEq)]
pub struct Track {
    /// The name for messages: the file.
    pub name: String,
    /// The times in seconds, each later than the one before.
    pub time_s: Vec<f64>,
    /// The positions, in any unit.
    pub position: Vec<f64>,
}

impl Track {
    /// Reads a CSV file with the columns `time_s` and `position`.
    ///
    /// # Errors
    /// Returns an error if the file cannot be read, if a number is missing or not finite, if times do not increase, or if the
    /// position never changes.
    pub fn read(path: &Path) -> Result<Self, FileError> {
        let text = table::text(path, "positions over time")?;
        let rows = table::rows(&text, COLUMNS).map_err(|wrong| wrong.of(path))?;
        let column = |at: usize| {
            rows.iter()
                .map(|row| row.number(at))
                .collect::<Result<Vec<f64>, TableProblem>>()
        };
        let numbers = column(0).and_then(|time_s| Ok((time_s, column(1)?)));
        let (time_s, position) = numbers.map_err(|wrong| wrong.of(path))?;
        Self::checked(path, time_s, position, |at| format!("line {}", rows[at].line))
    }

    /// Creates a track from as many times as positions; `name` is for messages.
    ///
    /// # Errors
    /// Returns an error if the numbers of times and positions differ, if there are none, and as [`Track::read`].
    pub fn new(name: &str, time_s: Vec<f64>, position: Vec<f64>) -> Result<Self, FileError> {
        let path = Path::new(name);
        if time_s.len() != position.len() || time_s.is_empty() {
            let what = format!("has {} times and {} positions", time_s.len(), position.len());
            return Err(wrong(what, "give a position for each time").of(path));
        }
        if let Some(at) = (0..time_s.len()).find(|at| !(time_s[*at].is_finite() && position[*at].is_finite()))
        {
            let what = format!("sample {at}: ({}, {}) is not finite", time_s[at], position[at]);
            return Err(wrong(what, "remove what is not a number").of(path));
        }
        Self::checked(path, time_s, position, |at| format!("sample {at}"))
    }

    fn checked(
        path: &Path,
        time_s: Vec<f64>,
        position: Vec<f64>,
        place: impl Fn(usize) -> String,
    ) -> Result<Self, FileError> {
        if let Some(at) = (1..time_s.len()).find(|at| time_s[at - 1] >= time_s[*at]) {
            let what = format!(
                "{}: time_s: {} is not after {}",
                place(at),
                time_s[at],
                time_s[at - 1]
            );
            return Err(wrong(what, "sort by time, and remove what is repeated").of(path));
        }
        if position.windows(2).all(|pair| pair[0] == pair[1]) {
            return Err(wrong("the position never changes", "record an edge that moves").of(path));
        }
        Ok(Self {
            name: path.display().to_string(),
            time_s,
            position,
        })
    }

    /// Returns the position at a time within the track, and the speed, per second; linear between samples.
    pub(super) fn at(&self, time_s: f64) -> (f64, f64) {
        let last = self.time_s.len() - 1;
        let after = self
            .time_s
            .partition_point(|t| *t <= time_s)
            .clamp(1, last.max(1))
            .min(last);
        let before = after.saturating_sub(1);
        let (t0, t1) = (self.time_s[before], self.time_s[after]);
        let (p0, p1) = (self.position[before], self.position[after]);
        if t1 <= t0 {
            return (p0, 0.0);
        }
        let speed = (p1 - p0) / (t1 - t0);
        (p0 + (time_s - t0) * speed, speed)
    }

    /// Returns the median time between samples, s.
    pub(super) fn interval_s(&self) -> f64 {
        let mut gaps: Vec<f64> = self.time_s.windows(2).map(|pair| pair[1] - pair[0]).collect();
        gaps.sort_by(f64::total_cmp);
        gaps.get(gaps.len() / 2).copied().unwrap_or(0.0)
    }
}

use std::fmt;

use super::inspect::Problem;

/// Why a file could not be opened as a stage: `FILE: PLACE: what is wrong; what to do`, on one line.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub struct StageError {
    /// The file as the caller named it.
    pub file: String,
    /// Where in the file, as far as known: a line, a section, an entry of the package. May be empty.
    pub place: String,
    /// What is wrong.
    pub what: String,
    /// What to do.
    pub remedy: String,
}

impl StageError {
    pub(super) fn new(
        file: &str,
        place: impl Into<String>,
        what: impl Into<String>,
        remedy: impl Into<String>,
    ) -> Self {
        Self {
            file: file.to_owned(),
            place: place.into(),
            what: what.into(),
            remedy: remedy.into(),
        }
    }

    pub(super) fn from_problem(file: &str, problem: Problem) -> Self {
        Self::new(file, problem.place, problem.what, problem.remedy)
    }
}

impl fmt::Display for StageError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: ", self.file)?;
        if !self.place.is_empty() {
            write!(f, "{}: ", self.place)?;
        }
        write!(f, "{}; {}", self.what, self.remedy)
    }
}

/// Makes one line of a message that another library laid out over several, and keeps it short.
pub(super) fn one_line(text: &str) -> String {
    const LONGEST: usize = 300;
    let mut line = text.split_whitespace().collect::<Vec<_>>().join(" ");
    if let Some((end, _)) = line.char_indices().nth(LONGEST) {
        line.truncate(end);
        line.push('…');
    }
    line
}

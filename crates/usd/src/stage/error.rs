use std::fmt;

use oaktwin_base::diagnostic::Message;

/// The reason why a file could not be opened as a stage, on one line: `FILE: PLACE: what is wrong; what to do`.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub struct StageError {
    /// The file's path as given by the caller.
    pub file: String,
    /// The place in the file, if known: a line, a section or a package entry. May be empty.
    pub place: String,
    /// The problem.
    pub what: String,
    /// The remedy.
    pub remedy: Message,
}

impl StageError {
    pub(super) fn new(
        file: &str,
        place: impl Into<String>,
        what: impl Into<String>,
        remedy: impl Into<Message>,
    ) -> Self {
        Self {
            file: file.to_owned(),
            place: place.into(),
            what: what.into(),
            remedy: remedy.into(),
        }
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

/// Joins the lines of another library's message and truncates it.
pub(super) fn one_line(text: &str) -> String {
    const MAX_CHARS: usize = 300;
    let mut line = text.split_whitespace().collect::<Vec<_>>().join(" ");
    if let Some((end, _)) = line.char_indices().nth(MAX_CHARS) {
        line.truncate(end);
        line.push('…');
    }
    line
}

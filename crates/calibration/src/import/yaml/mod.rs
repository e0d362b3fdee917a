//! A reader for the YAML that calibration tools write: block and flow collections, plain and quoted scalars on one line, comments, and
//! the header and tags of OpenCV's `FileStorage`. Anchors, aliases and block scalars are rejected. Its result is a JSON document
//! with positions.

mod block;
mod flow;
mod line;
mod scalar;

use super::CalibrationError;
use crate::raw::{MAX_DEPTH, Node};

/// A syntax error.
struct Problem {
    line: usize,
    what: String,
}

impl Problem {
    fn new(line: usize, what: impl Into<String>) -> Self {
        Self {
            line,
            what: what.into(),
        }
    }

    fn too_deep(line: usize) -> Self {
        Self::new(line, format!("nested deeper than {MAX_DEPTH} levels"))
    }
}

/// Parses the first document of a file. `name` is its name in messages.
pub(super) fn parse(bytes: &[u8], name: &str) -> Result<Node, CalibrationError> {
    document(bytes).map_err(|problem| CalibrationError::Unsuited {
        file: name.to_owned(),
        place: format!("line {}", problem.line),
        what: problem.what,
        remedy: "give a camera_info, camchain or FileStorage file in YAML, or write it again",
    })
}

fn document(bytes: &[u8]) -> Result<Node, Problem> {
    let text = std::str::from_utf8(bytes).map_err(|error| {
        let before = bytes.get(..error.valid_up_to()).unwrap_or_default();
        let line = 1 + before.iter().filter(|byte| **byte == b'\n').count();
        Problem::new(line, "not UTF-8 text")
    })?;
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    if text.trim_start().starts_with('<') {
        return Err(Problem::new(1, "XML, not YAML"));
    }
    let lines = line::lines(text)?;
    if lines.is_empty() {
        return Err(Problem::new(1, "the file is empty"));
    }
    block::document(&lines)
}

#[cfg(test)]
mod tests;

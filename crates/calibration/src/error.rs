use std::fmt;

use oaktwin_diagnostic::Finding;

use crate::Socket;

/// Why a calibration cannot be used.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CalibrationError {
    /// The file is not a JSON document.
    #[error("{file}: {line}:{column}: {what}; {remedy}")]
    Json {
        /// The file.
        file: String,
        /// From 1.
        line: usize,
        /// From 1, in characters.
        column: usize,
        /// What is wrong.
        what: String,
        /// What to do.
        remedy: &'static str,
    },
    /// The document is not a calibration that means anything.
    #[error("{file}: {}", Errors(.errors))]
    Meaningless {
        /// The file.
        file: String,
        /// What is wrong, in the file's order; at least one.
        errors: Vec<Finding>,
    },
    /// A camera that the calibration lacks.
    #[error("{file}: cameraData: no {socket}; name one of {}", Sockets(.present))]
    NoCamera {
        /// The file.
        file: String,
        /// The one asked for.
        socket: Socket,
        /// Those it has.
        present: Vec<Socket>,
    },
    /// Two parts of the device that no chain of extrinsics joins.
    #[error("{file}: cameraData: no extrinsics join {from} and {to}; calibrate them together")]
    Disconnected {
        /// The file.
        file: String,
        /// One part.
        from: String,
        /// The other part.
        to: String,
    },
    /// The specified (board) translation of a link was never filled in.
    #[error("{file}: {place}.specTranslation: all zero, so there is none; use the calibrated translation")]
    NoSpecTranslation {
        /// The file.
        file: String,
        /// The extrinsics' path.
        place: String,
    },
    /// The file places no such part.
    #[error("{file}: {place}: the file does not place it; calibrate it, or do without")]
    NotPlaced {
        /// The file.
        file: String,
        /// The key.
        place: &'static str,
    },
    /// The calibration does not do for what is asked.
    #[error("{file}: {place}: {what}; {remedy}")]
    Unsuited {
        /// The file.
        file: String,
        /// The field's path.
        place: String,
        /// What is wrong.
        what: String,
        /// What to do.
        remedy: &'static str,
    },
}

impl CalibrationError {
    /// Everything that is wrong, where the error knows more than the one thing that it prints.
    #[must_use]
    pub fn findings(&self) -> &[Finding] {
        match self {
            Self::Meaningless { errors, .. } => errors,
            _ => &[],
        }
    }
}

struct Errors<'a>(&'a [Finding]);

impl fmt::Display for Errors<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Some(first) = self.0.first() else {
            return Ok(());
        };
        write!(f, "{}: {}", first.place, first.message)?;
        if !first.remedy.is_empty() {
            write!(f, "; {}", first.remedy)?;
        }
        match self.0.len() - 1 {
            0 => Ok(()),
            1 => write!(f, " (and 1 more error)"),
            more => write!(f, " (and {more} more errors)"),
        }
    }
}

struct Sockets<'a>(&'a [Socket]);

impl fmt::Display for Sockets<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, socket) in self.0.iter().enumerate() {
            write!(f, "{}{socket}", if i == 0 { "" } else { ", " })?;
        }
        Ok(())
    }
}

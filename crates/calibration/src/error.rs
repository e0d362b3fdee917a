use std::fmt;

use oaktwin_base::diagnostic::Finding;

use crate::Socket;

/// An error in a calibration.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CalibrationError {
    /// The file is not a JSON document.
    #[error("{file}: {line}:{column}: {what}; {remedy}")]
    Json {
        /// The file.
        file: String,
        /// The line, from 1.
        line: usize,
        /// The column in characters, from 1.
        column: usize,
        /// The problem.
        what: String,
        /// The remedy.
        remedy: &'static str,
    },
    /// The document is not a valid calibration.
    #[error("{file}: {}", Errors(.errors))]
    Invalid {
        /// The file.
        file: String,
        /// The errors in the order of the file; at least one.
        errors: Vec<Finding>,
    },
    /// The calibration does not contain a camera.
    #[error("{file}: cameraData: no camera {socket}; use one of {}", Sockets(.present))]
    NoCamera {
        /// The file.
        file: String,
        /// The requested socket.
        socket: Socket,
        /// The sockets of the calibration.
        present: Vec<Socket>,
    },
    /// No chain of extrinsics connects two parts of the device.
    #[error("{file}: cameraData: no extrinsics connect {from} and {to}; calibrate them together")]
    Disconnected {
        /// The file.
        file: String,
        /// One part.
        from: String,
        /// The other part.
        to: String,
    },
    /// The translation of the board's design is missing.
    #[error("{file}: {place}.specTranslation: missing (all zero); use the calibrated translation")]
    NoSpecTranslation {
        /// The file.
        file: String,
        /// The path of the extrinsics.
        place: String,
    },
    /// The file does not contain the extrinsics of a part.
    #[error("{file}: {place}: missing or empty; calibrate this part or do not use it")]
    NotPlaced {
        /// The file.
        file: String,
        /// The key.
        place: &'static str,
    },
    /// The calibration is unsuitable for the operation.
    #[error("{file}: {place}: {what}; {remedy}")]
    Unsuited {
        /// The file.
        file: String,
        /// The path of the field.
        place: String,
        /// The problem.
        what: String,
        /// The remedy.
        remedy: &'static str,
    },
}

impl CalibrationError {
    /// Returns all errors of an invalid document. The error's text contains only the first.
    #[must_use]
    pub fn findings(&self) -> &[Finding] {
        match self {
            Self::Invalid { errors, .. } => errors,
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

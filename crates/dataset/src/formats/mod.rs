//! The formats of data sets.

use oaktwin_diagnostic::suggest;

use crate::{BasicWriter, Format, Options};

/// A format that a user chooses by name.
#[derive(Debug)]
pub struct FormatKind {
    /// The name.
    pub name: &'static str,
    /// One line of help.
    pub help: &'static str,
    /// What its shots must contain.
    pub needs: Needs,
    /// Creates the format.
    pub create: fn(Options) -> Box<dyn Format>,
}

/// What the shots of a format must contain besides annotations.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Needs {
    /// Whether objects are described.
    pub objects: bool,
    /// Whether there is a stereo pair.
    pub stereo: bool,
}

/// All formats; the first is the default.
pub const FORMATS: &[FormatKind] = &[FormatKind {
    name: "basic",
    help: "Replicator's BasicWriter",
    needs: Needs {
        objects: false,
        stereo: false,
    },
    create: |options| Box::new(BasicWriter::new(options)),
}];

impl FormatKind {
    /// Returns the format of this name.
    ///
    /// # Errors
    /// Returns the remedy, with the nearest name, if there is none.
    pub fn find(name: &str) -> Result<&'static Self, String> {
        let found = FORMATS.iter().find(|format| format.name == name);
        found.ok_or_else(|| suggest(name, FORMATS.iter().map(|format| format.name)))
    }
}

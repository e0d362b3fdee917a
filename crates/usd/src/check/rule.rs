use oaktwin_base::diagnostic::{Finding, Level, Message};
use serde::Serialize;

/// A rule of `check`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Rule {
    /// The code of the rule's findings.
    pub code: &'static str,
    /// The default level of its findings.
    pub level: Level,
    /// The problem that the rule reports.
    pub what: &'static str,
    /// The remedy; empty for notes.
    pub remedy: &'static str,
}

impl Rule {
    /// Creates a finding at the rule's level.
    pub(super) fn at(&self, place: &str, message: impl Into<Message>) -> Finding {
        Finding::new(self.code, self.level, place, message, self.remedy)
    }

    /// Creates a note.
    pub(super) fn note(&self, place: &str, message: impl Into<Message>) -> Finding {
        Finding::new(self.code, Level::Note, place, message, "")
    }

    /// Creates a finding at the rule's level, or a note if the file has the value that its source ships.
    pub(super) fn at_or_note(&self, as_shipped: bool, place: &str, message: impl Into<Message>) -> Finding {
        if as_shipped {
            self.note(place, message)
        } else {
            self.at(place, message)
        }
    }

    /// Creates a finding with a specific remedy.
    pub(super) fn with_remedy(
        &self,
        place: &str,
        message: impl Into<Message>,
        remedy: impl Into<Message>,
    ) -> Finding {
        Finding::new(self.code, self.level, place, message, remedy)
    }
}

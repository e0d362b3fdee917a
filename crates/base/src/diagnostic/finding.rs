use std::fmt;

use serde::{Deserialize, Serialize};

use crate::diagnostic::Message;

/// The severity of a finding.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Deserialize, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Level {
    /// For information; no action is needed.
    Note,
    /// Suspicious: the result is valid but should be checked.
    Warning,
    /// The result would be meaningless.
    Error,
}

/// A problem in an input: where it is, what is wrong, and how to fix it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Finding {
    /// A short stable name for machines, such as `baseline-off`.
    pub code: &'static str,
    /// The severity.
    pub level: Level,
    /// The path of the field or prim.
    pub place: String,
    /// What is wrong.
    pub message: Message,
    /// How to fix it; empty if there is nothing to fix.
    pub remedy: Message,
}

/// Adds the findings that are not in a list yet.
pub fn add_new(findings: &mut Vec<Finding>, more: impl IntoIterator<Item = Finding>) {
    for finding in more {
        if !findings.contains(&finding) {
            findings.push(finding);
        }
    }
}

impl Finding {
    /// A finding; the remedy may be empty.
    pub fn new(
        code: &'static str,
        level: Level,
        place: impl Into<String>,
        message: impl Into<Message>,
        remedy: impl Into<Message>,
    ) -> Self {
        Self {
            code,
            level,
            place: place.into(),
            message: message.into(),
            remedy: remedy.into(),
        }
    }

    /// The finding with other texts, for a reader who knows files by other names.
    #[must_use]
    pub fn map_texts(&self, change: impl Fn(&str) -> String) -> Self {
        Self {
            place: change(&self.place),
            message: self.message.map_texts(&change),
            remedy: self.remedy.map_texts(&change),
            ..*self
        }
    }

    /// Writes the finding with another text for its place.
    pub(crate) fn write_at(&self, f: &mut fmt::Formatter<'_>, place: &str) -> fmt::Result {
        write!(f, "{}[{}]: {place}: {}", self.level, self.code, self.message)?;
        match self.remedy.is_empty() {
            true => Ok(()),
            false => write!(f, "; {}", self.remedy),
        }
    }
}

impl fmt::Display for Level {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Note => "note",
            Self::Warning => "warning",
            Self::Error => "error",
        })
    }
}

/// `warning[baseline-off]: extrinsics: …; remedy`
impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.write_at(f, &self.place)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostic::{message, opt, with_style};

    #[test]
    fn a_finding_is_one_line() {
        let mut finding = Finding::new(
            "baseline-off",
            Level::Warning,
            "extrinsics",
            "8 cm",
            "recalibrate",
        );
        let line = "warning[baseline-off]: extrinsics: 8 cm; recalibrate";
        assert_eq!(finding.to_string(), line);
        let renamed = finding.map_texts(|text| text.replace("extrinsics", "rig"));
        assert_eq!(renamed.to_string(), line.replace("extrinsics", "rig"));
        finding.remedy = Message::default();
        assert_eq!(finding.to_string(), "warning[baseline-off]: extrinsics: 8 cm");
    }

    #[test]
    fn options_have_the_style_of_the_front_end() {
        let finding = Finding::new(
            "own-size",
            Level::Note,
            "run--fx/a.npy",
            message![opt("fx"), " has no effect"],
            message!["remove ", opt("fx")],
        );
        assert_eq!(
            with_style(|option| format!("--{}", option.name()), || finding.to_string()),
            "note[own-size]: run--fx/a.npy: --fx has no effect; remove --fx"
        );
    }
}

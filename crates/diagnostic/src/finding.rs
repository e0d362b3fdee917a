use std::fmt;

use serde::Serialize;

use crate::{Message, Opt, ToMessage, message};

/// The severity of a finding.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
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

    /// The same finding with each option spelled by `style`, ready to be printed or serialized.
    #[must_use]
    pub fn rendered(&self, style: impl Fn(&Opt) -> String) -> Self {
        Self {
            code: self.code,
            level: self.level,
            place: self.place.clone(),
            message: self.message.render(&style).into(),
            remedy: self.remedy.render(&style).into(),
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
impl ToMessage for Finding {
    fn to_message(&self) -> Message {
        let head = format!("{}[{}]: {}: ", self.level, self.code, self.place);
        let mut line = message![head, &self.message];
        if !self.remedy.is_empty() {
            line.push("; ");
            line.push(&self.remedy);
        }
        line
    }
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.to_message().fmt(f)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::opt;

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
        finding.remedy = Message::default();
        assert_eq!(finding.to_string(), "warning[baseline-off]: extrinsics: 8 cm");
    }

    #[test]
    fn rendering_a_finding_spells_the_options_of_its_message_and_remedy() {
        let finding = Finding::new(
            "own-size",
            Level::Note,
            "run--fx/a.npy",
            message![opt("fx"), " has no effect"],
            message!["remove ", opt("fx")],
        );
        let rendered = finding.rendered(|option| format!("--{}", option.name()));
        assert_eq!(
            rendered.to_string(),
            "note[own-size]: run--fx/a.npy: --fx has no effect; remove --fx"
        );
        assert_eq!(
            finding.to_message().render(|option| option.name().to_uppercase()),
            "note[own-size]: run--fx/a.npy: FX has no effect; remove FX"
        );
    }
}

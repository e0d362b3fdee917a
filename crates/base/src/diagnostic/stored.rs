//! Findings in files: with options as data, so that whoever reads them can print them in another style. For serde's `with`.

use std::collections::BTreeSet;
use std::sync::{Mutex, PoisonError};

use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::diagnostic::{Finding, Level, Message, command, opt};

/// The maximum number of different names of findings and options, of which there are fewer than 500.
const MAX_NAMES: usize = 2000;
/// The maximum length of a name, bytes.
const MAX_LENGTH: usize = 100;

#[derive(Deserialize, Serialize)]
struct StoredFinding {
    code: String,
    level: Level,
    place: String,
    message: Vec<Part>,
    remedy: Vec<Part>,
}

/// A part of a message.
#[derive(Deserialize, Serialize)]
#[serde(untagged)]
enum Part {
    Text(String),
    Option {
        option: String,
        #[serde(default, skip_serializing_if = "Option::is_none")]
        value: Option<String>,
        #[serde(default, skip_serializing_if = "std::ops::Not::not")]
        command: bool,
    },
}

/// Serializes findings.
///
/// # Errors
/// Returns the errors of the serializer.
pub fn serialize<S: Serializer>(findings: &[Finding], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(findings.iter().map(|finding| StoredFinding {
        code: finding.code.to_string(),
        level: finding.level,
        place: finding.place.clone(),
        message: parts(&finding.message),
        remedy: parts(&finding.remedy),
    }))
}

/// Deserializes findings.
///
/// # Errors
/// Returns an error if the input is not a list of findings.
pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<Finding>, D::Error> {
    let stored = Vec::<StoredFinding>::deserialize(deserializer)?;
    let finding = |finding: StoredFinding| {
        Some(Finding {
            code: interned(&finding.code)?,
            level: finding.level,
            place: finding.place,
            message: message(finding.message)?,
            remedy: message(finding.remedy)?,
        })
    };
    let findings: Option<_> = stored.into_iter().map(finding).collect();
    findings.ok_or_else(|| D::Error::custom("too many different names of findings and options"))
}

fn parts(message: &Message) -> Vec<Part> {
    let mut parts = Vec::new();
    for (text, option) in message.pieces() {
        if !text.is_empty() {
            parts.push(Part::Text(text.to_owned()));
        }
        parts.extend(option.map(|option| Part::Option {
            option: option.name().to_owned(),
            value: option.value().map(str::to_owned),
            command: option.is_command(),
        }));
    }
    parts
}

fn message(parts: Vec<Part>) -> Option<Message> {
    let mut message = Message::default();
    for part in parts {
        match part {
            Part::Text(text) => message.push(text),
            Part::Option {
                option,
                value,
                command: is_command,
            } => {
                let name = interned(&option)?;
                let option = if is_command { command(name) } else { opt(name) };
                message.push(match value {
                    Some(value) => option.with(value),
                    None => option,
                });
            }
        }
    }
    Some(message)
}

/// Returns the one copy of a name, which lives as long as the process; `None` if there are too many names.
fn interned(name: &str) -> Option<&'static str> {
    static NAMES: Mutex<BTreeSet<&'static str>> = Mutex::new(BTreeSet::new());
    let mut names = NAMES.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(known) = names.get(name) {
        return Some(known);
    }
    if names.len() >= MAX_NAMES || name.len() > MAX_LENGTH {
        return None;
    }
    let name: &'static str = Box::leak(name.into());
    names.insert(name);
    Some(name)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostic::message;

    #[derive(Debug, PartialEq, Deserialize, Serialize)]
    struct Record {
        #[serde(with = "super")]
        findings: Vec<Finding>,
    }

    #[test]
    fn findings_are_read_back_with_their_options() {
        let finding = Finding::new(
            "own-size",
            Level::Warning,
            "run--fx/ä.npy",
            message![opt("fx").with(500), " has no effect"],
            message!["remove ", opt("fx"), "; or ", opt("fy")],
        );
        let unknown = Finding::new("unknown", Level::Error, "model", message![command("models")], "");
        let record = Record {
            findings: vec![
                finding,
                unknown,
                Finding::new("far", Level::Note, "depth", "8 m", ""),
            ],
        };
        let text = serde_json::to_string(&record).unwrap();
        assert_eq!(serde_json::from_str::<Record>(&text).unwrap(), record);
        assert!(text.contains(r#""remedy":["remove ",{"option":"fx"},"; or ",{"option":"fy"}]"#));
    }
}

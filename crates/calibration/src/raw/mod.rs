//! The lossless layer: a DepthAI JSON with its keys, their order, and numbers as text.

mod parse;
mod value;
mod write;

pub use parse::{MAX_BYTES, MAX_DEPTH};
pub use value::{Node, Position, Value};

use crate::CalibrationError;

/// A lossless JSON document and its file name.
#[derive(Clone, Debug, PartialEq)]
pub struct Raw {
    /// The file's name in messages.
    pub name: String,
    /// The document.
    pub root: Node,
}

impl Raw {
    /// Parses the bytes of a JSON file. `name` is its name in messages.
    ///
    /// # Errors
    /// Returns an error with line and column if the file is not UTF-8, not JSON, nested deeper than [`MAX_DEPTH`] or larger than
    /// [`MAX_BYTES`].
    pub fn parse(bytes: &[u8], name: &str) -> Result<Self, CalibrationError> {
        parse::document(bytes)
            .map(|root| Self {
                name: name.to_owned(),
                root,
            })
            .map_err(|problem| CalibrationError::Json {
                file: name.to_owned(),
                line: problem.at.line,
                column: problem.at.column,
                what: problem.what,
                remedy: problem.remedy,
            })
    }

    /// Formats the document like `DepthAI`: four spaces per level, each element on a line, and a newline at the end. Numbers and
    /// keys do not change.
    #[must_use]
    pub fn to_text(&self) -> String {
        write::document(&self.root)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn value() -> impl Strategy<Value = Value> {
        let leaf = prop_oneof![
            Just(Value::Null),
            any::<bool>().prop_map(Value::Bool),
            any::<f64>().prop_map(|x| Value::Number(if x.is_finite() {
                format!("{x:?}")
            } else {
                "-0".into()
            })),
            any::<String>().prop_map(Value::String),
        ];
        leaf.prop_recursive(5, 40, 6, |inner| {
            let node = inner.prop_map(Node::from);
            prop_oneof![
                prop::collection::vec(node.clone(), 0..6).prop_map(Value::Array),
                prop::collection::vec((any::<String>(), node), 0..6).prop_map(Value::Object),
            ]
        })
    }

    proptest! {
        #[test]
        fn text_round_trips(value in value()) {
            let raw = Raw { name: "x".into(), root: Node::from(value) };
            let text = raw.to_text();
            let again = Raw::parse(text.as_bytes(), "x").unwrap();
            prop_assert!(again.root.same_as(&raw.root));
            prop_assert_eq!(again.to_text(), text);
        }

        #[test]
        fn never_panics_on_bytes(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
            let _ = Raw::parse(&bytes, "x");
        }

        #[test]
        fn accepts_the_same_texts_as_serde_json(text in r#"[\[\]{}:,"0-9eE+.\-\\unatrlsf ]{0,60}"#) {
            let ours = Raw::parse(text.as_bytes(), "x").is_ok();
            let theirs = serde_json::from_str::<serde_json::Value>(&text);
            // Numbers out of the range of f64 are kept as text here.
            let too_large = theirs.as_ref().is_err_and(|e| e.to_string().contains("out of range"));
            prop_assert!(ours == theirs.is_ok() || too_large, "{text}");
        }
    }

    #[test]
    fn keeps_the_text_of_numbers() {
        let text = "{\n    \"a\": [\n        1.50,\n        -0.0,\n        1e999,\n        12345678901234567890\n    ],\n    \"b\": [],\n    \"c\": {}\n}\n";
        assert_eq!(Raw::parse(text.as_bytes(), "x").unwrap().to_text(), text);
    }
}

//! The lossless layer: a DepthAI JSON with its keys, order, values and number text as they were.

mod parse;
mod value;
mod write;

pub use parse::{MAX_BYTES, MAX_DEPTH};
pub use value::{Node, Position, Value};

use crate::CalibrationError;

/// A JSON document as it was written, and the name that messages call it by.
#[derive(Clone, Debug, PartialEq)]
pub struct Raw {
    /// What messages call the file.
    pub name: String,
    /// The document.
    pub root: Node,
}

impl Raw {
    /// Parses the bytes of a JSON file. `name` is what messages call it.
    ///
    /// # Errors
    /// Not UTF-8, not JSON (with line and column), deeper than [`MAX_DEPTH`] or larger than [`MAX_BYTES`].
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

    /// The document as `DepthAI` lays it out: four spaces a level, every element on its own line, a newline at the
    /// end. Numbers and keys are what they were.
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
        fn any_bytes_parse_or_fail_politely(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
            let _ = Raw::parse(&bytes, "x");
        }

        #[test]
        fn json_like_bytes_parse_or_fail_politely(text in r#"[\[\]{}:,"0-9eE+.\-\\unatrlsf ]{0,60}"#) {
            let ours = Raw::parse(text.as_bytes(), "x").is_ok();
            let theirs = serde_json::from_str::<serde_json::Value>(&text);
            // Numbers beyond f64 are text to us.
            let too_large = theirs.as_ref().is_err_and(|e| e.to_string().contains("out of range"));
            prop_assert!(ours == theirs.is_ok() || too_large, "{text}");
        }
    }

    #[test]
    fn number_text_stays() {
        let text = "{\n    \"a\": [\n        1.50,\n        -0.0,\n        1e999,\n        12345678901234567890\n    ],\n    \"b\": [],\n    \"c\": {}\n}\n";
        assert_eq!(Raw::parse(text.as_bytes(), "x").unwrap().to_text(), text);
    }
}

use oaktwin_base::diagnostic::{Finding, Level, Message};
use oaktwin_camera::math::{DMat3, DVec3};

use crate::raw::{Node, Value};

/// A value of the document and its path.
#[derive(Clone, Debug)]
pub(crate) struct Field<'a> {
    pub(crate) node: &'a Node,
    pub(crate) path: String,
}

impl<'a> Field<'a> {
    pub(crate) fn root(node: &'a Node) -> Self {
        Self {
            node,
            path: String::new(),
        }
    }

    pub(crate) fn key_path(&self, key: &str) -> String {
        if self.path.is_empty() {
            key.to_owned()
        } else {
            format!("{}.{key}", self.path)
        }
    }

    pub(crate) fn get(&self, key: &str) -> Option<Self> {
        self.node.get(key).map(|node| Self {
            node,
            path: self.key_path(key),
        })
    }

    /// Returns the value of the first key that exists.
    pub(crate) fn get_any(&self, keys: &[&str]) -> Option<Self> {
        keys.iter().find_map(|key| self.get(key))
    }
}

/// Reads values of a document and collects errors. A method that returns `None` has recorded an error.
#[derive(Debug, Default)]
pub(crate) struct Reader {
    pub(crate) errors: Vec<Finding>,
    pub(crate) findings: Vec<Finding>,
}

impl Reader {
    pub(crate) fn error(
        &mut self,
        code: &'static str,
        place: impl Into<String>,
        message: impl Into<Message>,
        remedy: impl Into<Message>,
    ) {
        self.errors
            .push(Finding::new(code, Level::Error, place, message, remedy));
    }

    pub(crate) fn warn(
        &mut self,
        code: &'static str,
        place: impl Into<String>,
        message: impl Into<Message>,
        remedy: impl Into<Message>,
    ) {
        self.findings
            .push(Finding::new(code, Level::Warning, place, message, remedy));
    }

    pub(crate) fn note(&mut self, code: &'static str, place: impl Into<String>, message: impl Into<Message>) {
        self.findings
            .push(Finding::new(code, Level::Note, place, message, ""));
    }

    fn wrong_type(&mut self, field: &Field<'_>, wanted: &str) {
        let found = match &field.node.value {
            Value::Null if wanted.contains("number") => "null (DepthAI's NaN)".to_owned(),
            other => other.kind().to_owned(),
        };
        let message = format!("line {} has {found} instead of {wanted}", field.node.at.line);
        let place = if field.path.is_empty() {
            "the document"
        } else {
            &field.path
        };
        self.error(
            "wrong-type",
            place,
            message,
            "correct it, or export the calibration again",
        );
    }

    pub(crate) fn require<'a>(&mut self, parent: &Field<'a>, key: &str) -> Option<Field<'a>> {
        let found = parent.get(key);
        if found.is_none() {
            self.missing(parent, key);
        }
        found
    }

    pub(crate) fn missing(&mut self, parent: &Field<'_>, key: &str) {
        let message = format!("the key is missing in the object at line {}", parent.node.at.line);
        self.error(
            "missing-key",
            parent.key_path(key),
            message,
            "add it, or export the calibration again",
        );
    }

    /// Checks that the field is an object. Unknown keys are noted, repeated ones cause a warning.
    pub(crate) fn object(&mut self, field: &Field<'_>, known: &[&str]) -> Option<()> {
        let Value::Object(entries) = &field.node.value else {
            self.wrong_type(field, "an object");
            return None;
        };
        for (i, (key, _)) in entries.iter().enumerate() {
            let earlier = entries.iter().take(i);
            if earlier.clone().any(|(k, _)| k == key) {
                let place = field.key_path(key);
                self.warn(
                    "repeated-key",
                    place,
                    "repeated key",
                    "the last value is used; remove the others",
                );
            } else if !known.contains(&key.as_str()) {
                let message = "not a key of DepthAI's format; preserved, but ignored";
                self.note("unknown-key", field.key_path(key), message);
            }
        }
        Some(())
    }

    pub(crate) fn array<'a>(&mut self, field: &Field<'a>) -> Option<Vec<Field<'a>>> {
        let Value::Array(items) = &field.node.value else {
            self.wrong_type(field, "an array");
            return None;
        };
        let item = |(i, node)| Field {
            node,
            path: format!("{}[{i}]", field.path),
        };
        Some(items.iter().enumerate().map(item).collect())
    }

    /// Reads a number in the range of a 32-bit float, which `DepthAI` stores.
    pub(crate) fn number(&mut self, field: &Field<'_>) -> Option<f64> {
        let Value::Number(text) = &field.node.value else {
            self.wrong_type(field, "a number");
            return None;
        };
        let value = text.parse().ok().filter(|x: &f64| x.abs() <= f64::from(f32::MAX));
        if value.is_none() {
            let shown: String = text.chars().take(40).collect();
            self.error(
                "not-finite",
                &field.path,
                format!(
                    "line {}: {shown} is out of the range of a 32-bit float",
                    field.node.at.line
                ),
                "correct it, or export the calibration again",
            );
        }
        value
    }

    pub(crate) fn integer(&mut self, field: &Field<'_>, min: i64, max: i64) -> Option<i64> {
        let value = self.number(field)?;
        #[expect(clippy::cast_possible_truncation, reason = "checked on the same line")]
        let whole = (value.fract() == 0.0 && value.abs() < 9e15).then_some(value as i64);
        let found = whole.filter(|i| (min..=max).contains(i));
        if found.is_none() {
            self.error(
                "out-of-range",
                &field.path,
                format!(
                    "line {}: {value} is not a whole number from {min} to {max}",
                    field.node.at.line
                ),
                "correct it, or export the calibration again",
            );
        }
        found
    }

    pub(crate) fn flag(&mut self, field: &Field<'_>) -> Option<bool> {
        let Value::Bool(flag) = field.node.value else {
            self.wrong_type(field, "true or false");
            return None;
        };
        Some(flag)
    }

    pub(crate) fn text(&mut self, field: &Field<'_>) -> Option<String> {
        let Value::String(text) = &field.node.value else {
            self.wrong_type(field, "a string");
            return None;
        };
        Some(text.clone())
    }

    pub(crate) fn numbers(&mut self, field: &Field<'_>) -> Option<Vec<f64>> {
        let items = self.array(field)?;
        let numbers: Vec<_> = items.iter().filter_map(|item| self.number(item)).collect();
        (numbers.len() == items.len()).then_some(numbers)
    }

    /// A 3×3 matrix in rows; `Some(None)` for `[]`.
    #[expect(
        clippy::option_option,
        reason = "an unusable field, an empty one, and a matrix are three things"
    )]
    pub(crate) fn matrix(&mut self, field: &Field<'_>) -> Option<Option<[[f64; 3]; 3]>> {
        let items = self.array(field)?;
        if items.is_empty() {
            return Some(None);
        }
        let rows: Vec<_> = items.iter().filter_map(|row| self.numbers(row)).collect();
        if rows.len() != items.len() {
            return None;
        }
        let row = |i: usize| rows.get(i).and_then(|r| <[f64; 3]>::try_from(r.as_slice()).ok());
        match (rows.len(), row(0), row(1), row(2)) {
            (3, Some(a), Some(b), Some(c)) => Some(Some([a, b, c])),
            _ => {
                self.wrong_type(field, "a 3x3 matrix of numbers");
                None
            }
        }
    }

    pub(crate) fn point(&mut self, field: &Field<'_>) -> Option<DVec3> {
        self.object(field, &["x", "y", "z"])?;
        let [x, y, z] = ["x", "y", "z"].map(|key| {
            let field = self.require(field, key)?;
            self.number(&field)
        });
        Some(DVec3::new(x?, y?, z?))
    }
}

/// Converts rows to a matrix.
pub(crate) fn from_rows(rows: [[f64; 3]; 3]) -> DMat3 {
    DMat3::from_cols_array_2d(&rows).transpose()
}

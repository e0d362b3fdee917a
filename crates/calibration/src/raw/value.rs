use std::fmt;

/// A position in a text, from 1; columns count characters.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Position {
    /// The line.
    pub line: usize,
    /// The column.
    pub column: usize,
}

impl fmt::Display for Position {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}", self.line, self.column)
    }
}

/// A JSON value and its position. Values that were not parsed have position 0:0.
#[derive(Clone, Debug, PartialEq)]
pub struct Node {
    /// The value.
    pub value: Value,
    /// The position of the first character.
    pub at: Position,
}

/// A JSON value that keeps the order of keys and the text of numbers.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// `null`.
    Null,
    /// `true` or `false`.
    Bool(bool),
    /// The text of a number.
    Number(String),
    /// An unescaped string.
    String(String),
    /// An array.
    Array(Vec<Node>),
    /// The entries of an object in order. Repeated keys are kept; the last one is used.
    Object(Vec<(String, Node)>),
}

impl Node {
    /// Returns the value of a key; the last one if it is repeated, as in `DepthAI`.
    #[must_use]
    pub fn get(&self, key: &str) -> Option<&Self> {
        match &self.value {
            Value::Object(entries) => entries.iter().rev().find(|(k, _)| k == key).map(|(_, node)| node),
            _ => None,
        }
    }

    /// Whether two nodes are equal, ignoring positions.
    #[must_use]
    pub fn same_as(&self, other: &Self) -> bool {
        match (&self.value, &other.value) {
            (Value::Array(a), Value::Array(b)) => {
                a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a.same_as(b))
            }
            (Value::Object(a), Value::Object(b)) => {
                a.len() == b.len() && a.iter().zip(b).all(|((k, a), (l, b))| k == l && a.same_as(b))
            }
            (a, b) => a == b,
        }
    }
}

impl Value {
    /// Returns the type in words: `a string`.
    #[must_use]
    pub const fn kind(&self) -> &'static str {
        match self {
            Self::Null => "null",
            Self::Bool(_) => "true or false",
            Self::Number(_) => "a number",
            Self::String(_) => "a string",
            Self::Array(_) => "an array",
            Self::Object(_) => "an object",
        }
    }
}

impl From<Value> for Node {
    fn from(value: Value) -> Self {
        Self {
            value,
            at: Position::default(),
        }
    }
}

impl From<&str> for Node {
    fn from(text: &str) -> Self {
        Value::String(text.to_owned()).into()
    }
}

impl From<bool> for Node {
    fn from(value: bool) -> Self {
        Value::Bool(value).into()
    }
}

impl From<i64> for Node {
    fn from(value: i64) -> Self {
        Value::Number(value.to_string()).into()
    }
}

/// Formats with as many digits as are needed to read back the same number, with a point or an exponent. JSON cannot represent
/// NaN and infinity: they become `null`, as in `DepthAI`'s files.
impl From<f64> for Node {
    fn from(value: f64) -> Self {
        if value.is_finite() {
            Value::Number(format!("{value:?}")).into()
        } else {
            Value::Null.into()
        }
    }
}

impl<T: Into<Self>> From<Vec<T>> for Node {
    fn from(values: Vec<T>) -> Self {
        Value::Array(values.into_iter().map(Into::into).collect()).into()
    }
}

impl<const N: usize> From<[(&str, Self); N]> for Node {
    fn from(entries: [(&str, Self); N]) -> Self {
        Value::Object(entries.into_iter().map(|(k, v)| (k.to_owned(), v)).collect()).into()
    }
}

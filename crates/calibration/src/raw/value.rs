use std::fmt;

/// A place in a text, counted from 1; columns count characters.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Position {
    /// Line.
    pub line: usize,
    /// Column.
    pub column: usize,
}

impl fmt::Display for Position {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}", self.line, self.column)
    }
}

/// A JSON value and where it began; what a program made has position 0:0.
#[derive(Clone, Debug, PartialEq)]
pub struct Node {
    /// The value.
    pub value: Value,
    /// Where its first character was.
    pub at: Position,
}

/// A JSON value that keeps the order of keys and the text of numbers.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// `null`.
    Null,
    /// `true` or `false`.
    Bool(bool),
    /// A number, as it was spelt.
    Number(String),
    /// A string, unescaped.
    String(String),
    /// An array.
    Array(Vec<Node>),
    /// An object in its order; a repeated key is kept, and the last one counts.
    Object(Vec<(String, Node)>),
}

impl Node {
    /// The value of a key: the last one's where it is repeated, as `DepthAI` reads it.
    #[must_use]
    pub fn get(&self, key: &str) -> Option<&Self> {
        match &self.value {
            Value::Object(entries) => entries.iter().rev().find(|(k, _)| k == key).map(|(_, node)| node),
            _ => None,
        }
    }

    /// Equal but for positions.
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
    /// What it is, in words: `a string`.
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

/// The shortest text that reads back as the same number, with a point or an exponent. JSON has no text for NaN and
/// infinity: they become `null`, as in `DepthAI`'s own files.
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

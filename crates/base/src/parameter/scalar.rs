use std::fmt;

use serde::{Deserialize, Serialize};

/// The value of a parameter. A text is read as the parameter's type, as on a command line; any value is, in the end, what its text says.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Scalar {
    /// `true` or `false`.
    Flag(bool),
    /// A whole number of at least 0.
    Whole(u64),
    /// A whole number.
    Integer(i64),
    /// A number.
    Number(f64),
    /// A text.
    Text(String),
}

impl Scalar {
    /// Returns the value whose [`Display`](fmt::Display) is exactly this text: `0.20` remains a text, `0.2` becomes a number.
    #[must_use]
    pub fn of(text: &str) -> Self {
        let parsed = [
            text.parse().ok().map(Self::Flag),
            text.parse().ok().map(Self::Whole),
            text.parse().ok().map(Self::Integer),
            // JSON has no infinity.
            text.parse()
                .ok()
                .filter(|number: &f64| number.is_finite())
                .map(Self::Number),
        ];
        let mut exact = parsed
            .into_iter()
            .flatten()
            .filter(|value| value.to_string() == text);
        exact.next().unwrap_or_else(|| Self::Text(text.to_owned()))
    }
}

macro_rules! from {
    ($($kind:ident($own:ty): $($other:ty),+;)+) => {$($(
        impl From<$other> for Scalar {
            fn from(value: $other) -> Self {
                Self::$kind(<$own>::from(value))
            }
        }
    )+)+};
}

from! {
    Flag(bool): bool;
    Whole(u64): u8, u16, u32, u64;
    Integer(i64): i8, i16, i32, i64;
    Number(f64): f32, f64;
    Text(String): &str, &String, String;
}

impl From<&Self> for Scalar {
    fn from(value: &Self) -> Self {
        value.clone()
    }
}

impl fmt::Display for Scalar {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Flag(value) => value.fmt(f),
            Self::Whole(value) => value.fmt(f),
            Self::Integer(value) => value.fmt(f),
            Self::Number(value) => value.fmt(f),
            Self::Text(value) => value.fmt(f),
        }
    }
}

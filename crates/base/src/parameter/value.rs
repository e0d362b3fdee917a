use std::fmt::Display;

use crate::parameter::{Choice, Kind};

/// The type of a parameter: how it is read from text, written and compared with its range.
pub trait Value: Sized {
    /// The kind of values.
    const KIND: Kind;

    /// Reads a value; `None` if the text is invalid.
    fn parse(text: &str) -> Option<Self>;

    /// The text that [`parse`](Self::parse) reads.
    fn text(&self) -> String;

    /// The numbers that the range of the parameter applies to.
    fn numbers(&self) -> Vec<f64> {
        Vec::new()
    }
}

/// Another representation of a field of type `T` as text.
pub trait FieldText<T> {
    /// The kind of values.
    const KIND: Kind;

    /// Reads a value into the field; `None`, and no change, if the text is invalid.
    fn set(field: &mut T, text: &str) -> Option<()>;

    /// The text that [`set`](Self::set) reads.
    fn get(field: &T) -> String;

    /// The numbers that the range of the parameter applies to.
    fn numbers(_field: &T) -> Vec<f64> {
        Vec::new()
    }
}

/// The representation of a type by its own [`Value`].
#[derive(Clone, Copy, Debug)]
pub struct Plain;

impl<T: Value> FieldText<T> for Plain {
    const KIND: Kind = T::KIND;

    fn set(field: &mut T, text: &str) -> Option<()> {
        *field = T::parse(text)?;
        Some(())
    }

    fn get(field: &T) -> String {
        field.text()
    }

    fn numbers(field: &T) -> Vec<f64> {
        field.numbers()
    }
}

/// A bit mask, written in hexadecimal and read in decimal too.
#[derive(Clone, Copy, Debug)]
pub struct Hexadecimal;

impl FieldText<u64> for Hexadecimal {
    const KIND: Kind = Kind::Text("a bit mask such as 0xA82415, or 0");

    fn set(field: &mut u64, text: &str) -> Option<()> {
        let digits = text.strip_prefix("0x").or_else(|| text.strip_prefix("0X"));
        *field = match digits {
            Some(digits) => u64::from_str_radix(digits, 16).ok()?,
            None => text.parse().ok()?,
        };
        Some(())
    }

    fn get(field: &u64) -> String {
        format!("{field:#X}")
    }
}

/// An enumeration that is written by name and read by name or by number, from 0.
#[derive(Clone, Copy, Debug)]
pub struct Numbered;

impl<C: Choice> FieldText<C> for Numbered {
    const KIND: Kind = Kind::Choice(C::NAMES);

    fn set(field: &mut C, text: &str) -> Option<()> {
        let numbered = || {
            text.parse::<usize>()
                .ok()
                .and_then(|n| C::VARIANTS.get(n).copied())
        };
        *field = numbered().or_else(|| C::find(text))?;
        Some(())
    }

    fn get(field: &C) -> String {
        Choice::text(*field).to_owned()
    }
}

fn display(value: impl Display) -> String {
    value.to_string()
}

macro_rules! numbers {
    ($kind:ident: $($number:ty),+) => {$(
        impl Value for $number {
            const KIND: Kind = Kind::$kind;

            fn parse(text: &str) -> Option<Self> {
                text.parse().ok()
            }

            fn text(&self) -> String {
                display(self)
            }

            fn numbers(&self) -> Vec<f64> {
                vec![f64::from(*self)]
            }
        }
    )+};
}
numbers!(Number: f32, f64);
numbers!(Integer: u8, i16, u16, i32, u32);

impl Value for bool {
    const KIND: Kind = Kind::Flag;

    fn parse(text: &str) -> Option<Self> {
        match text {
            "true" | "1" => Some(true),
            "false" | "0" => Some(false),
            _ => None,
        }
    }

    fn text(&self) -> String {
        display(self)
    }
}

impl Value for [f64; 2] {
    const KIND: Kind = Kind::Text("two numbers separated by a comma");

    fn parse(text: &str) -> Option<Self> {
        let (a, b) = text.split_once(',')?;
        Some([a.trim().parse().ok()?, b.trim().parse().ok()?])
    }

    fn text(&self) -> String {
        let [a, b] = self;
        format!("{a},{b}")
    }

    fn numbers(&self) -> Vec<f64> {
        self.to_vec()
    }
}

impl<C: Choice> Value for C {
    const KIND: Kind = Kind::Choice(C::NAMES);

    fn parse(text: &str) -> Option<Self> {
        C::find(text)
    }

    fn text(&self) -> String {
        Choice::text(*self).to_owned()
    }
}

//! TOML files with the lines of their keys, and readable versions of serde's errors.

use std::path::Path;

use oaktwin_base::diagnostic::nearest;
use serde::de::DeserializeOwned;
use toml::Spanned;
use toml::de::{DeTable, DeValue, Deserializer};

use crate::CatalogError;

/// A TOML file with the lines of its keys.
#[derive(Debug)]
pub struct Document<'a> {
    file: &'a Path,
    text: &'a str,
    table: Spanned<DeTable<'a>>,
}

impl<'a> Document<'a> {
    /// Parses a file; `subject` names its contents in errors (`a sensor or a device`).
    ///
    /// # Errors
    /// Returns an error if the file is empty, binary or not TOML.
    pub fn parse(file: &'a Path, text: &'a str, subject: &str) -> Result<Self, CatalogError> {
        let error = |line, problem: &str, remedy: &str| CatalogError::new(file, line, problem, remedy);
        if text.contains('\0') {
            return Err(error(
                None,
                "the file is binary",
                &format!("pass a TOML file of {subject}"),
            ));
        }
        if text.trim().is_empty() {
            return Err(error(
                None,
                "the file is empty",
                &format!("describe {subject} in it"),
            ));
        }
        match DeTable::parse(text) {
            Ok(table) => Ok(Self { file, text, table }),
            Err(cause) => {
                let line = cause.span().map(|span| line_at(text, span.start));
                let problem = format!("not TOML: {}", one_line(cause.message()));
                Err(error(line, &problem, "correct the syntax"))
            }
        }
    }

    /// Whether the file has a key at its top level.
    #[must_use]
    pub fn has(&self, key: &str) -> bool {
        self.table.get_ref().contains_key(key)
    }

    /// Rejects NaN and infinite numbers.
    ///
    /// # Errors
    /// Returns an error at the line of such a number.
    pub fn check_finite(&self) -> Result<(), CatalogError> {
        // The parser bounds the depth, and so this recursion.
        fn walk(value: &Spanned<DeValue<'_>>) -> Option<usize> {
            match value.get_ref() {
                DeValue::Float(number) => {
                    let finite = number.as_str().parse::<f64>().is_ok_and(f64::is_finite);
                    (!finite).then(|| value.span().start)
                }
                DeValue::Array(array) => array.iter().find_map(walk),
                DeValue::Table(table) => table.iter().find_map(|(_, value)| walk(value)),
                _ => None,
            }
        }
        match self.table.get_ref().iter().find_map(|(_, value)| walk(value)) {
            Some(offset) => Err(CatalogError::new(
                self.file,
                Some(line_at(self.text, offset)),
                "not a finite number",
                "set a finite number",
            )),
            None => Ok(()),
        }
    }

    /// Returns the contents.
    ///
    /// # Errors
    /// Returns an error at the line of an unknown key, or of a value of another type.
    pub fn deserialize<T: DeserializeOwned>(&self) -> Result<T, CatalogError> {
        self.check_finite()?;
        T::deserialize(Deserializer::from(self.table.clone())).map_err(|cause| {
            let line = cause.span().map(|span| line_at(self.text, span.start));
            let (problem, remedy) = explain(cause.message());
            CatalogError::new(self.file, line, problem, remedy)
        })
    }

    /// Creates an error at `place`, a path of keys and indices such as `camera.0.hfov_deg`.
    #[must_use]
    pub fn error(&self, place: &str, problem: impl Into<String>, remedy: impl Into<String>) -> CatalogError {
        CatalogError::new(self.file, self.line_of(place), problem, remedy)
    }

    /// Whether the file has a value at `place`.
    #[must_use]
    pub fn contains(&self, place: &str) -> bool {
        let mut segments = place.split('.');
        let first = segments.next().and_then(|key| self.table.get_ref().get(key));
        first.is_some_and(|value| {
            segments
                .try_fold(value, |value, segment| {
                    step(value.get_ref(), segment).map(|(_, v)| v)
                })
                .is_some()
        })
    }

    /// Returns the line of `place`, or of the last existing part of its path.
    fn line_of(&self, place: &str) -> Option<usize> {
        let mut segments = place.split('.');
        let (key, mut value) = self.table.get_ref().get_key_value(segments.next()?)?;
        let mut offset = key.span().start;
        for segment in segments {
            let Some((at, next)) = step(value.get_ref(), segment) else {
                break;
            };
            (offset, value) = (at, next);
        }
        Some(line_at(self.text, offset))
    }
}

/// Returns the value of `segment` in `value`, and the offset of its key, or in an array of the value itself.
fn step<'v, 'a>(value: &'v DeValue<'a>, segment: &str) -> Option<(usize, &'v Spanned<DeValue<'a>>)> {
    match value {
        DeValue::Table(table) => {
            let (key, value) = table.get_key_value(segment)?;
            Some((key.span().start, value))
        }
        DeValue::Array(array) => {
            let value = array.get(segment.parse::<usize>().ok()?)?;
            Some((value.span().start, value))
        }
        _ => None,
    }
}

/// Returns the line of an offset, from 1.
fn line_at(text: &str, offset: usize) -> usize {
    1 + text
        .as_bytes()
        .iter()
        .take(offset)
        .filter(|byte| **byte == b'\n')
        .count()
}

fn one_line(message: &str) -> String {
    message.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Converts serde's message to a problem and a remedy.
fn explain(message: &str) -> (String, String) {
    let names = quoted(message);
    let named = names.split_first();
    if let (true, Some((name, known))) = (message.starts_with("unknown field"), named) {
        (
            format!("unknown key '{}'", name.escape_debug()),
            remedy_for_key(name, known),
        )
    } else if let (true, Some((name, _))) = (message.starts_with("missing field"), named) {
        (
            format!("the key '{name}' is missing in the table that starts here"),
            format!("add '{name} = ...'"),
        )
    } else if let (true, Some((name, known))) = (message.starts_with("unknown variant"), named) {
        (
            format!("unknown value '{}'", name.escape_debug()),
            format!("use one of {}", list(known)),
        )
    } else {
        let message = one_line(message);
        let problem = match message.strip_prefix("invalid ") {
            Some(rest) => format!("wrong {rest}"),
            None => message,
        };
        (
            plain_types(&problem),
            "see the schema for the type of the key".to_owned(),
        )
    }
}

/// Replaces Rust's names of types by words.
fn plain_types(message: &str) -> String {
    let Some((found, expected)) = message.split_once(", expected ") else {
        return message.to_owned();
    };
    let expected = match expected {
        "f32" | "f64" => "a number",
        "u8" | "u16" | "u32" | "u64" | "u128" | "usize" => "a whole number, 0 or more",
        other if other.starts_with("a nonzero u") => "a whole number, 1 or more",
        "i8" | "i16" | "i32" | "i64" | "i128" | "isize" => "a whole number",
        "a sequence" => "a list in [brackets]",
        other => other.strip_prefix("struct ").map_or(other, |_| "a table"),
    };
    format!("{}, expected {expected}", short_number(found))
}

/// Writes a number with very many digits with an exponent.
fn short_number(found: &str) -> String {
    let value = quoted(found).first().map_or("", |value| *value);
    match value.parse::<f64>() {
        Ok(number) if value.len() > 24 => found.replace(value, &format!("{number:e}")),
        _ => found.to_owned(),
    }
}

/// Returns the parts of a message between backticks.
fn quoted(message: &str) -> Vec<&str> {
    message.split('`').skip(1).step_by(2).collect()
}

fn list(names: &[&str]) -> String {
    let quoted: Vec<String> = names.iter().map(|name| format!("'{name}'")).collect();
    quoted.join(", ")
}

/// The unit suffixes of keys, with the explanation if a key has another unit; `None` for units that no key has.
const UNITS: [(&str, Option<&str>); 14] = [
    ("deg", Some("angles are in degrees here")),
    ("mm", Some("this is in millimetres here")),
    ("m", Some("this is in metres here")),
    ("um", Some("this is in micrometres here")),
    ("nm", Some("this is in nanometres here")),
    ("px", Some("this is in pixels here")),
    ("g", Some("masses are in grams here")),
    ("percent", Some("this is in percent here")),
    ("rad", None),
    ("cm", None),
    ("in", None),
    ("inch", None),
    ("kg", None),
    ("degrees", None),
];

fn split_unit(key: &str) -> (&str, Option<&'static str>, bool) {
    for (unit, phrase) in UNITS {
        if let Some(base) = key.strip_suffix(unit).and_then(|base| base.strip_suffix('_')) {
            return (base, phrase, true);
        }
    }
    (key, None, false)
}

fn remedy_for_key(name: &str, known: &[&str]) -> String {
    let (base, ..) = split_unit(name);
    let same_quantity = known.iter().find_map(|key| {
        let (known_base, phrase, has_unit) = split_unit(key);
        (has_unit && known_base == base).then_some((*key, phrase))
    });
    if let Some((key, Some(phrase))) = same_quantity {
        return format!("{phrase}: use '{key}'");
    }
    match nearest(name, known.iter().copied()).first() {
        Some(key) => format!("did you mean '{key}'?"),
        None if known.is_empty() => "remove it".to_owned(),
        None => format!("expected one of {}", list(known)),
    }
}

//! A table with every kind of field.

use oaktwin_base::parameter::{
    Group, Hexadecimal, Kind, ParameterError, Platform, by_name, choice, parameters,
};
use serde::{Deserialize, Serialize};

choice! {
    /// A colour.
    Colour {
        /// Red.
        Red = "RED",
        /// Deep blue.
        DeepBlue = "DEEP_BLUE",
    }
}

/// Two numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pair {
    /// The lower one.
    pub low: u32,
    /// The higher one.
    pub high: u32,
}

parameters! {
    /// An example.
    pub struct Example("example", platform) {
        /// A length.
        length_px: f64 = 1.0 => ("length".unit("px").range(0.5..=10.0).estimate()),
        /// Two numbers.
        pair: Pair = Pair { low: 1, high: 2 } => {
            /// The lower one.
            .low: u32 => ("low".range(0.0..=10.0)),
            /// The higher one.
            .high: u32 => ("high"),
        },
        /// A mask.
        mask: u64 = 0 => ("mask" as Hexadecimal),
        /// A group.
        limits: Limits = Limits::default() => [
            /// Limits.
            struct Limits {
                /// An odd number.
                window: u32 = if true { 3 } else { 5 } => ("limits.window".range(1.0..=7.0).step(2.0)),
                /// A flag.
                strict: bool = false => ("limits.strict".alias("strict").on(Platform::Rvc4)),
            }
        ],
        /// A colour of two lines
        /// of text.
        colour: Colour = if platform == Platform::Rvc4 { Colour::DeepBlue } else { Colour::Red } => ("colour"),
    }
    also {
        /// The lower one again.
        .pair.low: u32 => ("again"),
    }
    check ordered
}

impl Example {
    fn ordered(&self) -> Result<(), ParameterError> {
        if self.pair.low > self.pair.high {
            return Err(ParameterError::new("low", "above high", "swap them"));
        }
        Ok(())
    }
}

#[test]
fn sets_and_gets_by_name() {
    let mut e = Example::defaults(Platform::Rvc4);
    let values = ["2.5", "4", "9", "0xA8", "5", "true", "RED", "4"];
    for (name, value) in Example::names().into_iter().zip(values) {
        e.set(name, value).unwrap();
        assert_eq!(e.get(name).unwrap(), value, "{name}");
    }
    assert_eq!((e.pair.low, e.limits.window, e.limits.strict), (4, 5, true));
    e.set("STRICT", "0").unwrap();
    e.set("colour", "deep-blue").unwrap();
    assert_eq!((e.limits.strict, e.colour), (false, Colour::DeepBlue));
    e.set("low", "10").unwrap();
    assert_eq!(e.check().unwrap_err().to_string(), "low: above high; swap them");
}

#[test]
fn errors_name_the_parameter_and_what_it_expects() {
    let mut e = Example::defaults(Platform::Rvc2);
    let before = e;
    let mut error = |name, value| e.set(name, value).unwrap_err().to_string();
    assert_eq!(
        error("length", "x"),
        "length: invalid value 'x'; expected a number from 0.5 to 10 px"
    );
    assert_eq!(
        error("length", "11"),
        "length: 11 is out of range; expected a number from 0.5 to 10 px"
    );
    assert_eq!(
        error("Length", "NaN"),
        "length: must not be NaN; expected a number from 0.5 to 10 px"
    );
    assert_eq!(
        error("strict", "maybe"),
        "limits.strict: invalid value 'maybe'; expected true or false"
    );
    assert_eq!(
        error("limits.window", "4"),
        "limits.window: invalid value '4'; expected 1, 3, 5 or 7"
    );
    assert_eq!(
        error("high", "-1"),
        "high: invalid value '-1'; expected a whole number"
    );
    assert_eq!(
        error("colour", "GREEN"),
        "colour: invalid value 'GREEN'; expected RED or DEEP_BLUE"
    );
    assert_eq!(
        error("lenght", "1"),
        "lenght: unknown parameter of example; did you mean 'length'?"
    );
    assert_eq!(e, before);
}

#[test]
fn lists_rows_with_defaults_of_the_platform() {
    let group = Group::new("example", "An example.", &[Group::list_of::<Example>]);
    let list = group.list(Platform::Rvc4);
    let names: Vec<&str> = list.iter().map(|row| row.about.name).collect();
    assert_eq!(names, Example::names());
    let colour = &list[6];
    assert_eq!(
        (colour.default.as_str(), colour.about.doc),
        ("DEEP_BLUE", "A colour of two lines of text.")
    );
    assert_eq!(colour.about.kind, Kind::Choice(&["RED", "DEEP_BLUE"]));
    assert_eq!(list[5].about.platform, Some(Platform::Rvc4));
    assert_eq!(group.list(Platform::Rvc2)[6].default, "RED");
}

/// An example in a file.
#[derive(Serialize, Deserialize)]
#[serde(transparent)]
struct File(#[serde(with = "by_name")] Example);

fn read(text: &str) -> Result<Example, String> {
    let file: Result<File, _> = serde_json::from_str(text);
    file.map(|file| file.0).map_err(|error| error.to_string())
}

#[test]
fn files_are_tables_from_names_to_values() {
    let text = r#"{"length":0.7,"low":2,"mask":"0xFF","limits.strict":true,"colour":"deep-blue"}"#;
    let example = read(text).unwrap();
    assert_eq!((example.length_px, example.pair.low, example.mask), (0.7, 2, 255));
    assert_eq!((example.limits.strict, example.colour), (true, Colour::DeepBlue));
    let written = serde_json::to_string(&File(example)).unwrap();
    assert_eq!(
        written,
        r#"{"length":0.7,"low":2,"high":2,"mask":"0xFF","limits.window":3,"limits.strict":true,"colour":"DEEP_BLUE","again":2}"#
    );
    assert_eq!(read(&written).unwrap(), example);
    assert_eq!(read("{}").unwrap(), Example::defaults(Platform::default()));
    assert_eq!(
        serde_json::from_str::<Colour>("\"deep_BLUE\"").unwrap(),
        Colour::DeepBlue
    );
}

#[test]
fn files_name_what_is_wrong() {
    for (text, expected) in [
        (
            r#"{"lenth":1}"#,
            "lenth: unknown parameter of example; did you mean 'length'?",
        ),
        (
            r#"{"length":-1}"#,
            "length: -1 is out of range; expected a number from 0.5 to 10 px",
        ),
        (
            r#"{"colour":"read"}"#,
            "colour: invalid value 'read'; expected RED or DEEP_BLUE",
        ),
        (r#"{"length":[1]}"#, "did not match any variant"),
        (r#"{"low":9,"high":1}"#, ""),
    ] {
        let error = read(text).unwrap_err();
        assert!(error.contains(expected), "{text}: {error}");
    }
    let error = serde_json::from_str::<Colour>("\"rad\"").unwrap_err().to_string();
    assert!(
        error.contains("invalid value 'rad'; did you mean 'RED'?"),
        "{error}"
    );
}

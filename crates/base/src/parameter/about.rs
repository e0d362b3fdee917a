use std::fmt;
use std::ops::RangeInclusive;

use serde::Serialize;

use crate::parameter::Platform;

/// The kind of values that a parameter takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// `true` or `false`.
    Flag,
    /// A whole number.
    Integer,
    /// A number.
    Number,
    /// One of these names.
    Choice(&'static [&'static str]),
    /// A text of this description.
    Text(&'static str),
}

impl Kind {
    /// The name of the kind: `boolean`, `integer`, `number`, `enum` or `string`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Flag => "boolean",
            Self::Integer => "integer",
            Self::Number => "number",
            Self::Choice(_) => "enum",
            Self::Text(_) => "string",
        }
    }
}

/// The source of a parameter's default.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DefaultSource {
    /// `DepthAI`'s default.
    DepthAi,
    /// NVIDIA's schema.
    Nvidia,
    /// The camera that the parameters are for.
    Camera,
    /// A choice or a fit of this project, as described here.
    Project(&'static str),
    /// An estimate: there is no public number.
    Estimate,
}

impl fmt::Display for DefaultSource {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::DepthAi => "DepthAI",
            Self::Nvidia => "NVIDIA",
            Self::Camera => "camera",
            Self::Project(source) => source,
            Self::Estimate => "estimate",
        })
    }
}

impl Serialize for DefaultSource {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

/// The static description of a parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct About {
    /// The name: `DepthAI`'s or NVIDIA's where there is one.
    pub name: &'static str,
    /// The path of the field in its struct.
    pub field: &'static str,
    /// Another name that is accepted too; empty if there is none.
    pub alias: &'static str,
    /// The kind of values.
    pub kind: Kind,
    /// The unit of the value and of its range; empty if it has none.
    pub unit: &'static str,
    /// The smallest number. [`f64::MIN_POSITIVE`] excludes 0.
    pub min: f64,
    /// The largest number. [`f64::MAX`] excludes infinity only.
    pub max: f64,
    /// The step from the smallest number to the next; 0 if every number in the range is valid.
    pub step: f64,
    /// The smallest and the largest number that devices or experiments usually have: front ends offer them first.
    pub typical: Option<(f64, f64)>,
    /// The platform without which the parameter has no effect.
    pub platform: Option<Platform>,
    /// The source of the default.
    pub source: DefaultSource,
    /// The place among the parameters that people change first, from 1; 0 of all others.
    pub common: u8,
    /// What the parameter does.
    pub doc: &'static str,
}

impl About {
    /// Returns the description of a parameter with `DepthAI`'s default and without a unit or a range.
    #[must_use]
    pub const fn new(name: &'static str) -> Self {
        Self {
            name,
            field: "",
            alias: "",
            kind: Kind::Flag,
            unit: "",
            min: f64::MIN,
            max: f64::MAX,
            step: 0.0,
            typical: None,
            platform: None,
            source: DefaultSource::DepthAi,
            common: 0,
            doc: "",
        }
    }

    /// The same with another accepted name.
    #[must_use]
    pub const fn alias(self, alias: &'static str) -> Self {
        Self { alias, ..self }
    }

    /// The same with a unit.
    #[must_use]
    pub const fn unit(self, unit: &'static str) -> Self {
        Self { unit, ..self }
    }

    /// The same with a range.
    #[must_use]
    pub const fn range(self, range: RangeInclusive<f64>) -> Self {
        let (min, max) = (*range.start(), *range.end());
        Self { min, max, ..self }
    }

    /// The same for numbers above 0.
    #[must_use]
    pub const fn positive(self) -> Self {
        self.range(f64::MIN_POSITIVE..=f64::MAX)
    }

    /// The same for every `step`th number of the range.
    #[must_use]
    pub const fn step(self, step: f64) -> Self {
        Self { step, ..self }
    }

    /// The same with the range that devices or experiments usually have.
    #[must_use]
    pub const fn typical(self, range: RangeInclusive<f64>) -> Self {
        Self {
            typical: Some((*range.start(), *range.end())),
            ..self
        }
    }

    /// The same for the parameter at a place among those that people change first, from 1. Front ends list these first.
    #[must_use]
    pub const fn common(self, common: u8) -> Self {
        Self { common, ..self }
    }

    /// The same for a parameter of one platform.
    #[must_use]
    pub const fn on(self, platform: Platform) -> Self {
        Self {
            platform: Some(platform),
            ..self
        }
    }

    /// The same with an estimated default.
    #[must_use]
    pub const fn estimate(self) -> Self {
        self.source(DefaultSource::Estimate)
    }

    /// The same with a default that the camera provides.
    #[must_use]
    pub const fn from_camera(self) -> Self {
        self.source(DefaultSource::Camera)
    }

    /// The same with a default whose source is described here.
    #[must_use]
    pub const fn chosen(self, source: &'static str) -> Self {
        self.source(DefaultSource::Project(source))
    }

    /// The same with another source of the default.
    #[must_use]
    pub const fn source(self, source: DefaultSource) -> Self {
        Self { source, ..self }
    }

    /// The same with its field, the kind of values and the documentation.
    #[must_use]
    pub const fn of(self, field: &'static str, kind: Kind, doc: &'static str) -> Self {
        let doc = doc.trim_ascii();
        Self {
            field,
            kind,
            doc,
            ..self
        }
    }

    /// The first sentence of the documentation, without its full stop.
    #[must_use]
    pub fn summary(&self) -> &'static str {
        let end = [". ", ": ", "; "]
            .iter()
            .filter_map(|mark| self.doc.find(mark))
            .min();
        end.map_or(self.doc.trim_end_matches('.'), |end| &self.doc[..end])
    }

    /// Whether the parameter accepts this number.
    #[must_use]
    pub fn accepts(&self, number: f64) -> bool {
        let is_on_step = || self.step == 0.0 || (number - self.min).rem_euclid(self.step) == 0.0;
        (self.min..=self.max).contains(&number) && is_on_step()
    }

    /// The range in words: `0 to 10 px`, `1, 3, 5 or 7`, `a number above 0`; `None` if any finite number is valid.
    #[must_use]
    pub fn range_text(&self) -> Option<String> {
        let (min, max, step) = (self.min, self.max, self.step);
        let range = match (min, max) {
            (f64::MIN, f64::MAX) => return None,
            (f64::MIN_POSITIVE, f64::MAX) => "above 0".to_owned(),
            (_, f64::MAX) => format!("{min} or more"),
            _ if step > 0.0 && (max - min) / step < 5.0 => {
                let numbers = std::iter::successors(Some(min), |n| Some(n + step));
                let mut numbers: Vec<String> =
                    numbers.take_while(|n| *n <= max).map(|n| n.to_string()).collect();
                let last = numbers.pop().unwrap_or_default();
                format!("{} or {last}", numbers.join(", "))
            }
            _ if step > 0.0 => format!("{min}, {}, … {max}", min + step),
            _ => format!("{min} to {max}"),
        };
        Some(format!("{range} {}", self.unit).trim_end().to_owned())
    }

    /// The valid values in words: `true or false`, `0 to 10 px`, `a number in mm`.
    #[must_use]
    pub fn values_text(&self) -> String {
        match (self.kind, self.range_text()) {
            (Kind::Integer | Kind::Number, Some(range)) => range,
            _ => self.expectation().trim_start_matches("expected ").to_owned(),
        }
    }

    /// What a valid value is, for an error: `expected a number from 0 to 10 px`.
    #[must_use]
    pub fn expectation(&self) -> String {
        let what = match self.kind {
            Kind::Flag => return "expected true or false".to_owned(),
            Kind::Choice([names @ .., last]) => return format!("expected {} or {last}", names.join(", ")),
            Kind::Choice([]) => return String::new(),
            Kind::Integer => "a whole number",
            Kind::Number => "a number",
            Kind::Text(what) => what,
        };
        let (min, max, unit) = (self.min, self.max, self.unit);
        let expected = match (min, max) {
            (f64::MIN, f64::MAX) if unit.is_empty() => format!("expected {what}"),
            (f64::MIN, f64::MAX) => format!("expected {what} in {unit}"),
            (f64::MIN_POSITIVE, f64::MAX) => format!("expected {what} above 0 {unit}"),
            (_, f64::MAX) => format!("expected {what} of at least {min} {unit}"),
            _ if self.step > 0.0 => format!("expected {}", self.range_text().unwrap_or_default()),
            _ => format!("expected {what} from {min} to {max} {unit}"),
        };
        expected.trim_end().to_owned()
    }
}

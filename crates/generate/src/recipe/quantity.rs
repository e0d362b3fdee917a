use std::fmt;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::value::MapAccessDeserializer;
use serde::de::{Error, MapAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize};

use crate::random::Numbers;

/// A number, or the distribution that it is drawn from.
#[derive(Clone, Debug, PartialEq)]
pub enum Quantity {
    /// Always this number.
    Constant(f64),
    /// Any number of a range with the same probability.
    Uniform([f64; 2]),
    /// A number whose logarithm is uniform.
    LogUniform([f64; 2]),
    /// A normal distribution, cut at three standard deviations.
    Normal {
        /// The mean.
        mean: f64,
        /// The standard deviation.
        deviation: f64,
    },
    /// One of these numbers.
    Choice(Vec<f64>),
}

impl Quantity {
    /// Draws a number.
    pub(crate) fn draw(&self, numbers: &mut Numbers) -> f64 {
        match self {
            Self::Constant(value) => *value,
            Self::Uniform([low, high]) => low + (high - low) * numbers.uniform(),
            Self::LogUniform([low, high]) => {
                let (low, high) = (libm::log(*low), libm::log(*high));
                libm::exp(low + (high - low) * numbers.uniform())
            }
            Self::Normal { mean, deviation } => mean + deviation * numbers.normal_within(3.0),
            Self::Choice(values) => numbers.pick(values).copied().unwrap_or_default(),
        }
    }

    /// Returns the smallest and the largest number that can be drawn.
    #[must_use]
    pub fn range(&self) -> [f64; 2] {
        match self {
            Self::Constant(value) => [*value; 2],
            Self::Uniform(range) | Self::LogUniform(range) => *range,
            Self::Normal { mean, deviation } => [mean - 3.0 * deviation, mean + 3.0 * deviation],
            Self::Choice(values) => values
                .iter()
                .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| {
                    [low.min(*value), high.max(*value)]
                }),
        }
    }
}

impl From<f64> for Quantity {
    fn from(value: f64) -> Self {
        Self::Constant(value)
    }
}

/// The TOML table of a distribution, which has exactly one of these keys.
#[derive(Default, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
struct Written {
    #[serde(skip_serializing_if = "Option::is_none")]
    uniform: Option<[f64; 2]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    log_uniform: Option<[f64; 2]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    normal: Option<[f64; 2]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    choice: Option<Vec<f64>>,
}

impl Written {
    fn quantity(self) -> Result<Quantity, &'static str> {
        let ordered = |[low, high]: [f64; 2]| low <= high;
        match self {
            Self {
                uniform: Some(range),
                log_uniform: None,
                normal: None,
                choice: None,
            } => ordered(range)
                .then_some(Quantity::Uniform(range))
                .ok_or("uniform: the first number is larger than the second"),
            Self {
                uniform: None,
                log_uniform: Some(range),
                normal: None,
                choice: None,
            } => (range[0] > 0.0 && ordered(range))
                .then_some(Quantity::LogUniform(range))
                .ok_or("log_uniform: expected two numbers above 0, the smaller one first"),
            Self {
                uniform: None,
                log_uniform: None,
                normal: Some([mean, deviation]),
                choice: None,
            } => (deviation >= 0.0)
                .then_some(Quantity::Normal { mean, deviation })
                .ok_or("normal: the second number, the standard deviation, is below 0"),
            Self {
                uniform: None,
                log_uniform: None,
                normal: None,
                choice: Some(values),
            } => (!values.is_empty())
                .then_some(Quantity::Choice(values))
                .ok_or("choice: the list is empty"),
            _ => Err("expected exactly one of uniform, log_uniform, normal and choice"),
        }
    }
}

impl<'de> Deserialize<'de> for Quantity {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Reader;
        impl<'de> Visitor<'de> for Reader {
            type Value = Quantity;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a number or a distribution such as { uniform = [0, 1] }")
            }

            #[expect(clippy::cast_precision_loss, reason = "numbers of a recipe are small")]
            fn visit_i64<E: Error>(self, value: i64) -> Result<Quantity, E> {
                Ok(Quantity::Constant(value as f64))
            }

            fn visit_f64<E: Error>(self, value: f64) -> Result<Quantity, E> {
                Ok(Quantity::Constant(value))
            }

            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Quantity, A::Error> {
                let written = Written::deserialize(MapAccessDeserializer::new(map))?;
                written.quantity().map_err(A::Error::custom)
            }
        }
        deserializer.deserialize_any(Reader)
    }
}

impl Serialize for Quantity {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut written = Written::default();
        match self {
            Self::Constant(value) => return serializer.serialize_f64(*value),
            Self::Uniform(range) => written.uniform = Some(*range),
            Self::LogUniform(range) => written.log_uniform = Some(*range),
            Self::Normal { mean, deviation } => written.normal = Some([*mean, *deviation]),
            Self::Choice(values) => written.choice = Some(values.clone()),
        }
        written.serialize(serializer)
    }
}

impl JsonSchema for Quantity {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Quantity".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let numbers = |count: Option<u32>| json_schema!({"type": "array", "items": {"type": "number"}, "minItems": count.unwrap_or(1), "maxItems": count.unwrap_or(u32::MAX)});
        let of = |name: &str, numbers: Schema, text: &str| {
            json_schema!({
                "type": "object", "description": text, "properties": {name: numbers}, "required": [name],
                "additionalProperties": false
            })
        };
        json_schema!({
            "description": "A number, or the distribution that it is drawn from.",
            "anyOf": [
                {"type": "number"},
                of("uniform", numbers(Some(2)), "Any number of a range with the same probability."),
                of("log_uniform", numbers(Some(2)), "A number whose logarithm is uniform; both ends above 0."),
                of("normal", numbers(Some(2)), "Mean and standard deviation; cut at three standard deviations."),
                of("choice", numbers(None), "One of these numbers."),
            ]
        })
    }
}

/// One text or a list of texts.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(transparent)]
pub struct Texts(pub Vec<String>);

impl<'de> Deserialize<'de> for Texts {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Reader;
        impl<'de> Visitor<'de> for Reader {
            type Value = Texts;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a text or a list of texts")
            }

            fn visit_str<E: Error>(self, value: &str) -> Result<Texts, E> {
                Ok(Texts(vec![value.to_owned()]))
            }

            fn visit_seq<A: serde::de::SeqAccess<'de>>(self, mut list: A) -> Result<Texts, A::Error> {
                let mut texts = Vec::new();
                while let Some(text) = list.next_element()? {
                    texts.push(text);
                }
                Ok(Texts(texts))
            }
        }
        deserializer.deserialize_any(Reader)
    }
}

impl JsonSchema for Texts {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Texts".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "One text or a list of texts.",
            "anyOf": [{"type": "string"}, {"type": "array", "items": {"type": "string"}}]
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;

    fn read(text: &str) -> Result<Quantity, String> {
        #[derive(Deserialize)]
        struct One {
            x: Quantity,
        }
        toml::from_str::<One>(&format!("x = {text}"))
            .map(|one| one.x)
            .map_err(|error| error.message().to_owned())
    }

    #[test]
    fn reads_numbers_and_distributions() {
        assert_eq!(read("3"), Ok(Quantity::Constant(3.0)));
        assert_eq!(read("0.5"), Ok(Quantity::Constant(0.5)));
        assert_eq!(read("{ uniform = [1, 2] }"), Ok(Quantity::Uniform([1.0, 2.0])));
        assert_eq!(
            read("{ choice = [1, 2.5] }"),
            Ok(Quantity::Choice(vec![1.0, 2.5]))
        );
        for (text, expected) in [
            ("{ uniform = [2, 1] }", "larger than the second"),
            ("{ log_uniform = [0, 1] }", "above 0"),
            ("{ normal = [0, -1] }", "standard deviation"),
            ("{ choice = [] }", "empty"),
            ("{}", "exactly one"),
            ("{ uniform = [0, 1], normal = [0, 1] }", "exactly one"),
            ("{ unifrom = [0, 1] }", "unknown field"),
            ("true", "a number or a distribution"),
        ] {
            let error = read(text).unwrap_err();
            assert!(error.contains(expected), "{text}: {error}");
        }
    }

    #[test]
    fn draws_have_the_stated_distribution() {
        let draws = |quantity: &Quantity| -> Vec<f64> {
            (0..20_000)
                .map(|frame| quantity.draw(&mut Random::new(5).numbers("x", frame)))
                .collect()
        };
        let mean = |values: &[f64]| values.iter().sum::<f64>() / 20_000.0;
        let uniform = draws(&Quantity::Uniform([2.0, 4.0]));
        assert!((mean(&uniform) - 3.0).abs() < 0.02);
        assert!(uniform.iter().all(|x| (2.0..4.0).contains(x)));
        let logarithms: Vec<f64> = draws(&Quantity::LogUniform([0.1, 10.0]))
            .iter()
            .map(|x| x.ln())
            .collect();
        assert!(mean(&logarithms).abs() < 0.04, "{}", mean(&logarithms));
        let normal = draws(&Quantity::Normal {
            mean: 1.0,
            deviation: 0.5,
        });
        let squares: Vec<f64> = normal.iter().map(|x| (x - 1.0).powi(2)).collect();
        // Cut at three standard deviations, the variance is 0.9733 of the whole one's.
        assert!((mean(&normal) - 1.0).abs() < 0.015 && (mean(&squares) - 0.2433).abs() < 0.01);
        assert!(normal.iter().all(|x| (x - 1.0).abs() <= 1.5));
        let chosen = draws(&Quantity::Choice(vec![1.0, 7.0]));
        assert!((mean(&chosen) - 4.0).abs() < 0.1);
    }
}

//! The options of a depth sensor in JSON and TOML: a table with the names of [`SENSOR_OPTIONS`].

use std::collections::BTreeMap;

use oaktwin_base::diagnostic::suggest;
use oaktwin_base::parameter::Scalar;
use serde::de::Error as _;
use serde::ser::Error as _;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::{OptionValue, SENSOR_OPTIONS, SensorOption, SensorOptions, assignment};

/// The key of [`SensorOptions::name`], which front ends derive and do not offer as an option.
const NAME: &str = "name";

/// The value of an option.
#[derive(Serialize, Deserialize)]
#[serde(untagged)]
enum Entry {
    One(Scalar),
    Several(Vec<Scalar>),
    ByName(BTreeMap<String, Scalar>),
}

impl Entry {
    /// The value of an option in effect; `None` if the option is not set.
    fn of(option: &SensorOption, options: &SensorOptions) -> Option<Self> {
        let texts = (option.get)(options);
        let first = texts.first()?;
        Some(match option.value {
            OptionValue::Assignments => {
                let all = texts.iter().filter_map(|text| assignment(text).ok());
                Self::ByName(
                    all.map(|(name, value)| (name.to_owned(), Scalar::of(value)))
                        .collect(),
                )
            }
            OptionValue::List(_) => Self::Several(texts.into_iter().map(Scalar::Text).collect()),
            OptionValue::Flag | OptionValue::Number => Self::One(Scalar::of(first)),
            _ => Self::One(Scalar::Text(first.clone())),
        })
    }

    /// The texts that set an option; `None` if the option has values of another form.
    fn texts(self, option: &SensorOption) -> Option<Vec<String>> {
        match (self, &option.value) {
            (Self::One(Scalar::Flag(false)), OptionValue::Flag) => Some(Vec::new()),
            (Self::One(value), OptionValue::Flag) => {
                (value == Scalar::Flag(true)).then(|| vec![value.to_string()])
            }
            (Self::Several(values), OptionValue::List(_)) => {
                Some(values.iter().map(Scalar::to_string).collect())
            }
            (Self::ByName(values), OptionValue::Assignments) => Some(
                values
                    .iter()
                    .map(|(name, value)| format!("{name}={value}"))
                    .collect(),
            ),
            (_, OptionValue::List(_) | OptionValue::Assignments) => None,
            (Self::One(value), _) => Some(vec![value.to_string()]),
            _ => None,
        }
    }
}

fn form(value: &OptionValue) -> &'static str {
    match value {
        OptionValue::Flag => "true or false",
        OptionValue::Number => "a whole number",
        OptionValue::List(_) => "a list of texts",
        OptionValue::Assignments => "a table from names to values",
        OptionValue::Text(..) | OptionValue::File | OptionValue::Choice(..) => "a text",
    }
}

impl Serialize for SensorOptions {
    /// Writes the options that are set; an engine is written by its name.
    ///
    /// # Errors
    /// Returns an error if the options are for images of another camera, which have no text.
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        if self.image.is_some() {
            return Err(S::Error::custom(
                "the sensor measures images of another camera, which no file describes",
            ));
        }
        let name = self
            .name
            .iter()
            .map(|name| (NAME, Entry::One(Scalar::Text(name.clone()))));
        let set = SENSOR_OPTIONS.iter();
        let set = set.filter_map(|option| Some((option.name, Entry::of(option, self)?)));
        serializer.collect_map(name.chain(set))
    }
}

impl<'de> Deserialize<'de> for SensorOptions {
    /// Reads the given options; the others have their defaults. Only the engines of this library have names that are known.
    ///
    /// # Errors
    /// Returns an error that names the option for an unknown name, with the nearest ones, and for an invalid value.
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let mut given = BTreeMap::<String, Entry>::deserialize(deserializer)?;
        let mut options = Self::default();
        match given.remove(NAME) {
            None => {}
            Some(Entry::One(Scalar::Text(name))) => options.name = Some(name),
            Some(_) => return Err(D::Error::custom("name: expected a text")),
        }
        // A file of parameters is an option of command lines: what it contains is written here.
        for option in SensorOption::without_files() {
            let Some(entry) = given.remove(option.name) else {
                continue;
            };
            let texts = entry.texts(option).ok_or_else(|| {
                D::Error::custom(format_args!("{}: expected {}", option.name, form(&option.value)))
            })?;
            for text in texts {
                (option.set)(&mut options, &text).map_err(D::Error::custom)?;
            }
        }
        let Some(unknown) = given.keys().next() else {
            return Ok(options);
        };
        let known = SENSOR_OPTIONS.iter().map(|option| option.name);
        let remedy = suggest(unknown, known);
        Err(D::Error::custom(format_args!(
            "unknown option '{unknown}'; {remedy}"
        )))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sensor::STEREO_NOISE;

    fn error(text: &str) -> String {
        serde_json::from_str::<SensorOptions>(text)
            .unwrap_err()
            .to_string()
    }

    #[test]
    fn reads_what_it_writes() {
        let text = r#"{"name":"Camera_left","engine":"stereo-noise","preset":"robotics","filters":["median:size=5","speckle"],
            "parameters":{"noiseSigma":0.2,"ambient":1,"lookup":"0xA8"},"extended_disparity":true,"isaac":"6",
            "seed":18446744073709551615,"device_seed":3,"drift":"yaw=0.3,baseline=50"}"#;
        let options: SensorOptions = serde_json::from_str(text).unwrap();
        assert_eq!(options.engine.as_ref().unwrap(), &STEREO_NOISE);
        assert_eq!((options.seed, options.device_seed), (u64::MAX, Some(3)));
        assert_eq!(options.drift.unwrap().yaw_mrad, 0.3);
        let parameters = [
            ("ambient", Scalar::Whole(1)),
            ("lookup", Scalar::from("0xA8")),
            ("noiseSigma", Scalar::Number(0.2)),
        ];
        assert_eq!(
            options.parameters,
            parameters.map(|(name, value)| (name.to_owned(), value))
        );
        let written = serde_json::to_string(&options).unwrap();
        assert_eq!(serde_json::from_str::<SensorOptions>(&written).unwrap(), options);
        // Every option, because options are written by their table.
        for option in SensorOption::without_files() {
            assert!(
                written.contains(&format!("\"{}\":", option.name)),
                "{}: {written}",
                option.name
            );
        }
        let none = SensorOptions::default();
        assert_eq!(serde_json::from_str::<SensorOptions>("{}").unwrap(), none);
    }

    #[test]
    fn names_what_is_wrong() {
        for (text, expected) in [
            (
                r#"{"engin":"stereo-noise"}"#,
                "unknown option 'engin'; did you mean 'engine'?",
            ),
            (
                r#"{"engine":"stereo-nose"}"#,
                "did you mean 'stereo-noise' or 'stereo-matching'?",
            ),
            (r#"{"seed":-1}"#, "seed: invalid value '-1'"),
            (r#"{"filters":"median"}"#, "filters: expected a list of texts"),
            (
                r#"{"parameters":["a=1"]}"#,
                "parameters: expected a table from names to values",
            ),
            (
                r#"{"extended_disparity":"yes"}"#,
                "extended_disparity: expected true or false",
            ),
            (r#"{"drift":"yaw=900"}"#, "yaw: 900 is out of range"),
            (r#"{"params":"fit.toml"}"#, "unknown option 'params'"),
        ] {
            let found = error(text);
            assert!(found.contains(expected), "{text}: {found}");
        }
    }
}

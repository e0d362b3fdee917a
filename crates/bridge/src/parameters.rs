//! The options of the sensor as parameters of the node, which `ros2 param set` changes while the bridge runs.

use oaktwin::diagnostic::{fold_name, suggest};
use oaktwin::sensor::{OptionValue, SENSOR_OPTIONS, SensorOption, SensorOptions};
use ros2_client::ParameterValue;

/// Absent numbers; numbers of ROS have a sign.
const NONE: i64 = -1;

/// Returns the options that are parameters of the node: all except files, which others on the network must not choose.
pub(crate) fn offered() -> impl Iterator<Item = &'static SensorOption> {
    let options = SENSOR_OPTIONS.iter();
    options.filter(|option| !matches!(option.value, OptionValue::File))
}

/// Returns the value of an option as a parameter: "" and -1 mean that it is not set.
pub(crate) fn value(option: &SensorOption, options: &SensorOptions) -> ParameterValue {
    let values = (option.get)(options);
    let first = values.first();
    match option.value {
        OptionValue::Flag => ParameterValue::Boolean(first.is_some()),
        OptionValue::Number => {
            ParameterValue::Integer(first.and_then(|text| text.parse().ok()).unwrap_or(NONE))
        }
        OptionValue::List(_) | OptionValue::Assignments => ParameterValue::StringArray(values),
        OptionValue::Text(..) | OptionValue::Choice(..) | OptionValue::File => {
            ParameterValue::String(first.cloned().unwrap_or_default())
        }
    }
}

/// Returns the options with another value of one of them; `None` if there is no such option.
///
/// # Errors
/// Returns an error if the value is invalid.
pub(crate) fn with(
    options: &SensorOptions,
    name: &str,
    value: &ParameterValue,
) -> Option<Result<SensorOptions, String>> {
    let changed = offered().find(|option| option.name == name)?;
    let texts = match value {
        ParameterValue::Boolean(flag) => flag.then(|| "true".to_owned()).into_iter().collect(),
        ParameterValue::Integer(NONE) => Vec::new(),
        ParameterValue::Integer(number) => vec![number.to_string()],
        ParameterValue::String(text) if text.is_empty() => Vec::new(),
        ParameterValue::String(text) => vec![text.clone()],
        // A list of nothing has no type on ROS's command line, but a list of an empty text has.
        ParameterValue::StringArray(texts) => texts.iter().filter(|text| !text.is_empty()).cloned().collect(),
        _ => {
            return Some(Err(format!(
                "{name}: the value has another type; list the types with `ros2 param describe`"
            )));
        }
    };
    let mut new = SensorOptions {
        image: options.image,
        name: options.name.clone(),
        ..SensorOptions::default()
    };
    for option in SENSOR_OPTIONS {
        let texts = if option.name == changed.name {
            texts.clone()
        } else {
            (option.get)(options)
        };
        for text in texts {
            if let Err(error) = (option.set)(&mut new, &text) {
                return Some(Err(error.to_string()));
            }
        }
    }
    Some(Ok(new))
}

/// Reads `NAME=VALUE`, with several values of a list separated by spaces.
///
/// # Errors
/// Returns an error if there is no such parameter, or the value has another type.
pub(crate) fn parse(line: &str) -> Result<(&'static str, ParameterValue), String> {
    let (name, text) = line.split_once('=').unwrap_or((line, ""));
    let (name, text) = (name.trim(), text.trim());
    let Some(option) = offered().find(|option| fold_name(option.name) == fold_name(name)) else {
        let names = offered().map(|option| option.name);
        return Err(format!("'{name}' is not a parameter; {}", suggest(name, names)));
    };
    let value = match option.value {
        OptionValue::Flag => text.parse().ok().map(ParameterValue::Boolean),
        OptionValue::Number if text.is_empty() => Some(ParameterValue::Integer(NONE)),
        OptionValue::Number => text.parse().ok().map(ParameterValue::Integer),
        OptionValue::List(_) | OptionValue::Assignments => {
            let texts = text.split_whitespace().map(str::to_owned);
            Some(ParameterValue::StringArray(texts.collect()))
        }
        OptionValue::Text(..) | OptionValue::Choice(..) | OptionValue::File => {
            Some(ParameterValue::String(text.to_owned()))
        }
    };
    let expected = match option.value {
        OptionValue::Flag => "true or false",
        _ => "a whole number",
    };
    let value =
        value.ok_or_else(|| format!("{}: invalid value '{text}'; expected {expected}", option.name))?;
    Ok((option.name, value))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn set(options: &SensorOptions, name: &str, value: &ParameterValue) -> Result<SensorOptions, String> {
        with(options, name, value).unwrap()
    }

    fn text(text: &str) -> ParameterValue {
        ParameterValue::String(text.to_owned())
    }

    #[test]
    fn values_round_trip() {
        let mut options = SensorOptions::default();
        let list = ParameterValue::StringArray(vec!["median:size=5".to_owned(), "speckle".to_owned()]);
        for (name, value) in [
            ("engine", text("single-view")),
            ("preset", text("robotics")),
            ("filters", list),
            (
                "parameters",
                ParameterValue::StringArray(vec!["noiseMean=0.5".to_owned()]),
            ),
            ("extended_disparity", ParameterValue::Boolean(true)),
            ("isaac", text("6")),
            ("seed", ParameterValue::Integer(7)),
            ("device_seed", ParameterValue::Integer(3)),
        ] {
            options = set(&options, name, &value).unwrap();
            let option = offered().find(|option| option.name == name).unwrap();
            assert_eq!(super::value(option, &options), value, "{name}");
        }
        assert_eq!((options.seed, options.device_seed), (7, Some(3)));
        assert_eq!(options.filters.len(), 2);
        for option in offered() {
            let default = value(option, &SensorOptions::default());
            options = set(&options, option.name, &default).unwrap();
        }
        assert_eq!(options, SensorOptions::default());
    }

    #[test]
    fn invalid_values_change_nothing() {
        let options = SensorOptions::default();
        assert!(
            set(&options, "engine", &text("stereo-nose"))
                .unwrap_err()
                .contains("stereo-noise")
        );
        assert!(
            set(&options, "seed", &ParameterValue::Double(1.0))
                .unwrap_err()
                .contains("type")
        );
        assert!(set(&options, "seed", &ParameterValue::Integer(-2)).is_err());
        assert!(with(&options, "params", &text("/etc/passwd")).is_none());
        assert!(with(&options, "use_sim_time", &ParameterValue::Boolean(true)).is_none());
    }

    #[test]
    fn lines_are_read() {
        assert_eq!(parse("preset = robotics"), Ok(("preset", text("robotics"))));
        assert_eq!(parse("preset="), Ok(("preset", text(""))));
        assert_eq!(
            parse("extended-disparity=true"),
            Ok(("extended_disparity", ParameterValue::Boolean(true)))
        );
        assert_eq!(
            parse("device_seed="),
            Ok(("device_seed", ParameterValue::Integer(-1)))
        );
        let filters = ParameterValue::StringArray(vec!["median:size=5".to_owned(), "speckle".to_owned()]);
        assert_eq!(parse("filters=median:size=5 speckle"), Ok(("filters", filters)));
        assert_eq!(
            parse("seed=x").unwrap_err(),
            "seed: invalid value 'x'; expected a whole number"
        );
        assert!(parse("presett=x").unwrap_err().contains("did you mean 'preset'"));
        assert!(parse("").is_err() && parse("params=/etc/passwd").is_err());
    }
}

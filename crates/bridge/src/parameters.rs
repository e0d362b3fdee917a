//! The options of the sensor as parameters of the node, which `ros2 param set` changes while the bridge runs.

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
}

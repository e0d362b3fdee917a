use std::path::Path;

use oaktwin_base::parameter::{Choice, Scalar, Table, choose};
use oaktwin_camera::StereoDrift;
use oaktwin_depth::engines::ENGINES;
use oaktwin_depth::filter;
use oaktwin_depth::preset::{Platform, Preset, TIME_OF_FLIGHT_PRESETS};
use oaktwin_depth::{EngineKind, ParameterError};
use oaktwin_usd::asset::IsaacVersion;

use super::{ParameterFile, SensorOptions};

/// An option of the depth sensor, as the command line and the Python package offer it.
#[derive(Debug)]
pub struct SensorOption {
    /// The name of the argument in Python: `device_seed`.
    pub name: &'static str,
    /// The name of the option on a command line: `device-seed`.
    pub flag: &'static str,
    /// The value.
    pub value: OptionValue,
    /// The help of the command line.
    pub help: &'static str,
    /// More lines of help: the valid names.
    pub names: Option<fn() -> String>,
    /// The documentation of the argument in Python.
    pub doc: &'static str,
    /// Whether the matcher of existing image pairs has the option too.
    pub is_of_matcher: bool,
    /// Sets the option; each value of a list is added to it.
    pub set: fn(&mut SensorOptions, &str) -> Result<(), ParameterError>,
    /// The values in effect, as [`SensorOption::set`] takes them; none if the option is not set.
    pub get: fn(&SensorOptions) -> Vec<String>,
}

impl SensorOption {
    /// The options whose values are values and not files, as libraries and files of options offer them.
    pub fn without_files() -> impl Iterator<Item = &'static Self> {
        let is_file = |option: &&Self| matches!(option.value, OptionValue::File);
        SENSOR_OPTIONS.iter().filter(move |option| !is_file(option))
    }
}

/// The type of an option's value.
#[derive(Debug)]
pub enum OptionValue {
    /// `true`, or absent.
    Flag,
    /// A whole number.
    Number,
    /// A text with its name in help, and the valid texts, none if they are not listed; letter case, hyphens and underscores are ignored.
    Text(&'static str, fn() -> Vec<&'static str>),
    /// The path of a file, on a command line only.
    File,
    /// One of the names of an enumeration, with its name in help; each name with a description.
    Choice(&'static str, fn() -> Vec<(&'static str, &'static str)>),
    /// A list of texts with the name of one in help.
    List(&'static str),
    /// A list of `NAME=VALUE`.
    Assignments,
}

/// The options of the depth sensor. Front ends offer all of them and set them in this order.
pub static SENSOR_OPTIONS: &[SensorOption] = &[
    SensorOption {
        name: "engine",
        flag: "engine",
        value: OptionValue::Choice("ENGINE", || {
            ENGINES.iter().map(|kind| (&*kind.name, &*kind.help)).collect()
        }),
        help: "The error model [default: stereo-noise, or time-of-flight for a time-of-flight sensor]",
        names: None,
        doc: "the error model: \"stereo-noise\" (an OAK's stereo; the default for stereo), \"time-of-flight\" (the default for time \
              of flight), \"single-view\" (Isaac Sim's DepthSensorDistance), \"stereo-matching\", which matches pairs of images in \
              `shoot`, `accuracy` and `coverage`, or an engine of one's own: a callable with the parameters `left` and `right` (the \
              rectified pair) or `depth`; see the manual.",
        is_of_matcher: false,
        set: |options, name| EngineKind::parse(name).map(|kind| options.engine = Some(kind.into())),
        get: |options| texts(options.engine.as_ref()),
    },
    SensorOption {
        name: "preset",
        flag: "preset",
        value: OptionValue::Text("PRESET", preset_names),
        help: "Use a DepthAI preset of the device's platform, which sets the mode and the filters",
        names: Some(presets),
        doc: "the name of a DepthAI preset of the platform: \"default\", \"face\", \"robotics\", ...: sets the mode and the \
              filters.",
        is_of_matcher: true,
        set: |options, name| {
            options.preset = Some(name.to_owned());
            Ok(())
        },
        get: |options| texts(options.preset.as_deref()),
    },
    SensorOption {
        name: "filters",
        flag: "filter",
        value: OptionValue::List("FILTER"),
        help: "Apply a filter, NAME or NAME:KEY=VALUE,…, instead of the preset's; repeatable, in order",
        names: Some(|| format!("Filters: {}", filter::NAMES.join(", "))),
        doc: "the filters as text, in order, such as \"spatial:alpha=0.5,delta=20\"; they replace the preset's filters.",
        is_of_matcher: true,
        set: |options, text| {
            options.filters.push(text.to_owned());
            Ok(())
        },
        get: |options| options.filters.clone(),
    },
    SensorOption {
        name: "params",
        flag: "params",
        value: OptionValue::File,
        help: "Read the engine's parameters from a TOML file of `oaktwin fit`; --param overrides it",
        names: None,
        // Python's `parameters` takes the path.
        doc: "",
        is_of_matcher: false,
        set: |options, path| {
            let file = ParameterFile::read(Path::new(path)).map_err(|error| {
                ParameterError::new(path, error.message.to_string(), error.remedy.to_string())
            })?;
            file.apply(options).map_err(|error| {
                ParameterError::new(path, format!("{}: {}", error.name, error.what), error.remedy)
            })
        },
        get: |_| Vec::new(),
    },
    SensorOption {
        name: "parameters",
        flag: "param",
        value: OptionValue::Assignments,
        help: "Set a parameter of the engine, listed by `oaktwin params ENGINE`; repeatable",
        names: None,
        doc: "the parameters of the engine, which override all other settings: a mapping by name, as listed by \
              `oaktwin.parameters(engine)`, a `Fit`, or the path of a TOML file that `Fit.save` or `oaktwin fit` has written.",
        is_of_matcher: true,
        set: |options, text| {
            let (name, value) = assignment(text)?;
            options.parameters.push((name.to_owned(), Scalar::of(value)));
            Ok(())
        },
        get: |options| {
            let all = options.parameters.iter();
            all.map(|(name, value)| format!("{name}={value}")).collect()
        },
    },
    SensorOption {
        name: "extended_disparity",
        flag: "extended-disparity",
        value: OptionValue::Flag,
        help: "Search disparities up to 190 px instead of 95, for closer objects",
        names: None,
        doc: "whether to search disparities up to 190 px instead of 95, for closer objects.",
        is_of_matcher: true,
        set: |options, _| {
            options.extended_disparity = true;
            Ok(())
        },
        get: |options| texts(options.extended_disparity.then_some(true)),
    },
    SensorOption {
        name: "isaac",
        flag: "isaac",
        value: OptionValue::Choice("VERSION", names::<IsaacVersion>),
        help: "Use single-view's defaults of this Isaac Sim version [default: 5.1]",
        names: None,
        doc: "the Isaac Sim version that determines the defaults of \"single-view\", \"5.1\" or \"6\".",
        is_of_matcher: false,
        set: |options, name| {
            options.isaac = Some(choose("isaac", name)?);
            Ok(())
        },
        get: |options| texts(options.isaac),
    },
    SensorOption {
        name: "seed",
        flag: "seed",
        value: OptionValue::Number,
        help: "The noise seed [default: 0]",
        names: None,
        doc: "the noise seed: equal seeds, names, frames and items give equal noise. None draws one of fresh entropy.",
        is_of_matcher: false,
        set: |options, text| number("seed", text).map(|seed| options.seed = seed),
        get: |options| texts(Some(options.seed)),
    },
    SensorOption {
        name: "device_seed",
        flag: "device-seed",
        value: OptionValue::Number,
        help: "The seed of an individual unit's calibration error [default: a unit without error]",
        names: None,
        doc: "the seed of the unit's calibration error; None disables it.",
        is_of_matcher: false,
        set: |options, text| number("device_seed", text).map(|seed| options.device_seed = Some(seed)),
        get: |options| texts(options.device_seed),
    },
    SensorOption {
        name: "drift",
        flag: "drift",
        value: OptionValue::Text("NAME=VALUE,…", Vec::new),
        help: "Change the stereo pair after its calibration, such as by yaw=0.3,pitch=0.2",
        names: Some(drift_names),
        doc: "the change of the stereo pair since its calibration, such as {\"yaw\": 0.3, \"baseline\": 50}: rotations of the right camera \
              in mrad (yaw, pitch, roll), the growth of the baseline in µm, of the focal length in ppm, or the warming in K \
              (temperature). \"stereo-noise\" computes the resulting depth errors and lost pixels.",
        is_of_matcher: false,
        set: |options, text| StereoDrift::parse(text).map(|drift| options.drift = Some(drift)),
        get: |options| texts(options.drift.map(|drift| drift.to_text())),
    },
];

fn names<C: Choice>() -> Vec<(&'static str, &'static str)> {
    let all = C::NAMES.iter().zip(C::ABOUT);
    all.map(|(name, about)| (*name, *about)).collect()
}

/// Splits `NAME=VALUE`.
///
/// # Errors
/// Returns an error if the text has another form.
pub fn assignment(text: &str) -> Result<(&str, &str), ParameterError> {
    let (name, value) = text.split_once('=').unwrap_or_default();
    match (name.trim(), value.trim()) {
        ("", _) | (_, "") => {
            let what = format!("invalid assignment '{text}'");
            Err(ParameterError::new(
                "parameters",
                what,
                "write NAME=VALUE, as in noiseSigma=0.2",
            ))
        }
        assignment => Ok(assignment),
    }
}

fn texts(value: Option<impl ToString>) -> Vec<String> {
    value.into_iter().map(|value| value.to_string()).collect()
}

fn number(name: &'static str, text: &str) -> Result<u64, ParameterError> {
    text.parse().map_err(|_| {
        let what = format!("invalid value '{text}'");
        ParameterError::new(
            name,
            what,
            format!("expected a whole number from 0 to {}", u64::MAX),
        )
    })
}

fn drift_names() -> String {
    let names = StereoDrift::rows().map(|row| format!("{} ({})", row.about.name, row.about.unit));
    format!("Names: {}", names.collect::<Vec<_>>().join(", "))
}

fn preset_names() -> Vec<&'static str> {
    let mut names: Vec<&str> = Preset::ALL.iter().map(|preset| preset.name()).collect();
    names.extend(TIME_OF_FLIGHT_PRESETS);
    names.sort_unstable();
    names.dedup();
    names
}

fn presets() -> String {
    let stereo =
        |platform: Platform| format!("{}: {}", platform.title(), Preset::names_on(platform).join(", "));
    format!(
        "{}\n{}\nTime of flight: {}",
        stereo(Platform::Rvc2),
        stereo(Platform::Rvc4),
        TIME_OF_FLIGHT_PRESETS.join(", ")
    )
}

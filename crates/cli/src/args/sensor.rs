use std::path::Path;

use clap::builder::PossibleValuesParser;
use clap::parser::ValueSource;
use clap::{Arg, ArgAction, ArgMatches, Args, Command, Error, FromArgMatches, ValueHint, value_parser};
use oaktwin::sensor::{OptionValue, SENSOR_OPTIONS, SensorOption, SensorOptions, assignment};

use super::choice::possible;
use crate::context::Result;

/// The options of the depth sensor, from [`SENSOR_OPTIONS`].
#[derive(Clone, Debug, Default)]
pub(crate) struct SensorArgs(GivenOptions);

/// The options that also apply to matching image pairs.
#[derive(Clone, Debug, Default)]
pub(crate) struct MatcherArgs(GivenOptions);

/// The options on the command line with their values, in order.
#[derive(Clone, Debug, Default)]
struct GivenOptions(Vec<(&'static SensorOption, Vec<String>)>);

impl SensorArgs {
    /// The first option that was given, with hyphens.
    pub(crate) fn given(&self) -> Option<String> {
        let (option, _) = self.0.0.first()?;
        Some(format!("--{}", option.flag))
    }

    /// The first option but the noise seed that was given, with hyphens.
    pub(crate) fn given_but_seed(&self) -> Option<String> {
        let mut options = self.0.0.iter().map(|(option, _)| option);
        let option = options.find(|option| option.name != "seed")?;
        Some(format!("--{}", option.flag))
    }

    /// The files that options name.
    pub(crate) fn files(&self) -> impl Iterator<Item = &Path> {
        let files = self
            .0
            .0
            .iter()
            .filter(|(option, _)| matches!(option.value, OptionValue::File));
        files.flat_map(|(_, paths)| paths.iter().map(Path::new))
    }

    /// The options without the intrinsics of the images, which come later.
    pub(crate) fn options(&self) -> Result<SensorOptions> {
        self.0.options()
    }
}

impl MatcherArgs {
    pub(crate) fn options(&self) -> Result<SensorOptions> {
        self.0.options()
    }
}

impl GivenOptions {
    fn read(matches: &ArgMatches, is_offered: impl Fn(&SensorOption) -> bool) -> Self {
        let mut given = Vec::new();
        for option in SENSOR_OPTIONS.iter().filter(|option| is_offered(option)) {
            if matches.value_source(option.name) != Some(ValueSource::CommandLine) {
                continue;
            }
            let values = match option.value {
                OptionValue::Flag => vec!["true".to_owned()],
                OptionValue::Number => {
                    let number = matches.get_one::<u64>(option.name);
                    number.map(ToString::to_string).into_iter().collect()
                }
                _ => matches
                    .get_many(option.name)
                    .into_iter()
                    .flatten()
                    .cloned()
                    .collect(),
            };
            given.push((option, values));
        }
        Self(given)
    }

    fn options(&self) -> Result<SensorOptions> {
        let mut options = SensorOptions::default();
        for (option, values) in &self.0 {
            for value in values {
                (option.set)(&mut options, value)?;
            }
        }
        Ok(options)
    }
}

/// Returns the argument of an option.
fn argument(option: &SensorOption) -> Arg {
    let arg = Arg::new(option.name)
        .long(option.flag)
        .help(option.help)
        .help_heading("Depth sensor");
    let arg = match option.names {
        Some(names) => arg.long_help(format!("{}\n{}", option.help, names())),
        None => arg,
    };
    match option.value {
        OptionValue::Flag => arg.action(ArgAction::SetTrue),
        OptionValue::Number => arg.value_name("N").value_parser(value_parser!(u64)),
        OptionValue::Text(name, _) => arg.value_name(name),
        OptionValue::File => arg.value_name("FILE").value_hint(ValueHint::FilePath),
        OptionValue::Choice(name, names) => {
            let values = names().into_iter().map(|(name, about)| possible(name, about));
            arg.value_name(name)
                .value_parser(PossibleValuesParser::new(values))
        }
        OptionValue::List(name) => arg.value_name(name).action(ArgAction::Append),
        OptionValue::Assignments => arg
            .value_name("NAME=VALUE")
            .value_parser(assigned)
            .action(ArgAction::Append),
    }
}

/// Checks that a text has the form `NAME=VALUE`.
fn assigned(text: &str) -> std::result::Result<String, String> {
    match assignment(text) {
        Ok(_) => Ok(text.to_owned()),
        Err(error) => Err(error.remedy),
    }
}

macro_rules! flattened {
    ($($Type:ident: $is_offered:expr;)+) => {$(
        impl Args for $Type {
            fn augment_args(command: Command) -> Command {
                command.args(SENSOR_OPTIONS.iter().filter(|option| $is_offered(option)).map(argument))
            }

            fn augment_args_for_update(command: Command) -> Command {
                Self::augment_args(command)
            }
        }

        impl FromArgMatches for $Type {
            fn from_arg_matches(matches: &ArgMatches) -> std::result::Result<Self, Error> {
                Ok(Self(GivenOptions::read(matches, $is_offered)))
            }

            fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> std::result::Result<(), Error> {
                *self = Self::from_arg_matches(matches)?;
                Ok(())
            }
        }
    )+};
}

flattened! {
    SensorArgs: |_: &SensorOption| true;
    MatcherArgs: |option: &SensorOption| option.is_of_matcher;
}

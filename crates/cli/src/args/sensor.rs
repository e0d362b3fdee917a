use std::path::PathBuf;

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Args, ValueHint};
use oaktwin::depth::filter;
use oaktwin::depth::preset::{Platform, Preset, TIME_OF_FLIGHT_PRESETS};
use oaktwin::sensor::{ENGINES, EngineKind, ParameterFile, SensorOptions};

use super::Isaac;
use crate::context::Result;

/// Which model of the depth sensor's errors, and how it is set.
#[derive(Args, Debug)]
#[command(next_help_heading = "The depth sensor")]
pub(crate) struct SensorArgs {
    /// The model of the errors; by default stereo-noise, or time-of-flight
    #[arg(long, value_parser = engine_parser())]
    pub(crate) engine: Option<&'static EngineKind>,

    #[command(flatten)]
    pub(crate) settings: SettingsArgs,

    /// Parameters of the engine from a TOML file, as `oaktwin fit` writes it; --param counts more
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub(crate) params: Option<PathBuf>,

    /// The Isaac Sim whose defaults single-view has; by default 5.1
    #[arg(long, value_enum)]
    pub(crate) isaac: Option<Isaac>,

    /// The seed of the noise
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub(crate) seed: u64,

    /// Be one device of many: the seed of its calibration's error. By default it has none
    #[arg(long, value_name = "N")]
    pub(crate) device_seed: Option<u64>,
}

/// How an engine is set.
#[derive(Args, Debug)]
#[command(next_help_heading = "The depth sensor")]
pub(crate) struct SettingsArgs {
    /// A preset of DepthAI for the model's platform (default, face, robotics, …): the mode and the filters
    #[arg(long, value_name = "PRESET", long_help = preset_help())]
    pub(crate) preset: Option<String>,

    /// A filter, with settings as NAME:KEY=VALUE,…; repeatable, in order, instead of the preset's
    #[arg(long = "filter", value_name = "FILTER", long_help = filter_help())]
    pub(crate) filters: Vec<String>,

    /// Set a parameter of the engine, listed by `oaktwin params ENGINE`; repeatable
    #[arg(long = "param", value_name = "NAME=VALUE", value_parser = assignment)]
    pub(crate) parameters: Vec<(String, String)>,

    /// Find disparities up to 190 px instead of 95: nearer things, the same step
    #[arg(long)]
    pub(crate) extended_disparity: bool,
}

impl SensorArgs {
    /// The first option that was given.
    pub(crate) fn given(&self) -> Option<&'static str> {
        let settings = &self.settings;
        [
            (self.engine.is_some(), "--engine"),
            (settings.preset.is_some(), "--preset"),
            (!settings.filters.is_empty(), "--filter"),
            (!settings.parameters.is_empty(), "--param"),
            (settings.extended_disparity, "--extended-disparity"),
            (self.params.is_some(), "--params"),
            (self.isaac.is_some(), "--isaac"),
            (self.seed != 0, "--seed"),
            (self.device_seed.is_some(), "--device-seed"),
        ]
        .into_iter()
        .find_map(|(is_given, name)| is_given.then_some(name))
    }

    /// As typed, and what the file of parameters says; the intrinsics of the images come later.
    pub(crate) fn options(&self) -> Result<SensorOptions> {
        let mut options = SensorOptions {
            engine: self.engine,
            isaac: self.isaac.map(Into::into).unwrap_or_default(),
            seed: self.seed,
            device_seed: self.device_seed,
            ..self.settings.options()
        };
        if let Some(path) = &self.params {
            let applied = ParameterFile::read(path)?.apply(&mut options);
            applied.map_err(|error| format!("{}: {error}", path.display()))?;
        }
        Ok(options)
    }
}

impl SettingsArgs {
    /// As typed; the rest as by default.
    pub(crate) fn options(&self) -> SensorOptions {
        SensorOptions {
            preset: self.preset.clone(),
            filters: self.filters.clone(),
            parameters: self.parameters.clone(),
            extended_disparity: self.extended_disparity,
            ..SensorOptions::default()
        }
    }
}

/// The engines of the registry, with their help.
fn engine_parser() -> impl TypedValueParser<Value = &'static EngineKind> {
    let values = ENGINES.map(|kind| PossibleValue::new(kind.name).help(kind.help));
    PossibleValuesParser::new(values).try_map(|name| EngineKind::parse(&name))
}

fn preset_help() -> String {
    let stereo =
        |platform: Platform| format!("{}: {}", platform.name(), Preset::names_on(platform).join(", "));
    format!(
        "A preset of DepthAI for the model's platform: the mode and the filters.\n{}.\n{}.\nTime of flight: {}",
        stereo(Platform::Rvc2),
        stereo(Platform::Rvc4),
        TIME_OF_FLIGHT_PRESETS.join(", ")
    )
}

fn filter_help() -> String {
    format!(
        "A filter, with settings as NAME:KEY=VALUE,…; repeatable, in order, instead of the preset's: {}",
        filter::NAMES.join(", ")
    )
}

/// `NAME=VALUE`
pub(super) fn assignment(text: &str) -> std::result::Result<(String, String), String> {
    match text.split_once('=') {
        Some((name, value)) if !name.trim().is_empty() && !value.trim().is_empty() => {
            Ok((name.trim().to_owned(), value.trim().to_owned()))
        }
        _ => Err("write NAME=VALUE, as noiseSigma=0.2".to_owned()),
    }
}

//! What options make of an engine: preset, filters and parameters by name.

use oaktwin_depth::filter::{self, Chain, Filter};
use oaktwin_depth::preset::{Platform, PresetError, StereoConfig, TimeOfFlightConfig};
use oaktwin_depth::single_view::{self, Assumptions};
use oaktwin_depth::{ParameterError, stereo_matching, stereo_noise, time_of_flight};

use super::{EngineKind, SensorOptions};
use oaktwin_catalog::{DepthKind, Twin};
use oaktwin_diagnostic::{Finding, Level, fold_name, nearest};

/// What a preset is.
pub(super) enum Preset {
    Stereo(Box<StereoConfig>),
    TimeOfFlight(TimeOfFlightConfig),
}

impl Preset {
    /// The one that the options name.
    pub(super) fn of(
        twin: &Twin,
        kind: DepthKind,
        options: &SensorOptions,
    ) -> Result<Option<Self>, ParameterError> {
        let Some(name) = &options.preset else {
            return Ok(None);
        };
        let preset = match kind {
            DepthKind::Stereo => return Self::of_stereo(platform(twin)?, name).map(Some),
            DepthKind::Tof => TimeOfFlightConfig::preset(name).map(Self::TimeOfFlight),
        };
        preset.map(Some).map_err(unknown)
    }

    /// Of a platform's stereo.
    pub(super) fn of_stereo(platform: Platform, name: &str) -> Result<Self, ParameterError> {
        let config = StereoConfig::preset(platform, name).map_err(unknown)?;
        Ok(Self::Stereo(Box::new(config)))
    }

    fn filters(&self) -> Vec<Filter> {
        match self {
            Self::Stereo(config) => config.filters(),
            Self::TimeOfFlight(config) => config.filters.clone(),
        }
    }

    /// What it changes, for people.
    pub(super) fn finding(&self, options: &SensorOptions, engine: EngineKind, prim: &str) -> Finding {
        let mut changes = Vec::new();
        if let (Self::Stereo(config), EngineKind::StereoNoise | EngineKind::StereoMatching) = (self, engine) {
            changes.push(format!("{} subpixel bits", config.subpixel.bits()));
            if config.disparity_shift_px > 0 {
                changes.push(format!("disparities from {} px", config.disparity_shift_px));
            }
        }
        if let Self::Stereo(config) = self {
            changes.push(format!(
                "{} disparity",
                if config.extended_disparity || options.extended_disparity {
                    "extended"
                } else {
                    "standard"
                }
            ));
        }
        if let (Self::TimeOfFlight(config), EngineKind::TimeOfFlight) = (self, engine) {
            let apart = config.phase_unwrap_error_threshold;
            changes.push(format!("frequencies that differ by up to {apart} mm"));
            changes.push(format!("a confidence of {}", config.confidence_threshold));
        }
        let filters = self.filters();
        let names: Vec<&str> = filters.iter().map(Filter::name).collect();
        changes.push(match (&names[..], &options.filters[..]) {
            (_, [_, ..]) => "the filters that are named instead of its own".to_owned(),
            ([], _) => "no filters".to_owned(),
            (names, _) => format!("the filters {}", names.join(", ")),
        });
        let preset = options.preset.as_deref().unwrap_or_default();
        let message = format!("preset {}: {}", preset.to_uppercase(), changes.join(", "));
        Finding::new("preset", Level::Note, prim, message, "")
    }
}

fn unknown(error: PresetError) -> ParameterError {
    ParameterError {
        name: "preset".to_owned(),
        what: error.what,
        remedy: error.remedy,
    }
}

/// The processor of a device.
pub(super) fn platform(twin: &Twin) -> Result<Platform, ParameterError> {
    let generation = &twin.device.generation;
    [Platform::Rvc2, Platform::Rvc4]
        .into_iter()
        .find(|platform| fold_name(platform.name()) == fold_name(generation))
        .ok_or_else(|| ParameterError {
            name: "preset".to_owned(),
            what: format!(
                "{} is of {generation}, which has no presets here",
                twin.device.name
            ),
            remedy: "name its filters one by one".to_owned(),
        })
}

/// The named filters, or the preset's.
pub(super) fn chain(options: &SensorOptions, preset: Option<&Preset>) -> Result<Chain, ParameterError> {
    if options.filters.is_empty() {
        return Ok(Chain::new(preset.map(Preset::filters).unwrap_or_default()));
    }
    let filters = options.filters.iter().map(|text| filter::parse(text));
    Ok(Chain::new(filters.collect::<Result<_, _>>()?))
}

/// Sets what is named, of an engine with these two kinds of parameters.
pub(super) fn set_single_view(
    parameters: &mut single_view::Parameters,
    assumptions: &mut Assumptions,
    options: &SensorOptions,
) -> Result<(), ParameterError> {
    for (given, value) in &options.parameters {
        let name = resolve(given, EngineKind::SingleView)?;
        if Assumptions::names().contains(&name) {
            assumptions.set(name, value)?;
        } else {
            parameters.set(name, value)?;
        }
    }
    Ok(())
}

pub(super) fn set_stereo_noise(
    parameters: &mut stereo_noise::Parameters,
    options: &SensorOptions,
) -> Result<(), ParameterError> {
    for (given, value) in &options.parameters {
        parameters.set(resolve(given, EngineKind::StereoNoise)?, value)?;
    }
    Ok(())
}

pub(super) fn set_time_of_flight(
    parameters: &mut time_of_flight::Parameters,
    options: &SensorOptions,
) -> Result<(), ParameterError> {
    for (given, value) in &options.parameters {
        parameters.set(resolve(given, EngineKind::TimeOfFlight)?, value)?;
    }
    Ok(())
}

/// But for [`CALIBRATION_ERROR`], which is of the pair.
pub(super) fn set_stereo_matching(
    parameters: &mut stereo_matching::Parameters,
    options: &SensorOptions,
) -> Result<(), ParameterError> {
    for (given, value) in &options.parameters {
        let name = resolve(given, EngineKind::StereoMatching)?;
        if name != CALIBRATION_ERROR {
            parameters.set(name, value)?;
        }
    }
    Ok(())
}

/// The parameter of a device, not of its matcher.
pub(super) const CALIBRATION_ERROR: &str = "bias";

/// The parameters of an engine.
fn names(engine: EngineKind) -> Vec<&'static str> {
    match engine {
        EngineKind::SingleView => single_view_names(),
        EngineKind::StereoNoise => stereo_noise::Parameters::names(),
        EngineKind::StereoMatching => {
            [stereo_matching::Parameters::names(), vec![CALIBRATION_ERROR]].concat()
        }
        EngineKind::TimeOfFlight => time_of_flight::Parameters::names(),
    }
}

fn single_view_names() -> Vec<&'static str> {
    let also = vec!["outlierRemovalRange"];
    [single_view::Parameters::names(), also, Assumptions::names()].concat()
}

/// The engine's own name for what somebody wrote.
fn resolve(given: &str, engine: EngineKind) -> Result<&'static str, ParameterError> {
    let find = |engine| {
        names(engine)
            .into_iter()
            .find(|name| fold_name(name) == fold_name(given))
    };
    if let Some(name) = find(engine) {
        return Ok(name);
    }
    let mut others = EngineKind::ALL.into_iter();
    let (what, remedy) = match others.find_map(|other| Some((other, find(other)?))) {
        Some((other, name)) => (
            format!(
                "{} has no {name}: it is a parameter of {}",
                engine.as_str(),
                other.as_str()
            ),
            format!("leave it out, or choose the engine {}", other.as_str()),
        ),
        None => {
            let own = names(engine);
            let near = nearest(given, own.iter().copied());
            let remedy = if near.is_empty() {
                format!("there are {}", own.join(", "))
            } else {
                format!("did you mean {}?", near.join(" or "))
            };
            (format!("{} has no such parameter", engine.as_str()), remedy)
        }
    };
    Err(ParameterError {
        name: given.to_owned(),
        what,
        remedy,
    })
}

//! Presets of `DepthAI`.

use oaktwin_base::diagnostic::{Finding, Level};
use oaktwin_catalog::{DepthKind, Twin};
use oaktwin_depth::filter::Filter;
use oaktwin_depth::preset::{Platform, PresetError, StereoConfig, TimeOfFlightConfig};
use oaktwin_depth::{EngineKind, ParameterError, PresetConfig};

use super::SensorOptions;

/// Returns the preset that the options name for a depth sensor.
pub(super) fn of_sensor(
    twin: &Twin,
    kind: DepthKind,
    options: &SensorOptions,
) -> Result<Option<PresetConfig>, ParameterError> {
    let Some(name) = &options.preset else {
        return Ok(None);
    };
    match kind {
        DepthKind::Stereo => {
            let platform = twin.platform().ok_or_else(|| ParameterError {
                name: "preset".to_owned(),
                what: format!(
                    "no presets are known for {} of {}",
                    twin.device.generation, twin.device.name
                ),
                remedy: "choose filters by name".to_owned(),
            })?;
            of_stereo(platform, name).map(Some)
        }
        DepthKind::Tof => {
            let preset = TimeOfFlightConfig::preset(name).map_err(unknown)?;
            Ok(Some(PresetConfig::TimeOfFlight(preset)))
        }
    }
}

/// Returns a stereo preset of a platform.
pub(super) fn of_stereo(platform: Platform, name: &str) -> Result<PresetConfig, ParameterError> {
    let config = StereoConfig::preset(platform, name).map_err(unknown)?;
    Ok(PresetConfig::Stereo(Box::new(config)))
}

fn unknown(error: PresetError) -> ParameterError {
    ParameterError {
        name: "preset".to_owned(),
        what: error.what,
        remedy: error.remedy,
    }
}

/// Reports what a preset changes.
pub(super) fn finding(
    preset: &PresetConfig,
    options: &SensorOptions,
    kind: &EngineKind,
    prim: &str,
) -> Finding {
    let mut changes = Vec::new();
    let is_modelled = kind.models == Some(preset.technology());
    match preset {
        PresetConfig::Stereo(config) => {
            if is_modelled {
                changes.push(format!("{} subpixel bits", config.subpixel.bits()));
                if config.disparity_shift_px > 0 {
                    changes.push(format!("disparities from {} px", config.disparity_shift_px));
                }
            }
            let is_extended = config.extended_disparity || options.extended_disparity;
            let range = if is_extended { "extended" } else { "standard" };
            changes.push(format!("{range} disparity"));
        }
        PresetConfig::TimeOfFlight(config) if is_modelled => {
            let threshold = config.phase_unwrap_error_threshold;
            changes.push(format!("a phase unwrapping error of up to {threshold} mm"));
            changes.push(format!(
                "a confidence of at least {}",
                config.confidence_threshold
            ));
        }
        PresetConfig::TimeOfFlight(_) => {}
    }
    let filters = preset.filters();
    let names: Vec<&str> = filters.iter().map(Filter::name).collect();
    changes.push(match (&names[..], &options.filters[..]) {
        (_, [_, ..]) => "the given filters instead of its own".to_owned(),
        ([], _) => "no filters".to_owned(),
        (names, _) => format!("the filters {}", names.join(", ")),
    });
    let name = options.preset.as_deref().unwrap_or_default().to_uppercase();
    let message = format!("preset {name}: {}", changes.join(", "));
    Finding::new("preset", Level::Note, prim, message, "")
}

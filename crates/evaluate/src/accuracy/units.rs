//! Which of a twin's depth sensors is measured, and how many devices of it.

use super::stand::Unit;
use super::{AccuracyError, DEVICES, Devices, MATCHING_DEVICES, Options};
use oaktwin_catalog::{Twin, TwinDepthSensor};
use oaktwin_diagnostic::{Finding, fold_name, nearest};
use oaktwin_pipeline::sensor::{Engine, ParameterError, SensorOptions, calibration_error_px, sensor};

/// The depth sensor by prim or kind; by default the last, the device's own.
pub(crate) fn depth_sensor<'a>(
    twin: &'a Twin,
    name: Option<&str>,
) -> Result<&'a TwinDepthSensor, AccuracyError> {
    let sensors = &twin.depth_sensors;
    let found = match name {
        None => sensors.last(),
        Some(name) => {
            let wanted = fold_name(name);
            sensors.iter().find(|sensor| {
                [sensor.spec.prim.as_str(), sensor.spec.kind.as_str()]
                    .iter()
                    .any(|name| fold_name(name) == wanted)
            })
        }
    };
    found.ok_or_else(|| {
        let names = || {
            sensors
                .iter()
                .flat_map(|sensor| [sensor.spec.kind.as_str(), sensor.spec.prim.as_str()])
        };
        let near = nearest(name.unwrap_or_default(), names());
        AccuracyError::Sensor {
            model: twin.device.name.clone(),
            name: name.unwrap_or_default().to_owned(),
            hint: if near.is_empty() {
                format!("there are {}", names().collect::<Vec<_>>().join(", "))
            } else {
                format!("did you mean {}?", near.join(" or "))
            },
        }
    })
}

/// The devices that are measured: many only where they differ.
pub(super) fn units(
    twin: &Twin,
    depth: &TwinDepthSensor,
    options: &Options,
) -> Result<(Devices, Vec<Unit>, Vec<Finding>), AccuracyError> {
    let unit = |device_seed: Option<u64>| {
        let options = SensorOptions {
            device_seed,
            ..options.engine.clone()
        };
        let (sensor, findings) = sensor(twin, depth, &options)?;
        let bias_px = match sensor.engine() {
            Engine::StereoMatching(_) => calibration_error_px(&options)?,
            _ => 0.0,
        };
        let unit = Unit {
            engine: sensor.engine().clone(),
            filters: sensor.filters().clone(),
            bias_px,
        };
        Ok::<_, ParameterError>((unit, findings))
    };
    let (plain, findings) = unit(None)?;
    let devices = match (options.engine.device_seed, options.devices) {
        _ if unit(Some(0))?.0 == unit(Some(1))?.0 => Devices::AsGiven,
        (Some(device_seed), _) => Devices::One { device_seed },
        (None, Some(1)) => Devices::One { device_seed: 0 },
        (None, count) => Devices::Population {
            count: count.unwrap_or(match plain.engine {
                Engine::StereoMatching(_) => MATCHING_DEVICES,
                _ => DEVICES,
            }),
        },
    };
    let units = match devices {
        Devices::AsGiven => vec![plain],
        Devices::One { device_seed } => vec![unit(Some(device_seed))?.0],
        Devices::Population { count } => {
            let seeds = 0..u64::from(count);
            seeds
                .map(|seed| Ok(unit(Some(seed))?.0))
                .collect::<Result<_, ParameterError>>()?
        }
    };
    Ok((devices, units, findings))
}

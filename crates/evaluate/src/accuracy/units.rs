//! The units of a twin's depth sensor that are measured.

use std::sync::Arc;

use super::test_rig::Unit;
use super::{AccuracyError, DEVICES, Devices, MATCHING_DEVICES, Options};
use oaktwin_catalog::{Twin, TwinDepthSensor};
use oaktwin_diagnostic::Finding;
use oaktwin_pipeline::sensor::{EngineInput, ParameterError, SensorOptions, sensor};

/// Returns the devices to measure: several only if they differ.
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
        let bias_px = match sensor.engine().kind().input {
            EngineInput::Pair => options.calibration_error_px()?,
            EngineInput::Depth => 0.0,
        };
        let unit = Unit {
            engine: Arc::clone(sensor.engine()),
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
            count: count.unwrap_or(match plain.engine.kind().input {
                EngineInput::Pair => MATCHING_DEVICES,
                EngineInput::Depth => DEVICES,
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

//! The units of a twin's depth sensor that are measured.

use std::sync::{Arc, OnceLock};

use super::stereo_camera::StereoCamera;
use super::test_rig::{TestRig, Unit};
use super::{AccuracyError, AccuracyOptions, DEVICES, Devices, MATCHING_DEVICES};
use crate::measure::ImageRegion;
use oaktwin_base::diagnostic::Finding;
use oaktwin_base::parameter::Table;
use oaktwin_calibration::population::Population;
use oaktwin_camera::{Intrinsics, StereoDrift};
use oaktwin_catalog::{Origin, Twin, TwinDepthSensor};
use oaktwin_depth::random::{NoiseStage, Numbers, Stream};
use oaktwin_pipeline::sensor::{EngineInput, ParameterError, SensorOptions, sensor};

/// The units to measure, in front of the board.
#[derive(Debug)]
pub(super) struct Prepared {
    pub(super) devices: Devices,
    pub(super) rigs: Vec<TestRig>,
    pub(super) findings: Vec<Finding>,
}

/// Returns the devices to measure: several only if they differ. `scale` is the size of a pixel of the sensor in the images.
pub(super) fn rigs(
    twin: &Twin,
    depth: &TwinDepthSensor,
    options: &AccuracyOptions,
    scale: f64,
) -> Result<Prepared, AccuracyError> {
    if options.population {
        return population(twin, depth, options, scale);
    }
    let engine = &options.engine;
    let unit = |device_seed: Option<u64>| {
        let options = SensorOptions {
            device_seed,
            ..engine.clone()
        };
        unit(twin, depth, &options)
    };
    let (plain, findings) = unit(None)?;
    let devices = match (engine.device_seed, options.devices) {
        _ if unit(Some(0))?.0 == unit(Some(1))?.0 => Devices::AsGiven,
        (Some(device_seed), _) => Devices::One { device_seed },
        (None, Some(1)) => Devices::One { device_seed: 0 },
        (None, count) => Devices::Population {
            count: count.unwrap_or_else(|| default_count(&plain)),
        },
    };
    let units = match devices {
        Devices::One { device_seed } => vec![unit(Some(device_seed))?.0],
        Devices::Population { count } => {
            let seeds = 0..u64::from(count);
            seeds
                .map(|seed| Ok(unit(Some(seed))?.0))
                .collect::<Result<_, ParameterError>>()?
        }
        Devices::AsGiven | Devices::Factory { .. } => vec![plain],
    };
    let drift = engine.drift.unwrap_or_default();
    Ok(Prepared {
        devices,
        rigs: vec![rig(twin, depth, options, (units, 0), drift, scale)?],
        findings,
    })
}

/// Returns units of the factory population, each with its cameras, calibration error and drift.
fn population(
    twin: &Twin,
    depth: &TwinDepthSensor,
    options: &AccuracyOptions,
    scale: f64,
) -> Result<Prepared, AccuracyError> {
    if twin.origin != Origin::Nominal {
        return Err(AccuracyError::Option {
            option: "population",
            what: "units are drawn around the nominal device".to_owned(),
            remedy: "remove it, or the calibration",
        });
    }
    let engine = &options.engine;
    let population = Population::new(twin, engine.seed);
    let (plain, mut findings) = unit(twin, depth, engine)?;
    findings.push(population.finding());
    let count = options.devices.unwrap_or_else(|| default_count(&plain));
    let rigs = (0..count).map(|number| {
        let drift = engine
            .drift
            .map(|spread| drawn(&spread, engine.seed, number))
            .unwrap_or_default();
        let own = population.unit(number.into()).twin;
        let own_depth = own
            .depth_sensors
            .iter()
            .find(|own| own.spec.prim == depth.spec.prim);
        let own_depth = own_depth.unwrap_or(depth);
        let sensor = SensorOptions {
            device_seed: Some(engine.device_seed.unwrap_or(number.into())),
            drift: Some(drift),
            ..engine.clone()
        };
        let (unit, _) = unit(&own, own_depth, &sensor)?;
        rig(&own, own_depth, options, (vec![unit], number), drift, scale)
    });
    Ok(Prepared {
        devices: Devices::Factory { count },
        rigs: rigs.collect::<Result<_, AccuracyError>>()?,
        findings,
    })
}

/// Draws the drift of a unit, whose components are normal with these standard deviations, cut at three.
fn drawn(spread: &StereoDrift, seed: u64, number: u32) -> StereoDrift {
    let mut numbers =
        Numbers::new(Stream::new(seed, "drift").plane(NoiseStage::Population, number.into(), 0));
    let mut drift = StereoDrift::default();
    for row in StereoDrift::rows() {
        let deviation = (row.numbers)(spread).first().copied().unwrap_or_default();
        let value = (deviation * numbers.normal_within(3.0)).clamp(row.about.min, row.about.max);
        // A number in its range.
        let _ = (row.set)(&mut drift, &value.to_string());
    }
    drift
}

fn unit(
    twin: &Twin,
    depth: &TwinDepthSensor,
    options: &SensorOptions,
) -> Result<(Unit, Vec<Finding>), ParameterError> {
    let (sensor, findings) = sensor(twin, depth, options)?;
    let bias_px = match sensor.engine().kind().input {
        EngineInput::Pair => options.calibration_error_px()?,
        EngineInput::Depth => 0.0,
    };
    let unit = Unit {
        engine: Arc::clone(sensor.engine()),
        filters: sensor.filters().clone(),
        drifted: sensor.drifted().copied(),
        bias_px,
    };
    Ok((unit, findings))
}

fn default_count(unit: &Unit) -> u32 {
    match unit.engine.kind().input {
        EngineInput::Pair => MATCHING_DEVICES,
        EngineInput::Depth => DEVICES,
    }
}

/// Returns the intrinsics of a twin's depth images.
pub(super) fn intrinsics(twin: &Twin, depth: &TwinDepthSensor) -> Result<Intrinsics, AccuracyError> {
    let camera = twin.depth_camera(depth);
    camera
        .map(|camera| camera.intrinsics)
        .ok_or_else(|| AccuracyError::Sensor {
            model: twin.device.name.clone(),
            name: depth.spec.prim.clone(),
            hint: "it belongs to no camera".to_owned(),
        })
}

/// Places units in front of the board; their noise counts from `first`.
fn rig(
    twin: &Twin,
    depth: &TwinDepthSensor,
    options: &AccuracyOptions,
    (units, first): (Vec<Unit>, u32),
    drift: StereoDrift,
    scale: f64,
) -> Result<TestRig, AccuracyError> {
    let intrinsics = intrinsics(twin, depth)?;
    let pair = units.first().and_then(|unit| {
        let engine = &unit.engine;
        let matches = engine.kind().input == EngineInput::Pair;
        let of_twin = || twin.depth_baseline_m(depth.spec.pair()?);
        engine.baseline_m().or_else(of_twin).filter(|_| matches)
    });
    let camera = pair
        .map(|baseline_m| StereoCamera::new((baseline_m, drift), scale, options.engine.seed))
        .transpose()?;
    Ok(TestRig {
        intrinsics,
        stereo_camera: camera,
        picture: OnceLock::new(),
        units,
        first,
        random: Stream::new(options.engine.seed, &depth.spec.prim),
        region: ImageRegion::centred(intrinsics.size.width, intrinsics.size.height, options.region),
    })
}

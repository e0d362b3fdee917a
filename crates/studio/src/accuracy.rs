//! The accuracy of an OAK over distance, by the vendor's method.

use oaktwin::accuracy::{AccuracyOptions, AccuracyRow, Bench};
use oaktwin::sensor::EngineInput;

use crate::catalog::bands;
use crate::job::Job;
use crate::pose::ORIGIN;
use crate::protocol::{AccuracyCurve, Failure, OakState};
use crate::studio::Studio;

/// The number of units and captures: fewer than the command `accuracy` measures, because the page waits.
const UNITS: u32 = 25;
const CAPTURES: u32 = 2;
/// The same for an engine that matches images.
const MATCHED_UNITS: u32 = 1;

/// Returns the accuracy at about twenty distances, which is measured once for each OAK.
pub(crate) fn curve(studio: &Studio, state: &OakState, job: &Job) -> Result<AccuracyCurve, Failure> {
    // Where an OAK is has no effect.
    let state = OakState {
        pose: ORIGIN,
        frame: 0,
        ..state.clone()
    };
    if let Some(known) = studio.curves.get(&state) {
        return Ok(known);
    }
    let curve = job.in_full(|| measure(studio, &state, job))?;
    studio.curves.add(state, curve.clone());
    Ok(curve)
}

fn measure(studio: &Studio, state: &OakState, job: &Job) -> Result<AccuracyCurve, Failure> {
    let twin = state.twin(studio)?;
    let is_matching = state.engine()?.input == EngineInput::Pair;
    let options = AccuracyOptions {
        sensor: Some(state.sensor_kind().to_owned()),
        engine: state.options()?,
        devices: state
            .device_seed
            .is_none()
            .then_some(if is_matching { MATCHED_UNITS } else { UNITS }),
        captures: if is_matching { 1 } else { CAPTURES },
        ..AccuracyOptions::default()
    };
    let failed = |error: oaktwin::accuracy::AccuracyError| Failure::from(error.to_string());
    let (bench, _) = Bench::new(&twin, &options).map_err(failed)?;
    let measured = bench.measure(None, &|_| job.watch());
    let measured = measured.map_err(failed)?;
    let report = measured.report();
    let rows = || report.distances.iter();
    let error = |row: &AccuracyRow| row.reading.error_percent;
    Ok(AccuracyCurve {
        distances_m: rows().map(|row| row.distance_m).collect(),
        error_percent: rows().map(error).collect(),
        fill_rate: rows().map(|row| row.reading.fill_rate).collect(),
        bands: bands(report.published.as_ref()),
    })
}

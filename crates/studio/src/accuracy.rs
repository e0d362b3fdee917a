//! The accuracy of an OAK over distance, by the vendor's method.

use std::collections::VecDeque;
use std::sync::{Mutex, PoisonError};

use oaktwin::accuracy::{Bench, Options, Row};
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

/// The number of curves that are kept.
const KEPT: usize = 32;

/// Curves that were measured, with their OAKs; the one that was asked for last is the last.
#[derive(Debug, Default)]
pub(crate) struct Curves(Mutex<VecDeque<(OakState, AccuracyCurve)>>);

/// Returns the accuracy at about twenty distances, which is measured once for each OAK.
pub(crate) fn curve(studio: &Studio, state: &OakState, job: &Job) -> Result<AccuracyCurve, Failure> {
    // Where an OAK is has no effect.
    let state = OakState {
        pose: ORIGIN,
        frame: 0,
        ..state.clone()
    };
    let kept = || studio.curves.0.lock().unwrap_or_else(PoisonError::into_inner);
    let mut known = kept();
    let place = known.iter().position(|(other, _)| *other == state);
    if let Some(found) = place.and_then(|place| known.remove(place)) {
        known.push_back(found.clone());
        return Ok(found.1);
    }
    drop(known);
    let curve = measure(studio, &state, job)?;
    let mut known = kept();
    known.push_back((state, curve.clone()));
    while known.len() > KEPT {
        known.pop_front();
    }
    Ok(curve)
}

fn measure(studio: &Studio, state: &OakState, job: &Job) -> Result<AccuracyCurve, Failure> {
    let twin = state.twin(studio)?;
    let is_matching = state.engine()?.input == EngineInput::Pair;
    let options = Options {
        sensor: Some(state.sensor_kind().to_owned()),
        engine: state.options()?,
        devices: state
            .device_seed
            .is_none()
            .then_some(if is_matching { MATCHED_UNITS } else { UNITS }),
        captures: if is_matching { 1 } else { CAPTURES },
        ..Options::default()
    };
    let failed = |error: oaktwin::accuracy::AccuracyError| Failure::from(error.to_string());
    let (bench, _) = Bench::new(&twin, &options).map_err(failed)?;
    let measured = bench.measure(None, &|_| job.watch());
    let measured = measured.map_err(failed)?;
    let report = measured.report();
    let rows = || report.distances.iter();
    let error = |row: &Row| row.reading.error_percent;
    Ok(AccuracyCurve {
        distances_m: rows().map(|row| row.distance_m).collect(),
        error_percent: rows().map(error).collect(),
        fill_rate: rows().map(|row| row.reading.fill_rate).collect(),
        bands: bands(report.published.as_ref()),
    })
}

//! Types of arguments that always have the same name, so that errors name them.

use std::sync::atomic::{AtomicU64, Ordering};

use oaktwin::camera::math::DVec3;
use pyo3::prelude::*;
use pyo3::types::PyRange;
use pyo3::{Borrowed, FromPyObject};

use crate::array::numbers;
use crate::error::wrong;
use crate::settings::{mistyped, strings, whole};

/// `size`: (width, height) in px.
#[derive(Clone, Copy)]
pub(crate) struct Size(pub(crate) u32, pub(crate) u32);

/// `frame`: the number of a frame.
#[derive(Clone, Copy)]
pub(crate) struct FrameNumber(pub(crate) u64);

impl FrameNumber {
    /// Returns the given number, or the next one of a counter.
    pub(crate) fn or_next(given: Option<Self>, next: &AtomicU64) -> u64 {
        given.map_or_else(|| next.fetch_add(1, Ordering::Relaxed), |frame| frame.0)
    }
}

/// `annotators`: names.
pub(crate) struct Annotators(pub(crate) Vec<String>);

impl FromPyObject<'_, '_> for Size {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, '_, PyAny>) -> PyResult<Self> {
        let is = |_| mistyped("size", &object, "(width, height) in whole pixels above 0");
        let sides: Vec<i64> = object.extract().map_err(is)?;
        let sides: Option<Vec<u32>> = sides.into_iter().map(|side| u32::try_from(side).ok()).collect();
        match sides.as_deref() {
            Some(&[width, height]) => Ok(Self(width, height)),
            _ => Err(mistyped(
                "size",
                &object,
                "(width, height) in whole pixels above 0",
            )),
        }
    }
}

/// Reads a size from a pair, or from two numbers.
pub(crate) fn size(width: &Bound<'_, PyAny>, height: Option<&Bound<'_, PyAny>>) -> PyResult<Size> {
    match height {
        None => width.extract(),
        Some(height) => Ok(Size(whole("width", width)?, whole("height", height)?)),
    }
}

impl FromPyObject<'_, '_> for FrameNumber {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, '_, PyAny>) -> PyResult<Self> {
        whole("frame", &object).map(Self)
    }
}

impl FromPyObject<'_, '_> for Annotators {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, '_, PyAny>) -> PyResult<Self> {
        strings("annotators", &object).map(Self)
    }
}

/// Defines functions that read the arguments of their names.
macro_rules! arguments {
    ($read:ident: $($name:ident: $number:ty),+ $(,)?) => {$(
        #[doc = concat!("Reads the argument `", stringify!($name), "`.")]
        pub(crate) fn $name(object: &Bound<'_, PyAny>) -> PyResult<$number> {
            $read(stringify!($name), object)
        }
    )+};
}

arguments! {
    whole:
    captures: u32,
    count: u64,
    frame: u64,
    frames: u64,
    seed: u64,
    subdivide: u32,
}

/// Arguments that may be None.
pub(crate) mod optional {
    use pyo3::prelude::*;

    use crate::settings::maybe_whole;

    arguments! {
        maybe_whole:
        device_seed: Option<u64>,
        devices: Option<u32>,
        samples: Option<u32>,
        seed: Option<u64>,
        width_px: Option<u32>,
        workers: Option<usize>,
    }
}

/// Reads `formats`: names, or None.
pub(crate) fn formats(object: &Bound<'_, PyAny>) -> PyResult<Option<Vec<String>>> {
    (!object.is_none())
        .then(|| strings("formats", object))
        .transpose()
}

/// Reads `distortion`: coefficients in any shape, such as the (1, 5) of OpenCV's calibration, or None.
pub(crate) fn distortion(object: &Bound<'_, PyAny>) -> PyResult<Option<Vec<f64>>> {
    if object.is_none() {
        return Ok(None);
    }
    let (_, array) = numbers("distortion", object)?;
    Ok(Some(array.as_slice().unwrap_or_default().to_vec()))
}

/// Reads `isaac`: a version as text or number.
pub(crate) fn isaac(object: &Bound<'_, PyAny>) -> PyResult<String> {
    Ok(object.str()?.to_string())
}

/// Reads three numbers.
pub(crate) fn vector(argument: &str, object: &Bound<'_, PyAny>) -> PyResult<DVec3> {
    let (shape, array) = numbers(argument, object)?;
    match array.as_slice().unwrap_or_default() {
        &[x, y, z] if shape == [3] => match [("x", x), ("y", y), ("z", z)]
            .iter()
            .find(|(_, at)| !at.is_finite())
        {
            Some((axis, at)) => Err(wrong(
                argument,
                format_args!("{axis} is {at}"),
                "pass finite numbers",
            )),
            None => Ok(DVec3::new(x, y, z)),
        },
        _ => Err(wrong(
            argument,
            format_args!("has shape {shape:?}"),
            "pass three numbers",
        )),
    }
}

/// Reads `frames`: a range without gaps, or its ends.
pub(crate) fn frame_range(object: &Bound<'_, PyAny>) -> PyResult<Option<(u64, u64)>> {
    if object.is_none() {
        return Ok(None);
    }
    let wrong = || {
        mistyped(
            "frames",
            object,
            "a range, or the first frame and the one after the last",
        )
    };
    if object.is_instance_of::<PyRange>() {
        let part = |name: &str| object.getattr(name)?.extract::<u64>();
        return match (part("start"), part("stop"), part("step")) {
            (Ok(start), Ok(stop), Ok(1)) => Ok(Some((start, stop))),
            _ => Err(wrong()),
        };
    }
    object.extract().map(Some).map_err(|_| wrong())
}

//! Types of arguments that always have the same name, so that errors name them.

use oaktwin::camera::math::DVec3;
use pyo3::prelude::*;
use pyo3::{Borrowed, FromPyObject};

use crate::array::numbers;
use crate::error::wrong;
use crate::settings::{mistyped, strings, whole_number};

/// `size`: (width, height) in px.
#[derive(Clone, Copy)]
pub(crate) struct Size(pub(crate) u32, pub(crate) u32);

/// `frame`: the number of a frame.
#[derive(Clone, Copy)]
pub(crate) struct FrameNumber(pub(crate) u64);

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

impl FromPyObject<'_, '_> for FrameNumber {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, '_, PyAny>) -> PyResult<Self> {
        whole_number("frame", &object).map(Self)
    }
}

impl FromPyObject<'_, '_> for Annotators {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, '_, PyAny>) -> PyResult<Self> {
        strings("annotators", &object).map(Self)
    }
}

/// Reads three numbers.
pub(crate) fn vector(argument: &str, object: &Bound<'_, PyAny>) -> PyResult<DVec3> {
    let (shape, array) = numbers(argument, object)?;
    match array.as_slice().unwrap_or_default() {
        &[x, y, z] if shape == [3] => Ok(DVec3::new(x, y, z)),
        _ => Err(wrong(
            argument,
            format_args!("has shape {shape:?}"),
            "pass three numbers",
        )),
    }
}

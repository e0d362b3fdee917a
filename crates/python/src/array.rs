//! Arrays of whoever has them: NumPy's, and through the buffer protocol, DLPack or NumPy's array interface anybody's in
//! the memory of the CPU.

use numpy::{
    Element, PyArrayDescrMethods, PyArrayDyn, PyArrayMethods, PyReadonlyArrayDyn, PyReadwriteArrayDyn,
    PyUntypedArray, PyUntypedArrayMethods,
};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyMemoryView;

use crate::error::wrong;

/// DLPack's numbers of memory that a CPU reads: its own, CUDA's and ROCm's pinned host memory.
const HOST_MEMORY: [i32; 3] = [1, 3, 11];

/// As a NumPy array, on the same memory wherever the object lets others at it.
pub(crate) fn view<'py>(name: &str, object: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyUntypedArray>> {
    if let Ok(array) = object.cast::<PyUntypedArray>() {
        return Ok(array.clone());
    }
    let numpy = object.py().import("numpy")?;
    if object.hasattr("__dlpack__")? && object.hasattr("__dlpack_device__")? {
        let (device, _): (i32, i32) = object.call_method0("__dlpack_device__")?.extract()?;
        if !HOST_MEMORY.contains(&device) {
            return Err(wrong(
                name,
                format_args!("is in the memory of another device (DLPack's {device})"),
                "copy it to the CPU first",
            ));
        }
        if let Ok(array) = numpy.call_method1("from_dlpack", (object,)) {
            return Ok(array.cast_into()?);
        }
    }
    let array = if let Ok(memory) = PyMemoryView::from(object) {
        numpy.call_method1("asarray", (memory,))?
    } else if object.hasattr("__array_interface__")? || object.hasattr("__array__")? {
        numpy.call_method1("asarray", (object,))?
    } else {
        return Err(PyTypeError::new_err(format!(
            "{name}: {} is no array; give a NumPy array, or what has the buffer protocol or DLPack",
            object.get_type().name()?
        )));
    };
    Ok(array.cast_into()?)
}

/// Whether an array's numbers are of this type, as this machine has them.
pub(crate) fn is_of<T: Element>(array: &Bound<'_, PyUntypedArray>) -> bool {
    array.dtype().is_equiv_to(&T::get_dtype(array.py()))
}

/// Whether they are but for the order of their bytes.
pub(crate) fn is_like<T: Element>(array: &Bound<'_, PyUntypedArray>) -> bool {
    let (own, wanted) = (array.dtype(), T::get_dtype(array.py()));
    own.kind() == wanted.kind() && own.itemsize() == wanted.itemsize()
}

/// To read, row after row: the array itself where it lies so in memory, else a copy.
pub(crate) fn contiguous<'py, T: Element>(
    name: &str,
    array: &Bound<'py, PyUntypedArray>,
) -> PyResult<PyReadonlyArrayDyn<'py, T>> {
    let is_ready = array.is_c_contiguous() && is_of::<T>(array);
    let py = array.py();
    let array = match array.cast::<PyArrayDyn<T>>() {
        Ok(array) if is_ready && array.try_readonly().is_ok_and(|it| it.as_slice().is_ok()) => array.clone(),
        _ => {
            let wants = (array, T::get_dtype(py), ["C", "A"]);
            py.import("numpy")?.call_method1("require", wants)?.cast_into()?
        }
    };
    array.try_readonly().map_err(|_| {
        wrong(
            name,
            "another call is writing to it",
            "wait for that, or give a copy",
        )
    })
}

/// To write, row after row, in the array itself.
pub(crate) fn writable<'py, T: Element>(
    name: &str,
    array: &Bound<'py, PyUntypedArray>,
) -> PyResult<PyReadwriteArrayDyn<'py, T>> {
    if !array.is_c_contiguous() {
        return Err(wrong(
            name,
            "its rows do not follow each other in memory",
            "give a C-contiguous array",
        ));
    }
    let mut array = array.cast::<PyArrayDyn<T>>()?.try_readwrite().map_err(|_| {
        wrong(
            name,
            "it is read-only, or another call uses it",
            "give an array of its own to write to",
        )
    })?;
    if array.as_slice_mut().is_err() {
        return Err(wrong(
            name,
            "its numbers are not aligned in memory",
            "give an array that NumPy made",
        ));
    }
    Ok(array)
}

/// Zeros of a shape.
pub(crate) fn zeros<'py, T: Element>(
    py: Python<'py>,
    shape: &[usize],
) -> PyResult<Bound<'py, PyArrayDyn<T>>> {
    // NumPy's own function, whose error is an exception where there is no memory.
    let made = py
        .import("numpy")?
        .call_method1("zeros", (shape.to_vec(), T::get_dtype(py)))?;
    Ok(made.cast_into()?)
}

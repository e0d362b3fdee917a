//! Access to arrays in CPU memory: NumPy arrays, and objects with the buffer protocol, DLPack or NumPy's array interface.

use numpy::{
    BorrowError, Element, PyArrayDescrMethods, PyArrayDyn, PyArrayMethods, PyReadonlyArrayDyn,
    PyReadwriteArrayDyn, PyUntypedArray, PyUntypedArrayMethods,
};
use pyo3::PyTypeInfo;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyList, PyMemoryView, PyTuple};

use crate::error::{error, wrong};
use crate::memory::check_free;

/// DLPack's device types of memory that the CPU can read: CPU, CUDA pinned host and ROCm pinned host memory.
const HOST_MEMORY: [i32; 3] = [1, 3, 11];

/// Converts an object to a NumPy array, sharing its memory if the object allows it.
pub(crate) fn view<'py>(name: &str, object: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyUntypedArray>> {
    if let Ok(array) = object.cast::<PyUntypedArray>() {
        return Ok(array.clone());
    }
    let numpy = object.py().import("numpy")?;
    if object.hasattr("__dlpack__")? && object.hasattr("__dlpack_device__")? {
        let device = object.call_method0("__dlpack_device__")?.get_item(0)?;
        // Open3D returns an enumeration that is not a number.
        let device = device
            .extract::<i32>()
            .or_else(|_| device.getattr("value")?.extract());
        if let Ok(device) = device
            && !HOST_MEMORY.contains(&device)
        {
            return Err(wrong(
                name,
                format_args!("is in the memory of another device (DLPack device type {device})"),
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
            "{name}: {} is not an array; pass a NumPy array, or an object with the buffer protocol or DLPack",
            object.get_type().name()?
        )));
    };
    Ok(array.cast_into()?)
}

/// Converts an object to a NumPy array for writing, which shares its memory.
///
/// NumPy before 2.1 shares the memory of DLPack read-only, and so do newer versions that of producers without the versioned
/// protocol. Such an object, a tensor for instance, often has `__array__`, too.
pub(crate) fn shared<'py>(name: &str, object: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyUntypedArray>> {
    if let Ok(array) = object.cast::<PyUntypedArray>() {
        return Ok(array.clone());
    }
    let is_writable = |array: &Bound<'_, PyUntypedArray>| -> PyResult<bool> {
        array.getattr("flags")?.getattr("writeable")?.extract()
    };
    let array = view(name, object)?;
    if PyMemoryView::from(object).is_ok() || (object.hasattr("__dlpack__")? && is_writable(&array)?) {
        return Ok(array);
    }
    if !object.hasattr("__array__")? {
        if object.hasattr("__dlpack__")? {
            let numpy: String = object.py().import("numpy")?.getattr("__version__")?.extract()?;
            let is = format!("shares its memory with NumPy {numpy} by DLPack, read-only");
            return Err(wrong(name, is, "pass a NumPy array, and copy the result"));
        }
        return Ok(array);
    }
    // A copy has another address each time.
    let numpy = object.py().import("numpy")?;
    let once = || numpy.call_method1("asarray", (object,));
    let address = |array: &Bound<'_, PyAny>| -> PyResult<usize> {
        array
            .getattr("__array_interface__")?
            .get_item("data")?
            .get_item(0)?
            .extract()
    };
    let (array, again) = (once()?, once()?);
    if address(&array)? != address(&again)? {
        let remedy = "pass a NumPy array, and copy the result";
        return Err(wrong(name, "gives NumPy copies of its memory", remedy));
    }
    Ok(array.cast_into()?)
}

/// Whether an array has this dtype in native byte order.
pub(crate) fn is_of<T: Element>(array: &Bound<'_, PyUntypedArray>) -> bool {
    array.dtype().is_equiv_to(&T::get_dtype(array.py()))
}

/// Whether an array has this dtype in any byte order.
pub(crate) fn is_like<T: Element>(array: &Bound<'_, PyUntypedArray>) -> bool {
    let (own, wanted) = (array.dtype(), T::get_dtype(array.py()));
    own.kind() == wanted.kind() && own.itemsize() == wanted.itemsize()
}

/// Converts an object to a NumPy array for reading: what [`view`] takes, nested sequences, and masked arrays, whose masked
/// values become 0, which is invalid.
pub(crate) fn readable<'py>(name: &str, object: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyUntypedArray>> {
    if object.is_instance_of::<PyList>() || object.is_instance_of::<PyTuple>() {
        let numpy = object.py().import("numpy")?;
        let array = numpy.call_method1("asarray", (object,)).map_err(|cause| {
            let is = format!("is not an array ({cause})");
            wrong(name, is, "pass rows of equal length")
        })?;
        return Ok(array.cast_into()?);
    }
    let array = view(name, object)?;
    let is_plain = object.get_type().is(PyUntypedArray::type_object(object.py()));
    if !is_plain && array.hasattr("filled")? {
        check_copy(name, &array, size_of::<f64>())?;
        return Ok(array.call_method1("filled", (0,))?.cast_into()?);
    }
    Ok(array)
}

/// Whether an array has floating-point numbers of any precision.
pub(crate) fn is_float(array: &Bound<'_, PyUntypedArray>) -> bool {
    array.dtype().kind() == b'f'
}

/// Returns an error if copies with this many bytes for each number need more memory than is free. Arrays may repeat their
/// memory (strides of 0), so they may be larger than it.
pub(crate) fn check_copy(name: &str, object: &Bound<'_, PyAny>, bytes: usize) -> PyResult<()> {
    let Ok(array) = object.cast::<PyUntypedArray>() else {
        return Ok(());
    };
    let count = array
        .shape()
        .iter()
        .fold(bytes as u64, |count, &length| count.saturating_mul(length as u64));
    check_free(name, count, "pass a smaller array")
}

/// A C-contiguous array for reading: the array itself if possible, otherwise a copy.
pub(crate) fn contiguous<'py, T: Element>(
    name: &str,
    array: &Bound<'py, PyUntypedArray>,
) -> PyResult<PyReadonlyArrayDyn<'py, T>> {
    let is_ready = array.is_c_contiguous() && is_of::<T>(array);
    let py = array.py();
    let array = match array.cast::<PyArrayDyn<T>>() {
        Ok(array) if is_ready && array.try_readonly().is_ok_and(|it| it.as_slice().is_ok()) => array.clone(),
        _ => {
            check_copy(name, array, size_of::<T>())?;
            let wants = (array, T::get_dtype(py), ["C", "A"]);
            py.import("numpy")?.call_method1("require", wants)?.cast_into()?
        }
    };
    array.try_readonly().map_err(|_| {
        wrong(
            name,
            "another call is writing to the array",
            "wait for that call, or pass a copy",
        )
    })
}

/// The C-contiguous array itself, for writing; `input` is the range of addresses that is read meanwhile.
pub(crate) fn writable<'py, T: Element>(
    name: &str,
    array: &Bound<'py, PyUntypedArray>,
    (start, end): (usize, usize),
) -> PyResult<PyReadwriteArrayDyn<'py, T>> {
    if !array.is_c_contiguous() {
        return Err(wrong(name, "is not C-contiguous", "pass a C-contiguous array"));
    }
    let array = array.cast::<PyArrayDyn<T>>()?;
    let first = array.data() as usize;
    if start < first + array.len() * size_of::<T>() && first < end {
        return Err(wrong(name, "overlaps the input", "pass a separate array"));
    }
    let mut array = array.try_readwrite().map_err(|cause| match cause {
        BorrowError::NotWriteable => wrong(name, "is read-only", "pass an array that can be written to"),
        _ => wrong(
            name,
            "is used by another call",
            "pass a separate array to each call",
        ),
    })?;
    if array.as_slice_mut().is_err() {
        return Err(wrong(
            name,
            "is not aligned in memory",
            "pass an array allocated by NumPy",
        ));
    }
    Ok(array)
}

/// An array of zeros.
pub(crate) fn zeros<'py, T: Element>(
    py: Python<'py>,
    shape: &[usize],
) -> PyResult<Bound<'py, PyArrayDyn<T>>> {
    let bytes = shape.iter().fold(size_of::<T>() as u64, |bytes, &length| {
        bytes.saturating_mul(length as u64)
    });
    check_free("the result", bytes, "pass fewer or smaller images")?;
    // NumPy's own function raises a MemoryError instead of aborting.
    let made = py
        .import("numpy")?
        .call_method1("zeros", (shape.to_vec(), T::get_dtype(py)))?;
    Ok(made.cast_into()?)
}

/// Converts anything that NumPy can convert to an array of numbers.
pub(crate) fn numbers<'py>(
    name: &str,
    object: &Bound<'py, PyAny>,
) -> PyResult<(Vec<usize>, PyReadonlyArrayDyn<'py, f64>)> {
    // The array itself, and what is made of it.
    check_copy(name, object, 2 * size_of::<f64>())?;
    let array = object
        .py()
        .import("numpy")?
        .call_method1("array", (object, "float64"))
        .map_err(|cause| {
            wrong(
                name,
                format_args!("is not an array of numbers ({cause})"),
                "pass an array of numbers",
            )
        })?;
    let array = contiguous::<f64>(name, array.cast::<PyUntypedArray>()?)?;
    Ok((array.shape().to_vec(), array))
}

/// Reads an array (N, 3) as `dtype`.
pub(crate) fn triples<T: Element + Copy>(
    name: &str,
    object: &Bound<'_, PyAny>,
    dtype: &str,
) -> PyResult<Vec<[T; 3]>> {
    let array = readable(name, object)?;
    let kind = array.getattr("dtype")?.getattr("kind")?.extract::<String>()?;
    let fits = if dtype.starts_with("int") { "iu" } else { "fiu" };
    if !fits.contains(&kind) || array.ndim() != 2 || array.shape().last() != Some(&3) {
        let is = format!(
            "has shape {:?} and dtype {}",
            array.shape(),
            array.getattr("dtype")?
        );
        let numbers = if dtype.starts_with("int") {
            "integers"
        } else {
            "numbers"
        };
        return Err(wrong(name, is, format_args!("pass {numbers} of shape (N, 3)")));
    }
    check_copy(name, &array, 2 * size_of::<T>())?;
    let cast = array.call_method1("astype", (dtype,))?;
    let array = contiguous::<T>(name, cast.cast::<PyUntypedArray>()?)?;
    let (rows, _) = array.as_slice().map_err(error)?.as_chunks::<3>();
    Ok(rows.to_vec())
}

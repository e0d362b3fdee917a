//! Images and batches of images in NumPy arrays.

use std::borrow::Cow;

use numpy::{
    Element, PyArray1, PyArrayDyn, PyArrayMethods, PyReadonlyArrayDyn, PyReadwriteArrayDyn, PyUntypedArray,
    PyUntypedArrayMethods,
};
use oaktwin::camera::ImageSize;
use oaktwin::image::{Image, ZDepth, millimetres};
use oaktwin::render::check_size;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;

use crate::array::{contiguous, is_float, is_like, is_of, readable, shared, writable, zeros};
use crate::error::{error, wrong};

/// The shape of an image, or of a batch of images.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct ImageShape {
    /// The number of images; `None` for a single image.
    pub(crate) batch: Option<usize>,
    pub(crate) size: ImageSize,
    /// Whether the array has a last dimension of 1.
    pub(crate) has_channel: bool,
}

impl ImageShape {
    /// Parses (H, W), (H, W, 1), (N, H, W) or (N, H, W, 1).
    fn of(name: &str, shape: &[usize]) -> PyResult<Self> {
        let (batch, height, width, has_channel) = match *shape {
            [height, width] => (None, height, width, false),
            [height, width, 1] => (None, height, width, true),
            [count, height, width] => (Some(count), height, width, false),
            [count, height, width, 1] => (Some(count), height, width, true),
            _ => {
                let is = format!("has shape {shape:?}");
                return Err(wrong(name, is, "pass an image (H, W), or a batch (N, H, W)"));
            }
        };
        let side = |length: usize| u32::try_from(length).unwrap_or(u32::MAX);
        let size = ImageSize::new(side(width), side(height));
        check_size(size).map_err(|found| error(format!("{name}: {found}")))?;
        Ok(Self {
            batch,
            size,
            has_channel,
        })
    }

    pub(crate) fn count(self) -> usize {
        self.batch.unwrap_or(1)
    }

    pub(crate) fn pixels(self) -> usize {
        self.size.width as usize * self.size.height as usize
    }

    /// The same batch with images of another size.
    pub(crate) fn sized(self, size: ImageSize) -> Self {
        Self { size, ..self }
    }

    pub(crate) fn dims(self) -> Vec<usize> {
        let channel = self.has_channel.then_some(1);
        self.rows().into_iter().chain(channel).collect()
    }

    /// The dimensions without the channel's.
    pub(crate) fn rows(self) -> Vec<usize> {
        let rows = [self.size.height as usize, self.size.width as usize];
        self.batch.into_iter().chain(rows).collect()
    }

    pub(crate) fn of_batch(self) -> [usize; 3] {
        [self.count(), self.size.height as usize, self.size.width as usize]
    }
}

/// Depth images in metres or integer millimetres.
pub(crate) enum Depth<'py> {
    Metres(PyReadonlyArrayDyn<'py, f32>),
    Millimetres(PyReadonlyArrayDyn<'py, u16>),
}

/// The borrowed values of depth images.
#[derive(Clone, Copy)]
pub(crate) enum DepthSlice<'a> {
    Metres(&'a [f32]),
    Millimetres(&'a [u16]),
}

impl<'py> Depth<'py> {
    /// Reads floating-point metres, or uint16 millimetres.
    pub(crate) fn read(name: &str, object: &Bound<'py, PyAny>) -> PyResult<(Self, ImageShape)> {
        let array = readable(name, object)?;
        let depth = if is_float(&array) {
            Self::Metres(contiguous(name, &array)?)
        } else if is_like::<u16>(&array) {
            Self::Millimetres(contiguous(name, &array)?)
        } else {
            return Err(PyTypeError::new_err(format!(
                "{name}: unsupported dtype {}; pass floating-point metres or uint16 millimetres",
                array.dtype()
            )));
        };
        Ok((depth, ImageShape::of(name, array.shape())?))
    }

    pub(crate) fn slice(&self) -> PyResult<DepthSlice<'_>> {
        Ok(match self {
            Self::Metres(array) => DepthSlice::Metres(array.as_slice().map_err(error)?),
            Self::Millimetres(array) => DepthSlice::Millimetres(array.as_slice().map_err(error)?),
        })
    }
}

impl<'a> DepthSlice<'a> {
    /// The values in metres, borrowed if possible.
    pub(crate) fn metres(self) -> Cow<'a, [f32]> {
        match self {
            Self::Metres(metres) => Cow::Borrowed(metres),
            Self::Millimetres(values) => Cow::Owned(to_metres(values)),
        }
    }

    /// Some of the values in metres, evenly spaced.
    pub(crate) fn sampled(self) -> Vec<f32> {
        match self {
            Self::Metres(values) => sampled(values),
            Self::Millimetres(values) => to_metres(&sampled(values)),
        }
    }

    /// The part that begins at the pixel `from`.
    pub(crate) fn part(self, from: usize, pixels: usize) -> Self {
        match self {
            Self::Metres(values) => Self::Metres(part(values, from, pixels)),
            Self::Millimetres(values) => Self::Millimetres(part(values, from, pixels)),
        }
    }

    fn range(self) -> (usize, usize) {
        match self {
            Self::Metres(values) => bytes(values),
            Self::Millimetres(values) => bytes(values),
        }
    }
}

fn sampled<T: Copy>(values: &[T]) -> Vec<T> {
    values
        .iter()
        .copied()
        .step_by((values.len() / 256).max(1))
        .collect()
}

/// The part of a slice, shortened at its end.
pub(crate) fn part<T>(values: &[T], from: usize, length: usize) -> &[T] {
    values
        .get(from..)
        .map_or(&[], |rest| rest.get(..length).unwrap_or(rest))
}

fn bytes<T>(values: &[T]) -> (usize, usize) {
    let range = values.as_ptr_range();
    (range.start as usize, range.end as usize)
}

/// Images of any dtype that filters accept.
pub(crate) enum Numbers<'py> {
    U8(PyReadonlyArrayDyn<'py, u8>),
    U16(PyReadonlyArrayDyn<'py, u16>),
    F32(PyReadonlyArrayDyn<'py, f32>),
}

/// The borrowed values of such images.
pub(crate) enum NumbersSlice<'a> {
    U8(&'a [u8]),
    U16(&'a [u16]),
    F32(&'a [f32]),
}

impl<'py> Numbers<'py> {
    pub(crate) fn read(name: &str, object: &Bound<'py, PyAny>) -> PyResult<(Self, ImageShape)> {
        let array = readable(name, object)?;
        let numbers = if is_like::<u16>(&array) {
            Self::U16(contiguous(name, &array)?)
        } else if is_like::<u8>(&array) {
            Self::U8(contiguous(name, &array)?)
        } else if is_float(&array) {
            Self::F32(contiguous(name, &array)?)
        } else {
            return Err(PyTypeError::new_err(format!(
                "{name}: unsupported dtype {}; pass uint16, uint8 or floating-point metres",
                array.dtype()
            )));
        };
        Ok((numbers, ImageShape::of(name, array.shape())?))
    }

    pub(crate) fn slice(&self) -> PyResult<NumbersSlice<'_>> {
        Ok(match self {
            Self::U8(array) => NumbersSlice::U8(array.as_slice().map_err(error)?),
            Self::U16(array) => NumbersSlice::U16(array.as_slice().map_err(error)?),
            Self::F32(array) => NumbersSlice::F32(array.as_slice().map_err(error)?),
        })
    }
}

/// Returns an image as an array (H, W).
pub(crate) fn array<T: Element>(py: Python<'_>, image: Image<T>) -> PyResult<Bound<'_, PyAny>> {
    let dims = [image.height() as usize, image.width() as usize];
    Ok(PyArray1::from_vec(py, image.into_pixels())
        .reshape(dims)?
        .into_any())
}

/// Returns a colour image without its alpha as an array (H, W, 3).
pub(crate) fn colours(py: Python<'_>, image: Image<[u8; 4]>) -> PyResult<Bound<'_, PyAny>> {
    let dims = [image.height() as usize, image.width() as usize, 3];
    let values = image.into_pixels().into_iter().flat_map(|[r, g, b, _]| [r, g, b]);
    Ok(PyArray1::from_vec(py, values.collect()).reshape(dims)?.into_any())
}

/// Converts metres to integer millimetres; 0 if invalid.
pub(crate) fn from_metres(metres: Vec<f32>) -> Vec<u16> {
    // The shape does not matter.
    let columns = u32::try_from(metres.len()).unwrap_or(0);
    Image::new(columns, 1, metres).map_or_else(Vec::new, |row| millimetres::from_metres(&row).into_pixels())
}

/// Converts integer millimetres to metres.
pub(crate) fn to_metres(values: &[u16]) -> Vec<f32> {
    values.iter().map(|&mm| f32::from(mm) / 1000.0).collect()
}

/// Converts integer millimetres to metres in an array.
pub(crate) fn put_metres(values: &[u16], room: &mut [f32]) {
    let both = room.iter_mut().zip(values);
    both.for_each(|(room, &mm)| *room = f32::from(mm) / 1000.0);
}

/// The output array of measured depth, in metres or integer millimetres.
pub(crate) enum Out<'py> {
    Metres(PyReadwriteArrayDyn<'py, f32>),
    Millimetres(PyReadwriteArrayDyn<'py, u16>),
}

/// The borrowed output array of measured depth.
pub(crate) enum OutSlice<'a> {
    Metres(&'a mut [f32]),
    Millimetres(&'a mut [u16]),
}

impl<'py> Out<'py> {
    /// Returns `out`, or a new array with the dtype of `depth`, as a Python object and for writing.
    pub(crate) fn of(
        py: Python<'py>,
        given: Option<Bound<'py, PyAny>>,
        shape: ImageShape,
        depth: &Depth<'_>,
    ) -> PyResult<(Bound<'py, PyAny>, Self)> {
        let Some(given) = given else {
            return match depth {
                Depth::Metres(_) => made(py, shape, Self::Metres),
                Depth::Millimetres(_) => made(py, shape, Self::Millimetres),
            };
        };
        let array = shared("out", &given)?;
        check_shape(&array, &shape.dims())?;
        let read = depth.slice()?.range();
        let out = if is_of::<f32>(&array) {
            Self::Metres(writable("out", &array, read)?)
        } else if is_of::<u16>(&array) {
            Self::Millimetres(writable("out", &array, read)?)
        } else {
            return Err(PyTypeError::new_err(format!(
                "out: unsupported dtype {}; pass float32 for metres or uint16 for millimetres",
                array.dtype()
            )));
        };
        Ok((given, out))
    }

    pub(crate) fn slice(&mut self) -> PyResult<OutSlice<'_>> {
        Ok(match self {
            Self::Metres(array) => OutSlice::Metres(array.as_slice_mut().map_err(error)?),
            Self::Millimetres(array) => OutSlice::Millimetres(array.as_slice_mut().map_err(error)?),
        })
    }
}

/// Returns `out`, or a new array of the given shape and type, as a Python object and for writing. `input` is what is read meanwhile.
pub(crate) fn room<'py, T: Element>(
    py: Python<'py>,
    given: Option<Bound<'py, PyAny>>,
    dims: &[usize],
    input: &[T],
) -> PyResult<(Bound<'py, PyAny>, PyReadwriteArrayDyn<'py, T>)> {
    let Some(given) = given else {
        let array: Bound<'py, PyArrayDyn<T>> = zeros(py, dims)?;
        let writable = array.try_readwrite().map_err(error)?;
        return Ok((array.into_any(), writable));
    };
    let array = shared("out", &given)?;
    if !is_of::<T>(&array) {
        return Err(PyTypeError::new_err(format!(
            "out: unsupported dtype {}; pass the image's dtype, {}",
            array.dtype(),
            T::get_dtype(py)
        )));
    }
    check_shape(&array, dims)?;
    Ok((given, writable("out", &array, bytes(input))?))
}

fn check_shape(out: &Bound<'_, PyUntypedArray>, dims: &[usize]) -> PyResult<()> {
    if out.shape() == dims {
        return Ok(());
    }
    let is = format!("has shape {:?}", out.shape());
    Err(wrong("out", is, format_args!("pass an array of shape {dims:?}")))
}

fn made<'py, T: Element>(
    py: Python<'py>,
    shape: ImageShape,
    out: impl FnOnce(PyReadwriteArrayDyn<'py, T>) -> Out<'py>,
) -> PyResult<(Bound<'py, PyAny>, Out<'py>)> {
    let array: Bound<'py, PyArrayDyn<T>> = zeros(py, &shape.dims())?;
    let writable = array.try_readwrite().map_err(error)?;
    Ok((array.into_any(), out(writable)))
}

impl OutSlice<'_> {
    /// The first of `count` images in which nothing was measured.
    pub(crate) fn first_empty(&self, count: usize) -> Option<usize> {
        fn find<T: Default + PartialEq>(values: &[T], count: usize) -> Option<usize> {
            let mut images = values.chunks((values.len() / count.max(1)).max(1));
            images.position(|image| image.iter().all(|value| *value == T::default()))
        }
        match self {
            Self::Metres(values) => find(values, count),
            Self::Millimetres(values) => find(values, count),
        }
    }

    /// Writes a part, starting at a pixel, with metres computed by `make`.
    pub(crate) fn fill<E>(
        &mut self,
        from: usize,
        pixels: usize,
        make: impl FnOnce(&mut [f32]) -> Result<(), E>,
    ) -> Result<(), E> {
        match self {
            Self::Metres(values) => {
                let rest = values.get_mut(from..).unwrap_or_default();
                let length = pixels.min(rest.len());
                make(rest.get_mut(..length).unwrap_or_default())
            }
            Self::Millimetres(values) => {
                let mut metres = vec![0.0; pixels];
                make(&mut metres)?;
                let rest = values.get_mut(from..).unwrap_or_default();
                rest.iter_mut()
                    .zip(from_metres(metres))
                    .for_each(|(out, mm)| *out = mm);
                Ok(())
            }
        }
    }
}

/// Exact depth, and the colours of its pixels.
type Exact = (Option<ZDepth>, Option<Image<[u8; 4]>>);

/// Returns one image of exact depth in metres, `None` without pixels, and the colour image of the same pixels.
pub(crate) fn exact(depth: &Depth<'_>, rgb: Option<&Bound<'_, PyAny>>, shape: ImageShape) -> PyResult<Exact> {
    let ImageSize { width, height } = shape.size;
    let pictures = rgb.map(|rgb| Pictures::read(rgb, shape)).transpose()?;
    let rgba = pictures.as_ref().map(Pictures::rgba).transpose()?;
    let depth = Image::new(width, height, depth.slice()?.metres().into_owned());
    Ok((
        depth.map(ZDepth),
        rgba.and_then(|rgba| Image::new(width, height, rgba.into_owned())),
    ))
}

/// The colour images of depth images: (..., H, W, 4) borrowed, (..., H, W, 3) copied.
pub(crate) struct Pictures<'py> {
    array: PyReadonlyArrayDyn<'py, u8>,
    channels: usize,
}

impl<'py> Pictures<'py> {
    pub(crate) fn read(object: &Bound<'py, PyAny>, shape: ImageShape) -> PyResult<Self> {
        let array: Bound<'py, PyUntypedArray> = readable("rgb", object)?;
        if !is_like::<u8>(&array) {
            return Err(PyTypeError::new_err(format!(
                "rgb: unsupported dtype {}; pass uint8, sRGB",
                array.dtype()
            )));
        }
        let channels = array.shape().last().copied().unwrap_or(0);
        let wanted = shape.rows();
        let is_of_depth = array
            .shape()
            .split_last()
            .is_some_and(|(_, rows)| *rows == wanted);
        if !(is_of_depth && (channels == 3 || channels == 4)) {
            let is = format!("has shape {:?}, but the depth has {wanted:?}", array.shape());
            return Err(wrong("rgb", is, "pass the depth's shape with 3 or 4 channels"));
        }
        Ok(Self {
            array: contiguous("rgb", &array)?,
            channels,
        })
    }

    /// Red, green, blue and an unused channel.
    pub(crate) fn rgba(&self) -> PyResult<Cow<'_, [[u8; 4]]>> {
        let values = self.array.as_slice().map_err(error)?;
        Ok(if self.channels == 4 {
            Cow::Borrowed(values.as_chunks().0)
        } else {
            let (pixels, _) = values.as_chunks::<3>();
            pixels.iter().map(|&[r, g, b]| [r, g, b, 255]).collect()
        })
    }
}

/// The address from which a depth image is read: its own, unless a copy is required. For tests.
#[pyfunction]
pub(crate) fn _read_from(depth: &Bound<'_, PyAny>) -> PyResult<usize> {
    let (depth, _) = Depth::read("depth", depth)?;
    Ok(depth.slice()?.range().0)
}

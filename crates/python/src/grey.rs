//! Grey images with 8 or 10 bits.

use numpy::{Element, PyArray1, PyArrayMethods, PyUntypedArray, PyUntypedArrayMethods};
use oaktwin::camera::ImageSize;
use oaktwin::depth::imager::Recorded;
use oaktwin::image::Image;
use oaktwin::render::check_size;
use oaktwin::stereo::luma;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;

use crate::array::{contiguous, is_like, readable};
use crate::error::{error, wrong};
use crate::images::array;

/// The maximum 10-bit value.
const TEN_BITS: u16 = 1023;

/// One image or a batch.
pub(crate) struct Images {
    /// The number of images in a batch; `None` for a single image.
    pub(crate) batch: Option<usize>,
    pub(crate) size: ImageSize,
    /// Whether the images have 10 bits.
    pub(crate) is_wide: bool,
    pub(crate) images: Vec<Recorded>,
}

/// Reads (H, W) or (N, H, W) uint8, or uint16 with 10 bits; colours (..., H, W, 3 or 4) uint8 are converted to luma.
pub(crate) fn read(name: &str, object: &Bound<'_, PyAny>) -> PyResult<Images> {
    let array = readable(name, object)?;
    let is_wide = is_like::<u16>(&array);
    if !is_wide && !is_like::<u8>(&array) {
        return Err(PyTypeError::new_err(format!(
            "{name}: unsupported dtype {}; pass uint8, or uint16 with 10 bits",
            array.dtype()
        )));
    }
    let (batch, size, channels) = shape(name, &array)?;
    let numbers = size.width as usize * size.height as usize * channels;
    let images = if is_wide {
        if channels > 1 {
            return Err(PyTypeError::new_err(format!(
                "{name}: unsupported dtype {} for colours; pass uint8, or a grey image",
                array.dtype()
            )));
        }
        let values = contiguous::<u16>(name, &array)?;
        let values = values.as_slice().map_err(error)?;
        if let Some(max) = values.iter().max().filter(|max| **max > TEN_BITS) {
            let is = format!("has values above 10 bits, up to {max}");
            return Err(wrong(
                name,
                is,
                "pass values from 0 to 1023; of 16-bit images the upper 10 bits (>> 6)",
            ));
        }
        let images = values.chunks_exact(numbers);
        let one = |values: &[u16]| image(name, size, values.to_vec()).map(Recorded::Ten);
        images.map(one).collect::<PyResult<_>>()?
    } else {
        let values = contiguous::<u8>(name, &array)?;
        let values = values.as_slice().map_err(error)?;
        let images = values.chunks_exact(numbers);
        let one = |values: &[u8]| image(name, size, grey(values, channels)).map(Recorded::Eight);
        images.map(one).collect::<PyResult<_>>()?
    };
    Ok(Images {
        batch,
        size,
        is_wide,
        images,
    })
}

fn grey(values: &[u8], channels: usize) -> Vec<u8> {
    match channels {
        3 => values.as_chunks::<3>().0.iter().copied().map(luma).collect(),
        4 => {
            let colours = values.as_chunks::<4>().0.iter();
            colours.map(|&[r, g, b, _]| luma([r, g, b])).collect()
        }
        _ => values.to_vec(),
    }
}

/// The number of images of a batch, the size, and the number of channels.
fn shape(name: &str, array: &Bound<'_, PyUntypedArray>) -> PyResult<(Option<usize>, ImageSize, usize)> {
    let (batch, height, width, channels) = match *array.shape() {
        [height, width] => (None, height, width, 1),
        [height, width, channels @ (1 | 3 | 4)] => (None, height, width, channels),
        [count, height, width] => (Some(count), height, width, 1),
        [count, height, width, channels @ (1 | 3 | 4)] => (Some(count), height, width, channels),
        _ => {
            let is = format!("has shape {:?}", array.shape());
            return Err(wrong(
                name,
                is,
                "pass an image (H, W), colours (H, W, 3), or a batch (N, H, W)",
            ));
        }
    };
    let side = |length: usize| u32::try_from(length).unwrap_or(u32::MAX);
    let size = ImageSize::new(side(width), side(height));
    check_size(size).map_err(|found| error(format!("{name}: {found}")))?;
    Ok((batch, size, channels))
}

fn image<T: Element>(name: &str, size: ImageSize, values: Vec<T>) -> PyResult<Image<T>> {
    Image::new(size.width, size.height, values)
        .ok_or_else(|| wrong(name, "is smaller than its shape", "pass complete arrays"))
}

/// Returns an array (H, W): uint8, or uint16 with 10 bits.
pub(crate) fn recorded(py: Python<'_>, image: Recorded) -> PyResult<Bound<'_, PyAny>> {
    match image {
        Recorded::Eight(image) => array(py, image),
        Recorded::Ten(image) => array(py, image),
    }
}

/// Images of the same size, stacked as an array (N, H, W).
pub(crate) struct Stack<T> {
    count: usize,
    size: (u32, u32),
    values: Vec<T>,
}

impl<T: Element + Clone> Stack<T> {
    pub(crate) fn new(size: (u32, u32)) -> Self {
        Self {
            count: 0,
            size,
            values: Vec::new(),
        }
    }

    pub(crate) fn push(&mut self, image: &Image<T>) {
        self.count += 1;
        self.size = (image.width(), image.height());
        self.values.extend_from_slice(image.pixels());
    }

    pub(crate) fn array(self, py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
        let (width, height) = (self.size.0 as usize, self.size.1 as usize);
        let values = PyArray1::from_vec(py, self.values);
        Ok(values.reshape([self.count, height, width])?.into_any())
    }
}

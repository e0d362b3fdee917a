//! Grey images of a camera: 8 bits, or 10.

use numpy::{Element, PyUntypedArray, PyUntypedArrayMethods};
use oaktwin::camera::ImageSize;
use oaktwin::depth::imager::Recorded;
use oaktwin::image::Image;
use oaktwin::render::check_size;
use oaktwin::stereo::luma;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;

use crate::array::{contiguous, is_like, view};
use crate::error::{error, wrong};
use crate::images::array;

/// The largest number of 10 bits.
const TEN_BITS: u16 = 1023;

/// (H, W) uint8, or uint16 of 10 bits; colours (H, W, 3 or 4) uint8 become luma.
pub(crate) fn read(name: &str, object: &Bound<'_, PyAny>) -> PyResult<Recorded> {
    let array = view(name, object)?;
    let is_wide = is_like::<u16>(&array);
    if !is_wide && !is_like::<u8>(&array) {
        return Err(PyTypeError::new_err(format!(
            "{name}: its numbers are {}; give uint8, or uint16 of 10 bits",
            array.dtype()
        )));
    }
    let (size, channels) = shape(name, &array)?;
    if is_wide {
        if channels > 1 {
            return Err(PyTypeError::new_err(format!(
                "{name}: its colours are {}; give uint8, or grey",
                array.dtype()
            )));
        }
        let values = contiguous::<u16>(name, &array)?;
        let values = values.as_slice().map_err(error)?;
        if let Some(most) = values.iter().max().filter(|most| **most > TEN_BITS) {
            let is = format!("has numbers of more than 10 bits, up to {most}");
            return Err(wrong(name, is, "give 0 to 1023: of 16 bits the upper 10 (>> 6)"));
        }
        return image(name, size, values.to_vec()).map(Recorded::Ten);
    }
    let values = contiguous::<u8>(name, &array)?;
    let values = values.as_slice().map_err(error)?;
    let grey = match channels {
        3 => values.as_chunks::<3>().0.iter().copied().map(luma).collect(),
        4 => {
            let colours = values.as_chunks::<4>().0.iter();
            colours.map(|&[r, g, b, _]| luma([r, g, b])).collect()
        }
        _ => values.to_vec(),
    };
    image(name, size, grey).map(Recorded::Eight)
}

/// Rows and columns, and how many numbers a pixel has.
fn shape(name: &str, array: &Bound<'_, PyUntypedArray>) -> PyResult<(ImageSize, usize)> {
    let (height, width, channels) = match *array.shape() {
        [height, width] => (height, width, 1),
        [height, width, channels @ (1 | 3 | 4)] => (height, width, channels),
        _ => {
            let is = format!("has shape {:?}", array.shape());
            return Err(wrong(name, is, "give one image (H, W), or colours (H, W, 3)"));
        }
    };
    let side = |length: usize| u32::try_from(length).unwrap_or(u32::MAX);
    let size = ImageSize::new(side(width), side(height));
    check_size(size).map_err(|found| error(format!("{name}: {found}")))?;
    Ok((size, channels))
}

fn image<T: Element>(name: &str, size: ImageSize, values: Vec<T>) -> PyResult<Image<T>> {
    Image::new(size.width, size.height, values)
        .ok_or_else(|| wrong(name, "is smaller than its shape", "give whole arrays"))
}

/// As an array (H, W): uint8, or uint16 of 10 bits.
pub(crate) fn recorded(py: Python<'_>, image: Recorded) -> PyResult<Bound<'_, PyAny>> {
    match image {
        Recorded::Eight(image) => array(py, image),
        Recorded::Ten(image) => array(py, image),
    }
}

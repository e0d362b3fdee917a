use std::sync::{Mutex, PoisonError};

use oaktwin::camera::ImageSize;
use oaktwin::depth::filter::{self, Chain, Pixel, parse};
use oaktwin::image::{Image, ImageView};
use pyo3::prelude::*;
use pyo3::types::PyTuple;
use rayon::prelude::*;

use crate::error::{error, wrong};
use crate::images::{ImageShape, Numbers, NumbersSlice, Pictures, from_metres, part, put_metres, room};
use crate::settings::item_numbers;
use crate::threads;

/// Pixels of a batch between two checks for signals.
const PIXELS_AT_ONCE: usize = 1 << 23;

/// A chain of DepthAI's filters, bit-identical to its host implementation.
///
/// filters: the filters as text, NAME or NAME:SETTING=VALUE,..., in order; omitted settings have DepthAI's defaults:
///     "median:size=3|5|7", "spatial:alpha,delta,radius,iterations", "temporal:alpha,delta,persistency",
///     "speckle:range,difference", "decimation:factor,mode", "threshold:min,max" (mm), "brightness:min,max".
///
/// Raises oaktwin.Error for unknown names and settings, with the nearest names, and for invalid values.
///
/// A call, `filter(image, rgb=None, *, out=None)`, filters an image (H, W), the next of a sequence, or a batch (N, H, W), the
/// next images of N sequences.
///
/// image: uint16 (millimetres, or fixed-point disparity), uint8 (integer disparities) or float32 metres, which are
///     filtered as integer millimetres. 0 is invalid; in metres, so are values that are not finite and above 0, or beyond
///     65.535 m.
/// rgb: the colour images of the same camera, (..., H, W, 3 or 4) uint8, required by "brightness".
/// out: the output array: C-contiguous, with the result's shape and the image's dtype; must not overlap the image.
///
/// Returns `out`, or a new array of the same dtype; smaller if a filter decimates.
///
/// Raises TypeError for an object that is not an array or has another dtype, oaktwin.Error for an invalid shape.
///
/// A temporal filter remembers the (H, W) images of earlier calls, and of batches the images of each item, until the image size
/// changes; see `reset()`. Thread-safe; calls of one filter run one after another. Copies and pickles have the settings, but not
/// the state of temporal filters.
#[pyclass(frozen, module = "oaktwin")]
pub(crate) struct Filter {
    filters: Vec<filter::Filter>,
    wide: Mutex<Chains<u16>>,
    narrow: Mutex<Chains<u8>>,
}

/// The filters with their memory of images, and of each item of batches.
struct Chains<P> {
    of_images: Chain<P>,
    of_items: Vec<Chain<P>>,
}

impl<P: Pixel> Chains<P> {
    fn new(filters: &[filter::Filter]) -> Mutex<Self> {
        Mutex::new(Self {
            of_images: Chain::new(filters.to_vec()),
            of_items: Vec::new(),
        })
    }

    /// Forgets the images of some items, or all images.
    fn reset(&mut self, items: Option<&[usize]>) {
        match items {
            None => {
                self.of_images.reset();
                self.of_items.clear();
            }
            Some(items) => {
                for item in items {
                    if let Some(chain) = self.of_items.get_mut(*item) {
                        chain.reset();
                    }
                }
            }
        }
    }
}

#[pymethods]
impl Filter {
    #[new]
    #[pyo3(signature = (*filters))]
    #[expect(clippy::needless_pass_by_value, reason = "required by PyO3")]
    fn new(filters: Vec<String>) -> PyResult<Self> {
        let parsed = filters.iter().map(|text| parse(text).map_err(error));
        let filters: Vec<filter::Filter> = parsed.collect::<PyResult<_>>()?;
        Ok(Self {
            wide: Chains::new(&filters),
            narrow: Chains::new(&filters),
            filters,
        })
    }

    fn __getnewargs__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, self.filters.iter().map(ToString::to_string))
    }

    /// Filters an image or a batch; see the class.
    #[pyo3(name = "_call", signature = (image, rgb = None, *, out = None))]
    fn call<'py>(
        &self,
        py: Python<'py>,
        image: &Bound<'py, PyAny>,
        rgb: Option<&Bound<'py, PyAny>>,
        out: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let (numbers, shape) = Numbers::read("image", image)?;
        if let Some(filter) = self
            .filters
            .iter()
            .find(|filter| rgb.is_none() && filter.needs_rgb())
        {
            let is = format!("is required by the filter {}", filter.name());
            return Err(wrong("rgb", is, "pass the colour image of the same camera"));
        }
        let pictures = rgb.map(|rgb| Pictures::read(rgb, shape)).transpose()?;
        let rgb = pictures.as_ref().map(Pictures::rgba).transpose()?;
        let rgb = rgb.as_deref();
        let (width, height) =
            Chain::<u16>::new(self.filters.clone()).size(shape.size.width, shape.size.height);
        let dims = shape.sized(ImageSize::new(width, height)).dims();
        match numbers.slice()? {
            NumbersSlice::U8(values) => {
                let (result, mut room) = room::<u8>(py, out, &dims, values)?;
                let room = room.as_slice_mut().map_err(error)?;
                run(py, &self.narrow, values, rgb, shape, room)?;
                Ok(result)
            }
            NumbersSlice::U16(values) => {
                let (result, mut room) = room::<u16>(py, out, &dims, values)?;
                let room = room.as_slice_mut().map_err(error)?;
                run(py, &self.wide, values, rgb, shape, room)?;
                Ok(result)
            }
            NumbersSlice::F32(values) => {
                let (result, mut room) = room::<f32>(py, out, &dims, values)?;
                let room = room.as_slice_mut().map_err(error)?;
                let whole = py.detach(|| from_metres(values.to_vec()));
                let mut filtered = Vec::new();
                filtered.try_reserve_exact(room.len()).map_err(|_| no_room())?;
                filtered.resize(room.len(), 0);
                run(py, &self.wide, &whole, rgb, shape, &mut filtered)?;
                py.detach(|| put_metres(&filtered, room));
                Ok(result)
            }
        }
    }

    /// Starts a new sequence: temporal filters forget earlier images.
    ///
    /// items: the numbers of the items of batches that start a new sequence, or a mask; the others, and the (H, W) images, go on.
    #[pyo3(signature = (items = None))]
    fn reset(&self, py: Python<'_>, items: Option<&Bound<'_, PyAny>>) -> PyResult<()> {
        let items = items.map(|items| item_numbers("items", items)).transpose()?;
        let items = items.as_deref();
        py.detach(|| {
            self.wide
                .lock()
                .unwrap_or_else(PoisonError::into_inner)
                .reset(items);
            self.narrow
                .lock()
                .unwrap_or_else(PoisonError::into_inner)
                .reset(items);
        });
        Ok(())
    }

    /// The filters as text, with all settings.
    fn __str__(&self) -> String {
        let texts: Vec<String> = self.filters.iter().map(ToString::to_string).collect();
        texts.join(" ")
    }

    fn __repr__(&self) -> String {
        format!("<oaktwin.Filter {}>", self.__str__())
    }
}

fn no_room() -> PyErr {
    wrong(
        "image",
        "the result does not fit in memory",
        "pass fewer images at once",
    )
}

/// Filters images into an array of the result's size.
fn run<P: Pixel>(
    py: Python<'_>,
    chains: &Mutex<Chains<P>>,
    values: &[P],
    rgb: Option<&[[u8; 4]]>,
    shape: ImageShape,
    room: &mut [P],
) -> PyResult<()> {
    let ImageSize { width, height } = shape.size;
    let pixels = shape.pixels();
    let one = |chain: &mut Chain<P>, item: usize| {
        let image = Image::new(width, height, part(values, item * pixels, pixels).to_vec());
        let image = image.unwrap_or_else(|| Image::filled(width, height, P::default()));
        let rgb = rgb.map(|rgb| part(rgb, item * pixels, pixels));
        let rgb = rgb.and_then(|rgb| ImageView::new(width, height, rgb));
        chain.run_seeing(image, rgb)
    };
    let put = |image: &Image<P>, room: &mut [P]| {
        // Both have the chain's input size.
        let both = room.iter_mut().zip(image.pixels());
        both.for_each(|(room, value)| *room = *value);
    };
    let lock = || chains.lock().unwrap_or_else(PoisonError::into_inner);
    if shape.batch.is_none() {
        return py.detach(|| {
            // Locked before entering the pool, so that the pool's threads never wait for the lock.
            let mut chains = lock();
            let chain = &mut chains.of_images;
            put(&threads::install(|| one(chain, 0))?, room);
            Ok(())
        });
    }
    let out_pixels = (room.len() / shape.count().max(1)).max(1);
    let at_once = (PIXELS_AT_ONCE / pixels).max(1);
    for (part, room) in room.chunks_mut(at_once * out_pixels).enumerate() {
        py.check_signals()?;
        let first = part * at_once;
        py.detach(|| {
            let mut chains = lock();
            let Chains { of_images, of_items } = &mut *chains;
            let end = first + room.len() / out_pixels;
            if of_items.len() < end {
                let mut fresh = of_images.clone();
                fresh.reset();
                of_items.resize(end, fresh);
            }
            let chains = of_items.get_mut(first..end).unwrap_or_default();
            threads::install(|| {
                let items = chains.par_iter_mut().zip(room.par_chunks_mut(out_pixels));
                let items = items.enumerate();
                items.for_each(|(item, (chain, room))| put(&one(chain, first + item), room));
            })
        })?;
    }
    Ok(())
}

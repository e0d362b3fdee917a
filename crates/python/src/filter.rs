use std::sync::{Mutex, PoisonError};

use numpy::{Element, PyArray1, PyArrayMethods};
use oaktwin::camera::ImageSize;
use oaktwin::depth::filter::{self, Chain, Pixel, parse};
use oaktwin::image::{Image, ImageView};
use pyo3::prelude::*;
use rayon::prelude::*;

use crate::error::{error, wrong};
use crate::images::{Numbers, NumbersSlice, Pictures, Shape, from_metres, part, to_metres};
use crate::threads;

/// Pixels of a batch between two looks at the signals.
const PIXELS_AT_ONCE: usize = 1 << 23;

/// DepthAI's filters, first to last, bit for bit as its host runs them.
///
/// filters: each as text, NAME or NAME:SETTING=VALUE,...; what is not said has DepthAI's default:
///     "median:size=3|5|7", "spatial:alpha,delta,radius,iterations", "temporal:alpha,delta,persistency",
///     "speckle:range,difference", "decimation:factor,mode", "threshold:min,max" (mm), "brightness:min,max".
///
/// Raises oaktwin.Error for a name or setting that does not exist, with the nearest ones, or a value that cannot be.
///
/// A call, `filter(image, rgb=None)`, filters an image (H, W), the next of a sequence, or a batch (N, H, W) of images that have no past.
///
/// image: uint16 (millimetres, or disparity in fixed point), uint8 (whole disparities) or float32 metres, which are
///     filtered as whole millimetres. 0 is no value; in metres neither is what is not finite and above 0, or beyond
///     65.535 m.
/// rgb: the pictures of the same camera, (..., H, W, 3 or 4) uint8: what "brightness" looks at.
///
/// Returns a new array of the same type; smaller where a filter decimates.
///
/// Raises TypeError for what is no array or of another type, oaktwin.Error for another shape.
///
/// Safe to use from many threads; the frames of one filter wait for each other.
#[pyclass(frozen, module = "oaktwin")]
pub(crate) struct Filter {
    filters: Vec<filter::Filter>,
    wide: Mutex<Chain<u16>>,
    narrow: Mutex<Chain<u8>>,
}

#[pymethods]
impl Filter {
    #[new]
    #[pyo3(signature = (*filters))]
    #[expect(clippy::needless_pass_by_value, reason = "what PyO3 hands over")]
    fn new(filters: Vec<String>) -> PyResult<Self> {
        let parsed = filters.iter().map(|text| parse(text).map_err(error));
        let filters: Vec<filter::Filter> = parsed.collect::<PyResult<_>>()?;
        Ok(Self {
            wide: Mutex::new(Chain::new(filters.clone())),
            narrow: Mutex::new(Chain::new(filters.clone())),
            filters,
        })
    }

    /// See the class.
    #[pyo3(signature = (image, rgb = None))]
    fn __call__<'py>(
        &self,
        py: Python<'py>,
        image: &Bound<'py, PyAny>,
        rgb: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let (numbers, shape) = Numbers::read("image", image)?;
        let pictures = rgb.map(|rgb| Pictures::read(rgb, shape)).transpose()?;
        let rgb = pictures.as_ref().map(Pictures::rgba).transpose()?;
        let rgb = rgb.as_deref();
        match numbers.slice()? {
            NumbersSlice::U8(values) => {
                let (filtered, dims) = run(py, &self.narrow, values, rgb, shape)?;
                array(py, filtered, dims)
            }
            NumbersSlice::U16(values) => {
                let (filtered, dims) = run(py, &self.wide, values, rgb, shape)?;
                array(py, filtered, dims)
            }
            NumbersSlice::F32(values) => {
                let whole = py.detach(|| from_metres(values.to_vec()));
                let (filtered, dims) = run(py, &self.wide, &whole, rgb, shape)?;
                array(py, py.detach(|| to_metres(&filtered)), dims)
            }
        }
    }

    /// Forgets all earlier images.
    fn reset(&self, py: Python<'_>) {
        py.detach(|| {
            self.wide.lock().unwrap_or_else(PoisonError::into_inner).reset();
            self.narrow.lock().unwrap_or_else(PoisonError::into_inner).reset();
        });
    }

    /// As text, with all settings.
    fn __str__(&self) -> String {
        let texts: Vec<String> = self.filters.iter().map(ToString::to_string).collect();
        texts.join(" ")
    }

    fn __repr__(&self) -> String {
        format!("<oaktwin.Filter {}>", self.__str__())
    }
}

fn array<T: Element>(py: Python<'_>, values: Vec<T>, dims: Vec<usize>) -> PyResult<Bound<'_, PyAny>> {
    Ok(PyArray1::from_vec(py, values).reshape(dims)?.into_any())
}

/// The filtered images, and their shape.
fn run<P: Pixel>(
    py: Python<'_>,
    chain: &Mutex<Chain<P>>,
    values: &[P],
    rgb: Option<&[[u8; 4]]>,
    shape: Shape,
) -> PyResult<(Vec<P>, Vec<usize>)> {
    let ImageSize { width, height } = shape.size;
    let pixels = shape.pixels();
    let one = |chain: &mut Chain<P>, item: usize| {
        let image = Image::new(width, height, part(values, item * pixels, pixels).to_vec());
        let image = image.unwrap_or_else(|| Image::filled(width, height, P::default()));
        let rgb = rgb.map(|rgb| part(rgb, item * pixels, pixels));
        let rgb = rgb.and_then(|rgb| ImageView::new(width, height, rgb));
        chain.run_seeing(image, rgb)
    };
    let lock = || chain.lock().unwrap_or_else(PoisonError::into_inner);
    if shape.batch.is_none() {
        return py.detach(|| {
            // Taken before the pool's threads are: they never wait for it.
            let mut chain = lock();
            let chain = &mut *chain;
            let image = threads::install(|| one(chain, 0))?;
            let dims = shape.sized(ImageSize::new(image.width(), image.height())).dims();
            Ok((image.into_pixels(), dims))
        });
    }
    let mut fresh = py.detach(|| lock().clone());
    fresh.reset();
    let (out_width, out_height) = fresh.size(width, height);
    let dims = shape.sized(ImageSize::new(out_width, out_height)).dims();
    let mut filtered: Vec<P> = Vec::new();
    let room = out_width as usize * out_height as usize * shape.count();
    filtered.try_reserve_exact(room).map_err(|_| {
        wrong(
            "image",
            "its result does not fit into the memory",
            "give fewer images at once",
        )
    })?;
    let at_once = (PIXELS_AT_ONCE / pixels).max(1);
    for first in (0..shape.count()).step_by(at_once) {
        py.check_signals()?;
        let items = first..(first + at_once).min(shape.count());
        let images: Vec<Image<P>> = threads::run(py, || {
            items
                .into_par_iter()
                .map(|item| one(&mut fresh.clone(), item))
                .collect()
        })?;
        images
            .iter()
            .for_each(|image| filtered.extend_from_slice(image.pixels()));
    }
    Ok((filtered, dims))
}

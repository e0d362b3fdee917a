//! Engines written in Python.
//!
//! An engine is called on the thread that called oaktwin, whichever threads do the rest of the work: see [`Desk`].

mod desk;

use std::fmt;
use std::sync::Arc;

use numpy::PyReadonlyArray2;
use oaktwin::camera::StereoGeometry;
use oaktwin::depth::filter::Chain;
use oaktwin::depth::random::{NoiseStage, Numbers, Stream};
use oaktwin::depth::stereo_matching::LuminanceImage;
use oaktwin::image::annotation::Annotator;
use oaktwin::image::{Image, ImageView, ZDepth};
use oaktwin::sensor::{
    Capture, Engine, EngineInput, EngineKind, EngineRef, Factory, Input, ParameterError, SensorOptions,
    Setup, Technology,
};
use pyo3::prelude::*;
use pyo3::types::PyDict;

pub(crate) use desk::{away, serve_all};

use crate::error::error;
use crate::images::{array, colours};
use desk::Desk;

/// The largest disparities that an OAK searches, px: the range in which the settings of filters are.
const RANGE_PX: [u32; 2] = [95, 190];

/// An engine written in Python.
pub(crate) struct PythonEngine {
    /// What was passed.
    pub(crate) object: Py<PyAny>,
    /// The `oaktwin._engines.Adapter`.
    adapter: Py<PyAny>,
    name: String,
    input: EngineInput,
    desk: Desk,
}

impl PythonEngine {
    /// Returns the engine of a callable.
    pub(crate) fn of(object: &Bound<'_, PyAny>) -> PyResult<EngineRef> {
        let adapter = object.py().import("oaktwin._engines")?.getattr("Adapter")?;
        let adapter = adapter.call1((object,))?;
        let input = match adapter.getattr("is_pair")?.extract()? {
            true => EngineInput::Pair,
            false => EngineInput::Depth,
        };
        let engine = Self {
            object: object.clone().unbind(),
            name: adapter.getattr("name")?.extract()?,
            adapter: adapter.unbind(),
            input,
            desk: Desk::default(),
        };
        Ok(kind(&Arc::new(engine)).into())
    }

    /// Returns the engine of options, if it is written in Python.
    pub(crate) fn in_options(options: &SensorOptions) -> Option<Arc<Self>> {
        options.engine.as_ref().and_then(Self::behind)
    }

    /// Returns an engine, if it is written in Python.
    pub(crate) fn behind(engine: &EngineRef) -> Option<Arc<Self>> {
        let EngineRef::Shared(kind) = engine else {
            return None;
        };
        let engine = kind.create(&Setup::new(1.0, 1, 1.0)).ok()?;
        Some(Arc::clone(&engine.downcast_ref::<Running>()?.engine))
    }

    /// Calls the engine with the interpreter held.
    fn answer(&self, py: Python<'_>, request: Request) -> PyResult<Answer> {
        let given = PyDict::new(py);
        given.set_item("focal_length", request.stereo.focal_length_px)?;
        let baseline_m = request.stereo.baseline_m;
        given.set_item("baseline", (baseline_m > 0.0).then_some(baseline_m))?;
        match request.images {
            Images::Pair([left, right]) => {
                given.set_item("left", left.array(py)?)?;
                given.set_item("right", right.array(py)?)?;
            }
            Images::Depth {
                depth,
                rgb,
                frame,
                seed,
            } => {
                given.set_item("depth", array(py, depth)?)?;
                given.set_item("rgb", rgb.map(|rgb| colours(py, rgb)).transpose()?)?;
                given.set_item("frame", frame)?;
                given.set_item("seed", seed)?;
            }
        }
        let measured = self.adapter.bind(py).call_method1("measure", (given,))?;
        let (is_disparity, image, confidence): (
            bool,
            PyReadonlyArray2<'_, f32>,
            Option<PyReadonlyArray2<'_, u8>>,
        ) = measured.extract()?;
        Ok(Answer {
            is_disparity,
            image: copied(&image)?,
            confidence: confidence.map(|image| copied(&image)).transpose()?,
        })
    }
}

fn copied<T: numpy::Element + Copy>(array: &PyReadonlyArray2<'_, T>) -> PyResult<Image<T>> {
    use numpy::PyUntypedArrayMethods;
    let [height, width] = [array.shape()[0], array.shape()[1]].map(|side| u32::try_from(side).unwrap_or(0));
    let values = array.as_slice().map_err(error)?.to_vec();
    Image::new(width, height, values).ok_or_else(|| error("engine: an image is larger than its input"))
}

impl fmt::Debug for PythonEngine {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("PythonEngine").field(&self.name).finish()
    }
}

/// The kind of an engine.
fn kind(engine: &Arc<PythonEngine>) -> EngineKind {
    let engine = Arc::clone(engine);
    EngineKind {
        name: engine.name.clone().into(),
        help: "An engine written in Python".into(),
        input: engine.input,
        models: (engine.input == EngineInput::Pair).then_some(Technology::Stereo),
        is_default: false,
        parameters: Vec::new,
        factory: Factory::Closure(Arc::new(move |setup| {
            Ok(Arc::new(Running {
                kind: kind(&engine),
                engine: Arc::clone(&engine),
                stereo: setup.stereo(),
                width_px: setup.width_px,
                range_px: RANGE_PX[usize::from(setup.extended_disparity)],
            }))
        })),
    }
}

/// An engine at the geometry of a sensor.
#[derive(Debug)]
struct Running {
    kind: EngineKind,
    engine: Arc<PythonEngine>,
    /// The geometry at this width of the images; without a pair, the baseline is 0.
    stereo: StereoGeometry,
    width_px: u32,
    range_px: u32,
}

impl PartialEq for Running {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.engine, &other.engine)
            && (self.stereo, self.width_px, self.range_px) == (other.stereo, other.width_px, other.range_px)
    }
}

impl Running {
    /// The geometry at a width of the images.
    fn stereo(&self, width_px: u32) -> StereoGeometry {
        let scale = f64::from(width_px) / f64::from(self.width_px.max(1));
        StereoGeometry {
            focal_length_px: self.stereo.focal_length_px * scale,
            ..self.stereo
        }
    }
}

impl Engine for Running {
    fn kind(&self) -> &EngineKind {
        &self.kind
    }

    fn disparity_times_depth(&self, width_px: u32) -> f64 {
        let stereo = self.stereo(width_px);
        match self.kind.input {
            EngineInput::Pair => stereo.focal_length_px * stereo.baseline_m,
            EngineInput::Depth => 0.0,
        }
    }

    fn outputs(&self) -> &'static [Annotator] {
        &[Annotator::DepthSensorConfidence]
    }

    fn capture(
        &self,
        input: &Input<'_>,
        random: &Stream,
        request: &[Annotator],
        filters: &mut Chain,
    ) -> Result<Capture, ParameterError> {
        let images = match self.kind.input {
            EngineInput::Pair => Images::of_pair(input, &self.kind)?,
            EngineInput::Depth => Images::of_depth(input, &self.kind, random)?,
        };
        let stereo = self.stereo(images.width());
        let answer = self.engine.ask(Request { images, stereo })?;
        let mut capture = if answer.is_disparity {
            Capture::of_disparity(&answer.image, stereo, self.range_px, input, filters)
        } else {
            Capture::of_depth(ZDepth(answer.image), input, filters)
        };
        let wants = |annotator| request.contains(&annotator);
        if let Some(confidence) = answer.confidence {
            let levels = wants(Annotator::DepthSensorConfidence);
            let levels = levels.then(|| confidence.map(|&byte| u16::from(byte)));
            capture.add(Annotator::DepthSensorConfidence, levels);
            let bytes = wants(Annotator::Confidence).then_some(confidence);
            capture.add(Annotator::Confidence, bytes);
        }
        Ok(capture)
    }
}

/// What an engine is called with.
struct Request {
    images: Images,
    stereo: StereoGeometry,
}

/// The input of an engine.
enum Images {
    Pair([Grey; 2]),
    Depth {
        depth: Image<f32>,
        rgb: Option<Image<[u8; 4]>>,
        frame: u64,
        /// A number that differs between seeds, cameras, frames and items.
        seed: u64,
    },
}

/// A grey image of 8 or 10 bits.
enum Grey {
    Eight(Image<u8>),
    Ten(Image<u16>),
}

/// What an engine returned.
struct Answer {
    is_disparity: bool,
    /// Disparity in px, or depth in metres; 0 where nothing is measured.
    image: Image<f32>,
    confidence: Option<Image<u8>>,
}

impl Grey {
    fn of(image: &LuminanceImage<'_>) -> Self {
        match image {
            LuminanceImage::Bits8(image) => Self::Eight(owned(image)),
            LuminanceImage::Bits10(image) => Self::Ten(owned(image)),
        }
    }

    fn array(self, py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
        match self {
            Self::Eight(image) => array(py, image),
            Self::Ten(image) => array(py, image),
        }
    }

    fn width(&self) -> u32 {
        match self {
            Self::Eight(image) => image.width(),
            Self::Ten(image) => image.width(),
        }
    }
}

impl Images {
    fn of_pair(input: &Input<'_>, kind: &EngineKind) -> Result<Self, ParameterError> {
        let pair = input.pair(kind)?;
        Ok(Self::Pair([Grey::of(&pair.left()), Grey::of(&pair.right())]))
    }

    fn of_depth(input: &Input<'_>, kind: &EngineKind, random: &Stream) -> Result<Self, ParameterError> {
        let shot = input.shot(kind)?;
        let plane = random.plane(NoiseStage::Engine, shot.frame, shot.item);
        Ok(Self::Depth {
            depth: owned(&shot.depth()),
            rgb: shot.rgb().map(|rgb| owned(&rgb)),
            frame: shot.frame,
            seed: Numbers::new(plane).bits(),
        })
    }

    fn width(&self) -> u32 {
        match self {
            Self::Pair([left, _]) => left.width(),
            Self::Depth { depth, .. } => depth.width(),
        }
    }
}

fn owned<T: Copy + Default>(view: &ImageView<'_, T>) -> Image<T> {
    let pixels = view.pixels().to_vec();
    let image = Image::new(view.width(), view.height(), pixels);
    image.unwrap_or_else(|| Image::filled(0, 0, T::default()))
}

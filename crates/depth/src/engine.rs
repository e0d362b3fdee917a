use std::any::Any;
use std::fmt;
use std::sync::Arc;

use oaktwin_base::diagnostic::Finding;
use oaktwin_camera::Intrinsics;
use oaktwin_image::ZDepth;
use oaktwin_image::annotation::Annotator;

use crate::disparity::Subpixel;
use crate::filter::Chain;
use crate::random::Stream;
use crate::stereo_matching::Pair;
use crate::{BatchError, Capture, ParameterError, Setup, Shot};

/// A model of a depth sensor: it turns ground truth, or the images of a stereo pair, into measured depth.
///
/// Engines are immutable; a [`Sensor`](crate::Sensor) adds filters, which may remember earlier frames. The methods with
/// a default body describe properties that only some engines have.
pub trait Engine: Comparable + fmt::Debug + Send + Sync {
    /// The entry of [`ENGINES`](crate::engines::ENGINES).
    fn kind(&self) -> &'static EngineKind;

    /// The parameters by name, with their values as text.
    fn parameters(&self) -> Vec<(&'static str, String)>;

    /// Choices that the sensor's documentation leaves open, by name, with their values as text.
    fn assumptions(&self) -> Vec<(&'static str, String)> {
        Vec::new()
    }

    /// The outputs besides the distance.
    fn outputs(&self) -> &'static [Annotator] {
        &[]
    }

    /// Whether an output requires the colour image.
    fn needs_rgb(&self, output: Annotator) -> bool {
        matches!(
            output,
            Annotator::DepthSensorImager | Annotator::DepthSensorPointCloudColor
        )
    }

    /// The smallest distance that can be measured in images of a width, metres.
    fn nearest_m(&self, width_px: u32) -> f64;

    /// How many pixels around a pixel affect it, besides those within [`Engine::reach_px`].
    fn support_px(&self) -> u32;

    /// Disparity times depth in the pixels in which the engine counts disparity, px·m; 0 without disparity.
    fn disparity_times_depth(&self, _width_px: u32) -> f64 {
        0.0
    }

    /// The disparity of a surface in pixels of an image of a width; 0 without disparity.
    fn reach_px(&self, _width_px: u32, _distance_m: f64) -> f64 {
        0.0
    }

    /// The distance in metres by which the viewpoint of the reported image lies to the left of the camera's.
    fn lateral_shift_m(&self, _camera: &Intrinsics) -> f64 {
        0.0
    }

    /// The fractional bits of disparity; `None` without a fixed-point disparity.
    fn subpixel(&self) -> Option<Subpixel> {
        None
    }

    /// The distance between the cameras of the pair that the engine requires, metres.
    fn baseline_m(&self) -> Option<f64> {
        None
    }

    /// Whether images of this width cannot be cropped, because the engine resamples them to another width.
    fn needs_full_width(&self, _width_px: u32) -> bool {
        false
    }

    /// Whether images of this size are measured on several threads.
    fn is_parallel(&self, _width_px: u32, _height_px: u32) -> bool {
        true
    }

    /// Returns the engine for a crop of an image that is `width_px` wide, or `None` if this engine fits the crop.
    ///
    /// # Errors
    /// Returns an error if a parameter is out of range for the crop.
    fn crop(&self, width_px: u32, crop: &Intrinsics) -> Result<Option<Arc<dyn Engine>>, ParameterError>;

    /// Reports problems of an input that make its depth unreliable.
    fn inspect(&self, _input: &Input<'_>) -> Vec<Finding> {
        Vec::new()
    }

    /// Reports the given parameters that have no effect on this engine.
    fn without_effect(&self, _place: &str, _names: &[&str]) -> Option<Finding> {
        None
    }

    /// Measures an input and runs the filters. Of the extra outputs, those in `request` are made if the input suffices.
    ///
    /// # Errors
    /// Returns an error if the engine requires another kind of input.
    fn capture(
        &self,
        input: &Input<'_>,
        random: &Stream,
        request: &[Annotator],
        filters: &mut Chain,
    ) -> Result<Capture, ParameterError>;

    /// The faster way of measuring batches than one image after another, if the engine has one.
    fn batches(&self) -> Option<&dyn BatchEngine> {
        None
    }
}

/// An engine that measures batches of small images faster than one after another.
pub trait BatchEngine {
    /// Measures a batch `[count, height, width]` of depth images of one frame as [`Engine::capture`] does without colour and
    /// filters; items count from `first_item`. Metres in and out.
    ///
    /// # Errors
    /// Returns an error if the length of `depth` or `out` does not match the shape.
    fn sense_batch(
        &self,
        depth: &[f32],
        shape: [usize; 3],
        frame: u64,
        first_item: u32,
        random: &Stream,
        out: &mut [f32],
    ) -> Result<(), BatchError>;
}

impl dyn Engine {
    /// Returns the engine as its own type, or `None` if it is another engine.
    #[must_use]
    pub fn downcast_ref<E: Engine>(&self) -> Option<&E> {
        let any: &dyn Any = self;
        any.downcast_ref()
    }
}

impl PartialEq for dyn Engine {
    fn eq(&self, other: &Self) -> bool {
        self.equals(other)
    }
}

/// A type whose values can be compared with values of any type.
pub trait Comparable: Any {
    /// Whether the other value has the same type and is equal.
    fn equals(&self, other: &dyn Any) -> bool;
}

impl<T: Any + PartialEq> Comparable for T {
    fn equals(&self, other: &dyn Any) -> bool {
        other.downcast_ref() == Some(self)
    }
}

/// An entry of the registry of engines.
#[derive(Debug)]
pub struct EngineKind {
    /// The name in options and files: `stereo-noise`.
    pub name: &'static str,
    /// One line of help.
    pub help: &'static str,
    /// The required input.
    pub input: EngineInput,
    /// The technology of the cameras that the engine models; `None` if it models no physical device.
    pub models: Option<Technology>,
    /// Whether the engine is the default for cameras of that technology.
    pub is_default: bool,
    /// The names of all parameters.
    pub parameters: fn() -> Vec<&'static str>,
    /// Creates the engine; the setup's parameters are named as in `parameters`.
    pub(crate) create: fn(&Setup) -> Result<Arc<dyn Engine>, ParameterError>,
}

impl PartialEq for EngineKind {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

impl Eq for EngineKind {}

impl fmt::Display for EngineKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name)
    }
}

/// The measuring principle of a depth camera.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Technology {
    /// A stereo pair.
    Stereo,
    /// Time of flight.
    TimeOfFlight,
}

/// The kind of input that an engine requires.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EngineInput {
    /// A depth image, with or without a colour image.
    Depth,
    /// A rectified stereo pair.
    Pair,
}

/// The input of an engine.
#[derive(Clone, Copy, Debug)]
pub enum Input<'a> {
    /// A depth image and its companions.
    Depth(Shot<'a>),
    /// A rectified stereo pair.
    Pair(Pair<'a>),
}

impl<'a> From<Shot<'a>> for Input<'a> {
    fn from(shot: Shot<'a>) -> Self {
        Self::Depth(shot)
    }
}

impl<'a> From<&Shot<'a>> for Input<'a> {
    fn from(shot: &Shot<'a>) -> Self {
        Self::Depth(*shot)
    }
}

impl<'a> From<Pair<'a>> for Input<'a> {
    fn from(pair: Pair<'a>) -> Self {
        Self::Pair(pair)
    }
}

impl<'a> Input<'a> {
    pub(crate) fn shot(&self, engine: &'static EngineKind) -> Result<&Shot<'a>, ParameterError> {
        match self {
            Self::Depth(shot) => Ok(shot),
            Self::Pair(_) => Err(wrong_input(engine)),
        }
    }

    pub(crate) fn pair(&self, engine: &'static EngineKind) -> Result<&Pair<'a>, ParameterError> {
        match self {
            Self::Depth(_) => Err(wrong_input(engine)),
            Self::Pair(pair) => Ok(pair),
        }
    }
}

fn wrong_input(engine: &EngineKind) -> ParameterError {
    let (required, remedy) = match engine.input {
        EngineInput::Depth => ("a depth image", "pass a depth image, or choose stereo-matching"),
        EngineInput::Pair => ("a stereo pair", "pass a rectified pair, or choose another engine"),
    };
    ParameterError::new("engine", format!("{engine} requires {required}"), remedy)
}

impl Capture {
    /// Creates a capture of a distance image and its filtered version, if filters ran.
    pub(crate) fn new(unfiltered: ZDepth, filtered: Option<ZDepth>) -> Self {
        let (distance, unfiltered) = match filtered {
            Some(filtered) => (filtered, Some(unfiltered)),
            None => (unfiltered, None),
        };
        Self {
            distance,
            unfiltered,
            extras: Vec::new(),
        }
    }
}

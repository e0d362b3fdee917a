use std::any::Any;
use std::fmt;
use std::sync::Arc;

use oaktwin_base::diagnostic::Finding;
use oaktwin_camera::Intrinsics;
use oaktwin_image::annotation::Annotator;

use crate::disparity::Subpixel;
use crate::filter::Chain;
use crate::random::Stream;
use crate::stereo_matching::RectifiedPair;
use crate::{BatchError, Capture, DepthShot, EngineInput, EngineKind, ParameterError};

/// A model of a depth sensor: it turns ground truth, or the images of a stereo pair, into measured depth.
///
/// Engines are immutable; a [`Sensor`](crate::Sensor) adds filters, which may remember earlier frames. Only [`Engine::kind`] and
/// [`Engine::capture`] are required, and [`Capture::of_depth`] or [`Capture::of_disparity`] is what the latter returns; the other methods
/// describe properties that only some engines have. Where they are left out, `accuracy` measures whole images.
pub trait Engine: Comparable + fmt::Debug + Send + Sync {
    /// The kind of the engine.
    fn kind(&self) -> &EngineKind;

    /// The parameters by name, with their values as text.
    fn parameters(&self) -> Vec<(&'static str, String)> {
        Vec::new()
    }

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

    /// The smallest distance that can be measured in images of a width, metres; 0 if it is not known.
    fn nearest_m(&self, _width_px: u32) -> f64 {
        0.0
    }

    /// How many pixels around a pixel affect it, besides those within [`Engine::reach_px`]: by default, all of the image.
    fn support_px(&self) -> u32 {
        u32::MAX
    }

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

    /// How long ago each of the two measurements was that a frame combines, s; `None` if there is one.
    fn ages_s(&self) -> Option<[f64; 2]> {
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

    /// Returns the engine for a crop of an image that is `width_px` wide, or `None` if this engine fits the crop. Images are cropped
    /// only as far as [`Engine::support_px`] and [`Engine::needs_full_width`] permit.
    ///
    /// # Errors
    /// Returns an error if a parameter is out of range for the crop.
    fn crop(&self, _width_px: u32, _crop: &Intrinsics) -> Result<Option<Arc<dyn Engine>>, ParameterError> {
        Ok(None)
    }

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

/// The input of an engine.
#[derive(Clone, Copy, Debug)]
pub enum Input<'a> {
    /// A depth image and its companions.
    Depth(DepthShot<'a>),
    /// A rectified stereo pair.
    Pair(RectifiedPair<'a>),
}

impl<'a> From<DepthShot<'a>> for Input<'a> {
    fn from(shot: DepthShot<'a>) -> Self {
        Self::Depth(shot)
    }
}

impl<'a> From<&DepthShot<'a>> for Input<'a> {
    fn from(shot: &DepthShot<'a>) -> Self {
        Self::Depth(*shot)
    }
}

impl<'a> From<RectifiedPair<'a>> for Input<'a> {
    fn from(pair: RectifiedPair<'a>) -> Self {
        Self::Pair(pair)
    }
}

impl<'a> Input<'a> {
    /// Returns the depth image.
    ///
    /// # Errors
    /// Returns an error that names the engine if the input is a pair.
    pub fn shot(&self, engine: &EngineKind) -> Result<&DepthShot<'a>, ParameterError> {
        match self {
            Self::Depth(shot) => Ok(shot),
            Self::Pair(_) => Err(wrong_input(engine)),
        }
    }

    /// Returns the stereo pair.
    ///
    /// # Errors
    /// Returns an error that names the engine if the input is a depth image.
    pub fn pair(&self, engine: &EngineKind) -> Result<&RectifiedPair<'a>, ParameterError> {
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

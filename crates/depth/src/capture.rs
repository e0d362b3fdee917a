use oaktwin_image::annotation::Annotator;
use oaktwin_image::{Image, ZDepth};

use crate::filter::Chain;
use crate::reason::ReasonCodes;

/// The output of a sensor for one input. All images have one size, and show what the
/// [output camera](crate::Sensor::output_camera) sees.
#[derive(Clone, Debug, PartialEq)]
pub struct Capture {
    /// Metres along the optical axis, 0 where nothing was measured. Filters that decimate make it smaller than the
    /// input: [`Chain::size`](crate::filter::Chain::size).
    pub distance: ZDepth,
    /// The distance before filters of depth, if some ran.
    pub unfiltered: Option<ZDepth>,
    /// The requested outputs that the engine could make of the input.
    pub extras: Vec<(Annotator, CaptureLayer)>,
}

/// An output besides the distance.
#[derive(Clone, Debug, PartialEq)]
pub enum CaptureLayer {
    /// One byte per pixel, such as a matcher's confidence.
    Bytes(Image<u8>),
    /// One whole number per pixel, such as an engine's confidence.
    Levels(Image<u16>),
    /// One number per pixel, such as luminance.
    Floats(Image<f32>),
    /// sRGB with alpha.
    Colors(Image<[u8; 4]>),
    /// Homogeneous points: x, y and z in metres, and 1.
    Points(Image<[f32; 4]>),
    /// Fixed-point disparity.
    Disparity(FixedDisparity),
    /// Why pixels have no value.
    Reasons(ReasonCodes),
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

    /// Whether filters of depth changed the distance. Then [`Capture::extras`] have no points, because those would be the
    /// unfiltered ones.
    #[must_use]
    pub fn is_filtered(&self) -> bool {
        self.unfiltered
            .as_ref()
            .is_some_and(|unfiltered| *unfiltered != self.distance)
    }

    /// Returns an extra output, or `None` if it was not made or has another type.
    #[must_use]
    pub fn extra<T>(&self, annotator: Annotator) -> Option<&T>
    where
        for<'a> &'a T: TryFrom<&'a CaptureLayer>,
    {
        let layer = self.extras.iter().find(|(own, _)| *own == annotator);
        layer.and_then(|(_, layer)| layer.try_into().ok())
    }

    /// Removes and returns an extra output, or returns `None` if it was not made or has another type.
    pub fn take<T: TryFrom<CaptureLayer>>(&mut self, annotator: Annotator) -> Option<T> {
        let place = self.extras.iter().position(|(own, _)| *own == annotator)?;
        self.extras.swap_remove(place).1.try_into().ok()
    }

    /// Brings the extra outputs to the size of the filtered distance.
    pub(crate) fn follow(&mut self, filters: &Chain) {
        let is_points = |(_, layer): &(Annotator, CaptureLayer)| matches!(layer, CaptureLayer::Points(_));
        if self.extras.iter().any(is_points) && self.is_filtered() {
            self.extras.retain(|extra| !is_points(extra));
        }
        for (_, layer) in &mut self.extras {
            *layer = match std::mem::replace(layer, CaptureLayer::Bytes(Image::filled(0, 0, 0))) {
                CaptureLayer::Bytes(image) => CaptureLayer::Bytes(filters.companion(image)),
                CaptureLayer::Levels(image) => CaptureLayer::Levels(filters.companion(image)),
                CaptureLayer::Floats(image) => CaptureLayer::Floats(filters.companion(image)),
                CaptureLayer::Colors(image) => CaptureLayer::Colors(filters.companion(image)),
                // Disparity is filtered itself, and filters are among the reasons.
                layer @ (CaptureLayer::Points(_) | CaptureLayer::Disparity(_) | CaptureLayer::Reasons(_)) => {
                    layer
                }
            };
        }
    }

    /// Adds an extra output if there is one.
    pub fn add(&mut self, annotator: Annotator, layer: Option<impl Into<CaptureLayer>>) {
        self.extras.extend(layer.map(|layer| (annotator, layer.into())));
    }
}

macro_rules! layers {
    ($($variant:ident($image:ty);)+) => {$(
        impl From<$image> for CaptureLayer {
            fn from(image: $image) -> Self {
                Self::$variant(image)
            }
        }

        impl TryFrom<CaptureLayer> for $image {
            type Error = ();

            fn try_from(layer: CaptureLayer) -> Result<Self, ()> {
                match layer {
                    CaptureLayer::$variant(image) => Ok(image),
                    _ => Err(()),
                }
            }
        }

        impl<'a> TryFrom<&'a CaptureLayer> for &'a $image {
            type Error = ();

            fn try_from(layer: &'a CaptureLayer) -> Result<Self, ()> {
                match layer {
                    CaptureLayer::$variant(image) => Ok(image),
                    _ => Err(()),
                }
            }
        }
    )+};
}

layers! {
    Bytes(Image<u8>);
    Levels(Image<u16>);
    Floats(Image<f32>);
    Colors(Image<[u8; 4]>);
    Points(Image<[f32; 4]>);
    Disparity(FixedDisparity);
    Reasons(ReasonCodes);
}

/// A disparity image in fixed point.
#[derive(Clone, Debug, PartialEq)]
pub struct FixedDisparity {
    /// Units of `step_px` above `shift_px`; 0 where nothing was measured.
    pub fixed: Image<u16>,
    /// The size of a unit, px.
    pub step_px: f64,
    /// The smallest disparity, px.
    pub shift_px: u32,
}

impl FixedDisparity {
    /// Returns the disparities in pixels of the pair, 0 where nothing was measured.
    #[must_use]
    #[expect(clippy::cast_possible_truncation, reason = "pixels are single precision")]
    pub fn to_px(&self) -> Image<f32> {
        let shift = f64::from(self.shift_px);
        self.fixed.map(|&fixed| match fixed {
            0 => 0.0,
            fixed => (f64::from(fixed) * self.step_px + shift) as f32,
        })
    }
}

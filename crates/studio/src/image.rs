//! The images of a measurement.

use std::borrow::Cow;

use oaktwin::image::{Image, millimetres};

use crate::protocol::ImageName;
use crate::reasons;
use crate::station::Measurement;

/// An image of a measurement.
pub(crate) struct Pixels<'a> {
    pub(crate) width: u32,
    pub(crate) height: u32,
    pub(crate) format: &'static str,
    pub(crate) data: Data<'a>,
}

/// The pixels, exactly as they were rendered or measured.
pub(crate) enum Data<'a> {
    Color(&'a Image<[u8; 4]>),
    Metres(&'a Image<f32>),
    Bytes(Cow<'a, Image<u8>>),
}

impl<'a> Pixels<'a> {
    fn new<T>(image: &Image<T>, format: &'static str, data: Data<'a>) -> Self {
        Self {
            width: image.width(),
            height: image.height(),
            format,
            data,
        }
    }

    fn depth(metres: &'a Image<f32>) -> Self {
        Self::new(metres, "u16mm", Data::Metres(metres))
    }

    fn of_bytes(image: Cow<'a, Image<u8>>) -> Self {
        let (width, height) = (image.width(), image.height());
        Self {
            width,
            height,
            format: "u8",
            data: Data::Bytes(image),
        }
    }

    /// Returns the pixels in little endian, row by row.
    pub(crate) fn bytes(&self) -> Vec<u8> {
        match &self.data {
            Data::Color(image) => image.pixels().as_flattened().to_vec(),
            Data::Bytes(image) => image.pixels().to_vec(),
            Data::Metres(metres) => {
                let millimetres = millimetres::from_metres(metres);
                let values = millimetres.pixels().iter();
                values.flat_map(|value| value.to_le_bytes()).collect()
            }
        }
    }
}

/// Returns an image, if the measurement has it.
pub(crate) fn pixels(measurement: &Measurement, name: ImageName) -> Option<Pixels<'_>> {
    let frame = &measurement.frame;
    let pair = measurement.pair.as_ref();
    Some(match name {
        ImageName::Color => {
            let rgb = frame.rgb.as_ref()?;
            Pixels::new(rgb, "rgba8", Data::Color(rgb))
        }
        ImageName::Depth => Pixels::depth(&frame.distance_to_image_plane.as_ref()?.0),
        ImageName::Reference => Pixels::depth(&measurement.reference.as_ref()?.0),
        ImageName::Sensor => Pixels::depth(&measurement.capture.distance.0),
        ImageName::Confidence => Pixels::of_bytes(Cow::Owned(measurement.confidence()?)),
        ImageName::Left => Pixels::of_bytes(Cow::Owned(pair?.rectified_left.to_eight())),
        ImageName::Right => Pixels::of_bytes(Cow::Owned(pair?.rectified_right.to_eight())),
        ImageName::Reason => Pixels::of_bytes(Cow::Borrowed(reasons::codes(measurement)?)),
    })
}

//! Frames for the page: the images of a measurement, compressed, and their statistics.

use std::borrow::Cow;
use std::time::Instant;

use lz4_flex::block;
use oaktwin::image::{Image, millimetres};
use oaktwin::measure::{Errors, Region};

use crate::protocol::{Failure, FrameHeader, FrameRequest, Histogram, ImageHeader, ImageName, Statistics};
use crate::reasons;
use crate::station::{Measurement, Station};
use crate::studio::Studio;
use crate::wire;

/// Measures what a request asks for and encodes it.
pub(crate) fn frame(
    studio: &Studio,
    station: &mut Station,
    request: &FrameRequest,
) -> Result<Vec<u8>, Failure> {
    let start = Instant::now();
    let measurement = &station.measure(studio, request)?.clone();
    let mut images = Vec::new();
    let mut data = Vec::new();
    for name in &request.images {
        let Some(pixels) = pixels(measurement, *name) else {
            continue;
        };
        let unchanged = station.send(*name);
        let compressed = if unchanged {
            Vec::new()
        } else {
            block::compress(&pixels.bytes())
        };
        images.push(ImageHeader {
            name: *name,
            width: pixels.width,
            height: pixels.height,
            format: pixels.format,
            offset: data.len(),
            length: compressed.len(),
            unchanged,
        });
        data.extend(compressed);
    }
    let [hfov, vfov] = measurement.output.camera.field_of_view();
    let header = FrameHeader {
        id: request.id,
        oak: request.oak.clone(),
        images,
        parameters: measurement.engine.parameters().into_iter().collect(),
        filters: measurement.filters.clone(),
        findings: measurement.findings.clone(),
        statistics: statistics(measurement, request.region),
        milliseconds: start.elapsed().as_secs_f64() * 1e3,
        hfov_deg: hfov.to_degrees(),
        vfov_deg: vfov.to_degrees(),
    };
    let mut message = wire::begin(&header);
    message.extend(data);
    Ok(message)
}

/// An image to be encoded.
struct Pixels<'a> {
    width: u32,
    height: u32,
    format: &'static str,
    data: Data<'a>,
}

enum Data<'a> {
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
    fn bytes(&self) -> Vec<u8> {
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
fn pixels(measurement: &Measurement, name: ImageName) -> Option<Pixels<'_>> {
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
        ImageName::Confidence => Pixels::of_bytes(Cow::Borrowed(measurement.confidence()?)),
        ImageName::Left => Pixels::of_bytes(Cow::Owned(pair?.rectified_left.to_eight())),
        ImageName::Right => Pixels::of_bytes(Cow::Owned(pair?.rectified_right.to_eight())),
        ImageName::Reason => Pixels::of_bytes(Cow::Borrowed(reasons::codes(measurement)?)),
    })
}

/// Computes the statistics of a rectangle, given as fractions of the image.
pub(crate) fn statistics(measurement: &Measurement, [left, top, right, bottom]: [f64; 4]) -> Statistics {
    let measured = &measurement.capture.distance.0;
    let Some(truth) = measurement.truth() else {
        return Statistics::default();
    };
    let range = |from: f64, to: f64, length: u32| {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "saturates, and is limited to the image"
        )]
        let pixel = |fraction: f64| ((fraction * f64::from(length)).round() as u32).min(length);
        pixel(from)..pixel(to)
    };
    let region = Region {
        columns: range(left, right, measured.width()),
        rows: range(top, bottom, measured.height()),
    };
    let errors = Errors::of(truth, measured.into(), &region);
    Statistics {
        pixels: errors.pixels,
        fill_rate: errors.fill_rate,
        median_error_m: errors.median_error_m,
        median_absolute_error_m: errors.median_absolute_error_m,
        median_absolute_error_percent: errors.median_absolute_error_percent,
        p95_absolute_error_m: errors.p95_absolute_error_m,
        reasons: reasons::codes(measurement).map_or_else(Vec::new, |codes| reasons::count(codes, &region)),
        histogram: Histogram {
            from_m: errors.histogram.from_m,
            to_m: errors.histogram.to_m,
            counts: errors.histogram.counts,
        },
    }
}

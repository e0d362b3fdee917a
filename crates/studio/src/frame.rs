//! Frames for the page: the images of a measurement, compressed, and their statistics.

use std::time::Instant;

use lz4_flex::block;
use oaktwin::measure::{Errors, ImageRegion};

use crate::image::pixels;
use crate::job::Job;
use crate::protocol::{Failure, FrameHeader, FrameRequest, Histogram, ImageHeader, Statistics};
use crate::reasons;
use crate::station::{Measurement, Station};
use crate::studio::Studio;
use crate::wire;

/// Measures what a request asks for and encodes it.
pub(crate) fn frame(
    studio: &Studio,
    station: &mut Station,
    request: &FrameRequest,
    job: &Job,
) -> Result<Vec<u8>, Failure> {
    let start = Instant::now();
    let measurement = &station.measure(studio, request, &|| job.check())?.clone();
    let mut images = Vec::new();
    let mut data = Vec::new();
    for (index, name) in request.images.iter().enumerate() {
        if request.images[..index].contains(name) {
            continue;
        }
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
        findings: measurement.scene.local_findings(measurement.findings.clone()),
        statistics: statistics(measurement, request.region),
        milliseconds: start.elapsed().as_secs_f64() * 1e3,
        hfov_deg: hfov.to_degrees(),
        vfov_deg: vfov.to_degrees(),
    };
    let mut message = wire::begin(&header);
    message.extend(data);
    Ok(message)
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
    let region = ImageRegion {
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

//! Compares the median of two hundred units of each stereo model with its published accuracy.

#![allow(clippy::cast_possible_truncation, clippy::unwrap_used, reason = "a test")]

use oaktwin::accuracy::Bands;
use oaktwin::catalog::{Catalog, Source};
use oaktwin::depth::BatchEngine as _;
use oaktwin::depth::random::Stream;
use oaktwin::depth::stereo_noise::StereoNoise;
use oaktwin::sensor::stereo_noise_parameters;

const DEVICES: u64 = 200;
const STEP_M: f64 = 0.5;

/// Rows of a board, of which the central columns are evaluated.
const ROWS: u32 = 4;

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    let middle = values.len() / 2;
    if values.len().is_multiple_of(2) {
        f64::midpoint(values[middle - 1], values[middle])
    } else {
        values[middle]
    }
}

/// The error of the region's median at each distance, in percent.
#[expect(
    clippy::cast_possible_truncation,
    reason = "depth images are single precision"
)]
fn errors(sensor: &StereoNoise, seed: u64, distances: &[f64]) -> Vec<f64> {
    let width = sensor.parameters().width_px;
    let pixels = (width * ROWS) as usize;
    let depth: Vec<f32> = distances
        .iter()
        .flat_map(|&z| std::iter::repeat_n(z as f32, pixels))
        .collect();
    let mut out = vec![0.0; depth.len()];
    let shape = [distances.len(), ROWS as usize, width as usize];
    sensor
        .sense_batch(&depth, shape, 0, 0, &Stream::new(seed, "left"), &mut out)
        .unwrap();
    let width = width as usize;
    let regions = out.chunks_exact(pixels).zip(distances);
    regions
        .map(|(board, &distance)| {
            let rows = board.chunks_exact(width);
            let region = rows.flat_map(|row| &row[width * 3 / 8..width * 5 / 8]);
            let valid: Vec<f64> = region.copied().filter(|&z| z > 0.0).map(f64::from).collect();
            assert!(
                valid.len() as u32 == ROWS * sensor.parameters().width_px / 4,
                "{distance} m"
            );
            (median(valid) - distance).abs() / distance * 100.0
        })
        .collect()
}

#[test]
fn the_median_unit_is_as_accurate_as_published() {
    let catalog = Catalog::builtin();
    let models = [
        ("OAK-D Pro PoE", Source::VendorPage),
        ("OAK-D Pro W PoE", Source::VendorPage),
        ("OAK4-D", Source::VendorPage),
        // Nothing is published: the spec sheet's estimate.
        ("OAK4-D Wide", Source::Estimate),
    ];
    for (model, source) in models {
        let device = catalog.device(model).unwrap();
        let bands = Bands::of(device, &device.depth_sensors[0]).unwrap();
        assert_eq!(bands.source, source, "{model}");
        let end = bands.bands.iter().map(|band| band.to_m).fold(0.0, f64::max);
        let parameters = stereo_noise_parameters(&catalog.nominal(device)).unwrap();
        // From the distance at which a unit with any bias measures something.
        let nearest = parameters.stereo.depth(94.0);
        let distances: Vec<f64> = (1..)
            .map(|i| f64::from(i) * STEP_M)
            .skip_while(|&z| z < nearest)
            .take_while(|&z| z < end)
            .collect();
        assert!(distances.len() > 15, "{model}");
        let devices: Vec<Vec<f64>> = (0..DEVICES)
            .map(|seed| {
                errors(
                    &StereoNoise::new(parameters.of_device(seed)).unwrap(),
                    seed,
                    &distances,
                )
            })
            .collect();
        let mut largest = 0.0;
        for (i, &distance) in distances.iter().enumerate() {
            let error = median(devices.iter().map(|errors| errors[i]).collect());
            let band = &bands.at(distance)[0];
            assert!(
                error < band.error_percent,
                "{model} at {distance} m: {error} % exceeds {} %",
                band.error_percent
            );
            largest = f64::max(largest, error / band.error_percent);
        }
        // The error is not negligible: somewhere it approaches the limit.
        assert!(largest > 0.4, "{model}: {largest}");
    }
}

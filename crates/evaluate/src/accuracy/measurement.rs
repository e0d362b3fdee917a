use super::test_rig::Effort;
use super::{AccuracyError, AccuracyReport, Bench, plot};
use crate::figure::Figure;
use oaktwin_pipeline::progress::Watch;

/// The number of distances on the curve of a single device.
const SINGLE_DEVICE_POINTS: u32 = 400;
/// The number of distances on the median curve of several devices.
const POPULATION_POINTS: u32 = 200;

/// A completed measurement, which can measure further distances for a figure.
#[derive(Debug)]
pub struct Measurement {
    pub(super) bench: Bench,
}

impl Measurement {
    /// Returns the results.
    #[must_use]
    pub fn report(&self) -> &AccuracyReport {
        &self.bench.report
    }

    /// Draws the error over distance, measured at many distances. A population of devices needs only one capture each because the
    /// median over the devices suppresses the noise.
    ///
    /// # Errors
    /// Returns an error if a parameter is invalid or `watch` interrupts the measurement.
    pub fn figure(&self, watch: &Watch<'_>) -> Result<Figure, AccuracyError> {
        let report = &self.bench.report;
        let points = report.measured.iter().flat_map(|measured| &measured.points);
        let distances_m =
            (report.distances.iter().map(|row| row.distance_m)).chain(points.map(|point| point.distance_m));
        let (near, far) = distances_m.fold((f64::INFINITY, 0.0f64), |(a, b), z| (a.min(z), b.max(z)));
        let many = report.devices.are_many();
        let count = if many {
            POPULATION_POINTS
        } else {
            SINGLE_DEVICE_POINTS
        };
        let step = (far - near) / f64::from(count);
        let mut distances: Vec<f64> = (0..=count).map(|i| near + step * f64::from(i)).collect();
        distances.dedup();
        let effort = Effort {
            captures: if many { 1 } else { report.captures },
            quality: false,
        };
        let rows = if near.is_finite() {
            self.bench.rows(&distances, effort, watch)?
        } else {
            Vec::new()
        };
        Ok(plot::figure(report, &rows, self.bench.is_absolute))
    }
}

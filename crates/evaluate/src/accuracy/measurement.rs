use super::test_rig::Effort;
use super::{AccuracyError, Bench, Devices, Report, plot};
use crate::figure::Figure;
use oaktwin_pipeline::progress::Watch;

/// Places along the curve of a plot.
const CURVE_OF_ONE: u32 = 400;
const CURVE_OF_MANY: u32 = 200;

/// What was measured, and the means to measure between.
#[derive(Debug)]
pub struct Measurement {
    pub(super) bench: Bench,
}

impl Measurement {
    /// The numbers.
    #[must_use]
    pub fn report(&self) -> &Report {
        &self.bench.report
    }

    /// The error over distance as a figure. The curve is measured anew at many places; of many devices by one capture of
    /// each instead of several, whose noise the median over the devices averages out.
    ///
    /// # Errors
    /// A parameter of the sensor, or [`AccuracyError::Interrupted`].
    pub fn figure(&self, watch: &Watch<'_>) -> Result<Figure, AccuracyError> {
        let report = &self.bench.report;
        let points = report.measured.iter().flat_map(|measured| &measured.points);
        let places =
            (report.distances.iter().map(|row| row.distance_m)).chain(points.map(|point| point.distance_m));
        let (near, far) = places.fold((f64::INFINITY, 0.0f64), |(a, b), z| (a.min(z), b.max(z)));
        let many = matches!(report.devices, Devices::Population { .. });
        let count = if many { CURVE_OF_MANY } else { CURVE_OF_ONE };
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

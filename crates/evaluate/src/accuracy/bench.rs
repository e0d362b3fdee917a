use std::path::Path;
use std::sync::atomic::{AtomicU64, Ordering};

use crate::measure::r_squared;
use rayon::prelude::*;

use super::measured::MeasuredCurve;
use super::test_rig::{Effort, RunControl, TestRig};
use super::units::{Prepared, intrinsics, rigs};
use super::vendor::protocol_deviations;
use super::{
    AccuracyError, AccuracyOptions, AccuracyReport, AccuracyRow, Bands, ComparedPoint, Comparison, Devices,
    Measurement, Verdict, distances,
};
use oaktwin_base::diagnostic::Finding;
use oaktwin_catalog::{Twin, TwinDepthSensor};
use oaktwin_pipeline::progress::{Progress, Watch};
use oaktwin_pipeline::sensor::depth_sensor;

/// A depth sensor of a twin, ready to be measured.
#[derive(Debug)]
pub struct Bench {
    pub(super) report: AccuracyReport,
    rigs: Vec<TestRig>,
    pub(super) is_absolute: bool,
    from_m: f64,
}

impl Bench {
    /// Prepares the measurement of a twin and returns findings about the sensor's settings.
    ///
    /// # Errors
    /// Returns an error if an option is invalid.
    pub fn new(twin: &Twin, options: &AccuracyOptions) -> Result<(Self, Vec<Finding>), AccuracyError> {
        options.check()?;
        let mut twin = twin.clone();
        let depth = depth_sensor(&twin, options.sensor.as_deref())?.clone();
        let own_width_px = twin
            .depth_camera(&depth)
            .map(|camera| camera.intrinsics.size.width);
        let depth = options.optics.apply(&mut twin, &depth)?;
        let intrinsics = intrinsics(&twin, &depth)?;
        let size = intrinsics.size;
        let scale = own_width_px.map_or(1.0, |own| f64::from(size.width) / f64::from(own));
        let Prepared {
            devices,
            rigs,
            findings,
        } = rigs(&twin, &depth, options, scale)?;
        let Some(rig) = rigs.first() else {
            return Err(AccuracyError::Option {
                option: "devices",
                what: "there is no device".to_owned(),
                remedy: "give 1 to 5000",
            });
        };
        let published = Bands::of(&twin.device, &depth.spec);
        let distances = match &options.distances_m {
            Some(distances) => distances.clone(),
            None => default_distances(rig, &depth, published.as_ref())?,
        };
        let report = AccuracyReport {
            model: twin.device.name.clone(),
            sensor: depth.spec.prim.clone(),
            engine: options.engine.engine_for(depth.spec.kind).name.to_string(),
            carries_depth: rig.carries_depth(),
            devices,
            focal_length_px: intrinsics.fx,
            image_width_px: size.width,
            image_height_px: size.height,
            disparity_times_depth_px_m: rig.disparity_times_depth(),
            region_width_px: rig.region.columns.end - rig.region.columns.start,
            region_height_px: rig.region.rows.end - rig.region.rows.start,
            captures: options.captures,
            protocol_deviations: protocol_deviations(rig, options, depth.spec.kind, own_width_px),
            published,
            distances: distances
                .iter()
                .map(|&z| AccuracyRow::new(z, &[], None))
                .collect(),
            measured: None,
            passed: false,
        };
        let bench = Self {
            report,
            rigs,
            is_absolute: true,
            from_m: options.from_m,
        };
        Ok((bench, findings))
    }

    /// Measures the sensor. With a measured curve and the path of its file, it also measures at the curve's distances and compares
    /// the errors.
    ///
    /// # Errors
    /// Returns an error if a parameter is invalid, a rendered pair cannot be matched, or `watch` interrupts the
    /// measurement.
    pub fn measure(
        mut self,
        measured: Option<(&Path, &MeasuredCurve)>,
        watch: &Watch<'_>,
    ) -> Result<Measurement, AccuracyError> {
        self.is_absolute = measured.is_none_or(|(_, curve)| curve.is_absolute);
        let own: Vec<f64> = self.report.distances.iter().map(|row| row.distance_m).collect();
        let points = measured
            .map(|(_, curve)| curve.points.as_slice())
            .unwrap_or_default();
        let measured_distances: Vec<f64> = points.iter().map(|point| point.distance_m).collect();
        let (before, total) = (own.len() as u64, (own.len() + measured_distances.len()) as u64);
        let from = |done: u64| {
            move |progress: Progress| {
                watch(Progress {
                    done: done + progress.done,
                    total,
                })
            }
        };
        let captures = self.report.captures;
        let effort = |quality: bool| Effort { captures, quality };
        self.report.distances = self.rows(&own, effort(true), &from(0))?;
        let compared = self.rows(&measured_distances, effort(false), &from(before))?;
        self.report.measured = measured.map(|(path, curve)| self.comparison(path, curve, &compared));
        let verdicts = || self.report.distances.iter().map(|row| row.verdict);
        self.report.passed = verdicts().all(|verdict| verdict != Verdict::Outside)
            && verdicts().any(|verdict| verdict != Verdict::NothingMeasured);
        Ok(Measurement { bench: self })
    }

    pub(super) fn rows(
        &self,
        distances: &[f64],
        effort: Effort,
        watch: &Watch<'_>,
    ) -> Result<Vec<AccuracyRow>, AccuracyError> {
        let done = AtomicU64::new(0);
        if let Some(first) = distances.first() {
            self.rigs.iter().for_each(|rig| rig.prepare(*first));
        }
        distances
            .par_iter()
            .map(|&distance_m| {
                let total = distances.len() as u64;
                let progress = |done| Progress { done, total };
                let wants_more = || watch(progress(done.load(Ordering::Relaxed))).is_continue();
                let work = RunControl {
                    effort,
                    wants_more: &wants_more,
                };
                let units = self.rigs.par_iter().map(|rig| rig.measure(distance_m, work));
                let units = units.collect::<Result<Vec<_>, _>>()?.concat();
                if watch(progress(done.fetch_add(1, Ordering::Relaxed) + 1)).is_break() {
                    return Err(AccuracyError::Interrupted);
                }
                let mut row = AccuracyRow::new(distance_m, &units, self.report.published.as_ref());
                if let Devices::Factory { .. } = self.report.devices {
                    row = row.with_band(&units);
                }
                let jitter = self.rigs.first().and_then(TestRig::jitter_times_depth);
                Ok(row.with_single_view(jitter, self.report.carries_depth))
            })
            .collect()
    }

    fn comparison(&self, path: &Path, curve: &MeasuredCurve, rows: &[AccuracyRow]) -> Comparison {
        let points: Vec<ComparedPoint> = curve
            .points
            .iter()
            .zip(rows)
            .map(|(point, row)| ComparedPoint {
                distance_m: point.distance_m,
                measured_error_percent: point.error_percent,
                twin_error_percent: row
                    .reading
                    .error_percent
                    .map(|error| if curve.is_absolute { error.abs() } else { error }),
            })
            .collect();
        let far = || points.iter().filter(|point| point.distance_m >= self.from_m);
        let pairs: Vec<[f64; 2]> = far()
            .filter_map(|point| Some([point.measured_error_percent, point.twin_error_percent?]))
            .collect();
        let squares = pairs.iter().map(|[a, b]| (a - b).powi(2)).sum::<f64>();
        Comparison {
            file: path.display().to_string(),
            is_absolute: curve.is_absolute,
            from_m: self.from_m,
            r_squared: r_squared(&pairs),
            rms_difference_percent: (!pairs.is_empty()).then(|| (squares / pairs.len() as f64).sqrt()),
            compared_points: pairs.len(),
            unmeasured_points: far().count() - pairs.len(),
            points,
        }
    }
}

fn default_distances(
    rig: &TestRig,
    depth: &TwinDepthSensor,
    published: Option<&Bands>,
) -> Result<Vec<f64>, AccuracyError> {
    let begin = published.and_then(|bands| bands.bands.iter().map(|band| band.from_m).reduce(f64::min));
    let near = rig.nearest_m().max(begin.unwrap_or(0.0));
    let far = published
        .and_then(Bands::end_m)
        .unwrap_or(depth.spec.max_distance_m);
    distances::between(near, far)
}

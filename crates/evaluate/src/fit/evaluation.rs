//! The evaluation of recordings, common to all engines.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicU64, Ordering};

use crate::measure::r_squared;
use rayon::prelude::*;

use super::method::{Fitted, Method};
use super::point::{OfTarget, Point};
use super::recording::TargetRecording;
use super::report::{FitQuality, FittedPoint};
use super::state::FitState;
use super::target::{self, EvaluationSettings, Observation};
use super::{FitError, findings, points};
use oaktwin_base::diagnostic::{message, opt};
use oaktwin_pipeline::progress::{Progress, Watch};

impl FitState<'_> {
    /// Evaluates all images: the noise, the targets, and the errors where the true distance is known.
    pub(super) fn evaluate(
        &mut self,
        recordings: &[TargetRecording],
        method: &mut dyn Method,
        watch: &Watch<'_>,
    ) -> Result<Vec<OfTarget>, FitError> {
        let (focal_length_px, width_px) = method.focal_length_px();
        let settings = EvaluationSettings {
            error_domain: method.error_domain(),
            step: method.step(),
            focal_of_width: focal_length_px / f64::from(width_px),
            region: self.options.region,
            unit_m: self.options.depth_scale,
            is_truncated: method.is_truncated(),
        };
        let (done, total) = (AtomicU64::new(0), recordings.len() as u64);
        let observe = |recording| {
            let observations = target::observe(recording, &settings)?;
            let done = done.fetch_add(1, Ordering::Relaxed) + 1;
            match watch(Progress { done, total }) {
                ControlFlow::Continue(()) => Ok(observations),
                ControlFlow::Break(()) => Err(FitError::Interrupted),
            }
        };
        let observations: Vec<Observation> = recordings
            .par_iter()
            .map(observe)
            .collect::<Result<_, FitError>>()?;
        points::of_one_size(&observations, recordings)?;
        findings::of_targets(&observations, settings.error_domain, &mut self.findings);
        if observations.iter().all(|one| one.values() == 0) {
            return Err(FitError::Option(message![
                self.report.sources.join(", "),
                ": the centre of every image is invalid; record again, or increase ",
                opt("region")
            ]));
        }
        method.noise(&observations, self);
        self.keep_determined();
        let tilts = points::tilts(&observations, method, &mut self.findings)?;
        self.report.tilt_deg = tilts.common_deg();
        self.report.targets = observations
            .iter()
            .map(|one| points::target(one, &tilts, method))
            .collect();
        Ok(points::of_targets(&observations, &tilts, method))
    }

    /// Fits the systematic error to the points.
    pub(super) fn systematic(&mut self, points: &[OfTarget], method: &dyn Method) -> Option<Box<dyn Fitted>> {
        let from_m = self.options.from_m;
        let are_used: Vec<bool> = points
            .iter()
            .map(|one| one.point.depth_m >= from_m && method.is_used(one, self))
            .collect();
        let used = points.iter().zip(&are_used).filter(|(_, is_used)| **is_used);
        let used: Vec<Point> = used.map(|(one, _)| one.point).collect();
        let found = method.systematic(&used, self);
        let found = found.filter(|_| self.keep_determined());
        let error_domain = method.error_domain();
        let is_absolute = self.report.is_absolute;
        let counted = |error: f64, depth_m: f64| {
            let error = error_domain.of_error(error, depth_m);
            if is_absolute { error.abs() } else { error }
        };
        let fitted_point = |(one, &is_used): (&OfTarget, &bool)| {
            let point = &one.point;
            let fitted = found.as_ref().map(|found| found.error(point.depth_m));
            FittedPoint {
                target: one.target,
                distance_m: point.depth_m,
                error_percent: 100.0 * point.error,
                error: counted(point.error, point.depth_m),
                sigma: point.sigma,
                fitted_percent: fitted.map(|error| 100.0 * error),
                fitted: fitted.map(|error| counted(error, point.depth_m)),
                is_used,
            }
        };
        self.report.points = points.iter().zip(&are_used).map(fitted_point).collect();
        self.report.curve = found.as_deref().and_then(|found| self.goodness(found));
        found
    }

    /// Returns the quality of the curve; `None` if its residuals are no numbers.
    fn goodness(&self, found: &dyn Fitted) -> Option<FitQuality> {
        let used: Vec<&FittedPoint> = self.report.points.iter().filter(|point| point.is_used).collect();
        let rms = |of: &dyn Fn(&FittedPoint) -> f64| {
            (used.iter().map(|point| of(point).powi(2)).sum::<f64>() / used.len() as f64).sqrt()
        };
        let pairs: Vec<[f64; 2]> = used
            .iter()
            .filter_map(|point| Some([point.error_percent, point.fitted_percent?]))
            .collect();
        let (solution, is_known) = found.solution();
        let curve = FitQuality {
            points: used.len(),
            rms: rms(&|point| point.error - point.fitted.unwrap_or(f64::NAN)),
            rms_percent: rms(&|point| point.error_percent - point.fitted_percent.unwrap_or(f64::NAN)),
            r_squared: r_squared(&pairs),
            scatter: (is_known && solution.freedom > 0)
                .then(|| (solution.squares / solution.freedom as f64).sqrt()),
        };
        (curve.rms.is_finite() && curve.rms_percent.is_finite()).then_some(curve)
    }
}

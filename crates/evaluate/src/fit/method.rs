//! The parts of a fit that are specific to an engine.

use std::fmt::Debug;

use super::error_domain::ErrorDomain;
use super::least_squares::Solution;
use super::point::{OfTarget, Point};
use super::report::FitReport;
use super::state::FitState;
use super::target::Observation;

/// An engine that can be fitted.
pub(super) trait Method: Sync {
    /// Returns the quantity in which its errors are counted.
    fn error_domain(&self) -> ErrorDomain;
    /// Returns the smallest significant step.
    fn step(&self) -> f64;
    /// Returns the focal length in pixels of images of a given width.
    fn focal_length_px(&self) -> (f64, u32);
    /// Whether depth is rounded down to whole units rather than to the nearest.
    fn is_truncated(&self) -> bool {
        false
    }
    /// The parts that require images.
    fn noise_names(&self) -> &'static [&'static str];
    /// Estimates the noise of pixels over time.
    fn noise(&mut self, observations: &[Observation], state: &mut FitState<'_>);
    /// Returns the variance of a pixel over time, including the effect of steps.
    fn variance(&self, one: &Observation) -> Option<f64>;
    /// Returns the variance of the mean of a number of values due to noise.
    fn variance_of_mean(&self, one: &Observation, values: u64) -> Option<f64>;
    /// Returns the variance of such a mean due to rounding.
    fn variance_of_rounding(&self, one: &Observation) -> f64;
    /// Whether a point is fitted; if not, the reason is added to the findings.
    fn is_used(&self, _point: &OfTarget, _work: &mut FitState<'_>) -> bool {
        true
    }
    /// Fits the systematic error.
    fn systematic(&self, used: &[Point], state: &mut FitState<'_>) -> Option<Box<dyn Fitted>>;
    /// Adds known parameters, which describe the unit as much as the fitted ones.
    fn given(&self, _work: &mut FitState<'_>) {}
}

/// A fitted curve of errors over distance.
pub(super) trait Fitted: Debug + Send + Sync {
    /// Returns the quantity in which errors are counted.
    fn error_domain(&self) -> ErrorDomain;
    /// Returns the error as a share of depth.
    fn error(&self, depth_m: f64) -> f64;
    /// Returns half of the 95 % interval of the curve as a share of depth.
    fn half_width(&self, depth_m: f64) -> Option<f64>;
    /// Returns depths that are close enough to draw the curve.
    fn places(&self, near_m: f64, far_m: f64) -> Vec<f64>;
    /// Returns a short description of the curve.
    fn name(&self, report: &FitReport) -> String;
    /// Returns a short description of the noise.
    fn noise(&self, report: &FitReport) -> String;
    /// Returns the solution, and whether the standard errors of the points were known.
    fn solution(&self) -> (&Solution, bool);
}

//! What is an engine's own in a fit; all else is the same for all.

use std::fmt::Debug;

use super::counting::Counting;
use super::least_squares::Solution;
use super::points::{OfTarget, Point};
use super::report::Report;
use super::target::Seen;
use super::work::Work;

/// An engine that can be fitted.
pub(super) trait Method: Sync {
    /// In what its errors are counted.
    fn counting(&self) -> Counting;
    /// The least step that tells anything.
    fn step(&self) -> f64;
    /// The focal length, px, of images so many px wide.
    fn focal_length_px(&self) -> (f64, u32);
    /// Whether whole units are those below, not the nearest.
    fn is_truncated(&self) -> bool {
        false
    }
    /// What only images tell.
    fn noise_names(&self) -> &'static [&'static str];
    /// Finds how pixels vary over time.
    fn noise(&mut self, seen: &[Seen], work: &mut Work<'_>);
    /// The variance of a pixel over time, steps and all.
    fn variance(&self, one: &Seen) -> Option<f64>;
    /// That of the mean of so many values, by noise.
    fn variance_of_mean(&self, one: &Seen, values: u64) -> Option<f64>;
    /// That of what is left of rounding in such a mean.
    fn variance_of_rounding(&self, one: &Seen) -> f64;
    /// Whether a point counts that is not too near; says why where it does not.
    fn is_used(&self, _point: &OfTarget, _work: &mut Work<'_>) -> bool {
        true
    }
    /// Finds the systematic error.
    fn systematic(&self, used: &[Point], work: &mut Work<'_>) -> Option<Box<dyn Fitted>>;
    /// What was given belongs to the unit as much as what was fitted.
    fn given(&self, _work: &mut Work<'_>) {}
}

/// A fitted curve of errors over distance.
pub(super) trait Fitted: Debug + Send + Sync {
    /// In what errors are counted.
    fn counting(&self) -> Counting;
    /// The error of depth, a share of it.
    fn error(&self, depth_m: f64) -> f64;
    /// Half of the interval of 95 % of the curve, a share of the depth.
    fn half_width(&self, depth_m: f64) -> Option<f64>;
    /// Depths close enough to draw it.
    fn places(&self, near_m: f64, far_m: f64) -> Vec<f64>;
    /// What it is, in a few words.
    fn name(&self, report: &Report) -> String;
    /// The noise that was found beside it, in a few words.
    fn noise(&self, report: &Report) -> String;
    /// How it was found, and whether the points' standard errors were known.
    fn solution(&self) -> (&Solution, bool);
}

//! A measured error at a known distance.

/// A measured error at a distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Point {
    /// The true depth in metres.
    pub(super) depth_m: f64,
    /// The error as a share of the depth, positive if too far.
    pub(super) error: f64,
    /// The standard error, if it is known.
    pub(super) sigma: Option<f64>,
}

/// An error of one target.
#[derive(Clone, Copy, Debug)]
pub(super) struct OfTarget {
    /// The index of the target.
    pub(super) target: Option<usize>,
    pub(super) point: Point,
}

//! In what an engine's errors are even.

/// What measurements become before they are averaged: all numbers of a fit without a unit in their names are in it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Counting {
    /// Disparity, px: the errors of a matcher.
    Disparity {
        /// Disparity times depth, px·m.
        px_m: f64,
    },
    /// Depth along the axis, m: the errors of a phase.
    Depth,
}

impl Counting {
    /// Its unit.
    pub(super) const fn unit(self) -> &'static str {
        match self {
            Self::Disparity { .. } => "px",
            Self::Depth => "m",
        }
    }

    /// Of a depth, m.
    pub(super) fn of_depth(self, depth_m: f64) -> f64 {
        match self {
            Self::Disparity { px_m } => px_m / depth_m,
            Self::Depth => depth_m,
        }
    }

    /// The depth of a value, m.
    pub(super) fn depth_m(self, value: f64) -> f64 {
        // One over one over a number is that number.
        self.of_depth(value)
    }

    /// A whole unit of depth there.
    pub(super) fn of_unit(self, unit_m: f64, depth_m: f64) -> f64 {
        match self {
            Self::Disparity { px_m } => px_m * unit_m / (depth_m * depth_m),
            Self::Depth => unit_m,
        }
    }

    /// An error of depth, a share of it. Of disparity: below 0 it is too far.
    pub(super) fn of_error(self, error: f64, depth_m: f64) -> f64 {
        match self {
            Self::Disparity { px_m } => -px_m / depth_m * error / (1.0 + error),
            Self::Depth => depth_m * error,
        }
    }

    /// By what the share of a value grows where that of inverse depth grows by 1.
    pub(super) fn per_inverse_depth(self) -> f64 {
        match self {
            Self::Disparity { .. } => 1.0,
            Self::Depth => -1.0,
        }
    }

    /// Within this truths from images are put together: a hundredth of the period of what repeats.
    pub(super) fn bin(self) -> f64 {
        match self {
            Self::Disparity { .. } => 1.0 / 64.0,
            Self::Depth => 0.004,
        }
    }

    /// Within this those of a turned target are, which is nearly straight.
    pub(super) fn turned_bin(self) -> f64 {
        match self {
            Self::Disparity { .. } => 1.0 / 32.0,
            Self::Depth => f64::INFINITY,
        }
    }

    /// What moved less between two frames stood still.
    pub(super) fn still(self) -> f64 {
        match self {
            Self::Disparity { .. } => 1e-3,
            Self::Depth => 1e-4,
        }
    }
}

/// What is left of rounding to whole multiples of `of` in the mean of what varies by `sigma`, squared.
pub(super) fn left_of_rounding(sigma: f64, of: f64) -> f64 {
    if of <= 0.0 {
        return 0.0;
    }
    let turns = std::f64::consts::TAU * sigma / of;
    of * of / 12.0 * (-turns * turns).exp()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_are_differences_of_values() {
        for counting in [Counting::Disparity { px_m: 60.0 }, Counting::Depth] {
            for (depth_m, error) in [(1.3, 0.02), (4.0, -0.05), (0.3, 0.0)] {
                let values = [depth_m, depth_m * (1.0 + error)].map(|z| counting.of_depth(z));
                let apart = values[1] - values[0];
                assert!((counting.of_error(error, depth_m) - apart).abs() < 1e-12);
                assert!((counting.depth_m(values[0]) - depth_m).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn noise_evens_rounding_out() {
        assert!((left_of_rounding(0.0, 0.25) - 0.0625 / 12.0).abs() < 1e-12);
        assert!(left_of_rounding(0.25, 0.25) < 1e-15);
        assert_eq!(left_of_rounding(0.1, 0.0), 0.0);
    }
}

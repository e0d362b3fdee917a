//! The quantity in which an engine's errors are uniform.

/// The quantity in which measurements are averaged, and the unit of all numbers of a fit without a unit in their names.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum ErrorDomain {
    /// Disparity in pixels, for the errors of a matcher.
    Disparity {
        /// Disparity times depth, px·m.
        px_m: f64,
    },
    /// Depth along the optical axis in metres, for the errors of a phase.
    Depth,
}

impl ErrorDomain {
    /// Returns the unit.
    pub(super) const fn unit(self) -> &'static str {
        match self {
            Self::Disparity { .. } => "px",
            Self::Depth => "m",
        }
    }

    /// Returns the value of a depth in metres.
    pub(super) fn of_depth(self, depth_m: f64) -> f64 {
        match self {
            Self::Disparity { px_m } => px_m / depth_m,
            Self::Depth => depth_m,
        }
    }

    /// Returns the depth of a value in metres.
    pub(super) fn depth_m(self, value: f64) -> f64 {
        // The reciprocal of a reciprocal.
        self.of_depth(value)
    }

    /// Returns the size of a unit of depth at a value.
    pub(super) fn of_unit(self, unit_m: f64, depth_m: f64) -> f64 {
        match self {
            Self::Disparity { px_m } => px_m * unit_m / (depth_m * depth_m),
            Self::Depth => unit_m,
        }
    }

    /// Converts an error as a share of depth; a negative error of disparity is too far.
    pub(super) fn of_error(self, error: f64, depth_m: f64) -> f64 {
        match self {
            Self::Disparity { px_m } => -px_m / depth_m * error / (1.0 + error),
            Self::Depth => depth_m * error,
        }
    }

    /// Returns the relative change of a value per relative change of inverse depth.
    pub(super) fn per_inverse_depth(self) -> f64 {
        match self {
            Self::Disparity { .. } => 1.0,
            Self::Depth => -1.0,
        }
    }

    /// Returns the tolerance for combining true values of images: a hundredth of the period of the error.
    pub(super) fn bin(self) -> f64 {
        match self {
            Self::Disparity { .. } => 1.0 / 64.0,
            Self::Depth => 0.004,
        }
    }

    /// Returns the tolerance for a rotated target, over which the error is nearly linear.
    pub(super) fn turned_bin(self) -> f64 {
        match self {
            Self::Disparity { .. } => 1.0 / 32.0,
            Self::Depth => f64::INFINITY,
        }
    }

    /// Returns the change between two frames below which a pixel is static.
    pub(super) fn still(self) -> f64 {
        match self {
            Self::Disparity { .. } => 1e-3,
            Self::Depth => 1e-4,
        }
    }
}

/// Returns the variance that rounding to multiples of `of` leaves in the mean of values with a standard deviation of `sigma`.
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
        for error_domain in [ErrorDomain::Disparity { px_m: 60.0 }, ErrorDomain::Depth] {
            for (depth_m, error) in [(1.3, 0.02), (4.0, -0.05), (0.3, 0.0)] {
                let values = [depth_m, depth_m * (1.0 + error)].map(|z| error_domain.of_depth(z));
                let apart = values[1] - values[0];
                assert!((error_domain.of_error(error, depth_m) - apart).abs() < 1e-12);
                assert!((error_domain.depth_m(values[0]) - depth_m).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn noise_averages_rounding_out() {
        assert!((left_of_rounding(0.0, 0.25) - 0.0625 / 12.0).abs() < 1e-12);
        assert!(left_of_rounding(0.25, 0.25) < 1e-15);
        assert_eq!(left_of_rounding(0.1, 0.0), 0.0);
    }
}

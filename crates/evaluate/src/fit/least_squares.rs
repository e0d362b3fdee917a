//! Robust non-linear least squares for a few parameters: damped Gauss-Newton steps (Marquardt 1963) with weights that decrease
//! for outliers (Huber 1964).

/// The deviation, in standard deviations, from which the influence of an outlier is constant.
const HUBER: f64 = 1.345;

const STEPS: usize = 60;

/// The maximum number of parameters.
pub(super) const MOST: usize = 4;

/// A problem to solve: the deviation of each point, in units of its standard deviation if that is known.
pub(super) trait Problem {
    /// Returns the number of points.
    fn points(&self) -> usize;
    /// Returns the deviation of a point for these parameters.
    fn deviation(&self, parameters: &[f64], i: usize) -> f64;
}

/// The minimum.
#[derive(Clone, Debug)]
pub(super) struct Solution {
    pub(super) parameters: Vec<f64>,
    /// The covariance of the parameters, row by row; `None` if the points do not determine them.
    pub(super) covariance: Option<Vec<Vec<f64>>>,
    /// The number of points minus the number of parameters.
    pub(super) freedom: usize,
    /// The weighted sum of squares.
    pub(super) squares: f64,
}

impl Solution {
    /// Returns the standard error of a parameter.
    pub(super) fn error(&self, at: usize) -> Option<f64> {
        let variance = *self.covariance.as_ref()?.get(at)?.get(at)?;
        (variance >= 0.0 && variance.is_finite()).then(|| variance.sqrt())
    }

    /// Returns the correlation of the first two parameters, −1 to 1; `None` if the points do not determine them.
    pub(super) fn correlation(&self) -> Option<f64> {
        let c = self.covariance.as_ref()?;
        Some(c.first()?.get(1)? / (c.first()?.first()? * c.get(1)?.get(1)?).sqrt())
    }

    /// Returns half of the 95 % interval of a function of the parameters; `None` if the points do not determine it.
    pub(super) fn half_width(&self, value: impl Fn(&[f64]) -> f64, is_known: bool) -> Option<f64> {
        let slopes = derivatives(value, &self.parameters);
        let covariance = self.covariance.as_ref()?;
        let variance = covariance
            .iter()
            .zip(&slopes)
            .flat_map(|(row, a)| row.iter().zip(&slopes).map(move |(c, b)| a * b * c))
            .sum::<f64>();
        Some(self.factor(is_known) * variance.max(0.0).sqrt()).filter(|half| half.is_finite())
    }

    /// Returns the 95 % interval of a parameter, multiplied by `scale`; `None` if the points do not determine it.
    pub(super) fn interval(&self, at: usize, scale: f64, is_known: bool) -> Option<[f64; 2]> {
        let half = self.factor(is_known) * self.error(at)?;
        let value = *self.parameters.get(at)?;
        let ends = [(value - half) * scale, (value + half) * scale];
        ends.iter().all(|end| end.is_finite()).then_some(ends)
    }

    /// Returns the factor of a standard error for a 95 % interval.
    pub(super) fn factor(&self, is_known: bool) -> f64 {
        if is_known {
            NORMAL_95
        } else {
            student_95(self.freedom)
        }
    }
}

/// The 97.5 % quantile of the normal distribution.
pub(super) const NORMAL_95: f64 = 1.959_964;

/// Returns the 97.5 % quantile of Student's t distribution: exact up to 3 degrees of freedom, otherwise by the Cornish-Fisher
/// expansion, within 0.5 %.
pub(super) fn student_95(freedom: usize) -> f64 {
    let z = NORMAL_95;
    match freedom {
        0 => f64::INFINITY,
        1 => 12.7062,
        2 => 4.3027,
        3 => 3.1824,
        n => {
            let n = n as f64;
            z + (z.powi(3) + z) / (4.0 * n)
                + (5.0 * z.powi(5) + 16.0 * z.powi(3) + 3.0 * z) / (96.0 * n * n)
                + (3.0 * z.powi(7) + 19.0 * z.powi(5) + 17.0 * z.powi(3) - 15.0 * z) / (384.0 * n.powi(3))
        }
    }
}

/// Minimizes from `start`. `is_known` states whether the deviations are in units of known standard deviations; the covariance
/// is then increased if the points scatter more, and never decreased.
pub(super) fn solve(problem: &impl Problem, start: &[f64], is_known: bool) -> Solution {
    let count = start.len();
    let mut parameters = start.to_vec();
    let mut damping = 1e-3;
    let mut scale = spread(problem, &parameters, is_known);
    let mut cost = huber_cost(problem, &parameters, scale);
    for _ in 0..STEPS {
        let (normal, gradient) = normal_equations(problem, &parameters, scale);
        let mut damped = normal.clone();
        for (i, row) in damped.iter_mut().enumerate() {
            row[i] *= 1.0 + damping;
        }
        let Some(inverse) = inverted(&damped) else {
            break;
        };
        let step: Vec<f64> = inverse
            .iter()
            .map(|row| row.iter().zip(&gradient).map(|(a, b)| a * b).sum())
            .collect();
        let trial: Vec<f64> = parameters.iter().zip(&step).map(|(p, s)| p - s).collect();
        let trial_cost = huber_cost(problem, &trial, scale);
        if trial_cost <= cost {
            let gained = cost - trial_cost;
            parameters = trial;
            damping = (damping / 5.0).max(1e-9);
            scale = spread(problem, &parameters, is_known);
            let rescaled = huber_cost(problem, &parameters, scale);
            let is_done = gained <= 1e-12 * cost && (rescaled - cost).abs() <= 1e-9 * cost;
            cost = rescaled;
            if is_done {
                break;
            }
        } else {
            damping *= 5.0;
            if damping > 1e9 {
                break;
            }
        }
    }
    let (normal, _) = normal_equations(problem, &parameters, scale);
    let squares = (0..problem.points())
        .map(|i| {
            let deviation = problem.deviation(&parameters, i);
            weight(deviation, scale) * deviation * deviation
        })
        .sum::<f64>();
    let freedom = problem.points().saturating_sub(count);
    let by_scatter = if freedom > 0 {
        squares / freedom as f64
    } else {
        f64::NAN
    };
    let variance = if is_known {
        // `max` ignores NaN.
        by_scatter.max(1.0)
    } else {
        by_scatter
    };
    let covariance = inverted(&normal).filter(|_| variance.is_finite()).map(|inverse| {
        inverse
            .into_iter()
            .map(|row| row.into_iter().map(|value| value * variance).collect())
            .collect()
    });
    Solution {
        parameters,
        covariance,
        freedom,
        squares,
    }
}

/// Returns the robust scale of the deviations.
fn spread(problem: &impl Problem, parameters: &[f64], is_known: bool) -> f64 {
    let mut deviations: Vec<f64> = (0..problem.points())
        .map(|i| problem.deviation(parameters, i).abs())
        .collect();
    deviations.sort_unstable_by(f64::total_cmp);
    let middle = deviations.get(deviations.len() / 2).copied().unwrap_or_default();
    // The ratio of the standard deviation to the median absolute value of a normal distribution.
    let spread = middle * 1.4826;
    if is_known {
        spread.max(1.0)
    } else {
        spread.max(f64::MIN_POSITIVE)
    }
}

fn weight(deviation: f64, scale: f64) -> f64 {
    let limit = HUBER * scale;
    if deviation.abs() <= limit {
        1.0
    } else {
        limit / deviation.abs()
    }
}

fn huber_cost(problem: &impl Problem, parameters: &[f64], scale: f64) -> f64 {
    let limit = HUBER * scale;
    (0..problem.points())
        .map(|i| {
            let deviation = problem.deviation(parameters, i).abs();
            if deviation <= limit {
                deviation * deviation
            } else {
                2.0 * limit * deviation - limit * limit
            }
        })
        .sum()
}

/// Returns the normal equations: the weighted products of the derivatives with each other, and with the deviations.
fn normal_equations(problem: &impl Problem, parameters: &[f64], scale: f64) -> (Vec<Vec<f64>>, Vec<f64>) {
    let count = parameters.len();
    let mut normal = vec![vec![0.0; count]; count];
    let mut gradient = vec![0.0; count];
    for i in 0..problem.points() {
        let deviation = problem.deviation(parameters, i);
        let weight = weight(deviation, scale);
        let slope = derivatives(|p| problem.deviation(p, i), parameters);
        for (a, row) in normal.iter_mut().enumerate() {
            gradient[a] += weight * slope[a] * deviation;
            for (b, cell) in row.iter_mut().enumerate() {
                *cell += weight * slope[a] * slope[b];
            }
        }
    }
    (normal, gradient)
}

/// Returns the derivatives by central differences.
fn derivatives(value: impl Fn(&[f64]) -> f64, parameters: &[f64]) -> [f64; MOST] {
    let mut slopes = [0.0; MOST];
    let mut moved = parameters.to_vec();
    for (at, slope) in slopes.iter_mut().enumerate().take(parameters.len()) {
        let step = 1e-5 * parameters[at].abs().max(0.1);
        moved[at] = parameters[at] + step;
        let above = value(&moved);
        moved[at] = parameters[at] - step;
        *slope = (above - value(&moved)) / (2.0 * step);
        moved[at] = parameters[at];
    }
    slopes
}

/// Inverts a small symmetric matrix by Gauss-Jordan elimination after scaling the parameters; `None` if it is singular or
/// nearly so.
fn inverted(matrix: &[Vec<f64>]) -> Option<Vec<Vec<f64>>> {
    let count = matrix.len();
    let scales: Vec<f64> = (0..count).map(|i| matrix[i][i].sqrt()).collect();
    if !scales.iter().all(|scale| *scale > 0.0 && scale.is_finite()) {
        return None;
    }
    let mut left: Vec<Vec<f64>> = (0..count)
        .map(|i| {
            (0..count)
                .map(|j| matrix[i][j] / (scales[i] * scales[j]))
                .collect()
        })
        .collect();
    let mut right: Vec<Vec<f64>> = (0..count)
        .map(|i| (0..count).map(|j| if i == j { 1.0 } else { 0.0 }).collect())
        .collect();
    for at in 0..count {
        let pivot = (at..count).max_by(|&a, &b| left[a][at].abs().total_cmp(&left[b][at].abs()))?;
        if left[pivot][at].abs().is_nan() || left[pivot][at].abs() < 1e-9 {
            return None;
        }
        left.swap(at, pivot);
        right.swap(at, pivot);
        let divisor = left[at][at];
        for value in left[at].iter_mut().chain(&mut right[at]) {
            *value /= divisor;
        }
        let (own_left, own_right) = (left[at].clone(), right[at].clone());
        for row in (0..count).filter(|row| *row != at) {
            let factor = left[row][at];
            for (value, own) in left[row].iter_mut().zip(&own_left) {
                *value -= factor * own;
            }
            for (value, own) in right[row].iter_mut().zip(&own_right) {
                *value -= factor * own;
            }
        }
    }
    for (i, row) in right.iter_mut().enumerate() {
        for (j, value) in row.iter_mut().enumerate() {
            *value /= scales[i] * scales[j];
        }
    }
    Some(right)
}

#[cfg(test)]
mod tests {
    use super::*;

    struct StraightLine<'a>(&'a [[f64; 2]]);

    impl Problem for StraightLine<'_> {
        fn points(&self) -> usize {
            self.0.len()
        }

        fn deviation(&self, p: &[f64], i: usize) -> f64 {
            let [x, y] = self.0[i];
            p[0] + p[1] * x - y
        }
    }

    /// Closed form: y = 1 + 2 x with deviations of alternately ±0.1.
    #[test]
    fn a_straight_line() {
        let points: Vec<[f64; 2]> = (0..8)
            .map(|i| {
                let x = f64::from(i);
                let off = if [0, 3, 4, 7].contains(&i) { 0.1 } else { -0.1 };
                [x, 1.0 + 2.0 * x + off]
            })
            .collect();
        let solution = solve(&StraightLine(&points), &[0.0, 0.0], false);
        assert!((solution.parameters[1] - 2.0).abs() < 1e-6, "{solution:?}");
        assert!((solution.parameters[0] - 1.0).abs() < 1e-6);
        // s² = 8·0.01/6; the variance of the slope is s²/Σ(x − x̄)² = s²/42.
        let expected = (0.08f64 / 6.0 / 42.0).sqrt();
        assert!((solution.error(1).unwrap() / expected - 1.0).abs() < 1e-4);
        assert_eq!(solution.freedom, 6);
        // If the points scatter less than their known errors, the known errors determine the interval.
        let known = solve(&StraightLine(&points), &[0.0, 0.0], true);
        assert!((known.error(1).unwrap() / (1.0f64 / 42.0).sqrt() - 1.0).abs() < 1e-4);
    }

    #[test]
    fn an_outlier_pulls_little() {
        let mut points: Vec<[f64; 2]> = (0..30)
            .map(|i| {
                let x = f64::from(i);
                [x, 3.0 + 0.01 * (x * 1.7).sin()]
            })
            .collect();
        points[4][1] = 100.0;
        let solution = solve(&StraightLine(&points), &[0.0, 0.0], false);
        assert!((solution.parameters[0] - 3.0).abs() < 0.02, "{solution:?}");
    }

    #[test]
    fn indistinguishable_parameters_have_no_error() {
        let solution = solve(
            &StraightLine(&[[2.0, 1.0], [2.0, 1.1], [2.0, 0.9]]),
            &[0.0, 0.0],
            false,
        );
        assert!(solution.covariance.is_none(), "{solution:?}");
        assert!(solve(&StraightLine(&[]), &[0.0, 0.0], true).covariance.is_none());
    }

    #[test]
    fn students_factors() {
        for (freedom, expected) in [
            (1, 12.706),
            (2, 4.303),
            (3, 3.182),
            (5, 2.571),
            (10, 2.228),
            (100, 1.984),
        ] {
            assert!((student_95(freedom) / expected - 1.0).abs() < 5e-3, "{freedom}");
        }
    }
}

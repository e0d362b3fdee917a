//! Levenberg and Marquardt's method on projections.

use oaktwin_camera::math::DVec2;
use oaktwin_camera::{Intrinsics, OpenCv};

use super::Sample;
use super::family::Family;

const MAX_STEPS: u32 = 50;
/// The relative decrease of the sum of squares that ends the iteration.
const CONVERGED: f64 = 1e-6;
/// The range of the damping; beyond it no step makes the residual smaller.
const DAMPING: std::ops::RangeInclusive<f64> = 1e-15..=1e6;

pub(super) struct FittedLens<const N: usize> {
    /// fx, fy, cx, cy in OpenCV's convention, px.
    pub(super) intrinsics: [f64; 4],
    pub(super) coefficients: [f64; N],
}

/// Minimizes the distance in pixels between the samples' pixels and the projections of their rays by a family of lenses, over the
/// intrinsics and the coefficients. `None` if the start has no finite residual or the focal lengths become negative.
pub(super) fn fit<const N: usize>(
    samples: &[Sample],
    family: Family<N>,
    intrinsics: &Intrinsics,
    start: [f64; N],
) -> Option<FittedLens<N>> {
    let c = intrinsics.principal_point::<OpenCv>();
    let mut at: Vec<f64> = [intrinsics.fx, intrinsics.fy, c.x, c.y]
        .into_iter()
        .chain(start)
        .collect();
    let mut damping = 1e-3;
    let mut system = System::at(samples, family, &at)?;
    for _ in 0..MAX_STEPS {
        let next = system.step(damping).and_then(|step| {
            let next: Vec<f64> = at.iter().zip(&step).map(|(a, b)| a + b).collect();
            let found = System::at(samples, family, &next)?;
            (found.sum < system.sum).then_some((next, found))
        });
        if let Some((next, found)) = next {
            let is_done = system.sum - found.sum <= CONVERGED * system.sum;
            (at, system) = (next, found);
            if is_done {
                break;
            }
            damping *= 0.1;
        } else {
            damping *= 10.0;
        }
        if damping > *DAMPING.end() {
            break;
        }
        damping = damping.max(*DAMPING.start());
    }
    let (intrinsics, coefficients) = split::<N>(&at)?;
    (intrinsics[0] > 0.0 && intrinsics[1] > 0.0).then_some(FittedLens {
        intrinsics,
        coefficients,
    })
}

fn split<const N: usize>(at: &[f64]) -> Option<([f64; 4], [f64; N])> {
    let (intrinsics, coefficients) = at.split_at_checked(4)?;
    Some((intrinsics.try_into().ok()?, coefficients.try_into().ok()?))
}

/// The normal equations at some parameters.
struct System {
    /// The sum of squares, px².
    sum: f64,
    /// The rows of the symmetric matrix `JᵀJ`.
    normal: Vec<Vec<f64>>,
    /// The vector `−Jᵀr`.
    right: Vec<f64>,
}

impl System {
    fn at<const N: usize>(samples: &[Sample], family: Family<N>, at: &[f64]) -> Option<Self> {
        let ([fx, fy, cx, cy], coefficients) = split::<N>(at)?;
        let n = N + 4;
        let mut system = Self {
            sum: 0.0,
            normal: vec![vec![0.0; n]; n],
            right: vec![0.0; n],
        };
        let (focal, centre) = (DVec2::new(fx, fy), DVec2::new(cx, cy));
        for Sample { point, pixel } in samples {
            let (distorted, slopes) = family(*point, &coefficients);
            let residual = focal * distorted + centre - *pixel;
            system.sum += residual.length_squared();
            let of_x = [distorted.x, 0.0, 1.0, 0.0].into_iter();
            let of_y = [0.0, distorted.y, 0.0, 1.0].into_iter();
            let of_x: Vec<f64> = of_x.chain(slopes.iter().map(|s| fx * s.x)).collect();
            let of_y: Vec<f64> = of_y.chain(slopes.iter().map(|s| fy * s.y)).collect();
            system.add(&of_x, residual.x);
            system.add(&of_y, residual.y);
        }
        system.sum.is_finite().then_some(system)
    }

    fn add(&mut self, row: &[f64], residual: f64) {
        for ((normal, right), a) in self.normal.iter_mut().zip(&mut self.right).zip(row) {
            *right -= a * residual;
            for (entry, b) in normal.iter_mut().zip(row) {
                *entry += a * b;
            }
        }
    }

    /// Returns the damped step, or `None` if the damped matrix is not positive definite. Parameters are scaled by the diagonal,
    /// because focal lengths and coefficients differ by orders of magnitude.
    fn step(&self, damping: f64) -> Option<Vec<f64>> {
        let scale: Vec<f64> = (0..self.right.len())
            .map(|i| self.normal.get(i)?.get(i).map(|d| d.sqrt().recip()))
            .collect::<Option<_>>()?;
        let mut matrix = self.normal.clone();
        for (i, row) in matrix.iter_mut().enumerate() {
            for (j, entry) in row.iter_mut().enumerate() {
                *entry *= scale.get(i)? * scale.get(j)?;
                if i == j {
                    *entry += damping;
                }
            }
        }
        let right: Vec<f64> = self.right.iter().zip(&scale).map(|(r, s)| r * s).collect();
        let scaled = solve(matrix, right)?;
        Some(scaled.iter().zip(&scale).map(|(x, s)| x * s).collect())
    }
}

/// Solves a symmetric positive definite system by elimination, or returns `None` if it is not positive definite.
fn solve(mut matrix: Vec<Vec<f64>>, mut right: Vec<f64>) -> Option<Vec<f64>> {
    let n = right.len();
    for i in 0..n {
        let pivot_row = matrix.get(i)?.clone();
        let (pivot, pivot_right) = (*pivot_row.get(i)?, *right.get(i)?);
        if pivot.is_nan() || pivot <= 0.0 {
            return None;
        }
        for (row, right) in matrix.iter_mut().zip(&mut right).skip(i + 1) {
            let factor = row.get(i)? / pivot;
            for (entry, above) in row.iter_mut().zip(&pivot_row).skip(i) {
                *entry -= factor * above;
            }
            *right -= factor * pivot_right;
        }
    }
    for i in (0..n).rev() {
        let row = matrix.get(i)?;
        let known: f64 = row.iter().zip(&right).skip(i + 1).map(|(a, x)| a * x).sum();
        let value = (right.get(i)? - known) / row.get(i)?;
        *right.get_mut(i)? = value;
    }
    right.iter().all(|x| x.is_finite()).then_some(right)
}

//! Cubic splines through positions.

use oaktwin_camera::math::DVec3;

/// A cubic spline with a continuous second derivative through points at increasing times. Its third derivative is continuous
/// at the second and the last but one point ("not-a-knot"), so that cubic motion is reproduced exactly; three points are joined
/// by a parabola and two by a line.
#[derive(Clone, Debug)]
pub(crate) struct PositionSpline {
    points: Vec<DVec3>,
    /// The derivatives at the points.
    slopes: Vec<DVec3>,
}

impl PositionSpline {
    /// Creates the spline of at least two points.
    pub(crate) fn new(times: &[f64], points: Vec<DVec3>) -> Self {
        let slopes = slopes(times, &points);
        Self { points, slopes }
    }

    /// Returns the position, velocity and acceleration at a fraction `u` of a segment of `h` seconds.
    pub(crate) fn at(&self, segment: usize, u: f64, h: f64) -> [DVec3; 3] {
        let (p, q) = (self.points[segment], self.points[segment + 1]);
        let (v, w) = (self.slopes[segment] * h, self.slopes[segment + 1] * h);
        let square = 3.0 * (q - p) - 2.0 * v - w;
        let cube = v + w - 2.0 * (q - p);
        [
            p + u * (v + u * (square + u * cube)),
            (v + u * (2.0 * square + u * 3.0 * cube)) / h,
            (2.0 * square + u * 6.0 * cube) / (h * h),
        ]
    }
}

/// Returns the derivatives at the points.
fn slopes(times: &[f64], points: &[DVec3]) -> Vec<DVec3> {
    let h: Vec<f64> = times.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let chords: Vec<DVec3> = points
        .windows(2)
        .zip(&h)
        .map(|(pair, h)| (pair[1] - pair[0]) / h)
        .collect();
    match (&h[..], &chords[..]) {
        ([_], [chord]) => return vec![*chord; 2],
        ([h0, h1], [c0, c1]) => {
            let bend = (c1 - c0) / (h0 + h1);
            return vec![c0 - bend * *h0, c0 + bend * *h0, c1 + bend * *h1];
        }
        _ => {}
    }
    let n = points.len();
    let last = h.len() - 1;
    // The rows (below, diagonal, above | right) of a tridiagonal system.
    let mut rows = Vec::with_capacity(n);
    rows.push(end_row(h[0], h[1], chords[0], chords[1]));
    for i in 1..n - 1 {
        let right = 3.0 * (h[i] * chords[i - 1] + h[i - 1] * chords[i]);
        rows.push(([h[i], 2.0 * (h[i - 1] + h[i]), h[i - 1]], right));
    }
    let ([_, diagonal, above], right) = end_row(h[last], h[last - 1], chords[last], chords[last - 1]);
    rows.push(([above, diagonal, 0.0], right));
    solve(rows)
}

/// The condition at an end, whose segment has the length `h0`.
fn end_row(h0: f64, h1: f64, chord0: DVec3, chord1: DVec3) -> ([f64; 3], DVec3) {
    let both = h0 + h1;
    let right = ((h0 + 2.0 * both) * h1 * chord0 + h0 * h0 * chord1) / both;
    ([0.0, h1, both], right)
}

/// Solves a tridiagonal system.
fn solve(mut rows: Vec<([f64; 3], DVec3)>) -> Vec<DVec3> {
    for i in 1..rows.len() {
        let ([_, diagonal, above], right) = rows[i - 1];
        let (row, value) = &mut rows[i];
        let factor = row[0] / diagonal;
        row[1] -= factor * above;
        *value -= factor * right;
    }
    let mut solution = vec![DVec3::ZERO; rows.len()];
    let mut next = DVec3::ZERO;
    for (([_, diagonal, above], right), slot) in rows.iter().zip(&mut solution).rev() {
        next = (*right - *above * next) / *diagonal;
        *slot = next;
    }
    solution
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn cubics_are_reproduced(
            steps in prop::collection::vec(0.1..1.0f64, 3..8),
            c in prop::array::uniform4(-2.0..2.0f64),
            u in 0.0..1.0f64,
        ) {
            let mut times = vec![0.0];
            times.extend(steps.iter().scan(0.0, |t, step| { *t += step; Some(*t) }));
            let cubic = |t: f64| DVec3::new(c[0] + t * (c[1] + t * (c[2] + t * c[3])), t, -t * t);
            let spline = PositionSpline::new(&times, times.iter().map(|t| cubic(*t)).collect());
            for (segment, h) in steps.iter().enumerate() {
                let t = times[segment] + u * h;
                let [p, v, a] = spline.at(segment, u, *h);
                prop_assert!((p - cubic(t)).length() < 1e-9);
                prop_assert!((v.x - (c[1] + t * (2.0 * c[2] + 3.0 * t * c[3]))).abs() < 1e-8);
                prop_assert!((a - DVec3::new(2.0 * c[2] + 6.0 * t * c[3], 0.0, -2.0)).length() < 1e-6);
            }
        }

        #[test]
        fn two_derivatives_are_continuous(
            steps in prop::collection::vec(0.1..1.0f64, 1..8),
            heights in prop::collection::vec(-1.0..1.0f64, 9),
        ) {
            let mut times = vec![0.0];
            times.extend(steps.iter().scan(0.0, |t, step| { *t += step; Some(*t) }));
            let points = heights[..times.len()].iter().map(|x| DVec3::splat(*x)).collect();
            let spline = PositionSpline::new(&times, points);
            for segment in 1..steps.len() {
                let (before, after) = (spline.at(segment - 1, 1.0, steps[segment - 1]), spline.at(segment, 0.0, steps[segment]));
                for (a, b) in before.iter().zip(after) {
                    prop_assert!((*a - b).length() < 1e-7 * (1.0 + b.length()), "{a} {b}");
                }
                prop_assert_eq!(after[0].x, heights[segment]);
            }
        }
    }
}

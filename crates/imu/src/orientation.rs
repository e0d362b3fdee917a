//! Splines through orientations.

use oaktwin_camera::math::{DMat3, DQuat, DVec3};

use crate::so3;

/// A spline through orientations at increasing times, whose angular velocity and angular acceleration are continuous.
///
/// In each segment, the rotation vector from the first orientation is a cubic polynomial (Kang and Park, "Cubic spline
/// algorithms for orientation interpolation", 1999). The angular velocities at the orientations are chosen so that the
/// angular acceleration is continuous; at the ends, they are the derivatives of polynomials through the four nearest
/// orientations.
#[derive(Clone, Debug)]
pub(crate) struct OrientationSpline {
    orientations: Vec<DQuat>,
    /// The rotation vectors of the segments.
    turns: Vec<DVec3>,
    /// The angular velocities at the orientations, in the rotating frame.
    rates: Vec<DVec3>,
}

/// The iterations after which the solution is as good as it gets; few are needed unless a segment turns far.
const MAX_ITERATIONS: usize = 30;

/// A change of an angular velocity in rad/s that does not matter.
const TOLERANCE: f64 = 1e-12;

/// A turn in radians of the segments at an end beyond which their rotation vectors are not extrapolated.
const LARGEST_END_TURN: f64 = 2.5;

impl OrientationSpline {
    /// Creates the spline of at least two orientations.
    pub(crate) fn new(times: &[f64], orientations: Vec<DQuat>) -> Self {
        let turns: Vec<DVec3> = orientations
            .windows(2)
            .map(|pair| so3::log(pair[0].inverse() * pair[1]))
            .collect();
        let h: Vec<f64> = times.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let rates = rates(times, &orientations, &turns, &h);
        Self {
            orientations,
            turns,
            rates,
        }
    }

    /// Returns the rotation vectors of the segments.
    pub(crate) fn turns(&self) -> &[DVec3] {
        &self.turns
    }

    /// Returns the orientation, and the angular velocity and acceleration in the rotating frame, at a fraction `u` of a segment
    /// of `h` seconds.
    pub(crate) fn at(&self, segment: usize, u: f64, h: f64) -> (DQuat, DVec3, DVec3) {
        let turn = self.turns[segment];
        let v = self.rates[segment] * h;
        let w = derivative(turn, self.rates[segment + 1]) * h;
        let square = 3.0 * turn - 2.0 * v - w;
        let cube = v + w - 2.0 * turn;
        let r = u * (v + u * (square + u * cube));
        let r_dot = (v + u * (2.0 * square + u * 3.0 * cube)) / h;
        let r_ddot = (2.0 * square + u * 6.0 * cube) / (h * h);
        (
            (self.orientations[segment] * so3::exp(r)).normalize(),
            so3::angular_velocity(r, r_dot),
            so3::angular_acceleration(r, r_dot, r_ddot),
        )
    }
}

/// Returns the derivative of a rotation vector from the angular velocity.
fn derivative(r: DVec3, rate: DVec3) -> DVec3 {
    so3::velocity_from_derivative(r).inverse() * rate
}

/// Returns the angular velocities at the orientations.
fn rates(times: &[f64], orientations: &[DQuat], turns: &[DVec3], h: &[f64]) -> Vec<DVec3> {
    let mut rates: Vec<DVec3> = turns.iter().zip(h).map(|(turn, h)| *turn / *h).collect();
    rates.push(rates[rates.len() - 1]);
    let last = rates.len() - 1;
    if last == 1 {
        return rates;
    }
    rates[0] = end_rate(
        (0..rates.len().min(4)).collect::<Vec<_>>().as_slice(),
        times,
        orientations,
    );
    rates[last] = end_rate(
        (0..=last).rev().take(4).collect::<Vec<_>>().as_slice(),
        times,
        orientations,
    );
    let forward: Vec<DMat3> = turns
        .iter()
        .map(|turn| so3::velocity_from_derivative(*turn))
        .collect();
    let backward: Vec<DMat3> = forward.iter().map(DMat3::inverse).collect();
    for _ in 0..MAX_ITERATIONS {
        let mut rows = Vec::with_capacity(last - 1);
        for k in 0..last - 1 {
            let curl = so3::acceleration_of_first_order(turns[k], backward[k] * rates[k + 1]);
            let mut right = 6.0 * (turns[k] / (h[k] * h[k]) + turns[k + 1] / (h[k + 1] * h[k + 1])) - curl;
            let below = forward[k] * (2.0 / h[k]);
            let above = backward[k + 1] * (2.0 / h[k + 1]);
            if k == 0 {
                right -= below * rates[0];
            }
            if k == last - 2 {
                right -= above * rates[last];
            }
            rows.push(BlockRow {
                below,
                diagonal: DMat3::IDENTITY * (4.0 / h[k] + 4.0 / h[k + 1]),
                above,
                right,
            });
        }
        let solved = solve(rows);
        let change = solved
            .iter()
            .zip(&rates[1..last])
            .map(|(new, old)| (*new - *old).length())
            .fold(0.0, f64::max);
        rates[1..last].copy_from_slice(&solved);
        if change < TOLERANCE {
            break;
        }
    }
    rates
}

/// Returns the angular velocity at the first of up to four neighbouring orientations: the derivative of the polynomial through
/// their rotation vectors from the first.
fn end_rate(indices: &[usize], times: &[f64], orientations: &[DQuat]) -> DVec3 {
    let first = indices[0];
    let mut nodes: Vec<(f64, DVec3)> = vec![(0.0, DVec3::ZERO)];
    let mut angle = 0.0;
    for pair in indices.windows(2) {
        angle += so3::log(orientations[pair[0]].inverse() * orientations[pair[1]]).length();
        if angle > LARGEST_END_TURN && nodes.len() > 1 {
            break;
        }
        let turn = so3::log(orientations[first].inverse() * orientations[pair[1]]);
        nodes.push((times[pair[1]] - times[first], turn));
    }
    // The derivative at 0 of Lagrange's polynomial that is zero at 0.
    let mut rate = DVec3::ZERO;
    for (i, (t, turn)) in nodes.iter().enumerate().skip(1) {
        let others = nodes.iter().enumerate().skip(1).filter(|(j, _)| *j != i);
        let weight: f64 = others.map(|(_, (other, _))| other / (other - t)).product();
        rate += *turn * (weight / t);
    }
    rate
}

struct BlockRow {
    below: DMat3,
    diagonal: DMat3,
    above: DMat3,
    right: DVec3,
}

/// Solves a block-tridiagonal system.
fn solve(mut rows: Vec<BlockRow>) -> Vec<DVec3> {
    for i in 1..rows.len() {
        let (before, rest) = rows.split_at_mut(i);
        let (before, row) = (&before[i - 1], &mut rest[0]);
        let factor = row.below * before.diagonal.inverse();
        row.diagonal -= factor * before.above;
        row.right -= factor * before.right;
    }
    let mut solution = vec![DVec3::ZERO; rows.len()];
    let mut next = DVec3::ZERO;
    for (row, slot) in rows.iter().zip(&mut solution).rev() {
        next = row.diagonal.inverse() * (row.right - row.above * next);
        *slot = next;
    }
    solution
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn spline(steps: &[f64], turns: &[[f64; 3]]) -> (OrientationSpline, Vec<DQuat>) {
        let mut times = vec![0.0];
        times.extend(steps.iter().scan(0.0, |t, step| {
            *t += step;
            Some(*t)
        }));
        let mut orientations = vec![DQuat::from_euler(Default::default(), 0.3, -0.4, 0.5)];
        for turn in &turns[..steps.len()] {
            let last = orientations[orientations.len() - 1];
            orientations.push((last * so3::exp(DVec3::from(*turn))).normalize());
        }
        (OrientationSpline::new(&times, orientations.clone()), orientations)
    }

    proptest! {
        #[test]
        fn passes_through_the_orientations_with_two_continuous_derivatives(
            steps in prop::collection::vec(0.05..0.2f64, 1..9),
            turns in prop::collection::vec(prop::array::uniform3(-0.5..0.5f64), 9),
        ) {
            let (spline, orientations) = spline(&steps, &turns);
            for (segment, h) in steps.iter().enumerate() {
                let (start, ..) = spline.at(segment, 0.0, *h);
                prop_assert!(so3::log(start.inverse() * orientations[segment]).length() < 1e-12);
                if segment > 0 {
                    let (_, rate, acceleration) = spline.at(segment - 1, 1.0, steps[segment - 1]);
                    let (_, next_rate, next_acceleration) = spline.at(segment, 0.0, *h);
                    prop_assert!((rate - next_rate).length() < 1e-9);
                    let scale = 1.0 + next_acceleration.length();
                    prop_assert!((acceleration - next_acceleration).length() < 1e-7 * scale);
                }
            }
        }

        #[test]
        fn derivatives_are_those_of_the_orientation(
            steps in prop::collection::vec(0.05..0.2f64, 1..9),
            turns in prop::collection::vec(prop::array::uniform3(-0.5..0.5f64), 9),
            u in 0.05..0.95f64,
        ) {
            let (spline, _) = spline(&steps, &turns);
            for (segment, h) in steps.iter().enumerate() {
                let d = 1e-4;
                let at = |u: f64| spline.at(segment, u, *h);
                let (_, rate, acceleration) = at(u);
                let turn = so3::log(at(u - d).0.inverse() * at(u + d).0);
                prop_assert!((turn / (2.0 * d * h) - rate).length() < 1e-4);
                let slope = (at(u + d).1 - at(u - d).1) / (2.0 * d * h);
                prop_assert!((slope - acceleration).length() < 1e-2, "{slope} {acceleration}");
            }
        }
    }
}

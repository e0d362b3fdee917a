use oaktwin_camera::math::{DMat3, DVec3};

/// A plane in the camera's frame (x right, y down, z forward; metres): the points p with `normal · p = distance`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// Of unit length, away from the camera.
    pub normal: DVec3,
    /// From the optical centre, m; not negative.
    pub distance_m: f64,
}

impl Plane {
    /// The plane whose squared distances from the points are least in sum; `None` where they do not make one.
    #[must_use]
    pub fn fitted(points: &[DVec3]) -> Option<Self> {
        let count = points.len() as f64;
        let centre = points.iter().copied().sum::<DVec3>() / count;
        let mut squares = DMat3::ZERO;
        for point in points {
            let p = *point - centre;
            squares += DMat3::from_cols(p * p.x, p * p.y, p * p.z);
        }
        let (values, axes) = eigen(squares);
        let mut order = [0usize, 1, 2];
        order.sort_unstable_by(|&a, &b| values[a].total_cmp(&values[b]));
        let [least, middle, most] = order;
        // On a line or at one place, up to rounding.
        if !values[middle].is_finite() || values[middle] <= 1e-12 * values[most] || values[most] <= 0.0 {
            return None;
        }
        let normal = axes.col(least).normalize();
        let normal = if normal.dot(centre) < 0.0 { -normal } else { normal };
        Some(Self {
            normal,
            distance_m: normal.dot(centre),
        })
    }

    /// How far behind the plane a point lies, m.
    #[must_use]
    pub fn signed_distance(&self, point: DVec3) -> f64 {
        self.normal.dot(point) - self.distance_m
    }
}

/// The eigenvalues of a symmetric matrix and, in columns, their axes (Jacobi's rotations).
fn eigen(mut m: DMat3) -> ([f64; 3], DMat3) {
    let mut axes = DMat3::IDENTITY;
    // Each sweep squares what is left off the diagonal; a handful is enough for any matrix of this size.
    for _ in 0..12 {
        for (i, j) in [(0, 1), (0, 2), (1, 2)] {
            let off = m.col(j)[i];
            if off == 0.0 {
                continue;
            }
            let half = (m.col(j)[j] - m.col(i)[i]) / (2.0 * off);
            let t = half.signum() / (half.abs() + (half * half + 1.0).sqrt());
            let t = if half == 0.0 { 1.0 } else { t };
            let cosine = 1.0 / (t * t + 1.0).sqrt();
            let sine = t * cosine;
            let mut turn = DMat3::IDENTITY;
            turn.col_mut(i)[i] = cosine;
            turn.col_mut(j)[j] = cosine;
            turn.col_mut(j)[i] = sine;
            turn.col_mut(i)[j] = -sine;
            m = turn.transpose() * m * turn;
            axes *= turn;
        }
    }
    ([0, 1, 2].map(|i| m.col(i)[i]), axes)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn points_of_a_plane_are_on_it(
            nx in -0.7..0.7f64, ny in -0.7..0.7f64, distance in 0.2..12.0f64,
            places in proptest::collection::vec((-1.0..1.0f64, -1.0..1.0f64), 8..40),
        ) {
            let normal = DVec3::new(nx, ny, 1.0).normalize();
            let points: Vec<DVec3> = places.iter().map(|&(x, y)| {
                DVec3::new(x, y, (distance - normal.x * x - normal.y * y) / normal.z)
            }).collect();
            let centre = points.iter().copied().sum::<DVec3>() / points.len() as f64;
            let plane = Plane::fitted(&points).unwrap();
            prop_assume!(normal.dot(centre) > 0.0);
            prop_assert!(plane.normal.distance(normal) < 1e-6, "{:?} {:?}", plane.normal, normal);
            prop_assert!((plane.distance_m - distance).abs() < 1e-6);
            prop_assert!(points.iter().all(|&p| plane.signed_distance(p).abs() < 1e-9));
        }
    }

    #[test]
    fn what_makes_no_plane() {
        let line: Vec<DVec3> = (0..9).map(|i| DVec3::new(f64::from(i), 0.0, 2.0)).collect();
        for points in [&[][..], &[DVec3::Z], &[DVec3::Z; 5], &line] {
            assert_eq!(Plane::fitted(points), None);
        }
    }
}

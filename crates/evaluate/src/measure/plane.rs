use oaktwin_camera::math::DVec3;

/// A plane in the camera's frame (x right, y down, z forward; metres): the points p with `normal · p = distance`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FittedPlane {
    /// The unit normal, which points away from the camera.
    pub normal: DVec3,
    /// The distance from the optical centre in metres, above 0.
    pub distance_m: f64,
}

impl FittedPlane {
    /// Fits a plane to points seen by a depth camera; `None` if they do not define one, or if it would pass through the camera.
    ///
    /// The inverse depth of a plane is linear in the image, so the fit minimizes the squared errors of inverse depth, that is of
    /// disparity. Unlike a fit of distances, it works where the noise along the rays exceeds the visible extent of the board.
    #[must_use]
    pub fn fitted(points: &[DVec3]) -> Option<Self> {
        let count = points.len() as f64;
        let seen = || points.iter().map(|p| DVec3::new(p.x / p.z, p.y / p.z, 1.0 / p.z));
        let centre = seen().sum::<DVec3>() / count;
        let (mut xx, mut xy, mut yy, mut xw, mut yw) = (0.0, 0.0, 0.0, 0.0, 0.0);
        for at in seen() {
            let off = at - centre;
            xx += off.x * off.x;
            xy += off.x * off.y;
            yy += off.y * off.y;
            xw += off.x * off.z;
            yw += off.y * off.z;
        }
        let determinant = xx * yy - xy * xy;
        // The points are collinear up to rounding.
        if determinant.is_nan() || determinant <= 1e-12 * (xx + yy).powi(2) {
            return None;
        }
        let slope_x = (yy * xw - xy * yw) / determinant;
        let slope_y = (xx * yw - xy * xw) / determinant;
        // Inverse depth is normal · (x, y, 1) / distance.
        let scaled = DVec3::new(
            slope_x,
            slope_y,
            centre.z - slope_x * centre.x - slope_y * centre.y,
        );
        let length = scaled.length();
        (length > 0.0 && length.is_finite()).then(|| Self {
            normal: scaled / length,
            distance_m: 1.0 / length,
        })
    }

    /// Returns the distance of a point behind the plane in metres.
    #[must_use]
    pub fn signed_distance(&self, point: DVec3) -> f64 {
        self.normal.dot(point) - self.distance_m
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn points_of_a_plane_are_on_it(
            nx in -0.7..0.7f64, ny in -0.7..0.7f64, distance in 0.2..12.0f64,
            places in proptest::collection::vec((-0.3..0.3f64, -0.3..0.3f64), 8..40),
        ) {
            let normal = DVec3::new(nx, ny, 1.0).normalize();
            let points: Vec<DVec3> = places.iter().map(|&(x, y)| {
                let ray = DVec3::new(x, y, 1.0);
                ray * (distance / normal.dot(ray))
            }).collect();
            let plane = FittedPlane::fitted(&points).unwrap();
            prop_assert!(plane.normal.distance(normal) < 1e-6, "{:?} {:?}", plane.normal, normal);
            prop_assert!((plane.distance_m - distance).abs() < 1e-6 * distance);
            prop_assert!(points.iter().all(|&p| plane.signed_distance(p).abs() < 1e-6));
        }
    }

    /// The noise is metres deep, and only half a metre of the board is visible.
    #[test]
    fn noise_does_not_tilt_the_plane() {
        let points: Vec<DVec3> = (0..400u16)
            .map(|i| {
                let ray = DVec3::new(f64::from(i % 20) / 400.0, f64::from(i / 20) / 400.0, 1.0);
                let disparity = 3.0 + if (i + i / 20).is_multiple_of(2) { 0.3 } else { -0.3 };
                ray * (30.0 / disparity)
            })
            .collect();
        let plane = FittedPlane::fitted(&points).unwrap();
        assert!(plane.normal.z > 0.999, "{plane:?}");
        assert!((plane.distance_m - 10.0).abs() < 0.2, "{plane:?}");
    }

    #[test]
    fn rejects_points_that_define_no_plane() {
        let line: Vec<DVec3> = (0..9).map(|i| DVec3::new(f64::from(i), 0.0, 2.0)).collect();
        for points in [&[][..], &[DVec3::Z], &[DVec3::Z; 5], &line] {
            assert_eq!(FittedPlane::fitted(points), None);
        }
    }
}

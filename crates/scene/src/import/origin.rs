use oaktwin_camera::math::{DAffine3, DVec3};

/// The coordinate from which single precision loses what depth shows: neighbouring numbers are 0.06 mm apart in metres.
const LARGE: f64 = 1000.0;

/// The origin of a file's mesh: near its first point if that is far from the file's own, as with coordinates of a map.
///
/// Meshes have single precision, and instances place them with double precision.
#[derive(Debug, Default)]
pub(super) struct Origin(Option<DVec3>);

impl Origin {
    /// Returns a point of the file relative to the origin.
    pub(super) fn relative(&mut self, point: [f64; 3]) -> [f32; 3] {
        let point = DVec3::from(point);
        let origin = *self.0.get_or_insert_with(|| {
            let far = |x: f64| {
                if x.is_finite() && x.abs() >= LARGE {
                    x.round()
                } else {
                    0.0
                }
            };
            DVec3::new(far(point.x), far(point.y), far(point.z))
        });
        (point - origin).as_vec3().to_array()
    }

    /// Returns the transform from the mesh to the file.
    pub(super) fn file_from_mesh(&self) -> DAffine3 {
        DAffine3::from_translation(self.0.unwrap_or_default())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_large_coordinates_move() {
        let mut near = Origin::default();
        assert_eq!(near.relative([1.5, -999.0, 0.25]), [1.5, -999.0, 0.25]);
        assert_eq!(near.relative([1e6, 0.0, 0.0]), [1e6, 0.0, 0.0]);
        assert_eq!(near.file_from_mesh(), DAffine3::IDENTITY);
        let mut far = Origin::default();
        assert_eq!(far.relative([499_123.4, 4_649_776.25, 215.5]), [0.4, 0.25, 215.5]);
        assert_eq!(far.relative([499_124.0, 4_649_777.0, 0.0]), [1.0, 1.0, 0.0]);
        assert_eq!(
            far.file_from_mesh().translation,
            DVec3::new(499_123.0, 4_649_776.0, 0.0)
        );
        assert!(Origin::default().relative([f64::NAN, f64::INFINITY, 0.0])[0].is_nan());
    }
}

use glam::{DMat3, DMat4, DQuat, DVec3};

/// The axes of a right-handed frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axes {
    /// A camera prim of OpenUSD: x right, y up, looking along −z.
    Usd,
    /// OpenCV, DepthAI and ROS's `*_optical_frame`: x right, y down, z forward.
    OpenCv,
    /// A body in ROS (REP-103): x forward, y left, z up.
    Ros,
}

impl Axes {
    /// Returns the rotation of coordinates in axes `from` to coordinates in axes `self`.
    #[must_use]
    pub fn rotation_from(self, from: Self) -> DMat3 {
        self.opencv_from_self().transpose() * from.opencv_from_self()
    }

    fn opencv_from_self(self) -> DMat3 {
        match self {
            Self::OpenCv => DMat3::IDENTITY,
            Self::Usd => DMat3::from_diagonal(DVec3::new(1.0, -1.0, -1.0)),
            // Columns: forward is +z, left is −x, up is −y.
            Self::Ros => DMat3::from_cols(DVec3::Z, DVec3::NEG_X, DVec3::NEG_Y),
        }
    }
}

/// A rotation and a translation: `point_in_target = rotation · point_in_source + translation`.
///
/// A value is named `target_from_source`. The unit of the translation is up to the caller; this project uses metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RigidTransform {
    /// An orthonormal matrix with determinant +1.
    pub rotation: DMat3,
    /// The position of the source's origin in the target frame.
    pub translation: DVec3,
}

impl RigidTransform {
    /// The identity.
    pub const IDENTITY: Self = Self {
        rotation: DMat3::IDENTITY,
        translation: DVec3::ZERO,
    };

    /// Creates a transform from a rotation and a translation.
    #[must_use]
    pub const fn new(rotation: DMat3, translation: DVec3) -> Self {
        Self {
            rotation,
            translation,
        }
    }

    /// Creates a transform from the rows of a 4×4 matrix, as OpenCV and DepthAI print it. The last row is assumed to be
    /// (0, 0, 0, 1).
    #[must_use]
    pub fn from_rows(rows: [[f64; 4]; 4]) -> Self {
        let m = DMat4::from_cols_array_2d(&rows).transpose();
        Self::new(DMat3::from_mat4(m), m.w_axis.truncate())
    }

    /// Returns the rows of the 4×4 matrix for column vectors (OpenUSD uses the transpose).
    #[must_use]
    pub fn rows(&self) -> [[f64; 4]; 4] {
        let m = DMat4::from_mat3_translation(self.rotation, self.translation);
        m.transpose().to_cols_array_2d()
    }

    /// Returns `source_from_target`.
    #[must_use]
    pub fn inverse(&self) -> Self {
        let rotation = self.rotation.transpose();
        Self::new(rotation, -(rotation * self.translation))
    }

    /// Transforms a point.
    #[must_use]
    pub fn apply(&self, point_in_source: DVec3) -> DVec3 {
        self.rotation * point_in_source + self.translation
    }

    /// Returns the rotation as a unit quaternion with w ≥ 0.
    #[must_use]
    pub fn quaternion(&self) -> DQuat {
        let q = DQuat::from_mat3(&self.rotation).normalize();
        if q.w < 0.0 { -q } else { q }
    }

    /// Returns the deviation of the rotation from orthonormal: the largest entry of `|RᵀR − I|`, or infinity for a
    /// reflection.
    #[must_use]
    pub fn orthonormality_error(&self) -> f64 {
        if self.rotation.determinant() <= 0.0 {
            return f64::INFINITY;
        }
        let d = self.rotation.transpose() * self.rotation - DMat3::IDENTITY;
        d.to_cols_array()
            .into_iter()
            .fold(0.0, |worst, x| if x.is_nan() { x } else { worst.max(x.abs()) })
    }
}

/// Composes transforms: `a_from_c = a_from_b * b_from_c`.
impl std::ops::Mul for RigidTransform {
    type Output = Self;

    fn mul(self, b_from_c: Self) -> Self {
        Self::new(
            self.rotation * b_from_c.rotation,
            self.apply(b_from_c.translation),
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn converts_between_axes() {
        let forward = DVec3::Z; // OpenCV
        assert_eq!(Axes::Ros.rotation_from(Axes::OpenCv) * forward, DVec3::X);
        assert_eq!(Axes::Usd.rotation_from(Axes::OpenCv) * forward, DVec3::NEG_Z);
        assert_eq!(Axes::Ros.rotation_from(Axes::OpenCv) * DVec3::X, DVec3::NEG_Y);
        assert_eq!(Axes::Ros.rotation_from(Axes::Usd) * DVec3::Y, DVec3::Z);
        for a in [Axes::Usd, Axes::OpenCv, Axes::Ros] {
            for b in [Axes::Usd, Axes::OpenCv, Axes::Ros] {
                assert_eq!(a.rotation_from(b) * b.rotation_from(a), DMat3::IDENTITY);
                assert_eq!(a.rotation_from(b).determinant(), 1.0);
            }
        }
    }

    #[test]
    fn rows_round_trip() {
        let t = RigidTransform::new(DMat3::from_rotation_z(0.3), DVec3::new(1.0, 2.0, 3.0));
        assert_eq!(t.rows()[0][3], 1.0);
        assert_eq!(t.rows()[1][0], 0.3_f64.sin());
        assert_eq!(RigidTransform::from_rows(t.rows()), t);
    }

    proptest! {
        #[test]
        fn inverse_cancels(axis in prop::array::uniform3(-1.0..1.0f64), angle in -3.0..3.0f64, t in prop::array::uniform3(-10.0..10.0f64)) {
            prop_assume!(DVec3::from(axis).length() > 0.1);
            let a_from_b = RigidTransform::new(DMat3::from_axis_angle(DVec3::from(axis).normalize(), angle), DVec3::from(t));
            let p = DVec3::new(0.1, -2.0, 5.0);
            prop_assert!((a_from_b.inverse().apply(a_from_b.apply(p)) - p).length() < 1e-12);
            prop_assert!(((a_from_b * a_from_b.inverse()).apply(p) - p).length() < 1e-12);
            prop_assert!(a_from_b.orthonormality_error() < 1e-14);
        }
    }
}

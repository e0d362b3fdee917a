use oaktwin_camera::math::{DAffine3, DMat3, DMat4, DQuat, DVec3};
use openusd::sdf::Value;

use super::reader::{Reader, Record};
use super::value::{number, quaternion, texts, vec3};

/// The transform authored on a prim.
#[derive(Clone, Copy)]
pub(super) struct LocalTransform {
    /// The product of all ops.
    pub(super) parent_from_prim: DAffine3,
    /// Whether ancestors' transforms are ignored (`!resetXformStack!`).
    pub(super) resets: bool,
}

impl LocalTransform {
    /// Returns the transform from the prim to the stage below a parent with the transform `stage_from_parent`.
    pub(super) fn below(&self, stage_from_parent: DAffine3) -> DAffine3 {
        if self.resets {
            self.parent_from_prim
        } else {
            stage_from_parent * self.parent_from_prim
        }
    }
}

/// The types without a transform: OpenUSD ignores ops authored on them, too.
const UNTRANSFORMED_TYPES: [&str; 8] = [
    "",
    "Scope",
    "Material",
    "Shader",
    "NodeGraph",
    "GeomSubset",
    "RenderProduct",
    "RenderSettings",
];

/// Whether prims of a type have a transform.
pub(super) fn is_transformed(kind: &str) -> bool {
    !UNTRANSFORMED_TYPES.contains(&kind)
}

/// Returns the transform authored on a prim, if any.
pub(super) fn local_transform(reader: &Reader, prim: &Record) -> Option<LocalTransform> {
    if !prim.has("xformOpOrder") || !is_transformed(prim.type_name.as_str()) {
        return None;
    }
    let mut ops = texts(reader.value(prim, "xformOpOrder")?)?;
    // Ops before the last reset are ignored like ancestors.
    let reset = ops.iter().rposition(|op| op == "!resetXformStack!");
    if let Some(reset) = reset {
        ops.drain(..=reset);
    }
    let mut parent_from_prim = DAffine3::IDENTITY;
    for op in &ops {
        let (name, inverted) = match op.strip_prefix("!invert!") {
            Some(name) => (name, true),
            None => (op.as_str(), false),
        };
        let Some(matrix) = reader.value(prim, name).and_then(|value| matrix(name, &value)) else {
            continue;
        };
        // The first op in the list is applied last.
        parent_from_prim *= if inverted { matrix.inverse() } else { matrix };
    }
    Some(LocalTransform {
        parent_from_prim,
        resets: reset.is_some(),
    })
}

/// Returns the matrix of an op; `None` for unknown ops and values of the wrong type, which OpenUSD skips, too.
fn matrix(name: &str, value: &Value) -> Option<DAffine3> {
    let kind = name.strip_prefix("xformOp:")?.split(':').next()?;
    Some(match kind {
        "translate" => DAffine3::from_translation(vec3(value)?),
        "translateX" => DAffine3::from_translation(DVec3::X * number(value)?),
        "translateY" => DAffine3::from_translation(DVec3::Y * number(value)?),
        "translateZ" => DAffine3::from_translation(DVec3::Z * number(value)?),
        "scale" => DAffine3::from_scale(vec3(value)?),
        "scaleX" => DAffine3::from_scale(DVec3::new(number(value)?, 1.0, 1.0)),
        "scaleY" => DAffine3::from_scale(DVec3::new(1.0, number(value)?, 1.0)),
        "scaleZ" => DAffine3::from_scale(DVec3::new(1.0, 1.0, number(value)?)),
        "orient" => DAffine3::from_mat3(rotation(quaternion(value)?)),
        "transform" => {
            let Value::Matrix4d(matrix) = value else {
                return None;
            };
            affine(&matrix.0)
        }
        _ => DAffine3::from_mat3(euler(kind.strip_prefix("rotate")?, value)?),
    })
}

/// Returns the product of rotations about `axes`, applied in that order; angles are in degrees.
fn euler(axes: &str, value: &Value) -> Option<DMat3> {
    let angles = match axes {
        "X" | "Y" | "Z" => DVec3::splat(number(value)?),
        "XYZ" | "XZY" | "YXZ" | "YZX" | "ZXY" | "ZYX" => vec3(value)?,
        _ => return None,
    };
    let mut rotation = DMat3::IDENTITY;
    for axis in axes.chars() {
        let one = match axis {
            'X' => DMat3::from_rotation_x(angles.x.to_radians()),
            'Y' => DMat3::from_rotation_y(angles.y.to_radians()),
            _ => DMat3::from_rotation_z(angles.z.to_radians()),
        };
        rotation = one * rotation;
    }
    Some(rotation)
}

/// Returns the rotation of a quaternion that may not be normalized, like OpenUSD's `GfRotation`: about its imaginary
/// part, by twice the arc cosine of its real part.
fn rotation(quaternion: DQuat) -> DMat3 {
    let imaginary = DVec3::new(quaternion.x, quaternion.y, quaternion.z);
    let length = imaginary.length();
    if length <= 1e-10 || !length.is_finite() {
        return DMat3::IDENTITY;
    }
    let angle = 2.0 * quaternion.w.clamp(-1.0, 1.0).acos();
    DMat3::from_axis_angle(imaginary / length, angle)
}

/// Returns the matrix of a quaternion without normalization, like OpenUSD's point instancers. It is a rotation only if
/// the quaternion is normalized.
pub(super) fn unchecked_rotation(q: DQuat) -> DMat3 {
    let (xx, yy, zz) = (q.x * q.x, q.y * q.y, q.z * q.z);
    let (xy, xz, yz) = (q.x * q.y, q.x * q.z, q.y * q.z);
    let (wx, wy, wz) = (q.w * q.x, q.w * q.y, q.w * q.z);
    DMat3::from_cols(
        DVec3::new(1.0 - 2.0 * (yy + zz), 2.0 * (xy + wz), 2.0 * (xz - wy)),
        DVec3::new(2.0 * (xy - wz), 1.0 - 2.0 * (xx + zz), 2.0 * (yz + wx)),
        DVec3::new(2.0 * (xz + wy), 2.0 * (yz - wx), 1.0 - 2.0 * (xx + yy)),
    )
}

/// Converts OpenUSD's matrix for row vectors, ignoring its projective part.
pub(super) fn affine(rows: &[f64; 16]) -> DAffine3 {
    DAffine3::from_mat4(DMat4::from_cols_array(rows))
}

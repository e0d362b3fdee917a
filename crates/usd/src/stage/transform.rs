use oaktwin_camera::math::{DAffine3, DMat3, DMat4, DQuat, DVec3};
use openusd::sdf::Value;

use super::reader::{Reader, Record};
use super::value::{number, quaternion, texts, vec3};

/// A prim's transform ops.
#[derive(Clone, Copy)]
pub(super) struct LocalTransform {
    /// All ops together.
    pub(super) parent_from_prim: DAffine3,
    /// Whether what its ancestors say does not count (`!resetXformStack!`).
    pub(super) resets: bool,
}

/// Types that have no place in space, whatever is authored on them: OpenUSD does not look there either.
const PLACELESS: [&str; 8] = [
    "",
    "Scope",
    "Material",
    "Shader",
    "NodeGraph",
    "GeomSubset",
    "RenderProduct",
    "RenderSettings",
];

/// The transform that a prim authors; `None` where it authors none.
pub(super) fn local_transform(reader: &Reader, prim: &Record) -> Option<LocalTransform> {
    if !prim.has("xformOpOrder") || PLACELESS.contains(&prim.type_name.as_str()) {
        return None;
    }
    let mut ops = texts(reader.value(prim, "xformOpOrder")?)?;
    // Whatever is listed before the last reset counts no more than the ancestors.
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
        // Listed first is applied last.
        parent_from_prim *= if inverted { matrix.inverse() } else { matrix };
    }
    Some(LocalTransform {
        parent_from_prim,
        resets: reset.is_some(),
    })
}

/// One op's matrix; `None` where its kind is unknown or its value of the wrong type, which OpenUSD passes over too.
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

/// Rotations about the axes that `axes` names, the first one first; degrees.
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

/// The rotation of a quaternion that need not be of length 1: its axis, and the angle whose half has the real part
/// for its cosine, as OpenUSD's `GfRotation` takes it.
fn rotation(quaternion: DQuat) -> DMat3 {
    let imaginary = DVec3::new(quaternion.x, quaternion.y, quaternion.z);
    let length = imaginary.length();
    if length <= 1e-10 || !length.is_finite() {
        return DMat3::IDENTITY;
    }
    let angle = 2.0 * quaternion.w.clamp(-1.0, 1.0).acos();
    DMat3::from_axis_angle(imaginary / length, angle)
}

/// The matrix of a quaternion as it stands, which for one that is not of length 1 is no rotation: OpenUSD's point
/// instancers take theirs like this.
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

/// A matrix as OpenUSD writes it, for row vectors, without its projective part.
fn affine(rows: &[f64; 16]) -> DAffine3 {
    DAffine3::from_mat4(DMat4::from_cols_array(rows))
}

//! Converts the USD library's value types.

use oaktwin_camera::math::{DQuat, DVec3};
use openusd::gf::f16;
use openusd::sdf::Value as V;

/// Converts a scalar of any precision.
pub(super) fn number(value: &V) -> Option<f64> {
    Some(match value {
        V::Half(v) => v.to_f64(),
        V::Float(v) => (*v).into(),
        V::Double(v) => *v,
        V::TimeCode(v) => v.value(),
        V::Int(v) => (*v).into(),
        V::Uint(v) => (*v).into(),
        V::Uchar(v) => (*v).into(),
        #[expect(
            clippy::cast_precision_loss,
            reason = "attributes have no integers beyond 2^53"
        )]
        V::Int64(v) => *v as f64,
        _ => return None,
    })
}

/// Converts a scalar to single precision.
#[expect(clippy::cast_possible_truncation, reason = "single precision is intended")]
pub(super) fn single(value: &V) -> Option<f32> {
    number(value).map(|v| v as f32)
}

/// Converts a vector of any precision.
pub(super) fn vec3(value: &V) -> Option<DVec3> {
    Some(match value {
        V::Vec3d(v) => DVec3::new(v.x, v.y, v.z),
        V::Vec3f(v) => DVec3::new(v.x.into(), v.y.into(), v.z.into()),
        V::Vec3h(v) => DVec3::new(v.x.to_f64(), v.y.to_f64(), v.z.to_f64()),
        V::Vec3i(v) => DVec3::new(v.x.into(), v.y.into(), v.z.into()),
        _ => return None,
    })
}

/// Converts a colour, or the first three components of a 4-vector, to single precision.
#[expect(clippy::cast_possible_truncation, reason = "colours have single precision")]
pub(super) fn color(value: &V) -> Option<[f32; 3]> {
    match value {
        V::Vec4f(v) => Some([v.x, v.y, v.z]),
        V::Vec4d(v) => Some([v.x as f32, v.y as f32, v.z as f32]),
        V::Vec4h(v) => Some([v.x.to_f32(), v.y.to_f32(), v.z.to_f32()]),
        _ => vec3(value).map(|v| v.as_vec3().to_array()),
    }
}

/// Converts a 4-vector to single precision.
#[expect(clippy::cast_possible_truncation, reason = "single precision is intended")]
pub(super) fn vec4(value: &V) -> Option<[f32; 4]> {
    Some(match value {
        V::Vec4f(v) => [v.x, v.y, v.z, v.w],
        V::Vec4d(v) => [v.x, v.y, v.z, v.w].map(|x| x as f32),
        V::Vec4h(v) => [v.x, v.y, v.z, v.w].map(f16::to_f32),
        _ => return None,
    })
}

/// Converts a 2-vector to single precision.
#[expect(clippy::cast_possible_truncation, reason = "single precision is intended")]
pub(super) fn vec2(value: &V) -> Option<[f32; 2]> {
    Some(match value {
        V::Vec2f(v) => [v.x, v.y],
        V::Vec2d(v) => [v.x as f32, v.y as f32],
        V::Vec2h(v) => [v.x.to_f32(), v.y.to_f32()],
        _ => return None,
    })
}

/// Converts a quaternion of any precision, without normalization.
pub(super) fn quaternion(value: &V) -> Option<DQuat> {
    Some(match value {
        V::Quatd(q) => DQuat::from_xyzw(q.x, q.y, q.z, q.w),
        V::Quatf(q) => DQuat::from_xyzw(q.x.into(), q.y.into(), q.z.into(), q.w.into()),
        V::Quath(q) => DQuat::from_xyzw(q.x.to_f64(), q.y.to_f64(), q.z.to_f64(), q.w.to_f64()),
        _ => return None,
    })
}

/// Converts a token, string or asset path.
pub(super) fn text(value: V) -> Option<String> {
    match value {
        V::Token(v) => Some(v.as_str().to_owned()),
        V::String(v) => Some(v),
        V::AssetPath(v) => Some(v.authored_path),
        _ => None,
    }
}

/// Converts one or more tokens or strings.
pub(super) fn texts(value: V) -> Option<Vec<String>> {
    match value {
        V::TokenVec(v) => Some(v.iter().map(|token| token.as_str().to_owned()).collect()),
        V::StringVec(v) => Some(v),
        V::TokenListOp(op) => Some(op.flatten().into_iter().map(String::from).collect()),
        V::StringListOp(op) => Some(op.flatten()),
        other => text(other).map(|text| vec![text]),
    }
}

/// Converts a `bool` or an `int`.
pub(super) fn boolean(value: &V) -> Option<bool> {
    match value {
        V::Bool(v) => Some(*v),
        V::Int(v) => Some(*v != 0),
        _ => None,
    }
}

/// Converts an array of integers.
pub(super) fn ints(value: V) -> Option<Vec<i32>> {
    match value {
        V::IntVec(v) => Some(v),
        V::UintVec(v) => v.into_iter().map(|v| i32::try_from(v).ok()).collect(),
        V::Int64Vec(v) => v.into_iter().map(|v| i32::try_from(v).ok()).collect(),
        V::UcharVec(v) => Some(v.into_iter().map(i32::from).collect()),
        _ => None,
    }
}

/// Converts a number or an array of numbers.
#[expect(clippy::cast_possible_truncation, reason = "single precision is intended")]
pub(super) fn floats(value: V) -> Option<Vec<f32>> {
    match value {
        V::FloatVec(v) => Some(v),
        V::DoubleVec(v) => Some(v.into_iter().map(|v| v as f32).collect()),
        V::HalfVec(v) => Some(v.into_iter().map(f16::to_f32).collect()),
        other => single(&other).map(|v| vec![v]),
    }
}

/// Converts a point, vector or colour or an array of them. Arrays in single precision are not copied.
#[expect(clippy::cast_possible_truncation, reason = "single precision is intended")]
pub(super) fn vec3s(value: V) -> Option<Vec<[f32; 3]>> {
    match value {
        V::Vec3fVec(v) => Some(v.into_iter().map(<[f32; 3]>::from).collect()),
        V::Vec3dVec(v) => Some(
            v.into_iter()
                .map(|v| [v.x as f32, v.y as f32, v.z as f32])
                .collect(),
        ),
        V::Vec3hVec(v) => Some(
            v.into_iter()
                .map(|v| [v.x.to_f32(), v.y.to_f32(), v.z.to_f32()])
                .collect(),
        ),
        V::Vec4fVec(v) => Some(v.into_iter().map(|v| [v.x, v.y, v.z]).collect()),
        other => color(&other).map(|v| vec![v]),
    }
}

/// Converts texture coordinates or an array of them, taking the first two of three components.
#[expect(clippy::cast_possible_truncation, reason = "single precision is intended")]
pub(super) fn vec2s(value: V) -> Option<Vec<[f32; 2]>> {
    match value {
        V::Vec2fVec(v) => Some(v.into_iter().map(<[f32; 2]>::from).collect()),
        V::Vec2dVec(v) => Some(v.into_iter().map(|v| [v.x as f32, v.y as f32]).collect()),
        V::Vec2hVec(v) => Some(v.into_iter().map(|v| [v.x.to_f32(), v.y.to_f32()]).collect()),
        V::Vec3fVec(v) => Some(v.into_iter().map(|v| [v.x, v.y]).collect()),
        other => vec2(&other).map(|v| vec![v]),
    }
}

/// Converts a quaternion or an array of them, without normalization.
pub(super) fn quaternions(value: V) -> Option<Vec<DQuat>> {
    Some(match value {
        V::QuathVec(v) => v.into_iter().filter_map(|q| quaternion(&V::Quath(q))).collect(),
        V::QuatfVec(v) => v.into_iter().filter_map(|q| quaternion(&V::Quatf(q))).collect(),
        V::QuatdVec(v) => v.into_iter().filter_map(|q| quaternion(&V::Quatd(q))).collect(),
        other => vec![quaternion(&other)?],
    })
}

/// Converts an array of ids.
pub(super) fn ids(value: V) -> Option<Vec<i64>> {
    match value {
        V::Int64Vec(v) => Some(v),
        V::IntVec(v) => Some(v.into_iter().map(i64::from).collect()),
        V::Int64ListOp(op) => Some(op.flatten()),
        V::IntListOp(op) => Some(op.flatten().into_iter().map(i64::from).collect()),
        _ => None,
    }
}

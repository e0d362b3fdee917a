//! The types of values, by their names in text layers.

/// The type of the numbers in a vector, a quaternion or an array.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Number {
    Int,
    Half,
    Float,
    Double,
}

/// The type of a value without its role: a point is a vector.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ValueKind {
    Bool,
    Uchar,
    Uint,
    Int64,
    Uint64,
    TimeCode,
    String,
    Token,
    Asset,
    PathExpression,
    Dictionary,
    Scalar(Number),
    /// A vector, with the number of its components.
    Vector(Number, usize),
    Quaternion(Number),
    /// A square matrix, with the number of its rows.
    Matrix(usize),
}

impl ValueKind {
    /// Returns the type of the name `name`, which may be one that OpenUSD keeps for old files; `None` if no values of
    /// such a type are known.
    pub(super) fn named(name: &str) -> Option<Self> {
        use Number::{Double, Float, Half, Int};
        Some(match name {
            "bool" => Self::Bool,
            "uchar" => Self::Uchar,
            "int" | "PointIndex" | "EdgeIndex" | "FaceIndex" => Self::Scalar(Int),
            "uint" => Self::Uint,
            "int64" => Self::Int64,
            "uint64" => Self::Uint64,
            "half" => Self::Scalar(Half),
            "float" => Self::Scalar(Float),
            "double" => Self::Scalar(Double),
            "timecode" => Self::TimeCode,
            "string" => Self::String,
            "token" => Self::Token,
            "asset" => Self::Asset,
            "pathExpression" => Self::PathExpression,
            "dictionary" => Self::Dictionary,
            "int2" | "Vec2i" => Self::Vector(Int, 2),
            "int3" | "Vec3i" => Self::Vector(Int, 3),
            "int4" | "Vec4i" => Self::Vector(Int, 4),
            "half2" | "Vec2h" | "texCoord2h" => Self::Vector(Half, 2),
            "half3" | "Vec3h" | "point3h" | "normal3h" | "vector3h" | "color3h" | "texCoord3h" => {
                Self::Vector(Half, 3)
            }
            "half4" | "Vec4h" | "color4h" => Self::Vector(Half, 4),
            "float2" | "Vec2f" | "texCoord2f" => Self::Vector(Float, 2),
            "float3" | "Vec3f" | "point3f" | "PointFloat" | "normal3f" | "NormalFloat" | "vector3f"
            | "VectorFloat" | "color3f" | "ColorFloat" | "texCoord3f" => Self::Vector(Float, 3),
            "float4" | "Vec4f" | "color4f" => Self::Vector(Float, 4),
            "double2" | "Vec2d" | "texCoord2d" => Self::Vector(Double, 2),
            "double3" | "Vec3d" | "point3d" | "Point" | "normal3d" | "Normal" | "vector3d" | "Vector"
            | "color3d" | "Color" | "texCoord3d" => Self::Vector(Double, 3),
            "double4" | "Vec4d" | "color4d" => Self::Vector(Double, 4),
            "quath" | "Quath" => Self::Quaternion(Half),
            "quatf" | "Quatf" => Self::Quaternion(Float),
            "quatd" | "Quatd" => Self::Quaternion(Double),
            "matrix2d" | "Matrix2d" => Self::Matrix(2),
            "matrix3d" | "Matrix3d" => Self::Matrix(3),
            "matrix4d" | "Matrix4d" | "frame4d" | "Frame" | "Transform" => Self::Matrix(4),
            _ => return None,
        })
    }
}

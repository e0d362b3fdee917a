use std::collections::BTreeMap;

/// Named values, sorted by name.
pub type Dictionary = BTreeMap<String, SpecValue>;

/// A value with its OpenUSD type.
#[derive(Clone, Debug, PartialEq)]
pub enum SpecValue {
    /// `bool`.
    Bool(bool),
    /// `int`.
    Int(i32),
    /// `float`.
    Float(f32),
    /// `double`.
    Double(f64),
    /// `string`.
    String(String),
    /// `token`.
    Token(String),
    /// `asset`, a path.
    Asset(String),
    /// `int2`.
    Int2([i32; 2]),
    /// `float2`.
    Float2([f32; 2]),
    /// `float4`.
    Float4([f32; 4]),
    /// `color3f`.
    Color3f([f32; 3]),
    /// `double3`.
    Double3([f64; 3]),
    /// `quatd`, the real part first.
    Quatd([f64; 4]),
    /// `matrix4d`, row by row, translation in the last row.
    Matrix4d([[f64; 4]; 4]),
    /// `token[]`.
    TokenArray(Vec<String>),
    /// `int[]`.
    IntArray(Vec<i32>),
    /// `float[]`.
    FloatArray(Vec<f32>),
    /// `float3[]`.
    Float3Array(Vec<[f32; 3]>),
    /// `point3f[]`.
    Point3fArray(Vec<[f32; 3]>),
    /// `normal3f[]`.
    Normal3fArray(Vec<[f32; 3]>),
    /// `color3f[]`.
    Color3fArray(Vec<[f32; 3]>),
    /// `texCoord2f[]`.
    TexCoord2fArray(Vec<[f32; 2]>),
    /// `dictionary`, valid in metadata only.
    Dictionary(Dictionary),
}

impl SpecValue {
    /// Creates a token.
    pub fn token(text: impl Into<String>) -> Self {
        Self::Token(text.into())
    }

    /// Creates a string.
    pub fn string(text: impl Into<String>) -> Self {
        Self::String(text.into())
    }

    /// Returns OpenUSD's name of the type.
    #[must_use]
    pub const fn type_name(&self) -> &'static str {
        match self {
            Self::Bool(_) => "bool",
            Self::Int(_) => "int",
            Self::Float(_) => "float",
            Self::Double(_) => "double",
            Self::String(_) => "string",
            Self::Token(_) => "token",
            Self::Asset(_) => "asset",
            Self::Int2(_) => "int2",
            Self::Float2(_) => "float2",
            Self::Float4(_) => "float4",
            Self::Color3f(_) => "color3f",
            Self::Double3(_) => "double3",
            Self::Quatd(_) => "quatd",
            Self::Matrix4d(_) => "matrix4d",
            Self::TokenArray(_) => "token[]",
            Self::IntArray(_) => "int[]",
            Self::FloatArray(_) => "float[]",
            Self::Float3Array(_) => "float3[]",
            Self::Point3fArray(_) => "point3f[]",
            Self::Normal3fArray(_) => "normal3f[]",
            Self::Color3fArray(_) => "color3f[]",
            Self::TexCoord2fArray(_) => "texCoord2f[]",
            Self::Dictionary(_) => "dictionary",
        }
    }

    /// Whether all numbers in it are finite.
    #[must_use]
    pub fn is_finite(&self) -> bool {
        match self {
            Self::Float(v) => v.is_finite(),
            Self::Double(v) => v.is_finite(),
            Self::Float2(v) => v.iter().all(|x| x.is_finite()),
            Self::Float4(v) => v.iter().all(|x| x.is_finite()),
            Self::TexCoord2fArray(v) => v.iter().flatten().all(|x| x.is_finite()),
            Self::Color3f(v) => v.iter().all(|x| x.is_finite()),
            Self::Double3(v) => v.iter().all(|x| x.is_finite()),
            Self::Quatd(v) => v.iter().all(|x| x.is_finite()),
            Self::Matrix4d(v) => v.iter().flatten().all(|x| x.is_finite()),
            Self::FloatArray(v) => v.iter().all(|x| x.is_finite()),
            Self::Float3Array(v) | Self::Point3fArray(v) | Self::Normal3fArray(v) | Self::Color3fArray(v) => {
                v.iter().flatten().all(|x| x.is_finite())
            }
            Self::Dictionary(entries) => entries.values().all(Self::is_finite),
            Self::Bool(_)
            | Self::Int(_)
            | Self::String(_)
            | Self::Token(_)
            | Self::Asset(_)
            | Self::Int2(_)
            | Self::TokenArray(_)
            | Self::IntArray(_) => true,
        }
    }
}

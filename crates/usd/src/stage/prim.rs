use std::collections::BTreeMap;

use oaktwin_camera::math::DVec3;
use oaktwin_camera::{Axes, ImageSize, RigidTransform, UsdOptics};
use serde::Serialize;

/// A composed prim: its authored attributes and relationships, schema fallbacks not among them.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Prim {
    /// `/Root/oak_d_pro/Camera_rgb_imx378`.
    pub path: String,
    /// `Camera`; empty where the prim has no type.
    pub type_name: String,
    /// The applied API schemas, strongest first.
    pub api_schemas: Vec<String>,
    /// Attributes by name, namespaces included.
    pub attributes: BTreeMap<String, Attribute>,
}

/// An authored attribute.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Attribute {
    /// The declared type, `float`, `token[]`.
    pub type_name: String,
    /// Its default value, or its first time sample. Absent where the attribute is declared or blocked only.
    pub value: Option<Value>,
    /// Whether it has time samples.
    pub animated: bool,
}

/// An attribute's value, its many types brought down to a few. Half and single precision become `f64` exactly.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Value {
    /// `bool`.
    Bool(bool),
    /// Any integer type that fits.
    Int(i64),
    /// `half`, `float`, `double`, `timecode`.
    Float(f64),
    /// `string`, `token`, `asset`.
    Text(String),
    /// `int2` to `int4`, `int[]` and other arrays of integers.
    Ints(Vec<i64>),
    /// `float2` to `double4`, `float[]`, `double[]`.
    Floats(Vec<f64>),
    /// `token[]`, `string[]`, `asset[]`.
    Texts(Vec<String>),
    /// A type that no rule looks at, by its name in the USD library.
    Other(String),
}

/// A camera of the scene.
#[derive(Clone, Debug, PartialEq)]
pub struct SceneCamera {
    /// Its prim.
    pub prim: Prim,
    /// Where it stands: metres, the camera's axes being `OpenCV`'s, the world's the stage's own.
    pub world_from_camera: RigidTransform,
}

impl Default for SceneCamera {
    /// At the origin, as OpenUSD's cameras stand there: looking along −z, y up.
    fn default() -> Self {
        Self {
            prim: Prim::default(),
            world_from_camera: RigidTransform::new(Axes::Usd.rotation_from(Axes::OpenCv), DVec3::ZERO),
        }
    }
}

/// A render product of the scene.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RenderProduct {
    /// Its prim.
    pub prim: Prim,
    /// The targets of its `camera` relationship.
    pub cameras: Vec<Target>,
}

/// A relationship's target.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Target {
    /// Where it points.
    pub path: String,
    /// The type of the prim there; absent where there is none.
    pub type_name: Option<String>,
}

impl Value {
    /// The number, if it is one.
    #[must_use]
    pub fn number(&self) -> Option<f64> {
        match self {
            Self::Bool(_)
            | Self::Text(_)
            | Self::Ints(_)
            | Self::Floats(_)
            | Self::Texts(_)
            | Self::Other(_) => None,
            #[expect(
                clippy::cast_precision_loss,
                reason = "attributes hold no integers beyond 2^53"
            )]
            Self::Int(int) => Some(*int as f64),
            Self::Float(float) => Some(*float),
        }
    }

    /// The numbers of a vector or an array.
    #[must_use]
    pub fn numbers(&self) -> Option<Vec<f64>> {
        match self {
            #[expect(
                clippy::cast_precision_loss,
                reason = "attributes hold no integers beyond 2^53"
            )]
            Self::Ints(ints) => Some(ints.iter().map(|int| *int as f64).collect()),
            Self::Floats(floats) => Some(floats.clone()),
            _ => None,
        }
    }
}

impl Prim {
    /// The last element of the path.
    #[must_use]
    pub fn name(&self) -> &str {
        self.path.rsplit('/').next().unwrap_or(&self.path)
    }

    /// The value of an attribute, if one is authored.
    #[must_use]
    pub fn value(&self, name: &str) -> Option<&Value> {
        self.attributes.get(name)?.value.as_ref()
    }

    /// The number that an attribute holds.
    #[must_use]
    pub fn number(&self, name: &str) -> Option<f64> {
        self.value(name)?.number()
    }

    /// The string or token that an attribute holds.
    #[must_use]
    pub fn text(&self, name: &str) -> Option<&str> {
        match self.value(name)? {
            Value::Text(text) => Some(text),
            _ => None,
        }
    }

    /// The two numbers that an attribute holds.
    #[must_use]
    pub fn pair(&self, name: &str) -> Option<(f64, f64)> {
        match *self.value(name)?.numbers()? {
            [a, b] => Some((a, b)),
            _ => None,
        }
    }

    /// The image size that an `int2` attribute holds; `None` also where it is not positive.
    #[must_use]
    pub fn size(&self, name: &str) -> Option<ImageSize> {
        let Value::Ints(ints) = self.value(name)? else {
            return None;
        };
        let [width, height] = ints[..] else { return None };
        let (width, height) = (u32::try_from(width).ok()?, u32::try_from(height).ok()?);
        (width > 0 && height > 0).then_some(ImageSize::new(width, height))
    }

    /// Whether an API schema is applied.
    #[must_use]
    pub fn has_api(&self, schema: &str) -> bool {
        self.api_schemas.iter().any(|applied| applied == schema)
    }

    /// The attributes whose name starts with `prefix`: what follows it, and the attribute.
    pub fn in_namespace<'a>(&'a self, prefix: &'a str) -> impl Iterator<Item = (&'a str, &'a Attribute)> {
        self.attributes
            .iter()
            .filter_map(move |(name, attribute)| Some((name.strip_prefix(prefix)?, attribute)))
    }
}

impl SceneCamera {
    /// `focalLength`, or the schema's fallback.
    #[must_use]
    pub fn focal_length(&self) -> f64 {
        self.prim.number("focalLength").unwrap_or(50.0)
    }

    /// `horizontalAperture`, or the schema's fallback.
    #[must_use]
    pub fn horizontal_aperture(&self) -> f64 {
        self.prim.number("horizontalAperture").unwrap_or(20.955)
    }

    /// `verticalAperture`, or the schema's fallback.
    #[must_use]
    pub fn vertical_aperture(&self) -> f64 {
        self.prim.number("verticalAperture").unwrap_or(15.2908)
    }

    /// `horizontalApertureOffset` and `verticalApertureOffset`, or the schema's fallbacks.
    #[must_use]
    pub fn aperture_offsets(&self) -> (f64, f64) {
        let of = |name| self.prim.number(name).unwrap_or(0.0);
        (of("horizontalApertureOffset"), of("verticalApertureOffset"))
    }

    /// `fStop`, or the schema's fallback: 0, no depth of field.
    #[must_use]
    pub fn f_stop(&self) -> f64 {
        self.prim.number("fStop").unwrap_or(0.0)
    }

    /// `clippingRange` in stage units, or the schema's fallback.
    #[must_use]
    pub fn clipping_range(&self) -> (f64, f64) {
        self.prim.pair("clippingRange").unwrap_or((1.0, 1_000_000.0))
    }

    /// Whether it projects in perspective, as it does unless `projection` says otherwise.
    #[must_use]
    pub fn is_perspective(&self) -> bool {
        self.prim.text("projection").unwrap_or("perspective") == "perspective"
    }

    /// The optical attributes, whatever their unit.
    #[must_use]
    pub fn optics(&self) -> UsdOptics {
        let (h, v) = self.aperture_offsets();
        UsdOptics {
            focal_length_mm: self.focal_length(),
            horizontal_aperture_mm: self.horizontal_aperture(),
            vertical_aperture_mm: self.vertical_aperture(),
            horizontal_aperture_offset_mm: h,
            vertical_aperture_offset_mm: v,
        }
    }
}

impl RenderProduct {
    /// `resolution`, where it is authored and positive.
    #[must_use]
    pub fn resolution(&self) -> Option<ImageSize> {
        self.prim.size("resolution")
    }
}

use std::collections::BTreeMap;

use oaktwin_camera::math::DVec3;
use oaktwin_camera::{Axes, ImageSize, RigidTransform, UsdOptics};
use serde::Serialize;

/// A composed prim with its authored attributes, without schema fallbacks.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Prim {
    /// The path, such as `/Root/oak_d_pro/Camera_rgb_imx378`.
    pub path: String,
    /// The type, such as `Camera`; empty if the prim has none.
    pub type_name: String,
    /// The applied API schemas, strongest first.
    pub api_schemas: Vec<String>,
    /// The attributes by full name.
    pub attributes: BTreeMap<String, Attribute>,
}

/// An authored attribute.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Attribute {
    /// The declared type, such as `float` or `token[]`.
    pub type_name: String,
    /// The default value, or else the first time sample. `None` if the attribute is only declared or blocked.
    pub value: Option<AttributeValue>,
    /// Whether it has time samples.
    pub animated: bool,
}

/// An attribute's value, converted to one of a few types. Half and single precision become `f64` exactly.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum AttributeValue {
    /// `bool`.
    Bool(bool),
    /// Any integer type whose value fits.
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
    /// Any other type, by its name in the USD library.
    Other(String),
}

/// A camera of a stage.
#[derive(Clone, Debug, PartialEq)]
pub struct SceneCamera {
    /// The camera prim.
    pub prim: Prim,
    /// The pose, in metres. The camera's axes are `OpenCV`'s, the world's are the stage's.
    pub world_from_camera: RigidTransform,
}

impl Default for SceneCamera {
    /// Returns a camera at the origin with OpenUSD's default orientation: looking along −z, y up.
    fn default() -> Self {
        Self {
            prim: Prim::default(),
            world_from_camera: RigidTransform::new(Axes::Usd.rotation_from(Axes::OpenCv), DVec3::ZERO),
        }
    }
}

/// A render product of a stage.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RenderProduct {
    /// The render product prim.
    pub prim: Prim,
    /// The targets of its `camera` relationship.
    pub cameras: Vec<RelationshipTarget>,
}

/// A relationship's target.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct RelationshipTarget {
    /// The target path.
    pub path: String,
    /// The type of the target prim; `None` if there is no such prim.
    pub type_name: Option<String>,
}

impl AttributeValue {
    /// Returns the value if it is a number.
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
                reason = "attributes have no integers beyond 2^53"
            )]
            Self::Int(int) => Some(*int as f64),
            Self::Float(float) => Some(*float),
        }
    }

    /// Returns the numbers of a vector or an array.
    #[must_use]
    pub fn numbers(&self) -> Option<Vec<f64>> {
        match self {
            #[expect(
                clippy::cast_precision_loss,
                reason = "attributes have no integers beyond 2^53"
            )]
            Self::Ints(ints) => Some(ints.iter().map(|int| *int as f64).collect()),
            Self::Floats(floats) => Some(floats.clone()),
            _ => None,
        }
    }
}

impl Prim {
    /// Returns the last element of the path.
    #[must_use]
    pub fn name(&self) -> &str {
        self.path.rsplit('/').next().unwrap_or(&self.path)
    }

    /// Returns the value of an attribute, if authored.
    #[must_use]
    pub fn value(&self, name: &str) -> Option<&AttributeValue> {
        self.attributes.get(name)?.value.as_ref()
    }

    /// Returns the value of a numeric attribute.
    #[must_use]
    pub fn number(&self, name: &str) -> Option<f64> {
        self.value(name)?.number()
    }

    /// Returns the value of a string, token or asset attribute.
    #[must_use]
    pub fn text(&self, name: &str) -> Option<&str> {
        match self.value(name)? {
            AttributeValue::Text(text) => Some(text),
            _ => None,
        }
    }

    /// Returns the value of an attribute with two numbers.
    #[must_use]
    pub fn pair(&self, name: &str) -> Option<(f64, f64)> {
        match *self.value(name)?.numbers()? {
            [a, b] => Some((a, b)),
            _ => None,
        }
    }

    /// Returns the value of an `int2` attribute as an image size; `None` if it is not positive.
    #[must_use]
    pub fn size(&self, name: &str) -> Option<ImageSize> {
        let AttributeValue::Ints(ints) = self.value(name)? else {
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

    /// Returns the attributes whose name starts with `prefix`, with the rest of their name.
    pub fn in_namespace<'a>(&'a self, prefix: &'a str) -> impl Iterator<Item = (&'a str, &'a Attribute)> {
        self.attributes
            .iter()
            .filter_map(move |(name, attribute)| Some((name.strip_prefix(prefix)?, attribute)))
    }
}

impl SceneCamera {
    /// Returns `focalLength`, or the schema's fallback.
    #[must_use]
    pub fn focal_length(&self) -> f64 {
        self.prim.number("focalLength").unwrap_or(50.0)
    }

    /// Returns `horizontalAperture`, or the schema's fallback.
    #[must_use]
    pub fn horizontal_aperture(&self) -> f64 {
        self.prim.number("horizontalAperture").unwrap_or(20.955)
    }

    /// Returns `verticalAperture`, or the schema's fallback.
    #[must_use]
    pub fn vertical_aperture(&self) -> f64 {
        self.prim.number("verticalAperture").unwrap_or(15.2908)
    }

    /// Returns `horizontalApertureOffset` and `verticalApertureOffset`, or the schema's fallbacks.
    #[must_use]
    pub fn aperture_offsets(&self) -> (f64, f64) {
        let of = |name| self.prim.number(name).unwrap_or(0.0);
        (of("horizontalApertureOffset"), of("verticalApertureOffset"))
    }

    /// Returns `fStop`, or the schema's fallback of 0: no depth of field.
    #[must_use]
    pub fn f_stop(&self) -> f64 {
        self.prim.number("fStop").unwrap_or(0.0)
    }

    /// Returns `clippingRange` in stage units, or the schema's fallback.
    #[must_use]
    pub fn clipping_range(&self) -> (f64, f64) {
        self.prim.pair("clippingRange").unwrap_or((1.0, 1_000_000.0))
    }

    /// Whether the projection is perspective, which is the schema's fallback.
    #[must_use]
    pub fn is_perspective(&self) -> bool {
        self.prim.text("projection").unwrap_or("perspective") == "perspective"
    }

    /// Returns the optical attributes without unit conversion.
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
    /// Returns `resolution` if it is authored and positive.
    #[must_use]
    pub fn resolution(&self) -> Option<ImageSize> {
        self.prim.size("resolution")
    }
}

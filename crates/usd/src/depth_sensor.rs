//! The depth sensor of a stage: the authored attributes of NVIDIA's schemas on a render product or its camera.

use oaktwin_base::parameter::nvidia::Attributes;
use oaktwin_base::parameter::{Kind, Table};

use crate::asset::IsaacVersion;
pub use crate::nvidia::OUTLIER_REMOVAL;
use crate::nvidia::{CAMERA_NAMESPACE, CAMERA_SCHEMA, PRODUCT_NAMESPACE, PRODUCT_SCHEMA};
use crate::stage::{Attribute, Prim, RenderProduct, SceneCamera};

/// The attributes of both schemas, sorted by name, with the types that Isaac Sim 5.1 gives them; `outlierRemovalEnabled` is a
/// `bool` in 6. All other `bool`s are switches, the rest shapes what the sensor reports. Source: Kit's schema; ovrtx
/// documents the same attributes.
#[must_use]
pub fn attribute_types() -> Vec<(&'static str, &'static str)> {
    let type_of = |kind| match kind {
        Kind::Flag => "bool",
        Kind::Number => "float",
        Kind::Integer | Kind::Choice(_) | Kind::Text(_) => "int",
    };
    let mut types: Vec<_> = Attributes::rows()
        .map(|row| (row.about.name, type_of(row.about.kind)))
        .collect();
    types.sort_unstable();
    types
}

/// The attributes that a stage authors for a depth sensor; all others have the schema's defaults.
#[derive(Clone, Debug, PartialEq)]
pub struct StageDepthSensor {
    prim: Prim,
    namespace: &'static str,
}

/// Returns the depth sensor of a render product: Kit's schema on the product, else ovrtx's on the camera. The former
/// takes precedence, as Isaac Sim reads no other.
#[must_use]
pub fn of_product(product: Option<&RenderProduct>, camera: Option<&SceneCamera>) -> Option<StageDepthSensor> {
    let of = |prim: &Prim, schema: &str, namespace| {
        prim.has_api(schema).then(|| StageDepthSensor {
            prim: prim.clone(),
            namespace,
        })
    };
    product
        .and_then(|product| of(&product.prim, PRODUCT_SCHEMA, PRODUCT_NAMESPACE))
        .or_else(|| camera.and_then(|camera| of(&camera.prim, CAMERA_SCHEMA, CAMERA_NAMESPACE)))
}

impl StageDepthSensor {
    /// Returns the prim that carries the attributes.
    #[must_use]
    pub fn prim(&self) -> &Prim {
        &self.prim
    }

    /// Returns the authored attributes by their name in the schema, such as `baselineMM`.
    pub fn attributes(&self) -> impl Iterator<Item = (&str, &Attribute)> {
        self.prim.in_namespace(self.namespace)
    }

    /// Returns the full name of an attribute, such as `omni:rtx:post:depthSensor:baselineMM`.
    #[must_use]
    pub fn full_name(&self, name: &str) -> String {
        format!("{}{name}", self.namespace)
    }

    /// Returns the Isaac Sim version that the sensor is written for, if known: `outlierRemovalEnabled` is an `int` in 5.x
    /// and a `bool` in 6.x; ovrtx's schema corresponds to 6.
    #[must_use]
    pub fn isaac(&self) -> Option<IsaacVersion> {
        if self.namespace == CAMERA_NAMESPACE {
            return Some(IsaacVersion::V6);
        }
        let (_, outlier_removal) = self.attributes().find(|(name, _)| *name == OUTLIER_REMOVAL)?;
        match outlier_removal.type_name.as_str() {
            "bool" => Some(IsaacVersion::V6),
            "int" => Some(IsaacVersion::V5_1),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stage::AttributeValue;

    fn attribute(type_name: &str, value: AttributeValue) -> Attribute {
        Attribute {
            type_name: type_name.to_owned(),
            value: Some(value),
            animated: false,
        }
    }

    #[test]
    fn product_takes_precedence_over_camera() {
        let mut product = RenderProduct::default();
        let mut camera = SceneCamera::default();
        assert!(of_product(Some(&product), Some(&camera)).is_none());
        camera.prim.api_schemas.push(CAMERA_SCHEMA.to_owned());
        let baseline = attribute("float", AttributeValue::Float(20.0));
        let name = format!("{CAMERA_NAMESPACE}baselineMM");
        camera.prim.attributes.insert(name.clone(), baseline.clone());
        let sensor = of_product(Some(&product), Some(&camera)).unwrap();
        assert_eq!(
            sensor.attributes().collect::<Vec<_>>(),
            [("baselineMM", &baseline)]
        );
        assert_eq!(sensor.full_name("baselineMM"), name);
        assert_eq!(sensor.isaac(), Some(IsaacVersion::V6));
        product.prim.api_schemas.push(PRODUCT_SCHEMA.to_owned());
        let sensor = of_product(Some(&product), Some(&camera)).unwrap();
        assert_eq!((sensor.attributes().count(), sensor.isaac()), (0, None));
    }

    #[test]
    fn type_of_outlier_removal_determines_the_version() {
        for (type_name, value, isaac) in [
            ("int", AttributeValue::Int(3), Some(IsaacVersion::V5_1)),
            ("bool", AttributeValue::Bool(true), Some(IsaacVersion::V6)),
            ("float", AttributeValue::Float(1.0), None),
        ] {
            let mut product = RenderProduct::default();
            product.prim.api_schemas.push(PRODUCT_SCHEMA.to_owned());
            let name = format!("{PRODUCT_NAMESPACE}{OUTLIER_REMOVAL}");
            product.prim.attributes.insert(name, attribute(type_name, value));
            assert_eq!(of_product(Some(&product), None).unwrap().isaac(), isaac);
        }
    }
}

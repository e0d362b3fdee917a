use std::collections::BTreeSet;

use super::AssetError;
use crate::text::{Layer, PrimSpec, Property, is_identifier};

/// Rejects invalid or duplicate prim names and non-finite numbers, which a user's catalog or calibration may contain.
pub(super) fn check(layer: &Layer, model: &str) -> Result<(), AssetError> {
    check_children("", &layer.prims, model)
}

fn check_children(parent: &str, children: &[PrimSpec], model: &str) -> Result<(), AssetError> {
    let mut seen = BTreeSet::new();
    for prim in children {
        if !is_identifier(&prim.name) {
            return Err(AssetError::Name {
                model: model.into(),
                parent: if parent.is_empty() { "/" } else { parent }.into(),
                name: prim.name.clone(),
            });
        }
        let path = format!("{parent}/{}", prim.name);
        if !seen.insert(&prim.name) {
            return Err(AssetError::Duplicate {
                model: model.into(),
                path,
            });
        }
        for property in &prim.properties {
            if let Property::Attribute(attribute) = property
                && attribute.value.as_ref().is_some_and(|value| !value.is_finite())
            {
                return Err(AssetError::NotFinite {
                    model: model.into(),
                    property: format!("{path}.{}", attribute.name),
                });
            }
        }
        check_children(&path, &prim.children, model)?;
    }
    Ok(())
}

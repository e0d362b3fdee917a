//! The inertial sensors of a recipe.

use std::collections::BTreeMap;

use oaktwin_base::diagnostic::Message;
use oaktwin_catalog::{Catalog, InertialPart};
use oaktwin_pipeline::imu::inertial_part;

use crate::recipe::{ImuRule, Recipe};

/// The inertial sensors of a recipe.
#[derive(Debug)]
pub(crate) struct Inertial {
    pub(crate) rule: ImuRule,
    /// The part of each model.
    pub(crate) parts: BTreeMap<String, InertialPart>,
}

impl Inertial {
    /// Finds the parts of the models of a recipe, if it asks for samples.
    pub(crate) fn open(recipe: &Recipe, catalog: &Catalog) -> Result<Option<Self>, Unfit> {
        let Some(rule) = recipe.camera.imu.clone() else {
            return Ok(None);
        };
        let mut parts = BTreeMap::new();
        for model in &recipe.camera.model.0 {
            // Unknown models are reported elsewhere.
            let Ok(device) = catalog.device(model) else {
                continue;
            };
            let part = inertial_part(catalog, device, rule.part.as_deref()).map_err(|error| Unfit {
                place: "camera.imu.part",
                problem: error.message,
                remedy: error.remedy,
            })?;
            parts.insert(model.clone(), part.clone());
        }
        Ok(Some(Self { rule, parts }))
    }
}

/// What does not fit in a recipe.
pub(crate) struct Unfit {
    pub(crate) place: &'static str,
    pub(crate) problem: Message,
    pub(crate) remedy: Message,
}

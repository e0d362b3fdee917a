//! What a scene contains: everything that is drawn at random once for all frames of an arrangement.

mod heap;
mod light;
mod look;
mod objects;
mod place;
mod placed;
mod pose;
mod size;
mod stage;

use oaktwin_base::diagnostic::Finding;
use oaktwin_pipeline::pair::default_projector;
use serde::Serialize;

pub(crate) use light::{DrawnLight, direction};
pub(crate) use look::DrawnLook;
use objects::place_objects;
pub(crate) use placed::Placed;
pub(crate) use pose::serialize_pose;
pub(crate) use stage::Stage;

use crate::GenerateError;
use crate::context::Context;
use crate::unit::DrawnUnit;

/// Everything that is drawn at random for an arrangement.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Arrangement {
    /// The number of the arrangement.
    pub(crate) number: u64,
    /// The base scene, as an index into the recipe's.
    #[serde(skip)]
    pub(crate) base: usize,
    /// Its path in the recipe.
    pub(crate) scene: String,
    pub(crate) unit: DrawnUnit,
    pub(crate) objects: Vec<Placed>,
    pub(crate) looks: Vec<DrawnLook>,
    pub(crate) lights: Vec<DrawnLight>,
    pub(crate) infrared_ambient: f64,
    pub(crate) projector: f64,
    /// Findings about heaps.
    #[serde(skip)]
    pub(crate) findings: Vec<Finding>,
}

impl Arrangement {
    /// Draws the arrangement of this number.
    ///
    /// # Errors
    /// Returns an error if an object cannot be read, or has no place.
    pub(crate) fn draw(context: &Context, number: u64) -> Result<Self, GenerateError> {
        let recipe = &context.file.recipe;
        let random = context.random;
        let base = context.base_of(number);
        let model = random
            .numbers("camera.model", number)
            .pick(&recipe.camera.model.0)
            .cloned()
            .unwrap_or_default();
        let (objects, findings) = place_objects(context, base, number)?;
        let light = &recipe.light;
        // Models without a projector ignore it, because a recipe may have models of both kinds.
        let full = default_projector(context.units(&model).any());
        let projector = light.projector.as_ref().map_or(full, |power| {
            full * power.draw(&mut random.numbers("light.projector", number))
        });
        let mut looks = Vec::new();
        for (rule, textures) in (0..).zip(&context.look_textures) {
            let mut numbers = random.numbers(&format!("looks.{rule}"), number);
            looks.push(look::draw(&recipe.looks[rule].look, textures, &mut numbers));
        }
        Ok(Self {
            number,
            base,
            scene: context.bases[base].name.clone(),
            unit: DrawnUnit::draw(context, &model, number),
            lights: light::draw(context, base, &objects, number),
            objects,
            looks,
            infrared_ambient: light
                .infrared_ambient
                .draw(&mut random.numbers("light.infrared_ambient", number)),
            projector,
            findings,
        })
    }
}

impl Context {
    /// Returns the index of the base scene of an arrangement.
    pub(crate) fn base_of(&self, number: u64) -> usize {
        let bases: Vec<usize> = (0..self.bases.len()).collect();
        let mut numbers = self.random.numbers("scene", number);
        numbers.pick(&bases).copied().unwrap_or_default()
    }
}

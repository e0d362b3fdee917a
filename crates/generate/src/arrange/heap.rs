//! Heaps: objects that fall onto each other until they lie still.

use oaktwin_base::diagnostic::{Finding, Level, Message};

use super::place::{PlacementSearch, region_of};
use super::placed::Placed;
use crate::GenerateError;
use crate::context::Context;
use crate::recipe::Pose;
use crate::settle::{Body, Simulation};

/// How often objects that left their region are dropped again.
const ROUNDS: u32 = 4;

/// The heaps of an arrangement.
pub(super) struct Heaps<'a> {
    pub(super) context: &'a Context,
    /// The index of the base scene.
    pub(super) base: usize,
    /// The number of the arrangement.
    pub(super) number: u64,
    /// How often its objects were drawn before.
    pub(super) redraw: u32,
}

impl Heaps<'_> {
    /// Lets all piled objects fall. Those that leave their region are dropped again, and finally left out.
    pub(super) fn settle(&self, placed: &mut Vec<Placed>) -> Result<Vec<Finding>, GenerateError> {
        let mut findings = Vec::new();
        for round in 0.. {
            let moving = self.fall(placed)?;
            let mut outside = Vec::new();
            for object in std::mem::take(placed) {
                match self.is_outside(&object)? {
                    true => outside.push(object),
                    false => placed.push(object),
                }
            }
            if outside.is_empty() {
                findings.extend(moving.into_iter().map(|rule| self.still_moves(rule)));
                break;
            }
            for mut object in outside {
                match round < ROUNDS && self.drop_again(&mut object, placed, round)? {
                    true => placed.push(object),
                    false => findings.push(self.left_out(object.rule)),
                }
            }
            placed.sort_by_key(|object| object.serial);
        }
        Ok(findings)
    }

    fn is_piled(&self, object: &Placed) -> bool {
        self.context.file.recipe.objects[object.rule].pose == Pose::Piled
    }

    /// Moves the objects to where they come to lie, and returns the rules of those that do not lie still.
    fn fall(&self, placed: &mut [Placed]) -> Result<Vec<usize>, GenerateError> {
        let bodies = placed.iter().map(|object| {
            let shape = object.asset.parts().shape(object.scale);
            Ok(Body {
                shape: shape.ok_or_else(|| GenerateError::Empty {
                    file: object.file.clone().into(),
                })?,
                world_from_body: object.world_from_object,
                is_fixed: !self.is_piled(object),
                gap_m: self.context.file.recipe.objects[object.rule].gap_m,
            })
        });
        let bodies = bodies.collect::<Result<Vec<_>, GenerateError>>()?;
        let base = &self.context.bases[self.base];
        let mut simulation = Simulation::new(base.shape(), base.up(), bodies);
        simulation.settle();
        let mut moving = Vec::new();
        for (object, settled) in placed.iter_mut().zip(simulation.settled()) {
            object.move_to(settled.world_from_body);
            if !settled.is_at_rest {
                moving.push(object.rule);
            }
        }
        Ok(moving)
    }

    /// Whether an object lies so far beside its region that it would not touch an object within, or further below than the region is high.
    fn is_outside(&self, object: &Placed) -> Result<bool, GenerateError> {
        if !self.is_piled(object) {
            return Ok(false);
        }
        let region = region_of(self.context, self.base, object.rule)?;
        let up = self.context.bases[self.base].up();
        let (bottom, top) = (region.min.dot(up), region.max.dot(up));
        let height = object.center.dot(up);
        let raised = object.center + up * (height.clamp(bottom, top) - height);
        let reach = object.hull.size() / 2.0;
        let nearby = raised.cmpge(region.min - reach).all() && raised.cmple(region.max + reach).all();
        let is_inside = nearby && height >= bottom - (top - bottom) - reach;
        Ok(!is_inside)
    }

    /// Drops an object onto the others at another place; returns whether there is one.
    fn drop_again(&self, object: &mut Placed, others: &[Placed], round: u32) -> Result<bool, GenerateError> {
        let rule = object.rule;
        let name = format!("objects.{rule}.{}.again{round}#{}", object.index, self.redraw);
        let mut numbers = self.context.random.numbers(&name, self.number);
        let place = PlacementSearch::new(self.context, self.base, rule, &object.asset, &object.hull, others)?;
        let found = place.find(&mut numbers).ok();
        Ok(found.is_some_and(|pose| {
            object.move_to(pose);
            true
        }))
    }

    fn still_moves(&self, rule: usize) -> Finding {
        self.finding(
            rule,
            "heap-moves",
            "an object of the heap still moves",
            "lower the count, or name objects without thin or round parts",
        )
    }

    fn left_out(&self, rule: usize) -> Finding {
        self.finding(
            rule,
            "heap-overflows",
            "an object does not stay in the region of its heap, and is left out",
            "lower the count, or enlarge the region",
        )
    }

    fn finding(
        &self,
        rule: usize,
        code: &'static str,
        message: impl Into<Message>,
        remedy: impl Into<Message>,
    ) -> Finding {
        let file = &self.context.file;
        let frame = self.number * file.recipe.frames_per_scene;
        let place = format!("{}: objects.{rule}: frame {frame}", file.path.display());
        Finding::new(code, Level::Warning, place, message, remedy)
    }
}

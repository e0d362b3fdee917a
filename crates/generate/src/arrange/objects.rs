//! Placement of objects without interpenetration.

use oaktwin_base::diagnostic::Finding;

use super::heap::Heaps;
use super::look;
use super::place::{PlacementSearch, Rejected};
use super::placed::{Placed, bounds_at};
use super::size;
use crate::GenerateError;
use crate::context::Context;
use crate::recipe::Pose;

/// The maximum number of attempts to place all objects.
const REDRAWS: u32 = 8;

/// Objects, and what is suspicious about them.
type Objects = (Vec<Placed>, Vec<Finding>);

/// An object that found no place.
struct NoPlace {
    rule: usize,
    index: u64,
    count: u64,
    /// Its file and its size.
    object: String,
    rejected: Rejected,
}

pub(super) fn place_objects(context: &Context, base: usize, number: u64) -> Result<Objects, GenerateError> {
    let mut failure = None;
    for redraw in 0..REDRAWS {
        match try_place(context, base, number, redraw)? {
            Ok(objects) => return Ok(objects),
            Err(no_place) => failure = Some(no_place),
        }
    }
    let Some(NoPlace {
        rule,
        index,
        count,
        object,
        rejected,
    }) = failure
    else {
        return Ok(Objects::default());
    };
    let objects = &context.file.recipe.objects[rule];
    Err(GenerateError::NoPlace {
        recipe: context.file.path.clone(),
        place: format!("objects.{rule}"),
        frame: number * context.file.recipe.frames_per_scene,
        problem: format!(
            "no place for object {} of {count} ({object}) in {REDRAWS} times {} attempts: of the last ones, {rejected}",
            index + 1,
            objects.attempts,
        ),
        remedy:
            "lower the count or the size, enlarge the region, name other prims in 'on', or raise attempts"
                .to_owned(),
    })
}

/// Places all objects once. The inner error is an object without a place.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "counts are checked to be small"
)]
fn try_place(
    context: &Context,
    base: usize,
    number: u64,
    redraw: u32,
) -> Result<Result<Objects, NoPlace>, GenerateError> {
    let mut placed: Vec<Placed> = Vec::new();
    let (mut findings, mut serial) = (Vec::new(), 0);
    for (rule, objects) in context.file.recipe.objects.iter().enumerate() {
        let count = objects
            .count
            .draw(&mut context.random.numbers(&format!("objects.{rule}.count"), number));
        let count = count.round() as u64;
        for index in 0..count {
            let name = format!("objects.{rule}.{index}");
            let mut numbers = context.random.numbers(&format!("{name}#{redraw}"), number);
            let entries: Vec<usize> = context.object_files.of_rule[rule].clone().collect();
            let entry = numbers.pick(&entries).copied().unwrap_or_default();
            let asset = context.object_files.asset(&context.file, entry)?;
            let scale = size::scale(objects, &asset, &mut numbers);
            let size_m = scale * asset.hull.longest_edge();
            let file = &context.object_files.entries[entry];
            let hull = asset.hull.scaled(scale).ok_or_else(|| GenerateError::Empty {
                file: file.path.clone(),
            })?;
            let place = PlacementSearch::new(context, base, rule, &asset, &hull, &placed)?;
            match place.find(&mut numbers) {
                Ok(pose) => {
                    findings.extend(size::unusual(rule, &file.path, size_m));
                    let textures = &context.object_textures[rule];
                    let mut numbers = context.random.numbers(&format!("{name}.look"), number);
                    let look = objects.look.as_ref();
                    placed.push(Placed {
                        path: format!("/Generated/{}_{}", identifier(&file.name), serial),
                        label: file.label.clone(),
                        file: file.path.display().to_string(),
                        scale,
                        look: look.and_then(|look| look::draw(look, textures, &mut numbers)),
                        rule,
                        index,
                        serial,
                        entry,
                        center: pose.apply(hull.center),
                        bounds: bounds_at(&hull, &pose),
                        world_from_object: pose,
                        asset,
                        hull,
                    });
                    serial += 1;
                }
                Err(rejected) => {
                    return Ok(Err(NoPlace {
                        rule,
                        index,
                        count,
                        object: format!("{}, {} long", file.path.display(), size::metres(size_m)),
                        rejected,
                    }));
                }
            }
        }
        // Consecutive heaps fall together.
        let is_piled = |rule: usize| {
            let rule = context.file.recipe.objects.get(rule);
            rule.is_some_and(|rule| rule.pose == Pose::Piled)
        };
        if is_piled(rule) && !is_piled(rule + 1) {
            let heaps = Heaps {
                context,
                base,
                number,
                redraw,
            };
            findings.extend(heaps.settle(&mut placed)?);
        }
    }
    Ok(Ok((placed, findings)))
}

/// A name as a prim's name.
fn identifier(name: &str) -> String {
    let mut text: String = name
        .chars()
        .map(|c| if c.is_ascii_alphanumeric() { c } else { '_' })
        .collect();
    if !text.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_') {
        text.insert(0, '_');
    }
    text
}

use std::collections::BTreeSet;

use oaktwin_image::Image;
use oaktwin_image::annotation::{Box2d, Boxes2d};
use oaktwin_scene::Scene;
use rayon::prelude::*;

use super::coverage::Coverage;
use super::semantics::{Entity, Semantics};
use super::stencil::{Extent, Stencil};
use crate::Hit;

/// The 2D bounding boxes of a view.
pub(super) struct Boxes {
    /// Boxes around the visible pixels of an entity; an entity without visible pixels has none.
    pub(super) tight: Boxes2d,
    /// Boxes around the pixels that an entity covers, occluded or not.
    pub(super) loose: Boxes2d,
}

/// Returns a box for each labelled prim, which includes its descendants. Parts outside the image count neither for the box nor
/// for the occlusion ratio.
pub(super) fn boxes(
    scene: &Scene,
    semantics: &Semantics,
    coverage: &Coverage<'_>,
    hits: &Image<Hit>,
) -> Boxes {
    let seen = seen_extents(scene, hits);
    let found: Vec<(&Entity, Extent, Extent)> = semantics
        .entities
        .par_iter()
        .map_init(
            || Stencil::new(hits.width(), hits.height()),
            |stencil, entity| {
                stencil.clear();
                let mut tight = Extent::EMPTY;
                for &instance in &entity.instances {
                    coverage.add_instance(scene, instance, stencil);
                    tight = tight.union(seen.get(instance as usize).copied().unwrap_or(Extent::EMPTY));
                }
                (entity, tight, stencil.extent())
            },
        )
        .collect();
    let mut boxes = Boxes {
        tight: Boxes2d::default(),
        loose: Boxes2d::default(),
    };
    for (entity, tight, loose) in found {
        // At an edge, a pixel may be visible that rounding excluded from the coverage.
        let loose = Extent {
            count: loose.count.max(tight.count),
            ..loose.union(tight)
        };
        let hidden = occlusion_ratio(tight.count, loose.count);
        add(&mut boxes.tight, entity, tight, hidden);
        add(&mut boxes.loose, entity, loose, hidden);
    }
    for boxes in [&mut boxes.tight, &mut boxes.loose] {
        let ids: BTreeSet<u32> = boxes.boxes.iter().map(|found| found.semantic_id).collect();
        boxes.labels = ids.into_iter().map(|id| (id, semantics.labels(id))).collect();
    }
    boxes
}

/// The extent of the visible pixels of each instance.
fn seen_extents(scene: &Scene, hits: &Image<Hit>) -> Vec<Extent> {
    let mut seen = vec![Extent::EMPTY; scene.instances.len()];
    for (row, y) in hits.rows().zip(0..) {
        for (hit, x) in row.iter().zip(0..) {
            if let Some(extent) = seen.get_mut(hit.instance as usize) {
                extent.add(x, y);
            }
        }
    }
    seen
}

#[expect(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    reason = "a ratio is float32"
)]
fn occlusion_ratio(seen: u64, all: u64) -> f32 {
    (1.0 - seen as f64 / (all as f64).max(1.0)) as f32
}

fn add(boxes: &mut Boxes2d, entity: &Entity, extent: Extent, occlusion_ratio: f32) {
    if extent.count == 0 {
        return;
    }
    boxes.boxes.push(Box2d {
        semantic_id: entity.semantic_id,
        x_min: extent.x[0].cast_signed(),
        y_min: extent.y[0].cast_signed(),
        x_max: extent.x[1].cast_signed(),
        y_max: extent.y[1].cast_signed(),
        occlusion_ratio,
    });
    boxes.prim_paths.push(entity.prim.clone());
}

use std::collections::BTreeSet;

use oaktwin_image::Image;
use oaktwin_image::annotation::{Segmentation, SemanticSegmentation};
use oaktwin_scene::Scene;

use super::semantics::{BACKGROUND, Semantics};
use crate::Hit;

/// Returns the index of the instance in the scene plus 1; 0 for a miss. It is the same in every view.
pub(super) fn instance_id(hit: Hit) -> u32 {
    hit.instance.wrapping_add(1)
}

/// The instance segmentation of an image.
pub(super) fn instances(scene: &Scene, hits: &Image<Hit>) -> Segmentation {
    let ids = hits.map(|hit| instance_id(*hit));
    let prim_paths = occurring(&ids)
        .into_iter()
        .filter_map(|id| {
            let instance = scene.instances.get((id as usize).checked_sub(1)?)?;
            Some((id, instance.path.clone()))
        })
        .collect();
    Segmentation { ids, prim_paths }
}

/// The semantic segmentation of an image.
pub(super) fn semantics(semantics: &Semantics, hits: &Image<Hit>) -> SemanticSegmentation {
    let ids = hits.map(|hit| {
        if hit.is_miss() {
            BACKGROUND
        } else {
            semantics.of_instance(hit.instance)
        }
    });
    let labels = occurring(&ids)
        .into_iter()
        .map(|id| (id, semantics.labels(id)))
        .collect();
    SemanticSegmentation { ids, labels }
}

fn occurring(ids: &Image<u32>) -> BTreeSet<u32> {
    let mut found = BTreeSet::new();
    let mut last = None;
    for id in ids.pixels() {
        if last != Some(*id) {
            found.insert(*id);
            last = Some(*id);
        }
    }
    found
}

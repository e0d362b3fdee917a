use std::collections::{BTreeMap, BTreeSet};

use oaktwin_image::annotation::Labels;
use oaktwin_scene::{Label, Scene};

/// The semantic id of the background.
pub(crate) const BACKGROUND: u32 = 0;
/// The semantic id of instances without a label.
pub(crate) const UNLABELLED: u32 = 1;
/// The semantic id of the first set of labels.
const FIRST: u32 = 2;

/// A labelled prim with its descendants.
#[derive(Debug, PartialEq)]
pub(crate) struct Entity {
    pub(crate) prim: String,
    pub(crate) semantic_id: u32,
    /// The indices of its instances in the scene, ascending.
    pub(crate) instances: Vec<u32>,
}

/// The semantic labels of a scene, with ids that are the same in all of its views.
///
/// The labels of an instance are its own and its ancestors', as Replicator flattens them. Each distinct set, also of the instances
/// that the scene may have at other times, has an id; ids are in the order of the sets.
#[derive(Debug)]
pub(crate) struct Semantics {
    of_instance: Vec<u32>,
    sets: Vec<Labels>,
    /// In the order of the scene, parents before children.
    pub(crate) entities: Vec<Entity>,
}

impl Semantics {
    #[expect(
        clippy::cast_possible_truncation,
        reason = "a scene's instances are counted in u32"
    )]
    pub(crate) fn new(scene: &Scene) -> Self {
        let mut entities: Vec<(&str, Labels, Vec<u32>)> = Vec::new();
        let mut entity_of_prim: BTreeMap<&str, usize> = BTreeMap::new();
        let mut nearest = Vec::with_capacity(scene.instances.len());
        for (instance, placed) in scene.instances.iter().enumerate() {
            let starts = carriers(&placed.labels);
            for &start in starts.iter().rev() {
                let inherited = &placed.labels[start..];
                let prim = inherited[0].prim.as_str();
                let at = *entity_of_prim.entry(prim).or_insert_with(|| {
                    entities.push((prim, flattened(inherited), Vec::new()));
                    entities.len() - 1
                });
                entities[at].2.push(instance as u32);
            }
            let own = placed.labels.first();
            nearest.push(own.and_then(|label| entity_of_prim.get(label.prim.as_str()).copied()));
        }
        let possible = scene.possible_labels.iter().flat_map(|labels| {
            let starts = carriers(labels).into_iter();
            starts.map(|start| flattened(&labels[start..]))
        });
        let shown = entities.iter().map(|(_, labels, _)| labels.clone());
        let sets: BTreeSet<Labels> = shown.chain(possible).collect();
        let sets: Vec<Labels> = sets.into_iter().collect();
        let id_of = |labels: &Labels| match sets.binary_search(labels) {
            Ok(at) => FIRST + at as u32,
            Err(_) => UNLABELLED,
        };
        let entities: Vec<Entity> = entities
            .into_iter()
            .map(|(prim, labels, instances)| Entity {
                prim: prim.to_owned(),
                semantic_id: id_of(&labels),
                instances,
            })
            .collect();
        let of_instance = nearest
            .into_iter()
            .map(|entity| entity.map_or(UNLABELLED, |at| entities[at].semantic_id))
            .collect();
        Self {
            of_instance,
            sets,
            entities,
        }
    }

    pub(crate) fn of_instance(&self, instance: u32) -> u32 {
        self.of_instance
            .get(instance as usize)
            .copied()
            .unwrap_or(UNLABELLED)
    }

    pub(crate) fn labels(&self, id: u32) -> Labels {
        let class = |name: &str| Labels::from([("class".to_owned(), name.to_owned())]);
        match id {
            BACKGROUND => class("BACKGROUND"),
            _ => (id.checked_sub(FIRST))
                .and_then(|at| self.sets.get(at as usize))
                .cloned()
                .unwrap_or_else(|| class("UNLABELLED")),
        }
    }
}

/// The indices at which the labels of each prim begin.
fn carriers(labels: &[Label]) -> Vec<usize> {
    (0..labels.len())
        .filter(|&at| at == 0 || labels[at].prim != labels[at - 1].prim)
        .collect()
}

/// The distinct labels of each taxonomy, sorted and joined by commas.
fn flattened(labels: &[Label]) -> Labels {
    let mut names: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    for label in labels {
        names.entry(&label.taxonomy).or_default().insert(&label.name);
    }
    names
        .into_iter()
        .map(|(taxonomy, names)| {
            let joined = names.into_iter().collect::<Vec<_>>().join(",");
            (taxonomy.to_owned(), joined)
        })
        .collect()
}

use std::collections::BTreeMap;

use oaktwin_camera::math::DAffine3;

use super::place;
use crate::text::{PrimSpec, is_identifier};

/// The default root, which is also added if the paths have different ones.
const ROOT: &str = "World";

/// Prims by the path of their source, in order of insertion.
#[derive(Default)]
pub(super) struct Tree {
    nodes: Vec<Node>,
}

struct Node {
    elements: Vec<String>,
    prim: PrimSpec,
    world_from_prim: DAffine3,
}

/// A level of the hierarchy.
#[derive(Default)]
struct Level {
    prim: Option<(PrimSpec, DAffine3)>,
    children: Vec<(String, Self)>,
    index: BTreeMap<String, usize>,
}

impl Tree {
    pub(super) fn insert(&mut self, path: &str, prim: PrimSpec, world_from_prim: &DAffine3) {
        let elements = path
            .split('/')
            .filter(|element| !element.is_empty())
            .map(str::to_owned);
        self.nodes.push(Node {
            elements: elements.collect(),
            prim,
            world_from_prim: *world_from_prim,
        });
    }

    /// Builds the hierarchy: the first element of all paths is the root if they share one that has no mesh itself.
    pub(super) fn into_root(self) -> PrimSpec {
        let first = self.nodes.first().and_then(|node| node.elements.first().cloned());
        let shared = first.filter(|first| {
            self.nodes
                .iter()
                .all(|node| node.elements.len() > 1 && node.elements.first() == Some(first))
        });
        let mut root = Level::default();
        for node in self.nodes {
            let skipped = usize::from(shared.is_some());
            let mut level = &mut root;
            for element in node.elements.iter().skip(skipped) {
                level = level.child(element);
            }
            if level.prim.is_some() {
                // Two prims of one path: the second gets another name.
                let name = format!(
                    "{}_{}",
                    node.elements.last().map_or("prim", String::as_str),
                    level.children.len()
                );
                level = level.child(&name);
            }
            level.prim = Some((node.prim, node.world_from_prim));
        }
        let name = shared.as_deref().map_or_else(|| ROOT.to_owned(), identifier);
        root.into_prim(name, false)
    }
}

impl Level {
    fn child(&mut self, name: &str) -> &mut Self {
        let at = *self.index.entry(name.to_owned()).or_insert_with(|| {
            self.children.push((name.to_owned(), Self::default()));
            self.children.len() - 1
        });
        &mut self.children[at].1
    }

    fn into_prim(self, name: String, is_below_transform: bool) -> PrimSpec {
        let has_transform = self.prim.is_some();
        let mut prim = match self.prim {
            Some((mut prim, world_from_prim)) => {
                place(&mut prim, &world_from_prim, is_below_transform);
                prim
            }
            None => PrimSpec::def("Xform", ""),
        };
        prim.name = name;
        let mut taken = BTreeMap::new();
        for (child, level) in self.children {
            let name = free(&identifier(&child), &mut taken);
            prim.children
                .push(level.into_prim(name, is_below_transform || has_transform));
        }
        prim
    }
}

/// The name, with a number if it is taken.
fn free(name: &str, taken: &mut BTreeMap<String, u32>) -> String {
    let mut free = name.to_owned();
    while taken.contains_key(&free) {
        let number = taken.entry(name.to_owned()).or_insert(0);
        *number += 1;
        free = format!("{name}_{number}");
    }
    taken.insert(free.clone(), 0);
    free
}

/// The name of a prim: other characters than ASCII letters, digits and underscores are replaced.
pub(super) fn identifier(name: &str) -> String {
    let plain: String = name
        .chars()
        .map(|c| if c.is_ascii_alphanumeric() { c } else { '_' })
        .collect();
    if is_identifier(&plain) {
        plain
    } else {
        format!("_{plain}")
    }
}

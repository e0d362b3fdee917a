use std::collections::{BTreeSet, HashMap};

use super::closure::{Closure, Extent};
use super::inspect::{Arc, ArcKind};

/// The layers of a stage by layer stack: an arc without an asset path leads to a prim of the same stack. Stacks with a
/// layer in common are taken as one.
#[derive(Debug, Default)]
pub(super) struct Stacks {
    stack_of_layer: HashMap<String, usize>,
    stacks: Vec<Closure>,
    /// The layers, linked to their sublayers.
    sublayers: Closure,
    largest: Extent,
}

/// A part of the composition that a layer has made too large.
pub(super) enum Growth {
    /// The number of layers in a stack.
    Layers { layer: String, count: u64 },
    /// The number of sites of a prim.
    Sites { prim: String, count: u64 },
    /// A prim that inherits from or specializes itself.
    Cycle { prim: String },
}

impl Stacks {
    /// Adds the layer `name` with its sublayers and arcs. Returns what grew by them.
    pub(super) fn add(&mut self, name: &str, sublayers: Vec<String>, arcs: &[Arc]) -> Vec<Growth> {
        let mut growth = Vec::new();
        let stack = self.stack(name, &sublayers);
        let links: Vec<Arc> = sublayers
            .into_iter()
            .map(|target| Arc {
                prim: name.to_owned(),
                kind: ArcKind::Reference,
                target,
            })
            .collect();
        if self.sublayers.add(&links) {
            growth.push(Growth::Layers {
                layer: self.sublayers.place().to_owned(),
                count: self.sublayers.bound().sites(0),
            });
        }
        let stack = &mut self.stacks[stack];
        if stack.add(arcs) {
            if let Some(prim) = stack.cycle() {
                growth.push(Growth::Cycle {
                    prim: prim.to_owned(),
                });
            }
            self.largest = self.largest.max(stack.bound());
            growth.push(Growth::Sites {
                prim: stack.place().to_owned(),
                count: stack.bound().sites(0),
            });
        }
        growth
    }

    /// Returns an upper bound on the sites of a prim that follows `arcs` arcs to other layers.
    pub(super) fn sites(&self, arcs: u64) -> u64 {
        self.largest.sites(arcs)
    }

    /// Returns the index of the stack of a layer and its sublayers, which join their stacks.
    fn stack(&mut self, name: &str, sublayers: &[String]) -> usize {
        let layers = || sublayers.iter().map(String::as_str).chain([name]);
        let joined: BTreeSet<usize> = layers()
            .filter_map(|layer| self.stack_of_layer.get(layer).copied())
            .collect();
        let mut joined = joined.into_iter();
        let stack = joined.next().unwrap_or_else(|| {
            self.stacks.push(Closure::default());
            self.stacks.len() - 1
        });
        for other in joined {
            let other_stack = std::mem::take(&mut self.stacks[other]);
            self.stacks[stack].absorb(other_stack);
            for index in self.stack_of_layer.values_mut() {
                if *index == other {
                    *index = stack;
                }
            }
        }
        for layer in layers() {
            self.stack_of_layer.insert(layer.to_owned(), stack);
        }
        stack
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn reference(prim: &str, target: &str) -> Arc {
        Arc {
            prim: prim.to_owned(),
            kind: ArcKind::Reference,
            target: target.to_owned(),
        }
    }

    #[test]
    fn joins_the_arcs_of_a_layer_and_its_sublayers() {
        let mut apart = Stacks::default();
        apart.add("a", Vec::new(), &[reference("/A", "/B")]);
        apart.add("b", Vec::new(), &[reference("/B", "/C")]);
        assert_eq!(apart.sites(0), 2);
        let mut joined = Stacks::default();
        joined.add("a", Vec::new(), &[reference("/A", "/B")]);
        joined.add("c", vec!["a".to_owned(), "b".to_owned()], &[]);
        joined.add("b", Vec::new(), &[reference("/B", "/C")]);
        assert_eq!(joined.sites(0), 3);
    }

    #[test]
    fn counts_a_sublayer_as_often_as_it_is_listed() {
        let mut stacks = Stacks::default();
        for at in 1..=20 {
            let below = format!("l{}", at - 1);
            let growth = stacks.add(&format!("l{at}"), vec![below.clone(), below], &[]);
            let [Growth::Layers { layer, count }] = &growth[..] else {
                panic!("unexpected growth");
            };
            assert_eq!(
                (layer.as_str(), *count),
                (&*format!("l{at}"), (1 << (at + 1)) - 1)
            );
        }
    }
}

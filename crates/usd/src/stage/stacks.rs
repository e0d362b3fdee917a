use std::collections::{BTreeSet, HashMap};

use super::class_cycle::Classes;
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
    classes: Classes,
    /// The default prims of the layers.
    default_prims: HashMap<String, String>,
    /// The prims that refer to the default prims of layers that were not read yet.
    waiting: HashMap<String, Vec<(usize, String)>>,
}

/// What a layer brings to a stage.
#[derive(Debug, Default)]
pub(super) struct Links<'a> {
    /// The names of its sublayers.
    pub sublayers: Vec<String>,
    /// Its arcs to prims of the same layer stack.
    pub arcs: &'a [Arc],
    /// Its arcs to prims of other layers: the prim, the name of the layer, and the path of the target, or the default prim.
    pub references: Vec<(&'a str, String, Option<&'a str>)>,
    pub default_prim: Option<&'a str>,
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
    /// Adds the layer `name`. Returns what grew by it.
    pub(super) fn add(&mut self, name: &str, links: Links) -> Vec<Growth> {
        let mut growth = Vec::new();
        let stack = self.stack(name, &links.sublayers);
        self.link(name, stack, &links);
        if let Some(prim) = self.classes.cycle() {
            growth.push(Growth::Cycle { prim });
        }
        let sublayers: Vec<Arc> = links
            .sublayers
            .into_iter()
            .map(|target| Arc {
                prim: name.to_owned(),
                kind: ArcKind::Reference,
                target,
            })
            .collect();
        if self.sublayers.add(&sublayers) {
            growth.push(Growth::Layers {
                layer: self.sublayers.place().to_owned(),
                count: self.sublayers.bound().sites(0),
            });
        }
        let stack = &mut self.stacks[stack];
        if stack.add(links.arcs) {
            self.largest = self.largest.max(stack.bound());
            growth.push(Growth::Sites {
                prim: stack.place().to_owned(),
                count: stack.bound().sites(0),
            });
        }
        growth
    }

    /// Adds the arcs of a layer to those among which cycles are searched.
    fn link(&mut self, name: &str, stack: usize, links: &Links) {
        for arc in links.arcs {
            self.classes
                .add(arc.kind, (stack, &arc.prim), (stack, &arc.target));
        }
        for (prim, layer, target) in &links.references {
            // A layer that was not read yet may still join another stack, and takes this arc there.
            let other = self.stack(layer, &[]);
            match target.or(self.default_prims.get(layer).map(String::as_str)) {
                Some(target) => self
                    .classes
                    .add(ArcKind::Reference, (stack, prim), (other, target)),
                None => {
                    let waiting = self.waiting.entry(layer.clone()).or_default();
                    waiting.push((stack, (*prim).to_owned()));
                }
            }
        }
        if let Some(target) = links.default_prim {
            self.default_prims.insert(name.to_owned(), target.to_owned());
            for (from, prim) in self.waiting.remove(name).unwrap_or_default() {
                self.classes
                    .add(ArcKind::Reference, (from, &prim), (stack, target));
            }
        }
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
            self.classes.join(other, stack);
            for (from, _) in self.waiting.values_mut().flatten() {
                if *from == other {
                    *from = stack;
                }
            }
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

    fn arcs(arcs: &[Arc]) -> Links<'_> {
        Links {
            arcs,
            ..Links::default()
        }
    }

    fn sublayers(names: &[&str]) -> Links<'static> {
        Links {
            sublayers: names.iter().map(|name| (*name).to_owned()).collect(),
            ..Links::default()
        }
    }

    #[test]
    fn joins_the_arcs_of_a_layer_and_its_sublayers() {
        let mut apart = Stacks::default();
        apart.add("a", arcs(&[reference("/A", "/B")]));
        apart.add("b", arcs(&[reference("/B", "/C")]));
        assert_eq!(apart.sites(0), 2);
        let mut joined = Stacks::default();
        joined.add("a", arcs(&[reference("/A", "/B")]));
        joined.add("c", sublayers(&["a", "b"]));
        joined.add("b", arcs(&[reference("/B", "/C")]));
        assert_eq!(joined.sites(0), 3);
    }

    #[test]
    fn counts_a_sublayer_as_often_as_it_is_listed() {
        let mut stacks = Stacks::default();
        for at in 1..=20 {
            let below = format!("l{}", at - 1);
            let growth = stacks.add(&format!("l{at}"), sublayers(&[&below, &below]));
            let [Growth::Layers { layer, count }] = &growth[..] else {
                panic!("unexpected growth");
            };
            assert_eq!(
                (layer.as_str(), *count),
                (&*format!("l{at}"), (1 << (at + 1)) - 1)
            );
        }
    }

    #[test]
    fn finds_circles_of_classes_over_layers() {
        let class = |prim: &str, target: &str| Arc {
            kind: ArcKind::Class,
            ..reference(prim, target)
        };
        let (root, library) = ([class("/P/A", "/P/B")], [class("/L/B", "/L/A")]);
        let root = |target| Links {
            references: vec![("/P", "library".to_owned(), target)],
            ..arcs(&root)
        };
        let library = || Links {
            default_prim: Some("/L"),
            ..arcs(&library)
        };
        let has_cycle = |growth: &[Growth]| growth.iter().any(|one| matches!(one, Growth::Cycle { .. }));
        // The library is read before or after what refers to it, by its default prim, and as a sublayer.
        let mut before = Stacks::default();
        assert!(!has_cycle(&before.add("library", library())));
        assert!(has_cycle(&before.add("root", root(None))));
        let mut after = Stacks::default();
        assert!(!has_cycle(&after.add("root", root(Some("/L")))));
        assert!(has_cycle(&after.add("library", library())));
        let mut joined = Stacks::default();
        assert!(!has_cycle(&joined.add("root", root(None))));
        assert!(!has_cycle(&joined.add("whole", sublayers(&["root", "library"]))));
        assert!(has_cycle(&joined.add("library", library())));
    }
}

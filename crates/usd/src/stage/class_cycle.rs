//! Finds prims that inherit from or specialize themselves.
//!
//! Before the library composes a prim, it composes what the prim inherits and specializes, what that inherits and specializes,
//! and so on. It has no end where these arcs form a cycle: the stack overflows, which aborts the process. What is computed here
//! is what the library visits, within one layer stack.

use std::collections::{BTreeMap, HashMap, HashSet};

use super::inspect::ArcKind;

/// The arcs by prim, with their counts.
pub(super) type Arcs = BTreeMap<String, BTreeMap<(ArcKind, String), usize>>;

/// The maximum number of paths that are visited. A stage with more is composed, as it would be without this check.
const MAX_VISITS: usize = 100_000;
/// How much deeper in the namespace than a prim the paths that contribute to it are followed: some cycles make them longer without end.
const MAX_DEEPER: usize = 16;

/// Returns a prim in a cycle of inherits and specializes, if there is one.
pub(super) fn class_cycle(arcs: &Arcs) -> Option<String> {
    let mut search = Search {
        arcs,
        states: HashMap::new(),
        visits: 0,
    };
    let starts = arcs.values().flat_map(BTreeMap::keys);
    let mut starts = starts.filter(|(kind, _)| *kind == ArcKind::Class);
    starts.find_map(|(_, start)| search.from(start))
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum State {
    Open,
    Done,
}

struct Search<'a> {
    arcs: &'a Arcs,
    states: HashMap<String, State>,
    visits: usize,
}

/// A path that contributes to a prim, with the arcs that lead to it, outermost first: paths below the first of each pair are mapped to
/// paths below the second.
struct Node {
    path: String,
    maps: Vec<(String, String)>,
}

impl Search<'_> {
    /// Visits what a class depends on, and returns a prim in a cycle.
    fn from(&mut self, start: &str) -> Option<String> {
        if self.states.contains_key(start) {
            return None;
        }
        self.states.insert(start.to_owned(), State::Open);
        let mut open = vec![(start.to_owned(), self.classes(start))];
        while let Some((path, classes)) = open.last_mut() {
            let Some(class) = classes.pop() else {
                self.states.insert(std::mem::take(path), State::Done);
                open.pop();
                continue;
            };
            match self.states.get(&class) {
                Some(State::Open) => return Some(class),
                Some(State::Done) => {}
                None => {
                    self.states.insert(class.clone(), State::Open);
                    let classes = self.classes(&class);
                    open.push((class, classes));
                }
            }
        }
        None
    }

    /// Returns the classes on which the library makes the composition of a prim depend: those of its parent and its own, wherever they
    /// are authored, at the paths where they are authored and at those to which the arcs on the way map them.
    fn classes(&mut self, prim: &str) -> Vec<String> {
        let Some((parent, name)) = prim.rsplit_once('/') else {
            return Vec::new();
        };
        let mut found = Vec::new();
        for node in self.nodes(parent) {
            for scanned in [node.path.clone(), format!("{}/{name}", node.path)] {
                for (kind, class) in self.arcs.get(&scanned).into_iter().flat_map(BTreeMap::keys) {
                    if *kind != ArcKind::Class {
                        continue;
                    }
                    let mut composed = class.clone();
                    for (from, to) in node.maps.iter().rev() {
                        found.push(composed.clone());
                        let Some(mapped) = moved(&composed, from, to) else {
                            break;
                        };
                        composed = mapped;
                    }
                    found.push(composed);
                }
            }
        }
        found
    }

    /// Returns the paths that contribute to a prim.
    fn nodes(&mut self, prim: &str) -> Vec<Node> {
        let mut nodes = vec![Node {
            path: prim.to_owned(),
            maps: Vec::new(),
        }];
        let mut known = HashSet::from([prim.to_owned()]);
        let depth = |path: &str| path.matches('/').count();
        let max_depth = depth(prim) + MAX_DEEPER;
        let mut next = 0;
        while next < nodes.len() && self.visits < MAX_VISITS {
            self.visits += 1;
            let path = nodes[next].path.clone();
            let ends = path.match_indices('/').map(|(end, _)| end).skip(1);
            for end in ends.chain([path.len()]) {
                let above = &path[..end];
                for (kind, target) in self.arcs.get(above).into_iter().flat_map(BTreeMap::keys) {
                    // The library ignores arcs to ancestors and descendants.
                    let is_related = moved(above, target, "").or(moved(target, above, "")).is_some();
                    if *kind == ArcKind::VariantSet || is_related {
                        continue;
                    }
                    let Some(reached) = moved(&path, above, target) else {
                        continue;
                    };
                    if depth(&reached) <= max_depth && known.insert(reached.clone()) {
                        let mut maps = nodes[next].maps.clone();
                        maps.push((target.clone(), above.to_owned()));
                        nodes.push(Node { path: reached, maps });
                    }
                }
            }
            next += 1;
        }
        nodes
    }
}

/// Returns a path at or below `from` as one at or below `to`.
fn moved(path: &str, from: &str, to: &str) -> Option<String> {
    let rest = path.strip_prefix(from)?;
    (rest.is_empty() || rest.starts_with('/')).then(|| format!("{to}{rest}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cycle(all: &[(&str, ArcKind, &str)]) -> bool {
        let mut arcs = Arcs::new();
        for (prim, kind, target) in all {
            let of_prim = arcs.entry((*prim).to_owned()).or_default();
            of_prim.insert((*kind, (*target).to_owned()), 1);
        }
        class_cycle(&arcs).is_some()
    }

    /// With prims below these, the library overflows the stack in each of the first cases, and in none of the second.
    /// The circle of three was not tried with it.
    #[test]
    fn finds_what_has_no_end() {
        use ArcKind::{Class, Reference};
        for endless in [
            &[("/A", Class, "/A")][..],
            &[("/A/B", Class, "/A/B")],
            &[("/A", Class, "/B"), ("/B", Class, "/A")],
            &[("/A", Class, "/B"), ("/B", Class, "/C"), ("/C", Class, "/A")],
            &[("/A", Class, "/A/B")],
            &[("/A/B", Class, "/X/Y"), ("/X/Y", Class, "/A/B")],
            &[("/A", Class, "/B/C"), ("/B", Class, "/A")],
            &[("/A", Reference, "/R"), ("/R/N", Class, "/A/N")],
            &[
                ("/A", Reference, "/R"),
                ("/A/N", Class, "/A/M"),
                ("/R/M", Class, "/R/N"),
            ],
        ] {
            assert!(cycle(endless), "{endless:?}");
        }
        for finite in [
            &[("/A", Class, "/B"), ("/B", Class, "/C"), ("/A", Class, "/C")][..],
            &[("/A", Reference, "/A")],
            &[("/A", Reference, "/B"), ("/B", Reference, "/A")],
            &[("/A", Reference, "/B"), ("/B", Class, "/A")],
            &[("/A/B", Class, "/A")],
            &[("/A/B", Reference, "/X"), ("/X/Y", Class, "/A")],
            &[("/A/B", Class, "/X"), ("/X/Y", Class, "/A/B")],
            &[("/A/B", Class, "/X/Y"), ("/X/Y", Class, "/A")],
            &[
                ("/W/a", Class, "/W/_c"),
                ("/W/b", Class, "/W/_c"),
                ("/W", Reference, "/L"),
            ],
        ] {
            assert!(!cycle(finite), "{finite:?}");
        }
    }

    #[test]
    fn large_stages_are_searched_in_part() {
        // Each prim has all classes of all before it.
        let names: Vec<String> = (0..2000).map(|at| format!("/P{at}")).collect();
        let mut arcs = Arcs::new();
        for at in 1..names.len() {
            let classes = names[at.saturating_sub(40)..at].iter();
            let classes = classes.map(|class| ((ArcKind::Class, class.clone()), 1));
            arcs.insert(names[at].clone(), classes.collect());
        }
        assert_eq!(class_cycle(&arcs), None);
    }
}

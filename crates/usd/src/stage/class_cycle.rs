//! Finds prims that inherit from or specialize themselves.
//!
//! Before the library composes a prim, it composes what the prim inherits and specializes, what that inherits and specializes,
//! and so on. It has no end where these arcs form a cycle: the stack overflows, which aborts the process. What is computed here
//! is what the library visits, in the namespace of every layer stack of a stage.

use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};

use super::inspect::ArcKind;

/// The maximum number of paths that are visited for a stage. One with more is composed, as it would be without this check.
const MAX_VISITS: usize = 300_000;
/// How much deeper in the namespace than a prim the paths that contribute to it are followed: some cycles make them longer without end.
const MAX_DEEPER: usize = 16;

/// The arcs of all layers of a stage. Prims of all layer stacks are in one namespace here, below the number of their stack: `0/World/A`.
#[derive(Debug, Default)]
pub(super) struct Classes {
    arcs: BTreeMap<String, BTreeSet<(ArcKind, String)>>,
    /// The prims that have a prim as their target.
    sources: BTreeMap<String, BTreeSet<String>>,
    /// The arcs since the last search.
    added: Vec<(ArcKind, String)>,
    visits: usize,
}

/// Returns the site of a prim in a layer stack.
fn site(stack: usize, prim: &str) -> String {
    format!("{stack}{prim}")
}

/// Splits a site into its layer stack and the path of its prim.
fn split(site: &str) -> (&str, &str) {
    site.split_at(site.find('/').unwrap_or(site.len()))
}

impl Classes {
    /// Adds an arc from a prim of one layer stack to a prim of another or the same.
    pub(super) fn add(
        &mut self,
        kind: ArcKind,
        (stack, prim): (usize, &str),
        (target_stack, target): (usize, &str),
    ) {
        if kind == ArcKind::VariantSet {
            return;
        }
        let (from, to) = (site(stack, prim), site(target_stack, target));
        let arcs = self.arcs.entry(from.clone()).or_default();
        if arcs.insert((kind, to.clone())) {
            if !are_related(&from, &to) {
                self.sources.entry(to.clone()).or_default().insert(from);
            }
            self.added.push((kind, to));
        }
    }

    /// Makes the prims of one layer stack prims of another.
    pub(super) fn join(&mut self, other: usize, stack: usize) {
        let (other, stack) = (other.to_string(), stack.to_string());
        let renamed = |at: &str| moved(at, &other, &stack).unwrap_or_else(|| at.to_owned());
        for (from, arcs) in std::mem::take(&mut self.arcs) {
            let arcs = arcs.into_iter().map(|(kind, to)| (kind, renamed(&to)));
            self.arcs.entry(renamed(&from)).or_default().extend(arcs);
        }
        for (to, sources) in std::mem::take(&mut self.sources) {
            let sources = sources.iter().map(|from| renamed(from));
            self.sources.entry(renamed(&to)).or_default().extend(sources);
        }
        // What was apart may form a cycle now.
        let arcs = self.arcs.values().flatten();
        self.added = arcs.cloned().collect();
    }

    /// Returns the path of a prim in a cycle of inherits and specializes to which an arc since the last search belongs, if there is one.
    pub(super) fn cycle(&mut self) -> Option<String> {
        let mut search = Search {
            arcs: &self.arcs,
            sources: &self.sources,
            states: HashMap::new(),
            visits: self.visits,
        };
        let starts = search.starts(&std::mem::take(&mut self.added));
        let cycle = starts.iter().find_map(|start| search.from(start));
        self.visits = search.visits;
        cycle.map(|site| split(&site).1.to_owned())
    }
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum State {
    Open,
    Done,
}

struct Search<'a> {
    arcs: &'a BTreeMap<String, BTreeSet<(ArcKind, String)>>,
    sources: &'a BTreeMap<String, BTreeSet<String>>,
    states: HashMap<String, State>,
    visits: usize,
}

/// A site that contributes to a prim, with the arcs that lead to it, outermost first: sites below the first of each pair are mapped to
/// sites below the second.
struct Node {
    site: String,
    maps: Vec<(String, String)>,
}

impl Search<'_> {
    /// Returns the classes that some arcs have as their targets or bring to other layer stacks, in every namespace into which arcs map them.
    fn starts(&mut self, added: &[(ArcKind, String)]) -> Vec<String> {
        let mut starts = BTreeSet::new();
        let mut stacks = BTreeSet::new();
        let mut open: Vec<(ArcKind, &str)> = added.iter().map(|(kind, to)| (*kind, to.as_str())).collect();
        while let Some((kind, to)) = open.pop() {
            let stack = split(to).0;
            if kind == ArcKind::Class {
                starts.insert(to);
            } else if stacks.insert(stack) {
                // '0' follows '/'.
                let of_stack = self.arcs.range(format!("{stack}/")..format!("{stack}0"));
                let arcs = of_stack.flat_map(|(_, arcs)| arcs);
                open.extend(arcs.map(|(kind, to)| (*kind, to.as_str())));
            }
        }
        let mut found: Vec<String> = starts.into_iter().map(str::to_owned).collect();
        let mut known: HashSet<String> = found.iter().cloned().collect();
        let mut next = 0;
        while next < found.len() && self.visits < MAX_VISITS {
            self.visits += 1;
            let site = found[next].clone();
            for above in self_and_ancestors(&site) {
                for source in self.sources.get(above).into_iter().flatten() {
                    if let Some(reached) = moved(&site, above, source)
                        && depth(&reached) <= MAX_DEEPER
                        && known.insert(reached.clone())
                    {
                        found.push(reached);
                    }
                }
            }
            next += 1;
        }
        found
    }

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
        // The library takes every path as one of the stage.
        let here = |site: &str| format!("{}{}", split(prim).0, split(site).1);
        let mut found = Vec::new();
        for node in self.nodes(parent) {
            for scanned in [node.site.clone(), format!("{}/{name}", node.site)] {
                for (kind, class) in self.arcs.get(&scanned).into_iter().flatten() {
                    if *kind != ArcKind::Class {
                        continue;
                    }
                    let mut composed = class.clone();
                    found.push(here(&composed));
                    for (from, to) in node.maps.iter().rev() {
                        let Some(mapped) = moved(&composed, from, to) else {
                            break;
                        };
                        composed = mapped;
                        found.push(here(&composed));
                    }
                }
            }
        }
        found
    }

    /// Returns the sites that contribute to a prim.
    fn nodes(&mut self, prim: &str) -> Vec<Node> {
        let mut nodes = vec![Node {
            site: prim.to_owned(),
            maps: Vec::new(),
        }];
        let mut known = HashSet::from([prim.to_owned()]);
        let max_depth = depth(prim) + MAX_DEEPER;
        let mut next = 0;
        while next < nodes.len() && self.visits < MAX_VISITS {
            self.visits += 1;
            let site = nodes[next].site.clone();
            for above in self_and_ancestors(&site) {
                for (_, target) in self.arcs.get(above).into_iter().flatten() {
                    if are_related(above, target) {
                        continue;
                    }
                    let Some(reached) = moved(&site, above, target) else {
                        continue;
                    };
                    if depth(&reached) <= max_depth && known.insert(reached.clone()) {
                        let mut maps = nodes[next].maps.clone();
                        maps.push((target.clone(), above.to_owned()));
                        nodes.push(Node { site: reached, maps });
                    }
                }
            }
            next += 1;
        }
        nodes
    }
}

/// Returns the number of prims from a site to the root.
fn depth(site: &str) -> usize {
    site.matches('/').count()
}

/// Returns the sites of a prim's ancestors, the first one at the root, and its own.
fn self_and_ancestors(site: &str) -> impl Iterator<Item = &str> {
    let ends = site.match_indices('/').map(|(end, _)| end).skip(1);
    ends.chain([site.len()]).map(|end| &site[..end])
}

/// Whether one of two sites is the other or below it: the library ignores arcs between them.
fn are_related(site: &str, other: &str) -> bool {
    moved(site, other, "").or(moved(other, site, "")).is_some()
}

/// Returns a site at or below `from` as one at or below `to`.
fn moved(path: &str, from: &str, to: &str) -> Option<String> {
    let rest = path.strip_prefix(from)?;
    (rest.is_empty() || rest.starts_with('/')).then(|| format!("{to}{rest}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cycle(all: &[(&str, ArcKind, &str)]) -> bool {
        let mut classes = Classes::default();
        for (prim, kind, target) in all {
            classes.add(*kind, place(prim), place(target));
        }
        classes.cycle().is_some()
    }

    /// Returns a layer stack and a path: `/P` is in the first one, `1/L` in another.
    fn place(site: &str) -> (usize, &str) {
        let (stack, path) = split(site);
        (stack.parse().unwrap_or(0), path)
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
            &[
                ("/X", Reference, "/R"),
                ("/X", Reference, "/S"),
                ("/R/N", Class, "/R/M"),
                ("/S/M", Class, "/S/N"),
            ],
            // Across layers.
            &[
                ("/P", Reference, "1/L"),
                ("/P/A", Class, "/P/B"),
                ("1/L/B", Class, "1/L/A"),
            ],
            &[
                ("/X", Reference, "1/L"),
                ("/X", Reference, "2/M"),
                ("1/L/N", Class, "1/L/M"),
                ("2/M/M", Class, "2/M/N"),
            ],
            &[
                ("/P", Reference, "1/M"),
                ("1/M", Reference, "2/L"),
                ("/P/A", Class, "/P/B"),
                ("2/L/B", Class, "2/L/A"),
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
            // Two layers with classes of one name, and a circle of references.
            &[
                ("/a", Reference, "1/asset"),
                ("/b", Reference, "1/asset"),
                ("1/asset", Class, "1/__class__/asset"),
                ("1/asset", Reference, "2/asset"),
                ("2/asset", Class, "2/__class__/asset"),
            ],
            &[
                ("/P", Reference, "1/L"),
                ("/P/A", Class, "/C"),
                ("1/L/A", Class, "1/L/B"),
                ("1/C/k", Reference, "/C"),
            ],
            // The other layer's path has another meaning in the stage.
            &[
                ("/A", Class, "/B"),
                ("1/B", Class, "1/A"),
                ("/R", Reference, "1/B"),
            ],
        ] {
            assert!(!cycle(finite), "{finite:?}");
        }
    }

    #[test]
    fn large_stages_are_searched_in_part() {
        // Each prim has all classes of all before it.
        let names: Vec<String> = (0..2000).map(|at| format!("/P{at}")).collect();
        let mut classes = Classes::default();
        for at in 1..names.len() {
            for class in &names[at.saturating_sub(40)..at] {
                classes.add(ArcKind::Class, (0, &names[at]), (0, class));
            }
        }
        assert_eq!(classes.cycle(), None);
    }
}

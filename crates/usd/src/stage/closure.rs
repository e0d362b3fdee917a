//! Bounds the number of sites that the arcs within a layer stack can give one prim, before it is composed.
//!
//! The arcs of all layers of the stack are taken together, and all variants as selected, which can only make the bound
//! larger. A prim has the arcs authored on it and on its ancestors; each leads to a prim with its own arcs. Where
//! arcs form a cycle, the library follows no chain through the same site twice.

use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::ops::Add;

use super::inspect::{Arc, ArcKind};

/// The arcs by prim, with their counts.
type Arcs = BTreeMap<String, BTreeMap<(ArcKind, String), usize>>;

/// The count at which counting stops.
const MANY: u64 = 1 << 40;
/// The maximum number of arcs and prims that depend on each other in cycles.
const MAX_CYCLE: usize = 512;

/// The arcs within the layers of a stage, and a bound on the sites that they lead to.
#[derive(Debug, Default)]
pub(super) struct Closure {
    arcs: Arcs,
    bound: Extent,
    /// The prim with the most sites.
    place: String,
}

/// Upper bounds of what arcs lead to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Extent {
    /// The number of sites.
    sites: u64,
    /// The number of sites that are inherited or specialized.
    classes: u64,
    /// The number of arcs in a row.
    depth: u64,
}

impl Add for Extent {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            sites: (self.sites + other.sites).min(MANY),
            classes: (self.classes + other.classes).min(MANY),
            depth: self.depth.max(other.depth),
        }
    }
}

impl Extent {
    const ENDLESS: Self = Self {
        sites: MANY,
        classes: MANY,
        depth: MANY,
    };

    pub(super) fn max(self, other: Self) -> Self {
        Self {
            sites: self.sites.max(other.sites),
            classes: self.classes.max(other.classes),
            depth: self.depth.max(other.depth),
        }
    }

    /// Returns an upper bound on the sites of a prim that follows `arcs` arcs to other layers. Each leads to a site with
    /// arcs in its own layers, and the library adds a class again for each arc on the way to it.
    pub(super) fn sites(self, arcs: u64) -> u64 {
        let count = arcs + 1;
        let implied = self
            .classes
            .saturating_mul(count)
            .saturating_mul(count.saturating_mul(self.depth))
            / 2;
        count.saturating_mul(self.sites + 1).saturating_add(implied)
    }

    /// Returns the extent of an arc to a prim with this one.
    fn through(self, kind: ArcKind) -> Self {
        Self {
            sites: (self.sites + 1).min(MANY),
            classes: (self.classes + u64::from(kind == ArcKind::Class)).min(MANY),
            depth: (self.depth + 1).min(MANY),
        }
    }
}

impl Closure {
    /// Adds the arcs of a layer. Returns whether one of them is new. An arc that several layers author counts as
    /// often as it occurs in the layer with most of them.
    pub(super) fn add(&mut self, layer: &[Arc]) -> bool {
        let mut grown = false;
        let mut counts = HashMap::new();
        for arc in layer {
            let count: &mut usize = counts.entry(arc).or_default();
            *count += 1;
            let arcs = self.arcs.entry(arc.prim.clone()).or_default();
            let known = arcs.entry((arc.kind, arc.target.clone())).or_default();
            grown |= *count > *known;
            *known = (*known).max(*count);
        }
        if grown {
            self.update();
        }
        grown
    }

    /// Adds the arcs of another layer stack.
    pub(super) fn absorb(&mut self, other: Self) {
        for (prim, arcs) in other.arcs {
            let own = self.arcs.entry(prim).or_default();
            for (arc, count) in arcs {
                let known = own.entry(arc).or_default();
                *known = count.max(*known);
            }
        }
        self.update();
    }

    fn update(&mut self) {
        (self.bound, self.place) = Graph::new(&self.arcs).bound();
    }

    /// Returns the largest extent of a prim.
    pub(super) fn bound(&self) -> Extent {
        self.bound
    }

    /// Returns the prim with the most sites.
    pub(super) fn place(&self) -> &str {
        &self.place
    }
}

/// The prims with arcs and the targets of arcs, in the order of their paths, so that descendants follow.
struct Graph<'a> {
    paths: Vec<&'a str>,
    /// The nearest ancestor of each prim, as an index.
    parents: Vec<Option<usize>>,
    children: Vec<Vec<usize>>,
    arcs: Vec<Vec<(ArcKind, Option<usize>)>>,
}

/// What is bounded: the arcs authored on a prim, or those on a chain of prims from it downwards.
#[derive(Clone, Copy)]
enum Quantity {
    Authored(usize),
    Below(usize),
}

impl<'a> Graph<'a> {
    fn new(arcs: &'a Arcs) -> Self {
        let targets = arcs
            .values()
            .flat_map(BTreeMap::keys)
            .filter(|(kind, _)| *kind != ArcKind::VariantSet);
        let paths: BTreeSet<&str> = targets
            .map(|(_, target)| target.as_str())
            .chain(arcs.keys().map(String::as_str))
            .collect();
        let paths: Vec<&str> = paths.into_iter().collect();
        let mut parents = vec![None; paths.len()];
        let mut children = vec![Vec::new(); paths.len()];
        let mut open: Vec<usize> = Vec::new();
        for (index, path) in paths.iter().enumerate() {
            let above = |above: &usize| {
                let rest = path.strip_prefix(paths[*above]);
                rest.is_some_and(|rest| rest.starts_with('/'))
            };
            while open.last().is_some_and(|last| !above(last)) {
                open.pop();
            }
            if let Some(parent) = open.last() {
                parents[index] = Some(*parent);
                children[*parent].push(index);
            }
            open.push(index);
        }
        let arcs = paths.iter().map(|path| {
            let authored = arcs.get(*path).into_iter().flatten();
            authored
                .flat_map(|((kind, target), count)| {
                    let target = paths.binary_search(&target.as_str()).ok();
                    std::iter::repeat_n((*kind, target), *count)
                })
                .collect()
        });
        let arcs = arcs.collect();
        Self {
            paths,
            parents,
            children,
            arcs,
        }
    }

    fn quantity(&self, index: usize) -> Quantity {
        match index.checked_sub(self.paths.len()) {
            None => Quantity::Authored(index),
            Some(index) => Quantity::Below(index),
        }
    }

    fn ancestors(&self, index: usize) -> impl Iterator<Item = usize> {
        std::iter::successors(self.parents[index], |index| self.parents[*index])
    }

    /// Calls `visit` with the quantities that a quantity depends on.
    fn dependencies(&self, index: usize, mut visit: impl FnMut(usize)) {
        let count = self.paths.len();
        match self.quantity(index) {
            Quantity::Authored(prim) => {
                for target in self.arcs[prim].iter().filter_map(|(_, target)| *target) {
                    visit(count + target);
                    self.ancestors(target).for_each(&mut visit);
                }
            }
            Quantity::Below(prim) => {
                visit(prim);
                for child in &self.children[prim] {
                    visit(count + child);
                }
            }
        }
    }

    fn evaluate(&self, index: usize, known: &[Extent]) -> Extent {
        let count = self.paths.len();
        match self.quantity(index) {
            Quantity::Authored(prim) => {
                let extents = self.arcs[prim].iter().map(|(kind, target)| {
                    let target = target.map_or(Extent::default(), |target| {
                        self.ancestors(target)
                            .fold(known[count + target], |sum, above| sum + known[above])
                    });
                    target.through(*kind)
                });
                extents.fold(Extent::default(), Extent::add)
            }
            Quantity::Below(prim) => {
                let children = self.children[prim].iter().map(|child| known[count + child]);
                known[prim] + children.fold(Extent::default(), Extent::max)
            }
        }
    }

    /// Returns the largest extent of a prim, and the prim with the most sites.
    fn bound(&self) -> (Extent, String) {
        let known = self.extents();
        let most = (0..self.paths.len()).rev().max_by_key(|prim| known[*prim].sites);
        let mut bound = Extent::default();
        for prim in 0..self.paths.len() {
            let above = self.ancestors(prim).map(|above| known[above]);
            bound = bound.max(above.fold(known[self.paths.len() + prim], Extent::add));
        }
        (
            bound,
            most.map_or_else(String::new, |prim| self.paths[prim].to_owned()),
        )
    }

    /// Bounds all quantities: in the order of their dependencies, except for cycles. There, each round of evaluation
    /// allows chains to be longer by one arc, and no chain passes a quantity twice.
    fn extents(&self) -> Vec<Extent> {
        let count = 2 * self.paths.len();
        let mut known = vec![Extent::default(); count];
        let mut open = vec![0_usize; count];
        let mut dependents = vec![Vec::new(); count];
        for (index, open) in open.iter_mut().enumerate() {
            self.dependencies(index, |needed| {
                *open += 1;
                dependents[needed].push(index);
            });
        }
        let mut done = vec![false; count];
        let mut ready: Vec<usize> = (0..count).filter(|index| open[*index] == 0).collect();
        self.settle(&mut ready, &mut open, &dependents, &mut done, &mut known);
        let cyclic = self.in_cycles(&done, &dependents);
        if cyclic.len() > MAX_CYCLE {
            for index in &cyclic {
                known[*index] = Extent::ENDLESS;
            }
        } else {
            for _ in 0..cyclic.len() {
                for index in &cyclic {
                    known[*index] = self.evaluate(*index, &known);
                }
            }
        }
        for index in &cyclic {
            done[*index] = true;
        }
        for index in cyclic {
            release(&dependents[index], &mut open, &done, &mut ready);
        }
        self.settle(&mut ready, &mut open, &dependents, &mut done, &mut known);
        known
    }

    /// Evaluates the quantities in `ready` and all that depend only on evaluated ones.
    fn settle(
        &self,
        ready: &mut Vec<usize>,
        open: &mut [usize],
        dependents: &[Vec<usize>],
        done: &mut [bool],
        known: &mut [Extent],
    ) {
        while let Some(index) = ready.pop() {
            known[index] = self.evaluate(index, known);
            done[index] = true;
            release(&dependents[index], open, done, ready);
        }
    }

    /// Returns the quantities in cycles and between them: those left after removing all on which no other one depends.
    fn in_cycles(&self, done: &[bool], dependents: &[Vec<usize>]) -> Vec<usize> {
        let mut left: Vec<bool> = done.iter().map(|done| !done).collect();
        let mut needed: Vec<usize> = dependents
            .iter()
            .map(|dependents| dependents.iter().filter(|index| left[**index]).count())
            .collect();
        let mut last: Vec<usize> = (0..left.len())
            .filter(|index| left[*index] && needed[*index] == 0)
            .collect();
        while let Some(index) = last.pop() {
            left[index] = false;
            self.dependencies(index, |dependency| {
                needed[dependency] -= 1;
                if left[dependency] && needed[dependency] == 0 {
                    last.push(dependency);
                }
            });
        }
        (0..left.len()).filter(|index| left[*index]).collect()
    }
}

/// Removes one open dependency of each dependent, and adds those without any to `ready`.
fn release(dependents: &[usize], open: &mut [usize], done: &[bool], ready: &mut Vec<usize>) {
    for dependent in dependents {
        open[*dependent] -= 1;
        if open[*dependent] == 0 && !done[*dependent] {
            ready.push(*dependent);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn closure(arcs: &[(&str, ArcKind, &str)]) -> Closure {
        let mut closure = Closure::default();
        let arc = |(prim, kind, target): &(&str, ArcKind, &str)| Arc {
            prim: (*prim).to_owned(),
            kind: *kind,
            target: (*target).to_owned(),
        };
        closure.add(&arcs.iter().map(arc).collect::<Vec<_>>());
        closure
    }

    #[test]
    fn adds_the_arcs_of_a_chain_and_of_ancestors() {
        use ArcKind::Reference;
        let chain = closure(&[("/A", Reference, "/B"), ("/B", Reference, "/C")]);
        assert_eq!((chain.bound.sites, chain.bound.depth), (2, 2));
        // The child of /A has the arcs of /A and its own.
        let nested = closure(&[
            ("/A", Reference, "/C"),
            ("/A/b", Reference, "/D"),
            ("/A/c", Reference, "/E"),
        ]);
        assert_eq!((nested.bound.sites, nested.bound.depth), (2, 1));
        // A target below a prim with arcs has those, too.
        let below = closure(&[("/A", Reference, "/L/m"), ("/L", Reference, "/C")]);
        assert_eq!(below.bound.sites, 2);
        // A reference brings the arcs of the target's descendants.
        let above = closure(&[("/A", Reference, "/L"), ("/L/m/n", Reference, "/C")]);
        assert_eq!(above.bound.sites, 2);
    }

    #[test]
    fn counts_every_path_through_a_diamond() {
        let mut arcs = Vec::new();
        let names: Vec<[String; 2]> = (0..=30)
            .map(|at| ["C", "D"].map(|name| format!("/{name}{at}")))
            .collect();
        for pair in names.windows(2) {
            for prim in &pair[1] {
                for target in &pair[0] {
                    arcs.push((prim.as_str(), ArcKind::Class, target.as_str()));
                }
            }
        }
        let diamonds = closure(&arcs);
        assert_eq!(diamonds.bound.sites, (1 << 31) - 2);
        assert_eq!(diamonds.place(), "/C30");
    }

    #[test]
    fn bounds_cycles() {
        use ArcKind::Reference;
        let simple = closure(&[
            ("/A", Reference, "/B"),
            ("/B", Reference, "/A"),
            ("/X", Reference, "/A"),
        ]);
        assert!((2..=10).contains(&simple.bound.sites), "{:?}", simple.bound);
        // Each of 30 prims references all the others: the number of simple chains is about 30!.
        let names: Vec<String> = (0..30).map(|at| format!("/P{at}")).collect();
        let all: Vec<(&str, ArcKind, &str)> = names
            .iter()
            .flat_map(|from| {
                names
                    .iter()
                    .map(move |to| (from.as_str(), Reference, to.as_str()))
            })
            .filter(|(from, _, to)| from != to)
            .collect();
        assert_eq!(closure(&all).bound.sites, MANY);
    }

    #[test]
    fn adds_classes_for_each_arc_on_the_way() {
        let class = closure(&[("/A", ArcKind::Class, "/_class")]);
        assert_eq!(class.bound().sites(0), 2);
        assert!(class.bound().sites(10) > 11 * 2 + 50);
        assert_eq!(closure(&[]).bound().sites(10), 11);
    }
}

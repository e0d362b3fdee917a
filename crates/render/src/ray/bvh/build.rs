//! Top-down construction by the binned surface area heuristic. The tree does not depend on the number of threads.

use rayon::prelude::*;

use super::Node;
use super::bins::{Bins, Grid};
use super::bounds::{Bounds, Item};

/// The depth from which on ranges are halved regardless of shape, so that no tree is deeper than this plus 32.
const MAX_CUT_DEPTH: u32 = 48;
/// The number of items above which a range is built in parallel.
const PARALLEL: usize = 1 << 14;
/// The number of items that one task bins.
const CHUNK: usize = 1 << 16;

/// Returns the nodes over all items, the root first; leaves, of at most `leaf` items, refer to the items' new order.
pub(crate) fn build(items: &mut [Item], leaf: usize) -> Vec<Node> {
    let measured = items.par_chunks(CHUNK).map(measure).reduce(
        || (Bounds::EMPTY, Bounds::EMPTY),
        |a, b| (a.0.join(b.0), a.1.join(b.1)),
    );
    let range = Range {
        first: 0,
        items,
        bounds: measured.0,
        centers: measured.1,
        depth: 0,
        leaf,
    };
    let mut nodes = Vec::new();
    if range.items.is_empty() {
        nodes.push(Node::EMPTY);
    } else {
        grow(range, &mut nodes);
    }
    nodes
}

/// A range of items, their bounding box, and the bounding box of their (doubled) centres.
#[derive(Debug)]
struct Range<'a> {
    first: usize,
    items: &'a mut [Item],
    bounds: Bounds,
    centers: Bounds,
    depth: u32,
    /// The maximum number of items of a leaf.
    leaf: usize,
}

fn measure(items: &[Item]) -> (Bounds, Bounds) {
    items
        .iter()
        .fold((Bounds::EMPTY, Bounds::EMPTY), |(bounds, centers), item| {
            (bounds.join(item.bounds()), centers.join(center(item)))
        })
}

#[inline]
fn center(item: &Item) -> Bounds {
    let c = item.bounds().center();
    Bounds([c[0], c[1], c[2], 0.0, -c[0], -c[1], -c[2], 0.0])
}

impl<'a> Range<'a> {
    fn is_leaf(&self) -> bool {
        self.items.len() <= self.leaf
    }

    /// Splits into two parts, neither of them empty.
    fn split(self) -> [Self; 2] {
        let cut = if self.depth < MAX_CUT_DEPTH {
            self.cut()
        } else {
            None
        };
        let Some((grid, cut)) = cut else {
            return self.halve();
        };
        let is_below = |item: &Item| grid.slice(cut.axis, &item.bounds()) < cut.slice;
        let mut centers = [Bounds::EMPTY; 2];
        let (mut low, mut high) = (0, self.items.len());
        while low < high {
            let item = self.items[low];
            if is_below(&item) {
                centers[0] = centers[0].join(center(&item));
                low += 1;
            } else {
                centers[1] = centers[1].join(center(&item));
                high -= 1;
                self.items.swap(low, high);
            }
        }
        let (below, above) = self.items.split_at_mut(low);
        let part = |first, items, bounds, centers| Range {
            first,
            items,
            bounds,
            centers,
            depth: self.depth + 1,
            leaf: self.leaf,
        };
        [
            part(self.first, below, cut.below, centers[0]),
            part(self.first + low, above, cut.above, centers[1]),
        ]
    }

    fn cut(&self) -> Option<(Grid, super::bins::Cut)> {
        let grid = Grid::new(&self.centers);
        let bins = if self.items.len() > 2 * CHUNK {
            self.items
                .par_chunks(CHUNK)
                .map(|items| Bins::new(&grid, items))
                .reduce_with(|a, b| a.join(&b))?
        } else {
            Bins::new(&grid, self.items)
        };
        Some((grid, bins.best_cut(self.leaf)?))
    }

    /// Splits in the middle of the list, for items that no plane separates.
    fn halve(self) -> [Self; 2] {
        let middle = self.items.len() / 2;
        let (below, above) = self.items.split_at_mut(middle);
        [(self.first, below), (self.first + middle, above)].map(|(first, items)| {
            let (bounds, centers) = measure(items);
            Range {
                first,
                items,
                bounds,
                centers,
                depth: self.depth + 1,
                leaf: self.leaf,
            }
        })
    }
}

/// Splits a range into up to eight children, always splitting the largest.
fn children(range: Range<'_>) -> Vec<Range<'_>> {
    if range.items.len() > PARALLEL {
        let [a, b] = range.split();
        let (mut low, high) = rayon::join(|| quarters(a), || quarters(b));
        low.extend(high);
        return low;
    }
    let max_items = items_per_child(range.items.len(), range.leaf);
    let mut children = Vec::with_capacity(8);
    children.push(range);
    while children.len() < 8 {
        let mut widest = None;
        for (index, child) in children.iter().enumerate() {
            let area = child.bounds.half_area();
            if child.items.len() > max_items && widest.is_none_or(|(_, other)| area > other) {
                widest = Some((index, area));
            }
        }
        let Some((index, _)) = widest else { break };
        let [a, b] = children.swap_remove(index).split();
        children.extend([a, b]);
    }
    children
}

/// Returns the maximum number of items of a child: as many as fill complete levels of the tree below it, so that nodes near the
/// leaves, which are nearly all nodes, have eight children.
fn items_per_child(items: usize, leaf: usize) -> usize {
    let mut max = leaf;
    while max * 8 < items - items / 8 {
        max *= 8;
    }
    // Halves are never exactly equal.
    if max > leaf { max + max / 8 } else { max }
}

/// Splits into up to four parts.
fn quarters(range: Range<'_>) -> Vec<Range<'_>> {
    if range.is_leaf() {
        return vec![range];
    }
    let [a, b] = range.split();
    let (mut low, high) = rayon::join(|| halves(a), || halves(b));
    low.extend(high);
    low
}

fn halves(range: Range<'_>) -> Vec<Range<'_>> {
    if range.is_leaf() {
        vec![range]
    } else {
        range.split().into()
    }
}

/// Appends the node over a range and its descendants.
#[allow(
    clippy::cast_possible_truncation,
    reason = "items are counted in u32, a leaf has few"
)]
fn grow(range: Range, nodes: &mut Vec<Node>) {
    let parallel = range.items.len() > PARALLEL;
    let index = nodes.len();
    nodes.push(Node::EMPTY);
    let children = if range.is_leaf() {
        vec![range]
    } else {
        children(range)
    };
    let mut node = Node::EMPTY;
    for (slot, child) in children.iter().enumerate() {
        let (min, max) = (child.bounds.min(), child.bounds.max());
        for axis in 0..3 {
            node.bounds[axis][slot] = min[axis];
            node.bounds[axis + 3][slot] = max[axis];
        }
        if child.is_leaf() {
            node.first[slot] = child.first as u32;
            node.count[slot] = child.items.len() as u8;
        }
    }
    let inner = children
        .into_iter()
        .enumerate()
        .filter(|(_, child)| !child.is_leaf());
    if parallel {
        let grown: Vec<(usize, Vec<Node>)> = inner
            .collect::<Vec<_>>()
            .into_par_iter()
            .map(|(slot, child)| {
                let mut nodes = Vec::new();
                grow(child, &mut nodes);
                (slot, nodes)
            })
            .collect();
        for (slot, mut below) in grown {
            let offset = nodes.len() as u32;
            node.first[slot] = offset;
            for node in &mut below {
                for (first, count) in node.first.iter_mut().zip(node.count) {
                    // Absent children are shifted too but never read.
                    *first += if count == 0 { offset } else { 0 };
                }
            }
            nodes.append(&mut below);
        }
    } else {
        for (slot, child) in inner {
            node.first[slot] = nodes.len() as u32;
            grow(child, nodes);
        }
    }
    nodes[index] = node;
}

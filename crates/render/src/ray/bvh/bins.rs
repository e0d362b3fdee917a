use super::bounds::{Bounds, Item};

/// The number of bins of the surface area heuristic.
pub(super) const BINS: usize = 16;

/// Adding it to a small number rounds the number to an integer, which is then the lowest bits of the sum.
const ROUNDING: f32 = 12_582_912.0;

/// The slices of a range along each axis, by the items' centres.
#[derive(Clone, Copy, Debug)]
pub(super) struct Grid {
    start: [f32; 4],
    per_length: [f32; 4],
}

impl Grid {
    /// Creates slices over centres (doubled, as from [`Bounds::center`]) within `centers`; an axis without extent has one slice.
    pub(super) fn new(centers: &Bounds) -> Self {
        let (min, max) = (centers.min(), centers.max());
        let mut grid = Self {
            start: [0.0; 4],
            per_length: [0.0; 4],
        };
        for axis in 0..3 {
            // Slightly less than 16, so that the last centre stays below the end.
            let per_length = 15.999 / (max[axis] - min[axis]);
            if per_length.is_normal() {
                grid.start[axis] = min[axis];
                grid.per_length[axis] = per_length;
            }
        }
        grid
    }

    /// Returns the slice of an item along each axis.
    #[inline]
    pub(super) fn slices(&self, bounds: &Bounds) -> [usize; 4] {
        let center = bounds.center();
        let rounded: [f32; 4] =
            std::array::from_fn(|i| ((center[i] - self.start[i]) * self.per_length[i] - 0.5) + ROUNDING);
        rounded.map(|x| (x.to_bits() & 15) as usize)
    }

    /// Returns the slice along one axis, as in [`slices`](Self::slices).
    #[inline]
    pub(super) fn slice(&self, axis: usize, bounds: &Bounds) -> usize {
        let center = bounds.0[axis] - bounds.0[axis + 4];
        let rounded = ((center - self.start[axis]) * self.per_length[axis] - 0.5) + ROUNDING;
        (rounded.to_bits() & 15) as usize
    }
}

/// The bounding box and the number of items in each slice.
#[derive(Clone, Debug)]
pub(super) struct Bins {
    bounds: [[Bounds; BINS]; 3],
    counts: [[u32; BINS]; 3],
}

/// A split below `slice`, with the bounding boxes of both sides.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cut {
    pub(super) axis: usize,
    pub(super) slice: usize,
    pub(super) below: Bounds,
    pub(super) above: Bounds,
}

impl Bins {
    pub(super) fn new(grid: &Grid, items: &[Item]) -> Self {
        let mut bins = Self {
            bounds: [[Bounds::EMPTY; BINS]; 3],
            counts: [[0; BINS]; 3],
        };
        for item in items {
            let bounds = item.bounds();
            let slices = grid.slices(&bounds);
            for (axis, slice) in slices.into_iter().take(3).enumerate() {
                let bin = &mut bins.bounds[axis][slice];
                *bin = bin.join(bounds);
                bins.counts[axis][slice] += 1;
            }
        }
        bins
    }

    pub(super) fn join(mut self, other: &Self) -> Self {
        for axis in 0..3 {
            for slice in 0..BINS {
                self.bounds[axis][slice] = self.bounds[axis][slice].join(other.bounds[axis][slice]);
                self.counts[axis][slice] += other.counts[axis][slice];
            }
        }
        self
    }

    /// Returns the cut with the minimum sum of surface area times leaves, of at most `leaf` items; `None` if all items are in one
    /// slice.
    pub(super) fn best_cut(&self, leaf: usize) -> Option<Cut> {
        let leaves = |items| leaves(items, leaf);
        let mut best: Option<(f32, Cut)> = None;
        for axis in 0..3 {
            let (bounds, counts) = (&self.bounds[axis], &self.counts[axis]);
            let mut above = [(Bounds::EMPTY, 0u32); BINS];
            let mut sum = (Bounds::EMPTY, 0);
            for slice in (1..BINS).rev() {
                sum = (sum.0.join(bounds[slice]), sum.1 + counts[slice]);
                above[slice] = sum;
            }
            let mut below = (Bounds::EMPTY, 0);
            for slice in 1..BINS {
                below = (below.0.join(bounds[slice - 1]), below.1 + counts[slice - 1]);
                let above = above[slice];
                if below.1 == 0 || above.1 == 0 {
                    continue;
                }
                let cost = below.0.half_area() * leaves(below.1) + above.0.half_area() * leaves(above.1);
                if best.as_ref().is_none_or(|(other, _)| cost < *other) {
                    let cut = Cut {
                        axis,
                        slice,
                        below: below.0,
                        above: above.0,
                    };
                    best = Some((cost, cut));
                }
            }
        }
        best.map(|(_, cut)| cut)
    }
}

/// Returns the minimum number of leaves: the cost of a leaf does not depend on its number of items.
#[allow(clippy::cast_precision_loss, reason = "a heuristic")]
fn leaves(items: u32, leaf: usize) -> f32 {
    (items as usize).div_ceil(leaf) as f32
}

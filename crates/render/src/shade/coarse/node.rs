//! The light of a sample, and what the samples around it predict.

use oaktwin_image::Image;

use super::samples::{Sample, Samples};
use crate::shade::occlusion::Light;
use crate::shade::pattern::Spots;
use crate::shade::strength::MAX_SHADOWS;

/// The difference between nodes from which on what lies halfway does not tell how light varies between them.
const WIDE: f32 = 0.25;

/// The similarity from which on a sample belongs to the same surface.
const SIMILAR: f32 = 0.25;

/// A lamp as seen from a sample.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shadow {
    /// The index of the lamp.
    pub(super) lamp: u32,
    /// The luminance that arrives without shadows.
    pub(super) strength: f32,
    /// The visible share of the lamp.
    pub(super) seen: f32,
    pub(super) spots: Spots,
    /// Whether the share differs from what the samples around predict.
    pub(super) is_rough: bool,
}

/// The light of a sample.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Node {
    /// The strongest lamps.
    pub(super) lamps: [Option<Shadow>; MAX_SHADOWS],
    /// The unoccluded shares of the surroundings and of the sky.
    pub(super) around: [f32; 2],
    /// Whether the shares differ from what the samples around predict.
    pub(super) is_rough: bool,
}

impl Node {
    pub(super) fn light(&self) -> Light {
        let (mut some, mut all) = (0.0, 0.0);
        for shadow in self.lamps.iter().flatten() {
            some += shadow.seen * shadow.strength;
            all += shadow.strength;
        }
        let [ambient, sky] = self.around;
        Light {
            some,
            all,
            ambient,
            sky,
        }
    }
}

/// Values of the samples around a place.
#[derive(Clone, Copy, Debug)]
pub(super) struct Expected {
    pub(super) mean: f32,
    /// The difference between the largest and the smallest.
    pub(super) spread: f32,
    /// Whether one of them was not predicted well itself.
    pub(super) is_rough: bool,
}

impl Expected {
    /// Whether the values differ by more than is invisible and what lies between them has to be found.
    pub(super) fn varies(&self, invisible: f32) -> bool {
        self.spread > invisible && (self.is_rough || self.spread > WIDE)
    }

    /// Whether a value is not predicted well enough for interpolation on both sides.
    pub(super) fn differs(&self, value: f32, invisible: f32) -> bool {
        (value - self.mean).abs() > invisible || self.spread > WIDE
    }

    fn of(values: impl Iterator<Item = (f32, bool)>) -> Option<Self> {
        let (mut sum, mut count) = (0.0, 0.0);
        let [mut low, mut high] = [f32::INFINITY, f32::NEG_INFINITY];
        let mut is_rough = false;
        for (value, rough) in values {
            sum += value;
            count += 1.0;
            (low, high) = (low.min(value), high.max(value));
            is_rough |= rough;
        }
        (count > 0.0).then(|| Self {
            mean: sum / count,
            spread: high - low,
            is_rough,
        })
    }
}

/// The nodes of a grid.
#[derive(Clone, Copy)]
pub(super) struct Grid<'a> {
    pub(super) samples: &'a Samples,
    pub(super) nodes: &'a Image<Node>,
    /// The distance between nodes, in samples.
    pub(super) stride: u32,
}

/// The nodes of the same surface around a place.
pub(super) struct Around<'a> {
    nodes: [Option<&'a Node>; 4],
    /// Whether the place is halfway between them, so that they predict its light.
    pub(super) is_between: bool,
}

impl<'a> Around<'a> {
    /// Nothing is known around a place.
    pub(super) const NOTHING: Self = Self {
        nodes: [None; 4],
        is_between: false,
    };

    /// Finds the nodes around a place, which is given in halves of the grid's stride.
    pub(super) fn new(grid: &Grid<'a>, at: Sample<'_>, place: [u32; 2]) -> Self {
        let [[left, right], [top, bottom]] = place.map(|x| [x / 2, x.div_ceil(2)]);
        let node = |[x, y]: [u32; 2]| {
            let sample = grid.samples.get(x * grid.stride, y * grid.stride)?;
            let is_similar = at.similarity(sample) >= SIMILAR;
            grid.nodes.get(x, y).filter(|_| is_similar)
        };
        let [a, b] = [node([left, top]), node([right, bottom])];
        let [c, d] = match left == right || top == bottom {
            true => [None; 2],
            false => [node([right, top]), node([left, bottom])],
        };
        let (is_first, is_second) = (a.is_some() && b.is_some(), c.is_some() && d.is_some());
        let nodes = match (is_first, is_second) {
            (true, false) => [a, b, None, None],
            (false, true) => [None, None, c, d],
            _ => [a, b, c, d],
        };
        Self {
            nodes,
            is_between: is_first || is_second,
        }
    }

    /// Returns the visible shares of a lamp, and the spots that all nodes see and that any sees; `None` if it is not known at all nodes.
    pub(super) fn lamp(&self, lamp: u32) -> Option<(Expected, Spots)> {
        let find = |node: &Node| {
            (node.lamps.iter().flatten())
                .find(|shadow| shadow.lamp == lamp)
                .copied()
        };
        let nodes = self.nodes.iter().flatten();
        if nodes.clone().any(|node| find(node).is_none()) {
            return None;
        }
        let shadows = nodes.filter_map(|node| find(node));
        let (mut certain, mut possible) = (u64::MAX, 0);
        for shadow in shadows.clone() {
            certain &= shadow.spots.certain;
            possible |= shadow.spots.possible;
        }
        let expected = Expected::of(shadows.map(|shadow| (shadow.seen, shadow.is_rough)))?;
        Some((expected, Spots { certain, possible }))
    }

    /// Returns the shares of the surroundings and of the sky.
    pub(super) fn around(&self) -> Option<[Expected; 2]> {
        let share = |index: usize| {
            let nodes = self.nodes.iter().flatten();
            Expected::of(nodes.map(|node| (node.around[index], node.is_rough)))
        };
        Some([share(0)?, share(1)?])
    }
}

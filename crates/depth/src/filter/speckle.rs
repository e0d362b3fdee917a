use oaktwin_image::Image;

use super::Pixel;
use super::simd::{self, Level};

/// `SpeckleFilter`: drops small patches of pixels that are alike.
///
/// `DepthAI` hands 16-bit images to OpenCV as signed ones: 32 767 and 32 768 are far apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Speckle {
    /// `speckleRange`: a patch of up to so many pixels is dropped.
    pub speckle_range: u32,
    /// `differenceThreshold`: the largest step between two neighbours of a patch, in pixel values.
    pub difference_threshold: u32,
}

impl Default for Speckle {
    fn default() -> Self {
        Self {
            speckle_range: 50,
            difference_threshold: 2,
        }
    }
}

/// Which pixels of a row belong together with their neighbours: 1 or 0.
#[derive(Debug)]
pub(super) struct Links {
    /// With the one on the left.
    left: Vec<u8>,
    /// Of the row above, with the one on the left.
    left_above: Vec<u8>,
    /// With the one above.
    up: Vec<u8>,
    /// With the one above, where the pixels on the left do not say so already.
    joins: Vec<u8>,
}

impl Speckle {
    pub(super) fn run<P: Pixel>(&self, level: Level, image: &mut Image<P>) {
        let width = image.width() as usize;
        if width == 0 || self.speckle_range == 0 {
            return;
        }
        let most: u16 = P::MAX.into();
        let threshold = i32::try_from(self.difference_threshold.min(most.into())).unwrap_or_default();
        let runs = self.runs(level, image, P::cut(threshold));
        let pixels = image.pixels_mut();
        for (run, &node) in runs.patches.nodes.iter().enumerate().skip(1) {
            if node != LARGE && runs.patches.root(run) != 0 {
                pixels[runs.starts[run]..runs.starts[run + 1]].fill(P::default());
            }
        }
    }

    /// Joins the runs of alike pixels to patches.
    fn runs<P: Pixel>(&self, level: Level, image: &Image<P>, threshold: P) -> Runs {
        let width = image.width() as usize;
        let none = || vec![0u8; width];
        let mut links = Links {
            left: none(),
            left_above: none(),
            up: none(),
            joins: none(),
        };
        let empty = vec![P::default(); width];
        let mut above = &empty[..];
        let mut runs = Runs {
            // Run 0 stands for all large patches.
            starts: vec![0],
            patches: Patches {
                nodes: vec![LARGE],
                range: i64::from(self.speckle_range),
            },
        };
        // Of each column: the run in this row and in the row above; of this row: where a run begins, where two join.
        let (mut run_of, mut run_above) = (vec![0usize; width], vec![0usize; width]);
        let (mut begins, mut joins) = (vec![0usize; width + 1], vec![0usize; width + 1]);
        for (y, row) in image.rows().enumerate() {
            simd::speckle_links(level, threshold, [above, row], &mut links);
            let first = runs.starts.len();
            let (mut begun, mut joined) = (0, 0);
            for x in 0..width {
                begins[begun] = x;
                begun += usize::from(1 - links.left[x]);
                run_of[x] = first + begun - 1;
                joins[joined] = x;
                joined += usize::from(links.joins[x]);
            }
            runs.starts.extend(begins[..begun].iter().map(|x| y * width + x));
            begins[begun] = width;
            let lengths = begins[..=begun].windows(2).map(|pair| (pair[1] - pair[0]) as i64);
            let range = runs.patches.range;
            let nodes = lengths.map(|length| if length > range { LARGE } else { -length });
            runs.patches.nodes.extend(nodes);
            for &x in &joins[..joined] {
                runs.patches.join(run_above[x], run_of[x]);
            }
            above = row;
            std::mem::swap(&mut run_of, &mut run_above);
        }
        runs.starts.push(image.pixels().len());
        runs
    }
}

/// Runs of alike pixels, from 1 on.
struct Runs {
    /// Where each begins, and the last ends.
    starts: Vec<usize>,
    patches: Patches,
}

/// A forest over runs: the trees are patches.
struct Patches {
    /// Below 0: a root, less the number of pixels. Above 0: a node, its parent. [`LARGE`]: belongs to a patch that stays.
    nodes: Vec<i64>,
    /// Larger patches stay.
    range: i64,
}

const LARGE: i64 = 0;

impl Patches {
    /// The root of a run's tree, 0 where it is large.
    fn root(&self, mut run: usize) -> usize {
        while let Ok(parent) = usize::try_from(self.nodes[run]) {
            run = parent;
            if parent == 0 {
                break;
            }
        }
        run
    }

    /// As [`Patches::root`]; what is on the way is hung to it.
    fn find(&mut self, run: usize) -> usize {
        let root = self.root(run);
        let mut at = run;
        while at != root {
            let Ok(parent) = usize::try_from(self.nodes[at]) else {
                break;
            };
            self.nodes[at] = root as i64;
            at = parent;
        }
        root
    }

    fn join(&mut self, a: usize, b: usize) {
        if self.nodes[a] == LARGE && self.nodes[b] == LARGE {
            return;
        }
        let (a, b) = (self.find(a), self.find(b));
        if a == b {
            return;
        }
        let (a, b) = (a.min(b), a.max(b));
        if a == 0 {
            self.nodes[b] = LARGE;
            return;
        }
        let size = self.nodes[a] + self.nodes[b];
        if -size > self.range {
            self.nodes[a] = LARGE;
            self.nodes[b] = LARGE;
        } else {
            self.nodes[a] = size;
            self.nodes[b] = a as i64;
        }
    }
}

/// The links of a row, the second, with itself and the row above it.
#[inline(always)]
pub(super) fn links<P: Pixel>(threshold: P, [above, row]: [&[P]; 2], links: &mut Links) {
    std::mem::swap(&mut links.left, &mut links.left_above);
    let zero = P::default();
    let linked = |a: P, b: P| u8::from((a != zero) & (b != zero) & (a.speckle_distance(b) <= threshold));
    let pairs = row.iter().zip(row.iter().skip(1));
    for (link, (&a, &b)) in links.left.iter_mut().skip(1).zip(pairs) {
        *link = linked(a, b);
    }
    for ((link, &a), &b) in links.up.iter_mut().zip(above).zip(row) {
        *link = linked(a, b);
    }
    if let (Some(join), Some(&up)) = (links.joins.first_mut(), links.up.first()) {
        *join = up;
    }
    let around = links.left.iter().zip(&links.left_above).skip(1);
    let ups = links.up.iter().zip(links.up.iter().skip(1));
    for ((join, (left, left_above)), (up_left, up)) in links.joins.iter_mut().skip(1).zip(around).zip(ups) {
        *join = up & !(left & left_above & up_left);
    }
}

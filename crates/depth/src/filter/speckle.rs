use oaktwin_image::Image;
use oaktwin_parameter::parameters;
use oaktwin_simd::Level;

use super::{Pixel, simd};

parameters! {
    /// `SpeckleFilter`: drops small regions of similar pixels.
    ///
    /// `DepthAI` passes 16-bit images to OpenCV as signed ones: 32 767 and 32 768 are far apart.
    pub struct Speckle("speckle filter", platform) {
        /// The largest region that is dropped.
        speckle_range: u32 = 50 => ("range".alias("speckleRange").unit("px")),
        /// The largest step between two neighbours in a region, in pixel values; in a stereo engine in pixels of disparity,
        /// whatever the subpixel step.
        difference_threshold: u32 = 2
            => ("difference".alias("differenceThreshold")),
    }
}

/// Which pixels of a row belong together with their neighbours: 1 or 0.
#[derive(Debug)]
pub(super) struct Links<'a> {
    /// With the one on the left; two of no value do.
    pub left: &'a mut [u8],
    /// Of the row above, with the one on the left.
    pub left_above: &'a [u8],
    /// With the one above.
    pub up: &'a mut [u8],
    /// With the one above, where the pixels on the left do not say so already.
    pub joins: &'a mut [u8],
}

impl Speckle {
    /// The same in pixel values, of which an integer level is so many.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "the cast saturates"
    )]
    pub(super) fn of_levels(self, integer_level: f64) -> Self {
        Self {
            difference_threshold: (f64::from(self.difference_threshold) * integer_level + 0.5) as u32,
            ..self
        }
    }

    /// An image of 2³¹ pixels or more stays as it is.
    pub(super) fn run<P: Pixel>(&self, level: Level, image: &mut Image<P>) {
        let width = image.width() as usize;
        if width == 0 || self.speckle_range == 0 || i32::try_from(image.pixels().len()).is_err() {
            return;
        }
        let most: u16 = P::MAX.into();
        let threshold = i32::try_from(self.difference_threshold.min(most.into())).unwrap_or_default();
        let threshold = P::cut(threshold);
        drop_lone(level, image, threshold);
        let mut runs = self.runs(level, image, threshold);
        runs.patches.settle();
        let mut run = 0;
        for (pixel, &left) in image.pixels_mut().iter_mut().zip(&runs.left) {
            run += usize::from(1 - left);
            let stays = runs.patches.nodes[run] == 0;
            *pixel = if stays { *pixel } else { P::default() };
        }
    }

    /// Joins the runs of alike pixels to patches.
    fn runs<P: Pixel>(&self, level: Level, image: &Image<P>, threshold: P) -> Runs {
        let width = image.width() as usize;
        let empty = (vec![P::default(); width], vec![0; width]);
        let (mut above, mut left_above) = (&empty.0[..], &empty.1[..]);
        let (mut up, mut joins) = (vec![0; width], vec![0; width]);
        let mut left = vec![0; image.pixels().len()];
        let mut patches = Patches {
            nodes: vec![i32::MIN],
            range: i32::try_from(self.speckle_range).unwrap_or(i32::MAX),
        };
        // Of each column: the run in this row and in the row above; of this row: where runs begin, where two join.
        let (mut run_of, mut run_above) = (vec![0usize; width], vec![0usize; width]);
        let (mut begins, mut joined) = (vec![0u32; width + 1], vec![0u32; width + 1]);
        for (row, left) in image.rows().zip(left.chunks_exact_mut(width)) {
            let links = &mut Links {
                left: &mut *left,
                left_above,
                up: &mut up,
                joins: &mut joins,
            };
            simd::speckle_links(level, threshold, [above, row], links);
            let last = patches.nodes.len() - 1;
            let (mut runs, mut places) = (0, 0);
            let columns = run_of.iter_mut().zip(&*left).zip(&joins);
            for (x, ((run, left), join)) in (0u32..).zip(columns) {
                begins[runs] = x;
                runs += usize::from(1 - left);
                *run = last + runs;
                joined[places] = x;
                places += usize::from(*join);
            }
            begins[runs] = image.width();
            let lengths = begins[..=runs]
                .windows(2)
                .map(|pair| (pair[1] - pair[0]).cast_signed());
            let range = patches.range;
            patches
                .nodes
                .extend(lengths.map(|length| if length > range { 0 } else { -length }));
            for &x in &joined[..places] {
                patches.join(run_above[x as usize], run_of[x as usize]);
            }
            (above, left_above) = (row, left);
            std::mem::swap(&mut run_of, &mut run_above);
        }
        Runs { left, patches }
    }
}

/// Makes pixels 0 that are like none of their neighbours: noise is full of them, and they need no runs.
fn drop_lone<P: Pixel>(level: Level, image: &mut Image<P>, threshold: P) {
    let width = image.width() as usize;
    let nothing = vec![P::default(); width];
    let mut left = vec![0; width + 1];
    let (mut above, mut rest) = (&nothing[..], image.pixels_mut());
    while let Some((row, next)) = rest
        .split_at_mut_checked(width)
        .filter(|(row, _)| !row.is_empty())
    {
        let below = next.get(..width).unwrap_or(&nothing);
        simd::speckle_lone(level, threshold, [above, below], &mut left, row);
        (above, rest) = (row, next);
    }
}

/// Runs of alike pixels, from 1 on.
struct Runs {
    /// 0 where one begins.
    left: Vec<u8>,
    patches: Patches,
}

/// A forest over runs: the trees are patches. Parents have lower numbers than their children.
struct Patches {
    /// Below 0: a root, less the number of pixels. Else the parent. 0 is the root of all patches that stay.
    nodes: Vec<i32>,
    /// Larger patches stay.
    range: i32,
}

impl Patches {
    /// The root of a run's tree; half of what is on the way is hung to what is above it.
    #[inline]
    fn find(&mut self, mut run: usize) -> usize {
        while let Ok(parent) = usize::try_from(self.nodes[run]) {
            let above = self.nodes[parent];
            if above < 0 {
                return parent;
            }
            self.nodes[run] = above;
            run = parent;
        }
        run
    }

    #[inline]
    fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.find(a), self.find(b));
        if a == b {
            return;
        }
        let (a, b) = (a.min(b), a.max(b));
        let size = self.nodes[a].saturating_add(self.nodes[b]);
        let stays = -self.range > size;
        self.nodes[b] = if stays {
            0
        } else {
            i32::try_from(a).unwrap_or_default()
        };
        if a != 0 {
            self.nodes[a] = if stays { 0 } else { size };
        }
    }

    /// Makes every run's node 0 where it stays, and nothing else.
    fn settle(&mut self) {
        self.nodes[0] = 0;
        for run in 1..self.nodes.len() {
            // A parent has been here before its children. No branch: noise would mislead it.
            let node = self.nodes[run];
            let parent = self.nodes[usize::try_from(node.max(0)).unwrap_or_default()];
            self.nodes[run] = parent | (node & (node >> 31));
        }
    }
}

/// Whether two pixels are alike: 1 or 0. What has no value is like nothing.
#[inline(always)]
fn linked<P: Pixel>(threshold: P, a: P, b: P) -> u8 {
    let zero = P::default();
    u8::from((a != zero) & (b != zero) & (a.speckle_distance(b) <= threshold))
}

/// Makes a row's pixels 0 that are like none of their neighbours in it and in the rows above and below. `left` has one
/// more than the row and is 0 at both ends.
#[inline(always)]
pub(super) fn lone<P: Pixel>(threshold: P, [above, below]: [&[P]; 2], left: &mut [u8], row: &mut [P]) {
    let zero = P::default();
    let pairs = row.iter().zip(row.iter().skip(1));
    for (link, (&a, &b)) in left.iter_mut().skip(1).zip(pairs) {
        *link = linked(threshold, a, b);
    }
    let sides = left.iter().zip(left.iter().skip(1));
    for ((pixel, (left, right)), (&above, &below)) in row.iter_mut().zip(sides).zip(above.iter().zip(below)) {
        let links = left | right | linked(threshold, *pixel, above) | linked(threshold, *pixel, below);
        *pixel = if links == 0 { zero } else { *pixel };
    }
}

/// The links of a row, the second, with itself and the row above it.
#[inline(always)]
pub(super) fn links<P: Pixel>(threshold: P, [above, row]: [&[P]; 2], links: &mut Links<'_>) {
    let zero = P::default();
    let pairs = row.iter().zip(row.iter().skip(1));
    for (link, (&a, &b)) in links.left.iter_mut().skip(1).zip(pairs) {
        *link = linked(threshold, a, b) | u8::from((a == zero) & (b == zero));
    }
    for ((link, &a), &b) in links.up.iter_mut().zip(above).zip(row) {
        *link = linked(threshold, a, b);
    }
    if let (Some(join), Some(&up)) = (links.joins.first_mut(), links.up.first()) {
        *join = up;
    }
    let around = links.left.iter().zip(links.left_above).skip(1);
    let ups = links.up.iter().zip(links.up.iter().skip(1));
    for ((join, (left, left_above)), (up_left, up)) in links.joins.iter_mut().skip(1).zip(around).zip(ups) {
        *join = up & !(left & left_above & up_left);
    }
}

use oaktwin_base::parameter::parameters;
use oaktwin_image::Image;
use oaktwin_simd::Level;
use rayon::prelude::*;

use super::Pixel;
use super::kernels::kernels;

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

/// The connections of a row's pixels with their neighbours, 1 or 0.
#[derive(Debug)]
pub(super) struct Links<'a> {
    /// The connections with the pixel on the left; two invalid pixels are connected.
    pub left: &'a mut [u8],
    /// The connections of the row above with the pixel on the left.
    pub left_above: &'a [u8],
    /// The connections with the pixel above.
    pub up: &'a mut [u8],
    /// The connections with the pixel above that do not follow from the left pixel's connections.
    pub joins: &'a mut [u8],
}

impl Speckle {
    /// Returns the filter for pixel values, with `integer_level` pixel values per pixel of disparity.
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

    /// Runs the filter; an image of 2³¹ pixels or more remains unchanged.
    pub(super) fn run<P: Pixel>(&self, level: Level, image: &mut Image<P>) {
        self.run_in_bands(level, image, band_height(image.height() as usize));
    }

    /// Runs the filter in parallel on bands of `height` rows; the result does not depend on it.
    pub(super) fn run_in_bands<P: Pixel>(&self, level: Level, image: &mut Image<P>, height: usize) {
        let width = image.width() as usize;
        if width == 0 || self.speckle_range == 0 || i32::try_from(image.pixels().len()).is_err() {
            return;
        }
        let most: u16 = P::MAX.into();
        let threshold = i32::try_from(self.difference_threshold.min(most.into())).unwrap_or_default();
        let threshold = P::cut(threshold);
        let band = width * height;
        drop_lone(level, image, band, threshold);
        let bands = image.pixels().par_chunks(band);
        let parts: Vec<Runs> = bands
            .map(|rows| self.runs(level, rows, width, threshold))
            .collect();
        let (lefts, mut patches) = self.joined(level, image, band, threshold, parts);
        patches.settle(lefts.iter().map(|(before, _)| *before));
        let bands = image.pixels_mut().par_chunks_mut(band);
        bands.zip(&lefts).for_each(|(pixels, (before, left))| {
            let mut run = *before;
            for (pixel, &left) in pixels.iter_mut().zip(left) {
                run += usize::from(1 - left);
                *pixel = if patches.stays(run) { *pixel } else { P::default() };
            }
        });
    }

    /// Joins the runs of similar pixels of some rows to regions.
    fn runs<P: Pixel>(&self, level: Level, rows: &[P], width: usize, threshold: P) -> Runs {
        let empty = (vec![P::default(); width], vec![0; width]);
        let (mut above, mut left_above) = (&empty.0[..], &empty.1[..]);
        let (mut up, mut joins) = (vec![0; width], vec![0; width]);
        let mut left = vec![0; rows.len()];
        let mut patches = Patches::new(self.speckle_range);
        // For each column, the runs in this row and in the row above; for this row, the starts of runs and the columns
        // of joins.
        let (mut run_of, mut run_above) = (vec![0usize; width], vec![0usize; width]);
        let (mut begins, mut joined) = (vec![0u32; width + 1], vec![0u32; width + 1]);
        let mut first = Vec::new();
        for (row, left) in rows.chunks_exact(width).zip(left.chunks_exact_mut(width)) {
            let links = &mut Links {
                left: &mut *left,
                left_above,
                up: &mut up,
                joins: &mut joins,
            };
            find_links(level, threshold, [above, row], links);
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
            begins[runs] = u32::try_from(width).unwrap_or(u32::MAX);
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
            if first.is_empty() {
                first.clone_from(&run_of);
            }
            (above, left_above) = (row, left);
            std::mem::swap(&mut run_of, &mut run_above);
        }
        Runs {
            left,
            patches,
            first,
            last: run_above,
        }
    }

    /// Joins the regions of bands. Returns the number of runs before each band and its connections with the left.
    fn joined<P: Pixel>(
        &self,
        level: Level,
        image: &Image<P>,
        band: usize,
        threshold: P,
        parts: Vec<Runs>,
    ) -> (Vec<(usize, Vec<u8>)>, Patches) {
        let width = image.width() as usize;
        let mut lefts: Vec<(usize, Vec<u8>)> = Vec::with_capacity(parts.len());
        let mut parts = parts.into_iter();
        let Some(first) = parts.next() else {
            return (lefts, Patches::new(self.speckle_range));
        };
        let (mut patches, mut last_row) = (first.patches, first.last);
        lefts.push((0, first.left));
        let (mut left, mut up, mut joins) = (vec![0; width], vec![0; width], vec![0; width]);
        for (index, part) in (1..).zip(parts) {
            let before = patches.nodes.len() - 1;
            let offset = i32::try_from(before).unwrap_or_default();
            let own = part.patches.nodes.iter().skip(1);
            patches
                .nodes
                .extend(own.map(|node| if *node > 0 { node + offset } else { *node }));
            let seam = index * band;
            let rows = [seam - width..seam, seam..seam + width];
            if let Some((_, above)) = lefts.last()
                && let [Some(upper), Some(lower)] = rows.map(|row| image.pixels().get(row))
            {
                let links = &mut Links {
                    left: &mut left,
                    left_above: &above[above.len() - width..],
                    up: &mut up,
                    joins: &mut joins,
                };
                find_links(level, threshold, [upper, lower], links);
                for ((a, b), join) in last_row.iter().zip(&part.first).zip(&joins) {
                    if *join != 0 {
                        patches.join(*a, before + b);
                    }
                }
            }
            last_row = part.last.iter().map(|run| before + run).collect();
            lefts.push((before, part.left));
        }
        (lefts, patches)
    }
}

/// The number of rows that a thread processes.
fn band_height(height: usize) -> usize {
    const LEAST: usize = 64;
    height.div_ceil(rayon::current_num_threads()).max(LEAST)
}

/// Drops pixels without a similar neighbour: noise has many of them, and they need no runs.
fn drop_lone<P: Pixel>(level: Level, image: &mut Image<P>, band: usize, threshold: P) {
    let width = image.width() as usize;
    let nothing = vec![P::default(); width];
    // The rows beside each band, which other threads change. Lone pixels are similar to none, changed or not.
    let row_at = |start: Option<usize>| {
        let row = start.and_then(|start| image.pixels().get(start..start + width));
        row.unwrap_or(&nothing).to_vec()
    };
    let starts = (0..image.pixels().len()).step_by(band);
    let beside: Vec<[Vec<P>; 2]> = starts
        .map(|start| [row_at(start.checked_sub(width)), row_at(Some(start + band))])
        .collect();
    let bands = image.pixels_mut().par_chunks_mut(band);
    bands.zip(&beside).for_each(|(rows, [above, below])| {
        let mut left = vec![0; width + 1];
        let (mut above, mut rest) = (&above[..], rows);
        while let Some((row, next)) = rest
            .split_at_mut_checked(width)
            .filter(|(row, _)| !row.is_empty())
        {
            let below = next.get(..width).unwrap_or(below);
            drop_lone_row(level, threshold, [above, below], &mut left, row);
            (above, rest) = (row, next);
        }
    });
}

/// The runs of similar pixels, numbered from 1.
struct Runs {
    /// 0 where a run begins, else 1.
    left: Vec<u8>,
    patches: Patches,
    /// The runs of the first and of the last row, by column.
    first: Vec<usize>,
    last: Vec<usize>,
}

/// A forest of runs whose trees are regions. Parents have smaller numbers than their children.
struct Patches {
    /// The negative number of pixels for a root, else the parent. 0 is the root of all regions that are kept.
    nodes: Vec<i32>,
    /// The maximum size of a region that is dropped.
    range: i32,
}

impl Patches {
    fn new(speckle_range: u32) -> Self {
        Self {
            nodes: vec![i32::MIN],
            range: i32::try_from(speckle_range).unwrap_or(i32::MAX),
        }
    }

    /// Returns the root of a run's tree, and halves the path to it.
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

    /// Replaces each node by its root's, as far as that is in the same band. `befores` has the number of runs before each band.
    fn settle(&mut self, befores: impl DoubleEndedIterator<Item = usize>) {
        let (mut rest, mut bands) = (&mut self.nodes[..], Vec::new());
        for before in befores.rev() {
            let (earlier, band) = rest.split_at_mut(before + 1);
            bands.push((i32::try_from(before).unwrap_or_default(), band));
            rest = earlier;
        }
        bands.into_par_iter().for_each(|(before, band)| {
            for run in 0..band.len() {
                // Parents precede their children. The loop is branchless, because noise is unpredictable.
                let node = band[run];
                let parent = if node > before {
                    (node - before - 1).cast_unsigned() as usize
                } else {
                    run
                };
                band[run] = band[parent];
            }
        });
    }

    /// Whether a run is kept, once the nodes are settled.
    #[inline]
    fn stays(&self, run: usize) -> bool {
        let mut node = self.nodes[run];
        // Few regions cross bands.
        while let Some(parent) = usize::try_from(node).ok().filter(|parent| *parent > 0) {
            node = self.nodes[parent];
        }
        node == 0
    }
}

/// Returns 1 if two pixels are similar, else 0. An invalid pixel is similar to none.
#[inline(always)]
fn linked<P: Pixel>(threshold: P, a: P, b: P) -> u8 {
    let zero = P::default();
    u8::from((a != zero) & (b != zero) & (a.speckle_distance(b) <= threshold))
}

/// Drops the pixels of a row without a similar neighbour in the row and in those above and below. `left` is one longer
/// than the row and 0 at both ends.
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

/// Finds the connections of a row with itself and the row above it.
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

kernels! {
    /// [`links`]
    fn find_links<'a> = links => (threshold: P, rows: [&'a [P]; 2], into: &'a mut Links<'a>);
    /// [`lone`]
    fn drop_lone_row<'a> = lone => (threshold: P, around: [&'a [P]; 2], left: &'a mut [u8], row: &'a mut [P]);
}

//! All steps for some rows of an image.

use std::ops::Range;

use oaktwin_simd::{self as simd, Kernel};

use super::OutputMode;
use super::assumptions::{ConfidenceAt, Invalid};
use super::confidence::{self, Texture};
use super::outliers::{self, Validity};
use super::plan::SingleViewPlan;
use super::reasons;
use super::rows::Rows;
use super::view;
use super::warp::{self, Key, LANES, RowBuffers};
use crate::random::{NoiseStage, RandomPlane, Stream};
use crate::{DepthShot, Reason};

/// The random numbers of an image.
#[derive(Clone, Copy, Debug)]
pub(super) struct Planes {
    jitter: RandomPlane,
    grain: RandomPlane,
}

impl Planes {
    pub(super) fn new(random: &Stream, shot: &DepthShot<'_>) -> Self {
        let plane = |stage| random.plane(stage, shot.frame, shot.item);
        Self {
            jitter: plane(NoiseStage::Jitter),
            grain: plane(NoiseStage::Grain),
        }
    }
}

/// Buffers of a thread.
#[derive(Debug, Default)]
pub(super) struct Scratch {
    row: RowBuffers,
    texture: Texture,
    validity: Validity,
    ranks: Vec<u32>,
    keys: Vec<u64>,
    halo: Vec<f32>,
    /// The source columns of the samples in the tile.
    sources: Vec<u32>,
}

/// Senses rows of an image that is not empty.
pub(super) fn sense(
    plan: &SingleViewPlan,
    shot: &DepthShot<'_>,
    random: &Planes,
    mode: OutputMode,
    rows: &mut Rows<'_>,
    scratch: &mut Scratch,
) {
    let mode = rows.view.is_some().then_some(mode);
    let sister_needs = rows.positions.is_some() || rows.colors.is_some();
    let needs_sources = sister_needs
        || rows.confidence.is_some()
        || matches!(mode, Some(OutputMode::Confidence | OutputMode::Disparity));
    let mut ranks = std::mem::take(&mut scratch.ranks);
    let mut keys = std::mem::take(&mut scratch.keys);
    let padded = plan.width.next_multiple_of(LANES);
    if needs_sources {
        keys.resize(padded, u64::NONE);
        simd::run(Tile::new(plan, shot, random, mode, rows, scratch, &mut keys));
    } else {
        ranks.resize(padded, u32::NONE);
        simd::run(Tile::new(plan, shot, random, mode, rows, scratch, &mut ranks));
    }
    (scratch.ranks, scratch.keys) = (ranks, keys);
}

struct Tile<'a, 'b, K> {
    plan: &'a SingleViewPlan,
    shot: &'a DepthShot<'a>,
    random: &'a Planes,
    /// The requested visualization.
    mode: Option<OutputMode>,
    rows: &'a mut Rows<'b>,
    scratch: &'a mut Scratch,
    landed: &'a mut [K],
    picture: Option<&'a [[u8; 4]]>,
    /// The colour image, if confidence is used or shown.
    textured: Option<&'a [[u8; 4]]>,
    /// Whether an output needs the source columns of samples.
    needs_sources: bool,
}

impl<'a, 'b, K: Key> Tile<'a, 'b, K> {
    fn new(
        plan: &'a SingleViewPlan,
        shot: &'a DepthShot<'a>,
        random: &'a Planes,
        mode: Option<OutputMode>,
        rows: &'a mut Rows<'b>,
        scratch: &'a mut Scratch,
        landed: &'a mut [K],
    ) -> Self {
        let picture = shot.rgb().map(|rgb| rgb.pixels());
        let shows_confidence = mode == Some(OutputMode::Confidence) || rows.confidence.is_some();
        Self {
            plan,
            shot,
            random,
            mode,
            needs_sources: rows.positions.is_some() || rows.colors.is_some(),
            rows,
            scratch,
            landed,
            picture,
            textured: picture.filter(|_| plan.can_lack || shows_confidence),
        }
    }
}

impl<K: Key> Kernel for Tile<'_, '_, K> {
    type Output = ();

    #[inline(always)]
    fn run(mut self) {
        let plan = self.plan;
        let first = self.rows.first;
        let end = first + self.rows.distance.len() / plan.width;
        let from = first.saturating_sub(plan.outlier_range);
        let to = (end + plan.outlier_range).min(plan.height);
        self.scratch.row.reset(plan);
        self.scratch.halo.resize(plan.width, 0.0);
        if self.textured.is_some() {
            self.scratch.texture.reset(plan.width);
        }
        if self.needs_sources {
            self.scratch.sources.resize((end - first) * plan.width, 0);
        }
        if plan.outlier_range > 0 {
            self.scratch.validity.reset(plan, from..to);
        }
        for y in from..to {
            self.row(y, (first..end).contains(&y).then(|| y - first));
        }
        if plan.outlier_range > 0 {
            self.scratch.validity.find(plan, first..end);
        }
        for place in 0..end - first {
            self.finish(first + place, place);
        }
    }
}

impl<K: Key> Tile<'_, '_, K> {
    /// Moves the samples of row `y`, which has this index in the tile or, for `None`, is next to the tile.
    #[inline(always)]
    fn row(&mut self, y: usize, place: Option<usize>) {
        let (plan, scratch) = (self.plan, &mut *self.scratch);
        let width = plan.width;
        if let Some(rgb) = self.textured {
            scratch.texture.measure_row(plan, &self.random.grain, rgb, y);
        }
        let lacks_at = |at: ConfidenceAt| self.textured.is_some() && plan.confidence_at == at;
        let lacking: &[u32] = if lacks_at(ConfidenceAt::Source) {
            &scratch.texture.lacking
        } else {
            &[]
        };
        let depth = &self.shot.depth().pixels()[y * width..][..width];
        scratch
            .row
            .warp(plan, &self.random.jitter, y, depth, lacking, self.landed);
        let out = match place {
            Some(place) => &mut self.rows.distance[place * width..][..width],
            None => scratch.halo.as_mut_slice(),
        };
        let [near, far] = plan.reported;
        let is_cut = near > 0.0 || far < f32::MAX;
        let lacking: &[u32] = if lacks_at(ConfidenceAt::Target) {
            &scratch.texture.lacking
        } else {
            &[]
        };
        let words = out.chunks_mut(LANES).zip(self.landed.as_chunks().0);
        for (word, (out, landed)) in words.enumerate() {
            let landed: &[K; LANES] = landed;
            let columns = out.len();
            let mut last = [0.0; LANES];
            let depths = out.first_chunk_mut().unwrap_or(&mut last);
            for (z, key) in depths.iter_mut().zip(landed) {
                *z = warp::depth(key.rank());
            }
            if is_cut {
                for z in &mut *depths {
                    *z = if (*z >= near) & (*z <= far) { *z } else { 0.0 };
                }
            }
            if let Some(lacking) = lacking.get(word * LANES..) {
                for (z, &lacks) in depths.iter_mut().zip(lacking) {
                    *z = if lacks == 0 { *z } else { 0.0 };
                }
            }
            if plan.outlier_range > 0 {
                scratch.validity.set(plan, y, word, depths, columns);
            }
            if columns < LANES {
                out.copy_from_slice(&last[..columns]);
            }
        }
        if let Some(place) = place {
            self.record(y, place);
        }
    }

    /// Fills the outputs besides the distance for the row that was moved last.
    #[inline(always)]
    fn record(&mut self, y: usize, place: usize) {
        let (plan, scratch) = (self.plan, &mut *self.scratch);
        let width = plan.width;
        let depth = &self.shot.depth().pixels()[y * width..][..width];
        let at = place * width..(place + 1) * width;
        if self.needs_sources {
            for (source, key) in scratch.sources[at.clone()].iter_mut().zip(&*self.landed) {
                *source = key.column();
            }
        }
        if let Some(imager) = &mut self.rows.imager
            && let Some(rgb) = self.picture
        {
            confidence::luma(plan.luma, &rgb[y * width..][..width], &mut imager[at.clone()]);
        }
        if let Some(reasons) = &mut self.rows.reasons {
            let distance = &self.rows.distance[at.clone()];
            reasons::row(
                plan,
                depth,
                &scratch.row,
                self.landed,
                distance,
                &mut reasons[at.clone()],
            );
        }
        if let Some(levels) = &mut self.rows.confidence {
            for (x, (level, key)) in levels[at.clone()].iter_mut().zip(&*self.landed).enumerate() {
                *level = match key.rank() {
                    u32::NONE => 0,
                    _ => confidence::level(confidence_of(plan, scratch, x, key.column() as usize)),
                };
            }
        }
        self.visualize(depth, at);
    }

    /// Visualizes the row that was moved last, with this true depth and these pixels of the tile; the modes of the finished
    /// distance are left out.
    #[inline(always)]
    fn visualize(&mut self, depth: &[f32], at: Range<usize>) {
        let (plan, scratch) = (self.plan, &*self.scratch);
        let Some(view) = &mut self.rows.view else { return };
        let view = view[at.clone()].iter_mut();
        match self.mode {
            Some(OutputMode::InputDepth) => {
                for (view, &z) in view.zip(depth) {
                    *view = view::depth(plan, OutputMode::Grayscale, z);
                }
            }
            Some(OutputMode::Reprojected) => {
                for (view, &z) in view.zip(&self.rows.distance[at]) {
                    *view = view::depth(plan, OutputMode::Grayscale, z);
                }
            }
            Some(mode @ (OutputMode::Confidence | OutputMode::Disparity)) => {
                for (x, (view, key)) in view.zip(&*self.landed).enumerate() {
                    *view = Self::landed(plan, scratch, self.textured.is_some(), mode, x, *key);
                }
            }
            _ => {}
        }
    }

    /// Returns the visualization of the sample in column `x` of the row that was moved last.
    fn landed(
        plan: &SingleViewPlan,
        scratch: &Scratch,
        is_textured: bool,
        mode: OutputMode,
        x: usize,
        key: K,
    ) -> [u8; 4] {
        if key.rank() == u32::NONE {
            return view::BLACK;
        }
        let source = key.column() as usize;
        let d = scratch.row.disparity[source];
        if mode == OutputMode::Disparity {
            return view::disparity(plan, d);
        }
        // Without a colour image, confidence is 1.
        let confidence = if is_textured {
            confidence_of(plan, scratch, x, source)
        } else {
            1.0
        };
        view::confidence(plan, confidence, d)
    }

    /// Removes the outliers of row `y` and makes the outputs that depend on the result.
    #[inline(always)]
    fn finish(&mut self, y: usize, place: usize) {
        let (plan, scratch) = (self.plan, &mut *self.scratch);
        let width = plan.width;
        let at = place * width..(place + 1) * width;
        let distance = &mut self.rows.distance[at.clone()];
        let mut sources = self.needs_sources.then(|| &mut scratch.sources[at.clone()]);
        if plan.outlier_range > 0 {
            let lone = scratch.validity.lone(y);
            for x in outliers::columns(lone.missing) {
                // An image of one column has no pixels on either side.
                let near = if x > 0 { x - 1 } else { (x + 1).min(width - 1) };
                distance[x] = distance[near];
                if let Some(sources) = &mut sources {
                    sources[x] = sources[near];
                }
                if let Some(levels) = &mut self.rows.confidence {
                    let levels = &mut levels[at.clone()];
                    levels[x] = levels[near];
                }
            }
            for x in outliers::columns(lone.measured) {
                distance[x] = 0.0;
            }
            if let Some(reasons) = &mut self.rows.reasons {
                let reasons = &mut reasons[at.clone()];
                for x in outliers::columns(lone.missing).filter(|&x| distance[x] > 0.0) {
                    reasons[x] = Reason::Measured.code();
                }
                outliers::columns(lone.measured).for_each(|x| reasons[x] = Reason::Outlier.code());
            }
        }
        let image_at = y * width..(y + 1) * width;
        let invalid = plan.assumptions.invalid;
        if let Some(positions) = &mut self.rows.positions
            && let (Some(input), Some(sources)) = (self.shot.positions(), &sources)
        {
            let input = &input.pixels()[image_at.clone()];
            let missing = |x: usize| match invalid {
                Invalid::Zero => [0.0; 4],
                Invalid::Nan => [f32::NAN; 4],
                Invalid::Input => input[x],
            };
            gather(&mut positions[at.clone()], input, distance, sources, missing);
        }
        if let Some(colors) = &mut self.rows.colors
            && let (Some(input), Some(sources)) = (self.picture, &sources)
        {
            let input = &input[image_at.clone()];
            let missing = |x: usize| match invalid {
                Invalid::Zero | Invalid::Nan => [0; 4],
                Invalid::Input => input[x],
            };
            gather(&mut colors[at.clone()], input, distance, sources, missing);
        }
        if let Some(view) = &mut self.rows.view {
            let view = &mut view[at];
            match self.mode {
                Some(OutputMode::Color) => {
                    if let Some(rgb) = self.picture {
                        view.copy_from_slice(&rgb[image_at]);
                    }
                }
                Some(mode @ (OutputMode::Sawtooth | OutputMode::Grayscale | OutputMode::Rainbow)) => {
                    for (view, &z) in view.iter_mut().zip(&*distance) {
                        *view = view::depth(plan, mode, z);
                    }
                }
                _ => {}
            }
        }
    }
}

/// Returns the confidence of the sample that moved from a column to column `x` of the row that was moved last.
fn confidence_of(plan: &SingleViewPlan, scratch: &Scratch, x: usize, source: usize) -> f32 {
    let at = match plan.confidence_at {
        ConfidenceAt::Source => source,
        ConfidenceAt::Target => x,
    };
    scratch.texture.confidence[at]
}

/// Gathers the values of the samples that moved to each pixel, and the invalid value elsewhere.
fn gather<T: Copy>(
    out: &mut [T],
    input: &[T],
    distance: &[f32],
    sources: &[u32],
    missing: impl Fn(usize) -> T,
) {
    for (x, ((out, &z), &source)) in out.iter_mut().zip(distance).zip(sources).enumerate() {
        *out = if z > 0.0 {
            input[source as usize]
        } else {
            missing(x)
        };
    }
}

//! What an OAK's stereo reports of a rectified pair: the device's pipeline.
//!
//! Disparities are those of the left image's pixels, in pixels of the pair: what is at x in the left image is at x − d
//! in the right one.
//!
//! # Steps
//! 1. **Census transform** ([`Parameters::kernel_size`]): a bit for each pixel of a window, 1 where it is brighter than
//!    the window's mean (whole grey levels, rounded down) or, without [mean mode](Parameters::mean_mode), than the middle,
//!    by more than a threshold. Beyond the image, its border goes on. Of 10-bit images thresholds are four times as large.
//! 2. **Cost** of each candidate: α·AD + β·(CTC << 3), at most 32 times the threshold, averaged over a
//!    [block](Parameters::block_size_px) of pixels and divided by 8, halves up; AD the difference of grey levels of 8 bits, CTC the
//!    number of bits that differ. The published equation shifts right by 5: two bits more are kept, or there would be 5 costs
//!    to tell. Beyond an image's border a block has what is at it. A candidate beyond the right image counts as one of which
//!    three eighths of the bits differ: more than of a right match, less than of a wrong one.
//! 3. **Semi-global aggregation** along [`Parameters::paths`] paths with penalties P1 and P2, those of RVC2 shifted right
//!    by [`Parameters::penalty_shift`]. The sum is divided by [`Parameters::division_factor`].
//! 4. **Winner takes all**: the least sum, of equal ones the smaller disparity.
//! 5. **Confidence**, 0 to 255, higher is surer: ⌊255 (s₂ − s₁) / s₂⌋ with s₁ the least sum and s₂ the least of those not
//!    beside it; 0 where s₂ is 0. RVC4 makes its own of whether both directions agree, of how disparities vary around and
//!    of this share: [`ConfidenceMetrics`].
//! 6. **Subpixel** interpolation ([`Parameters::interpolation`]) to 1/8, 1/16 or 1/32 px, halves up; none at the first and
//!    the last candidate.
//! 7. **Left-right check**: the same sums, read along the pixels of the right image, give its disparities; a pixel whose
//!    partner's differs by more than the threshold, or is not in the image, is lost.
//! 8. On RVC4, before anything is lost: **holes** take the mean of their superpixel or are lost ([`HoleFilling`]), then what is
//!    not sure takes the median of its neighbours ([`AdaptiveMedian`]).
//! 9. **Losses**: what has less confidence than asked for, and columns at the left border.
//! 10. **Extended disparity** ([`Parameters::extended_disparity`]): the same with both images halved; its disparities,
//!     doubled, stand where they are beyond the range of the whole images, and where those have none.
//!
//! Filters belong between these and depth z = f·b/d, as in [`crate::stereo_noise`].
//!
//! # What is published, and what is not
//! Published: the steps' order, census windows and masks, the linear equation and its defaults, P1 and P2, the range and
//! its companding (in steps of 1, 2 and 4 px), that confidence is of a ratio of costs, that subpixel looks at two
//! neighbours on each side, which thresholds and weights there are, and `DepthAI`'s defaults of all. Ours: the block, the number of
//! paths, what unit RVC2's penalties are in, which penalties paths aslant have (the vertical ones), rounding, the formulas of 5 and 6,
//! what is beyond the image, which of two passes counts, the scale of RVC4's noise thresholds, what RVC4's measures of confidence
//! are, its superpixels and its median; and that it fills and filters first and loses then (Qualcomm's interface to the
//! hardware fills and filters, and knows neither a threshold of confidence nor a left-right check).
//!
//! # Speed and memory
//! Two threads share an image; more are of use where several images are matched at once. Memory is about a byte for each
//! pixel and candidate, two where sums need 16 bits; it is kept for the next image.

mod block_sum;
mod census;
mod cost;
mod extended;
mod inspect;
mod lanes;
mod pair;
mod parameters;
mod pass;
mod paths;
mod plan;
mod refine;
mod rvc4;
mod scan;
mod select;

pub use inspect::inspect;
pub use pair::{Luminance, Pair, PairError};
pub use parameters::{
    AdaptiveMedian, AdaptivePenalty, CensusKernel, ConfidenceMetrics, DisparityWidth, HoleFilling,
    Interpolation, Parameters, platform_of,
};

use std::fmt;
use std::sync::{Arc, Mutex, PoisonError};

use oaktwin_camera::StereoGeometry;
use oaktwin_image::{Image, ZDepth};
use oaktwin_simd::Level;

use self::census::Source;
use self::pass::Workspace;
use self::plan::Plan;
use crate::ParameterError;
use crate::disparity::{DepthTable, Fixed};

/// The matcher, ready to look. Copies of it share the memory that they work in.
#[derive(Clone)]
pub struct StereoMatching {
    parameters: Parameters,
    table: DepthTable,
    /// What is not in use.
    memory: Arc<Mutex<Vec<Workspace>>>,
}

/// What the matcher finds in a pair.
#[derive(Clone, Debug, PartialEq)]
pub struct Matched {
    /// Of the left image: units of 2⁻ⁿ px with n bits of [`Parameters::subpixel`], without the
    /// [shift](Parameters::disparity_shift_px); 0 where nothing was measured.
    pub disparity: Image<u16>,
    /// 0 to 255, higher is surer; `DepthAI` 2 counts down from 255. It is there whether a disparity was kept or not.
    pub confidence: Image<u8>,
}

impl fmt::Debug for StereoMatching {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("StereoMatching")
            .field("parameters", &self.parameters)
            .finish_non_exhaustive()
    }
}

impl PartialEq for StereoMatching {
    fn eq(&self, other: &Self) -> bool {
        self.parameters == other.parameters
    }
}

impl StereoMatching {
    /// Of its parameters.
    ///
    /// # Errors
    /// A parameter out of its range.
    pub fn new(parameters: Parameters) -> Result<Self, ParameterError> {
        parameters.check()?;
        Ok(Self {
            parameters,
            table: DepthTable::new(&parameters.fixed(), 1.0, parameters.max_fixed_disparity()),
            memory: Arc::default(),
        })
    }

    /// Its parameters.
    #[must_use]
    pub fn parameters(&self) -> &Parameters {
        &self.parameters
    }

    /// What it finds in a pair, as it hands it to the filters.
    #[must_use]
    pub fn disparity(&self, pair: &Pair<'_>) -> Matched {
        self.disparity_at(Level::detect(), pair)
    }

    /// Depth of the left image: metres, whole millimetres up to 65 535, 0 where nothing was measured.
    #[must_use]
    pub fn sense(&self, pair: &Pair<'_>) -> ZDepth {
        self.depth(&self.disparity(pair).disparity, 1.0, pair.width())
    }

    /// Depth from a disparity image, in which a unit of [`Matched::disparity`] is `scale` units, of a pair `pair_width`
    /// pixels wide: metres, whole millimetres up to 65 535, 0 where nothing was measured.
    #[must_use]
    pub fn depth(&self, disparity: &Image<u16>, scale: f64, pair_width: u32) -> ZDepth {
        let p = &self.parameters;
        let last = disparity.pixels().iter().copied().max().unwrap_or(0);
        let other;
        #[expect(clippy::float_cmp, reason = "the very number that callers write")]
        let table = if scale == 1.0 && pair_width == p.width_px && u32::from(last) <= self.table.last() {
            &self.table
        } else {
            let wider = f64::from(pair_width) / f64::from(p.width_px);
            let stereo = StereoGeometry {
                focal_length_px: p.stereo.focal_length_px * wider,
                ..p.stereo
            };
            let fixed = Fixed { stereo, ..p.fixed() };
            other = DepthTable::new(&fixed, scale, u32::from(last));
            &other
        };
        let mut out = Image::filled(disparity.width(), disparity.height(), 0.0);
        table.look_up(disparity.pixels(), out.pixels_mut());
        ZDepth(out)
    }

    fn disparity_at(&self, level: Level, pair: &Pair<'_>) -> Matched {
        let p = &self.parameters;
        let (width, height) = (pair.width() as usize, pair.height() as usize);
        let levels = [pair.left().levels(), pair.right().levels()];
        let bits = pair.left().bits();
        let sources = levels.each_ref().map(|levels| Source {
            width,
            height,
            bits,
            levels,
        });
        let mut memory = self.take();
        let plan = Plan::new(p, width);
        let matched = pass(level, &plan, &sources, &mut memory);
        let Matched {
            mut disparity,
            mut confidence,
        } = matched;
        if p.extended_disparity && width > 1 && height > 1 {
            let halves = sources.each_ref().map(extended::halve);
            let sources = halves.each_ref().map(|(width, height, levels)| Source {
                width: *width,
                height: *height,
                bits,
                levels,
            });
            let half_plan = Plan {
                invalid_edge: plan.invalid_edge / 2,
                ..plan.clone()
            };
            let half = pass(level, &half_plan, &sources, &mut memory);
            let shift = p.disparity_shift_px << p.subpixel.bits();
            let beyond = u32::from(plan.disparities[plan.candidates - 1] - plan.shift) << p.subpixel.bits();
            let half = (&half.disparity, &half.confidence);
            extended::merge(half, shift, beyond, &mut disparity, &mut confidence);
        }
        self.give_back(memory);
        Matched {
            disparity,
            confidence,
        }
    }

    fn take(&self) -> Workspace {
        let mut unused = self.memory.lock().unwrap_or_else(PoisonError::into_inner);
        unused.pop().unwrap_or_default()
    }

    fn give_back(&self, memory: Workspace) {
        let mut unused = self.memory.lock().unwrap_or_else(PoisonError::into_inner);
        unused.push(memory);
    }
}

fn pass(level: Level, plan: &Plan, sources: &[Source<'_>; 2], memory: &mut Workspace) -> Matched {
    let [left, right] = sources;
    let size = |side: usize| u32::try_from(side).unwrap_or(u32::MAX);
    let mut disparity = Image::filled(size(left.width), size(left.height), 0);
    let mut confidence = Image::filled(size(left.width), size(left.height), 0);
    pass::run(
        level,
        plan,
        [left, right],
        memory,
        disparity.pixels_mut(),
        confidence.pixels_mut(),
    );
    Matched {
        disparity,
        confidence,
    }
}

#[cfg(test)]
mod tests;

//! Stereo matching of a rectified pair, as in the device's pipeline.
//!
//! Disparities belong to the left image's pixels, in pixels of the pair: the point at x in the left image is at x − d
//! in the right one.
//!
//! # Steps
//! 1. **Census transform** ([`Parameters::kernel_size`]): one bit for each pixel of a window, 1 where it is brighter than
//!    the window's mean (whole grey levels, rounded down) or, without [mean mode](Parameters::mean_mode), than its centre,
//!    by more than a threshold. The image's border is repeated outside. For 10-bit images, thresholds are four times as large.
//! 2. **Cost** of each candidate: α·AD + β·(CTC << 3), at most 32 times the threshold, averaged over a
//!    [block](Parameters::block_size_px) of pixels and divided by 8, halves up. AD is the difference of 8-bit grey levels, CTC
//!    the number of bits that differ. The published equation shifts right by 5; two more bits are kept here, as only 5
//!    different costs would remain. Outside the image, a block repeats the border. A candidate outside the right image has the
//!    cost of one of which three eighths of the bits differ: more than a correct match, less than a wrong one.
//! 3. **Semi-global aggregation** along [`Parameters::paths`] paths with penalties P1 and P2: RVC2's, shifted right
//!    by [`Parameters::penalty_shift`]. The sum is divided by [`Parameters::division_factor`].
//! 4. **Winner takes all**: the smallest sum; of equal sums the smaller disparity.
//! 5. **Confidence**, 0 to 255 (highest): ⌊255 (s₂ − s₁) / s₂⌋ with the smallest sum s₁ and the smallest sum s₂ that is not
//!    its neighbour; 0 if s₂ is 0. RVC4 combines the agreement of both directions, the variance of disparity around the pixel
//!    and this ratio: [`ConfidenceMetrics`].
//! 6. **Subpixel** interpolation ([`Parameters::interpolation`]) to 1/8, 1/16 or 1/32 px, halves up; none at the first and
//!    the last candidate.
//! 7. **Left-right check**: the same sums, read along the pixels of the right image, give its disparities. A pixel is lost if
//!    its counterpart's disparity differs by more than the threshold, or its counterpart is outside the image.
//! 8. On RVC4, before pixels are lost: **holes** take the mean of their superpixel or are lost ([`HoleFilling`]), then pixels
//!    of low confidence take the median of their neighbourhood ([`AdaptiveMedian`]).
//! 9. **Losses**: pixels below the confidence threshold, and columns at the left border.
//! 10. **Extended disparity** ([`Parameters::extended_disparity`]): the same with both images at half size. Of its
//!     disparities, doubled, only those beyond the range of the full-size images are used, where the full-size images have
//!     none or a less confident one.
//!
//! Filters run between these steps and depth z = f·b/d, as in [`crate::stereo_noise`].
//!
//! # What is published, and what is not
//! Published are the order of the steps, census windows and masks, the linear equation and its defaults, P1 and P2, the range
//! and its companding (in steps of 1, 2 and 4 px), that confidence is a ratio of costs, that subpixel interpolation uses two
//! neighbours on each side, the thresholds and weights, and `DepthAI`'s defaults. Choices of this project are the block, the
//! number of paths, the unit of RVC2's penalties, the penalties of diagonal paths (the vertical ones), rounding, the formulas
//! of steps 5 and 6, the values outside the image, the priority of the two passes, the scale of RVC4's noise thresholds,
//! RVC4's measures of confidence, its superpixels and its median; and that it fills and filters before pixels are lost
//! (Qualcomm's interface to the hardware fills and filters, and has neither a confidence threshold nor a left-right check).
//!
//! # Speed and memory
//! Two threads share an image; more are useful if several images are matched at once. Memory is about one byte for each
//! pixel and candidate, two where sums need 16 bits; it is kept for the next image.

mod block_sum;
mod census;
mod cost;
mod extended;
mod gather;
mod inspect;
mod lanes;
mod out;
mod pair;
mod parameters;
mod pass;
mod paths;
mod plan;
mod reasons;
mod refine;
mod rvc4;
mod scan;
mod scan_input;
mod select;

pub use inspect::{VERTICAL_OFFSET, inspect};
pub use pair::{LuminanceImage, RectifiedPair, RectifiedPairError};
pub use parameters::{
    AdaptiveMedian, AdaptivePenalty, CensusKernel, ConfidenceMetrics, DisparityWidth, HoleFilling,
    Interpolation, Parameters, platform_of,
};

use std::fmt;
use std::sync::{Arc, Mutex, PoisonError};

use oaktwin_camera::StereoGeometry;
use oaktwin_image::{Image, ZDepth};
use oaktwin_simd::Level;

use self::census::CensusInput;
use self::out::Out;
use self::pass::Workspace;
use self::plan::PassPlan;
use crate::ParameterError;
use crate::disparity::{DepthTable, Fixed};

/// A stereo matcher. Clones share their working memory.
#[derive(Clone)]
pub struct StereoMatching {
    parameters: Parameters,
    table: DepthTable,
    /// The unused workspaces.
    memory: Arc<Mutex<Vec<Workspace>>>,
}

/// The result of matching a pair.
#[derive(Clone, Debug, PartialEq)]
pub struct Matched {
    /// The disparity of the left image in units of 2⁻ⁿ px with n bits of [`Parameters::subpixel`], without the
    /// [shift](Parameters::disparity_shift_px); 0 is invalid.
    pub disparity: Image<u16>,
    /// The confidence from 0 to 255 (highest), also of invalid pixels; `DepthAI` 2 inverts it.
    pub confidence: Image<u8>,
}

/// The result of a pass, with the codes of the reasons that depend on the position of a match if they are needed.
struct Passed {
    matched: Matched,
    lost: Vec<u8>,
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
    /// Creates a matcher from its parameters.
    ///
    /// # Errors
    /// Returns an error if a parameter is out of range.
    pub fn new(parameters: Parameters) -> Result<Self, ParameterError> {
        parameters.check()?;
        Ok(Self {
            parameters,
            table: DepthTable::new(&parameters.fixed(), 1.0, parameters.max_fixed_disparity()),
            memory: Arc::default(),
        })
    }

    /// The parameters.
    #[must_use]
    pub fn parameters(&self) -> &Parameters {
        &self.parameters
    }

    /// Returns the disparity and the confidence of a pair, before filters.
    #[must_use]
    pub fn disparity(&self, pair: &RectifiedPair<'_>) -> Matched {
        self.disparity_at(Level::detect(), pair, false).matched
    }

    /// Returns the depth of the left image in metres, rounded to millimetres, up to 65.535 m; 0 is invalid.
    #[must_use]
    pub fn sense(&self, pair: &RectifiedPair<'_>) -> ZDepth {
        self.depth(&self.disparity(pair).disparity, 1.0, pair.width())
    }

    /// Returns the depth of a disparity image, in which a unit of [`Matched::disparity`] is `scale` units, of a pair
    /// `pair_width` pixels wide, in metres, rounded to millimetres, up to 65.535 m; 0 is invalid.
    #[must_use]
    pub fn depth(&self, disparity: &Image<u16>, scale: f64, pair_width: u32) -> ZDepth {
        let p = &self.parameters;
        let last = disparity.pixels().iter().copied().max().unwrap_or(0);
        let other;
        #[expect(clippy::float_cmp, reason = "callers pass exactly 1")]
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

    fn disparity_at(&self, level: Level, pair: &RectifiedPair<'_>, explains: bool) -> Passed {
        let p = &self.parameters;
        let (width, height) = (pair.width() as usize, pair.height() as usize);
        let levels = [pair.left().levels(), pair.right().levels()];
        let bits = pair.left().bits();
        let sources = levels.each_ref().map(|levels| CensusInput {
            width,
            height,
            bits,
            levels,
        });
        let mut memory = self.take();
        let plan = PassPlan::new(p, width);
        let Passed { mut matched, lost } = pass(level, &plan, &sources, &mut memory, explains);
        if p.extended_disparity && width > 1 && height > 1 {
            let halves = sources.each_ref().map(extended::halve);
            let sources = halves.each_ref().map(|(width, height, levels)| CensusInput {
                width: *width,
                height: *height,
                bits,
                levels,
            });
            let half_plan = PassPlan {
                invalid_edge: plan.invalid_edge / 2,
                ..plan.clone()
            };
            let half = pass(level, &half_plan, &sources, &mut memory, false).matched;
            let shift = p.disparity_shift_px << p.subpixel.bits();
            let beyond = u32::from(plan.disparities[plan.candidates - 1] - plan.shift) << p.subpixel.bits();
            let half = (&half.disparity, &half.confidence);
            let Matched {
                disparity,
                confidence,
            } = &mut matched;
            extended::merge(half, shift, beyond, disparity, confidence);
        }
        self.give_back(memory);
        Passed { matched, lost }
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

fn pass(
    level: Level,
    plan: &PassPlan,
    sources: &[CensusInput<'_>; 2],
    memory: &mut Workspace,
    explains: bool,
) -> Passed {
    let [left, right] = sources;
    let size = |side: usize| u32::try_from(side).unwrap_or(u32::MAX);
    let mut disparity = Image::filled(size(left.width), size(left.height), 0);
    let mut confidence = Image::filled(size(left.width), size(left.height), 0);
    let mut lost = vec![0; if explains { left.width * left.height } else { 0 }];
    let out = Out {
        disparity: disparity.pixels_mut(),
        confidence: confidence.pixels_mut(),
        lost: &mut lost,
    };
    pass::run(level, plan, [left, right], memory, out);
    let matched = Matched {
        disparity,
        confidence,
    };
    Passed { matched, lost }
}

#[cfg(test)]
mod tests;

//! The constants of a matcher pass for one image size, derived from the parameters.

use super::parameters::{AdaptivePenalty, CensusKernel, DisparityWidth, Interpolation, Parameters};
use super::rvc4::steps::Steps;
use crate::preset::Platform;

/// The maximum number of candidates.
pub(super) const MOST: usize = 96;

/// A range of candidates with a constant disparity step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Zone {
    /// The index of its first candidate.
    pub(super) start: usize,
    pub(super) count: usize,
    /// The disparity of its first candidate, px.
    pub(super) first: usize,
    /// The disparity step, px.
    pub(super) step: usize,
}

/// The settings of one pass.
#[derive(Clone, Debug)]
pub(super) struct PassPlan {
    pub(super) zones: Vec<Zone>,
    pub(super) candidates: usize,
    /// The disparity of each candidate, px.
    pub(super) disparities: [u16; MOST],
    pub(super) shift: u16,
    /// The rows and columns of the census window, and the pixels in the mask relative to its top left one.
    pub(super) window: [usize; 2],
    pub(super) pixels: Vec<[usize; 2]>,
    pub(super) mean_mode: bool,
    /// The census threshold in 8-bit grey levels.
    pub(super) census_threshold: i32,
    pub(super) census_scale: i32,
    pub(super) raw: Raw,
    /// The columns of the block over which costs are averaged.
    pub(super) block: usize,
    /// The rows of that block.
    pub(super) block_rows: usize,
    pub(super) penalties: Penalties,
    /// The number of paths of the downward and the upward scan.
    pub(super) paths: [usize; 2],
    pub(super) division: u8,
    pub(super) width: Width,
    pub(super) check: Option<u16>,
    /// Whether the disparities of the right image are needed.
    pub(super) looks_back: bool,
    pub(super) confidence: u8,
    pub(super) invalid_edge: usize,
    pub(super) bits: u32,
    pub(super) interpolation: Interpolation,
    /// RVC4's post-processing.
    pub(super) rvc4: Option<Steps>,
}

/// The matching cost of a single pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Raw {
    /// The number of census bits that differ; each counts 16 in the linear equation.
    Bits { most: u8 },
    /// The complete linear equation.
    Equation { alpha: u32, beta: u32, most: u32 },
}

impl Raw {
    fn new(p: &Parameters, bits: usize) -> Self {
        /// The cost per unit of the threshold.
        const STEP: u32 = 32;
        let (alpha, beta) = (u32::from(p.alpha), u32::from(p.beta));
        let most = alpha * 255 + beta * 8 * counter(bits);
        let most = most.min(STEP * u32::from(p.cost_threshold));
        if alpha == 0 && beta == 2 {
            #[expect(clippy::cast_possible_truncation, reason = "at most 64")]
            let most = (most / 16) as u8;
            Self::Bits { most }
        } else {
            Self::Equation { alpha, beta, most }
        }
    }

    /// The maximum cost of the equation.
    fn most(self) -> u32 {
        match self {
            Self::Bits { most } => 16 * u32::from(most),
            Self::Equation { most, .. } => most,
        }
    }

    /// The cost of a candidate outside the right image. It is below the cost of a wrong match, in which half of the bits
    /// differ, so that a pixel visible only in the left image is matched there and detected as occluded; and above that
    /// of most correct matches.
    pub(super) fn beyond(self) -> u32 {
        let bits = (3 * self.most()) >> 7;
        match self {
            Self::Bits { .. } => bits,
            Self::Equation { .. } => 16 * bits,
        }
    }
}

/// The penalties P1 and P2 of the paths.
#[derive(Clone, Debug)]
pub(super) enum Penalties {
    /// The penalties along the row and those from the previous row.
    Fixed([[u16; 2]; 2]),
    /// The penalties by the difference of grey levels.
    Adaptive(Box<[[u16; 2]; 256]>),
}

/// The integer widths of costs and sums.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Width {
    /// 8 bits for costs and sums.
    Narrow,
    /// 8 bits for costs and the sums of one scan, 9 bits for the sums of both.
    Short,
    /// 8 bits for costs, 16 bits for sums.
    Mixed,
    /// 16 bits for costs and sums.
    Wide,
}

impl Width {
    /// Returns the widths for the largest cost of a path and the number of paths of both scans.
    fn new(largest: u32, paths: [usize; 2]) -> Self {
        let half = largest * counter(paths[0].max(paths[1]));
        let sum = largest * counter(paths[0] + paths[1]);
        match (largest, half, sum) {
            (_, _, ..=255) => Self::Narrow,
            (_, ..=255, ..=511) => Self::Short,
            (..=255, _, _) => Self::Mixed,
            _ => Self::Wide,
        }
    }
}

/// `DepthAI`'s masks: every other pixel of every other row, row by row without the centre.
const MASKS: [u64; 3] = [0xA8_2415, 0xAA02_A815_4055, 0x2AA0_0AA8_0554_0155];

/// The width from which on [`MASKS`] apply: `DepthAI` documents that they are disabled at 400P (640 px) and enabled at
/// 720P (1280 px), and nothing between the two.
const MASKED_WIDTH: usize = 1280;

impl Parameters {
    /// Returns the mask of the window's pixels for images `width` px wide: [`kernel_mask`](Self::kernel_mask), or
    /// `DepthAI`'s choice.
    #[must_use]
    pub const fn mask_at(&self, width: usize) -> u64 {
        match (self.kernel_mask, self.kernel_size) {
            (0, _) if width < MASKED_WIDTH => u64::MAX,
            (0, CensusKernel::Auto | CensusKernel::Kernel5x5) => MASKS[0],
            (0, CensusKernel::Kernel7x7) => MASKS[1],
            (0, CensusKernel::Kernel7x9) => MASKS[2],
            (own, _) => own,
        }
    }
}

impl PassPlan {
    /// Creates the plan of a pass over images `width` px wide.
    pub(super) fn new(p: &Parameters, width: usize) -> Self {
        let window = match p.kernel_size {
            CensusKernel::Auto | CensusKernel::Kernel5x5 => [5, 5],
            CensusKernel::Kernel7x7 => [7, 7],
            CensusKernel::Kernel7x9 => [7, 9],
        };
        let pixels = pixels(window, p.mask_at(width));
        let raw = Raw::new(p, pixels.len());
        let penalties = Penalties::new(p);
        let paths = match p.paths {
            3 => [2, 1],
            4 => [2, 2],
            5 => [4, 1],
            6 => [4, 2],
            _ => [4, 4],
        };
        let zones = zones(p);
        let rvc4 = Steps::new(p);
        let mut disparities = [0; MOST];
        for zone in &zones {
            for k in 0..zone.count {
                if let Some(own) = disparities.get_mut(zone.start + k) {
                    *own = narrow(counter(zone.first + k * zone.step));
                }
            }
        }
        Self {
            candidates: p.candidates() as usize,
            zones,
            disparities,
            shift: narrow(p.disparity_shift_px),
            window,
            pixels,
            mean_mode: p.mean_mode,
            census_threshold: p.census_threshold.cast_signed() + p.noise_threshold_offset,
            census_scale: p.noise_threshold_scale,
            raw,
            block: p.block_size_px as usize,
            block_rows: match p.block_rows_px {
                0 => p.block_size_px as usize,
                rows => rows as usize,
            },
            width: Width::new((raw.most() + 4) / 8 + penalties.largest(), paths),
            penalties,
            paths,
            division: p.division_factor.max(1),
            check: p
                .left_right_check
                .then_some(narrow(p.left_right_check_threshold_px)),
            looks_back: p.left_right_check || rvc4.is_some_and(|steps| steps.look_back()),
            confidence: p.confidence_threshold,
            invalid_edge: p.invalid_edge_px as usize,
            bits: p.subpixel.bits(),
            interpolation: p.interpolation,
            rvc4,
        }
    }

    /// Returns the largest disparity, px.
    pub(super) fn last(&self) -> usize {
        self.zones
            .last()
            .map_or(0, |zone| zone.first + (zone.count - 1) * zone.step)
    }

    /// The number of pixels in a block.
    pub(super) fn area(&self) -> u32 {
        counter(self.block * self.block_rows)
    }

    /// The number of bytes of a pixel's census transform, rounded up to a number that the kernels support.
    pub(super) fn planes(&self) -> usize {
        match self.pixels.len().div_ceil(8) {
            0 | 1 => 1,
            2 => 2,
            3 => 3,
            4..=6 => 6,
            _ => 8,
        }
    }
}

impl Penalties {
    fn new(p: &Parameters) -> Self {
        match p.platform {
            Platform::Rvc2 => {
                let pair = |p1: u32, p2: u32| pair(p1 >> p.penalty_shift, p2 >> p.penalty_shift);
                Self::Fixed([
                    pair(p.horizontal_p1, p.horizontal_p2),
                    pair(p.vertical_p1, p.vertical_p2),
                ])
            }
            Platform::Rvc4 if p.p1.adaptive || p.p2.adaptive => {
                let mut table = Box::new([[0; 2]; 256]);
                for (difference, own) in (0..).zip(table.iter_mut()) {
                    let of = |penalty: &AdaptivePenalty| adaptive(p, penalty, difference);
                    *own = pair(of(&p.p1), of(&p.p2));
                }
                Self::Adaptive(table)
            }
            Platform::Rvc4 => Self::Fixed([pair(p.p1.default, p.p2.default); 2]),
        }
    }

    fn largest(&self) -> u32 {
        let all = match self {
            Self::Fixed(pairs) => pairs.as_slice(),
            Self::Adaptive(table) => table.as_slice(),
        };
        all.iter().map(|pair| u32::from(pair[1])).max().unwrap_or(0)
    }
}

/// Returns an RVC4 penalty at a difference of neighbours in 8-bit grey levels.
const fn adaptive(p: &Parameters, penalty: &AdaptivePenalty, difference: u32) -> u32 {
    if !penalty.adaptive {
        penalty.default
    } else if difference > p.edge_threshold {
        penalty.edge
    } else if difference < p.smooth_threshold {
        penalty.smooth
    } else {
        penalty.default
    }
}

/// Returns the window's pixels in the mask, relative to its top left one.
fn pixels([rows, columns]: [usize; 2], mask: u64) -> Vec<[usize; 2]> {
    let middle = rows * columns / 2;
    let others = (0..rows * columns).filter(|&place| place != middle);
    let last = rows * columns - 2;
    others
        .enumerate()
        .filter(|(bit, _)| mask >> (last - bit) & 1 == 1)
        .map(|(_, place)| [place / columns, place % columns])
        .collect()
}

fn zones(p: &Parameters) -> Vec<Zone> {
    let counts: &[usize] = match (p.disparity_width, p.companding) {
        (DisparityWidth::Disparity96, false) => &[96],
        (DisparityWidth::Disparity96, true) => &[48, 32, 16],
        (DisparityWidth::Disparity64, false) => &[64],
        (DisparityWidth::Disparity64, true) => &[32, 16, 16],
    };
    let (mut start, mut first, mut step) = (0, p.disparity_shift_px as usize, 1);
    counts
        .iter()
        .map(|&count| {
            let zone = Zone {
                start,
                count,
                first,
                step,
            };
            start += count;
            first += count * step;
            step *= 2;
            zone
        })
        .collect()
}

/// Clamps P1 to P2.
fn pair(p1: u32, p2: u32) -> [u16; 2] {
    [narrow(p1.min(p2)), narrow(p2)]
}

fn narrow(value: u32) -> u16 {
    u16::try_from(value).unwrap_or(u16::MAX)
}

#[expect(clippy::cast_possible_truncation, reason = "small numbers")]
fn counter(value: usize) -> u32 {
    value as u32
}

//! Fixed-point disparities, and what depth they are.

use oaktwin_camera::StereoGeometry;
use oaktwin_simd::{self as simd, Kernel};

use crate::choice::choice;

/// The fractional bits of a disparity.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Subpixel {
    /// Whole pixels.
    Off,
    /// Eighths.
    Bits3,
    /// Sixteenths.
    Bits4,
    /// Thirty-seconds.
    #[default]
    Bits5,
}

impl Subpixel {
    /// How many bits.
    #[must_use]
    pub const fn bits(self) -> u32 {
        match self {
            Self::Off => 0,
            Self::Bits3 => 3,
            Self::Bits4 => 4,
            Self::Bits5 => 5,
        }
    }

    /// So many bits; none where the device has no such mode.
    pub(crate) fn of_bits(bits: u32) -> Option<Self> {
        [Self::Off, Self::Bits3, Self::Bits4, Self::Bits5]
            .into_iter()
            .find(|subpixel| subpixel.bits() == bits)
    }

    /// On, with the bits there are or else the default's, or off.
    pub(crate) fn switched(self, is_on: bool) -> Self {
        match (is_on, self) {
            (false, _) => Self::Off,
            (true, Self::Off) => Self::default(),
            (true, own) => own,
        }
    }

    /// The step, px.
    #[must_use]
    pub fn step_px(self) -> f64 {
        1.0 / f64::from(1u32 << self.bits())
    }
}

choice! {
    /// How depth becomes whole millimetres. What the device does is not published.
    DepthRounding {
        /// the nearest, halves up.
        Nearest = "nearest",
        /// the one below.
        Truncate = "truncate",
    }
}

/// What a disparity image counts in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Fixed {
    /// In the pixels of a disparity.
    pub(crate) stereo: StereoGeometry,
    /// The unit.
    pub(crate) subpixel: Subpixel,
    /// The disparity that 0 stands for, px: that itself is no measurement.
    pub(crate) shift_px: u32,
    /// How depth becomes whole millimetres.
    pub(crate) rounding: DepthRounding,
}

/// Every value of a disparity.
const ALL: usize = 1 << 16;

/// Depth of fixed-point disparities, metres in whole millimetres.
#[derive(Clone, PartialEq)]
pub(crate) struct DepthTable {
    /// [`ALL`], so that none is out of bounds.
    metres: Vec<f32>,
    last: u32,
}

impl DepthTable {
    /// Of disparities 0 to `last`, `scale` units a step.
    pub(crate) fn new(fixed: &Fixed, scale: f64, last: u32) -> Self {
        let step = fixed.subpixel.step_px() / scale;
        let metres = (0..=last).map(|value| {
            if value == 0 {
                return 0.0;
            }
            let d = f64::from(value) * step + f64::from(fixed.shift_px);
            let exact = fixed.stereo.depth(d) * 1000.0;
            let millimetres = match fixed.rounding {
                DepthRounding::Nearest => (exact + 0.5).floor(),
                DepthRounding::Truncate => exact.floor(),
            };
            if millimetres > f64::from(u16::MAX) {
                return 0.0;
            }
            #[expect(clippy::cast_possible_truncation, reason = "metres are single precision")]
            let metres = (millimetres / 1000.0) as f32;
            metres
        });
        let mut metres: Vec<f32> = metres.collect();
        metres.resize(ALL, 0.0);
        Self { metres, last }
    }

    /// The largest disparity that it has.
    pub(crate) fn last(&self) -> u32 {
        self.last
    }

    /// Disparities, none larger than the last, become depth.
    pub(crate) fn look_up(&self, fixed: &[u16], out: &mut [f32]) {
        let metres = self.metres.as_slice();
        simd::run(LookUp { metres, fixed, out });
    }
}

struct LookUp<'a> {
    metres: &'a [f32],
    fixed: &'a [u16],
    out: &'a mut [f32],
}

impl Kernel for LookUp<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Some(metres) = self.metres.first_chunk::<ALL>() else {
            return;
        };
        for (out, &fixed) in self.out.iter_mut().zip(self.fixed) {
            *out = metres[usize::from(fixed)];
        }
    }
}

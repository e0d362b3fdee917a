use super::parameters::{DepthRounding, Parameters};
use crate::simd::{self, Kernel};

/// Every value of a disparity.
const ALL: usize = 1 << 16;

/// Depth of fixed-point disparities, metres in whole millimetres.
#[derive(Clone, PartialEq)]
pub(super) struct DepthTable {
    /// [`ALL`], so that none is out of bounds.
    metres: Vec<f32>,
    last: u32,
}

impl DepthTable {
    /// Of disparities 0 to `last`, `scale` units a step.
    pub(super) fn new(p: &Parameters, scale: f64, last: u32) -> Self {
        let step = p.subpixel.step_px() / scale;
        let metres = (0..=last).map(|fixed| {
            if fixed == 0 {
                return 0.0;
            }
            let d = f64::from(fixed) * step + f64::from(p.disparity_shift_px);
            let exact = p.stereo.depth(d) * 1000.0;
            let millimetres = match p.depth_rounding {
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
    pub(super) fn last(&self) -> u32 {
        self.last
    }

    /// Disparities, none larger than the last, become depth.
    pub(super) fn look_up(&self, fixed: &[u16], out: &mut [f32]) {
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

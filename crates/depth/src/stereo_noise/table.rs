use super::parameters::{DepthRounding, Parameters};

/// Depth of fixed-point disparities, metres in whole millimetres.
#[derive(Clone, PartialEq)]
pub(super) struct DepthTable {
    metres: Vec<f32>,
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
        Self {
            metres: metres.collect(),
        }
    }

    /// The largest disparity that it has.
    pub(super) fn last(&self) -> usize {
        self.metres.len() - 1
    }

    /// Disparities become depth.
    pub(super) fn look_up(&self, fixed: &[u16], out: &mut [f32]) {
        for (out, &fixed) in out.iter_mut().zip(fixed) {
            *out = self.metres.get(usize::from(fixed)).copied().unwrap_or(0.0);
        }
    }
}

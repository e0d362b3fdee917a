//! The candidates of every pixel of a row, side by side, for plans with several zones.

use oaktwin_simd::{self as simd, Kernel, Level};

use super::plan::{PassPlan, Zone};

/// A row of the right image as its candidates: for each plane, the candidates of every pixel of the left image.
#[derive(Clone, Debug, Default)]
pub(super) struct Gathered {
    /// The plane, regrouped by the disparity steps of the zones.
    stepped: Vec<u8>,
    rows: Vec<u8>,
}

impl Gathered {
    /// Gathers the candidates of `width` pixels from planes of a mirrored row, which are `stride` apart.
    pub(super) fn of(
        &mut self,
        level: Level,
        plan: &PassPlan,
        planes: &[u8],
        stride: usize,
        width: usize,
    ) -> &[u8] {
        let length = width * plan.candidates;
        self.rows.resize(planes.len() / stride.max(1) * length, 0);
        for (plane, out) in planes
            .chunks_exact(stride)
            .zip(self.rows.chunks_exact_mut(length))
        {
            for zone in &plan.zones {
                let phase_stride = stride.div_ceil(zone.step);
                let plane = match zone.step {
                    1 => plane,
                    step => regroup(plane, step, phase_stride, &mut self.stepped),
                };
                let zoned = Zoned {
                    zone,
                    phase_stride,
                    plane,
                    candidates: plan.candidates,
                    out,
                };
                match zone.count {
                    48 => simd::run_at(level, Copy::<48>(zoned)),
                    32 => simd::run_at(level, Copy::<32>(zoned)),
                    _ => simd::run_at(level, Copy::<16>(zoned)),
                }
            }
        }
        &self.rows
    }
}

/// Regroups a plane: every `step`-th pixel from the first one, then from the second one, and so on.
fn regroup<'a>(plane: &[u8], step: usize, phase_stride: usize, out: &'a mut Vec<u8>) -> &'a [u8] {
    out.clear();
    for phase in 0..step {
        let before = out.len();
        out.extend(plane.iter().skip(phase).step_by(step));
        out.resize(before + phase_stride, 0);
    }
    out
}

/// The work for one zone of a plane.
struct Zoned<'a> {
    zone: &'a Zone,
    /// The pixels of a phase in `plane`.
    phase_stride: usize,
    plane: &'a [u8],
    candidates: usize,
    out: &'a mut [u8],
}

/// Copies the `COUNT` candidates of a zone for each pixel.
struct Copy<'a, const COUNT: usize>(Zoned<'a>);

impl<const COUNT: usize> Kernel for Copy<'_, COUNT> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Zoned {
            zone,
            phase_stride,
            plane,
            candidates,
            out,
        } = self.0;
        // Steps are powers of two; division would take longer than the copy.
        let bits = zone.step.trailing_zeros();
        let pixels = out.chunks_exact_mut(candidates).rev();
        for (place, out) in (zone.first..).zip(pixels) {
            let from = (place & (zone.step - 1)) * phase_stride + (place >> bits);
            let candidates = plane.get(from..).and_then(|rest| rest.first_chunk::<COUNT>());
            let out = out.get_mut(zone.start..).and_then(|rest| rest.first_chunk_mut());
            if let (Some(candidates), Some(out)) = (candidates, out) {
                *out = *candidates;
            }
        }
    }
}

//! Why pixels of a row have no value.

use super::plan::SingleViewPlan;
use super::warp::{Key, RowBuffers, depth};
use crate::Reason;

/// Fills the codes of a row with this true depth, from the samples that `landed` in its pixels and its distances before the
/// removal of outliers.
pub(super) fn row<K: Key>(
    plan: &SingleViewPlan,
    truth: &[f32],
    samples: &RowBuffers,
    landed: &[K],
    distance: &[f32],
    out: &mut [u8],
) {
    out.fill(0);
    dropped(plan, truth, samples, out);
    unseen(plan, landed, out);
    let [near, far] = plan.reported;
    for (code, (key, z)) in out.iter_mut().zip(landed.iter().zip(distance)) {
        let rank = key.rank();
        let sample = depth(rank);
        *code = if *z > 0.0 {
            Reason::Measured.code()
        } else if rank == u32::NONE {
            if *code == 0 {
                Reason::Occluded.code()
            } else {
                *code
            }
        } else if rank & 1 == 0 && sample < near {
            Reason::TooNear.code()
        } else if rank & 1 == 0 && sample > far {
            Reason::TooFar.code()
        } else {
            Reason::NoTexture.code()
        };
    }
}

/// Marks the pixels to which samples would have moved that were dropped.
fn dropped(plan: &SingleViewPlan, truth: &[f32], samples: &RowBuffers, out: &mut [u8]) {
    let [near, _] = plan.looked_at;
    for (x, (z, d)) in truth.iter().zip(&samples.disparity).enumerate() {
        if d.is_finite() {
            continue;
        }
        let is_surface = z.is_finite() && *z > 0.0;
        let disparity = if is_surface {
            plan.disparity_times_depth / z
        } else {
            0.0
        };
        let is_beyond = !plan.clamps && disparity > plan.max_disparity_px;
        let reason = match is_surface {
            false => Reason::NoSurface,
            true if *z < near || is_beyond => Reason::TooNear,
            true => Reason::TooFar,
        };
        #[expect(
            clippy::cast_possible_truncation,
            reason = "saturates, and is then outside the image"
        )]
        let target = (x as i64).saturating_add((plan.side * disparity).round_ties_even() as i64);
        let place = usize::try_from(target)
            .ok()
            .and_then(|target| out.get_mut(target));
        if let Some(code) = place.filter(|code| **code == 0) {
            *code = reason.code();
        }
    }
}

/// Marks the columns at the border from which samples move into the image: what is there is outside the rendered view.
fn unseen<K: Key>(plan: &SingleViewPlan, landed: &[K], out: &mut [u8]) {
    let columns = landed.len().min(out.len());
    let from_border: &mut dyn Iterator<Item = usize> = match plan.side > 0.0 {
        true => &mut (0..columns),
        false => &mut (0..columns).rev(),
    };
    for x in from_border.take_while(|x| landed[*x].rank() == u32::NONE) {
        if out[x] == 0 {
            out[x] = Reason::OutsideOtherView.code();
        }
    }
}

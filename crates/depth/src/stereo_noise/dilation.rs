//! Edge fattening: a matching window across an edge reports the near side.

use oaktwin_simd::{self as simd, Kernel, Level};

/// The minimum disparity difference at an edge, px; smaller differences are slopes of surfaces.
const JUMP_PX: f32 = 1.0;

/// The last rows of a disparity image, each with the maximum within reach along the row.
#[derive(Clone, Debug, Default)]
pub(super) struct Dilation {
    reach: usize,
    rows: Vec<f32>,
    next: usize,
}

impl Dilation {
    pub(super) fn reset(&mut self, width: usize, reach: usize) {
        self.reach = reach;
        self.next = 0;
        self.rows.clear();
        self.rows.resize(width * (2 * reach + 1), 0.0);
    }

    /// Adds the next row; `None` beyond the border.
    pub(super) fn push(&mut self, level: Level, disparities: Option<&[f32]>) {
        let count = 2 * self.reach + 1;
        let width = self.rows.len() / count;
        let start = self.next * width;
        self.next = (self.next + 1) % count;
        let Some(out) = self.rows.get_mut(start..start + width) else {
            return;
        };
        match disparities {
            None => out.fill(0.0),
            Some(disparities) => simd::run_at(
                level,
                AlongRow {
                    reach: self.reach,
                    disparities,
                    out,
                },
            ),
        }
    }

    /// Writes the middle row with widened edges.
    pub(super) fn widen(&self, level: Level, disparities: &[f32], out: &mut [f32]) {
        simd::run_at(
            level,
            AcrossRows {
                rows: &self.rows,
                disparities,
                out,
            },
        );
    }
}

struct AlongRow<'a> {
    reach: usize,
    disparities: &'a [f32],
    out: &'a mut [f32],
}

impl Kernel for AlongRow<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        self.out.copy_from_slice(self.disparities);
        for offset in 1..=self.reach {
            let from_right = self.disparities.get(offset..).unwrap_or_default();
            raise(self.out, from_right);
            raise(self.out.get_mut(offset..).unwrap_or_default(), self.disparities);
        }
    }
}

struct AcrossRows<'a> {
    rows: &'a [f32],
    disparities: &'a [f32],
    out: &'a mut [f32],
}

impl Kernel for AcrossRows<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        self.out.fill(0.0);
        for row in self.rows.chunks_exact(self.disparities.len().max(1)) {
            raise(self.out, row);
        }
        for (out, &d) in self.out.iter_mut().zip(self.disparities) {
            *out = if *out > d + JUMP_PX { *out } else { d };
        }
    }
}

#[inline(always)]
fn raise(out: &mut [f32], to: &[f32]) {
    for (out, &to) in out.iter_mut().zip(to) {
        *out = if to > *out { to } else { *out };
    }
}

//! When a frame is sampled, and in which rows.
//!
//! The time from the first row's opening to the last row's closing is divided into equal cells, each sampled in its middle. A row is the
//! mean of the samples, weighted by how long it is exposed in each cell. There are as many cells as the fastest point moves pixels in
//! that time, so that samples are at most a pixel apart, unless this costs more than [`MAX_COST`] frames: then there are fewer, and what
//! moves fast is smeared further between them.

use std::ops::Range;

/// The most that the samples of a frame cost, in frames. Another one is rendered at the time of the frame.
pub(super) const MAX_COST: f64 = 7.0;

/// The rows beyond those of a sample that are rendered with it: antialiasing and the filters of shadows look at neighbours.
const MARGIN: u32 = 8;

/// Parts of images begin at multiples of the period of the shader's sampling pattern, so that they are shaded like the whole.
const PERIOD: u32 = 16;

/// The motion below which a frame is as sharp as one without exposure, px.
const STILL_PX: f64 = 0.05;

/// The times of a camera, s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Timing {
    /// The exposure of each row.
    pub(crate) exposure_s: f64,
    /// The readout time: how much later the last row is exposed than the first.
    pub(crate) readout_s: f64,
}

impl Timing {
    /// The time from the opening of the first row to the closing of the last.
    pub(super) fn span_s(self) -> f64 {
        self.exposure_s + self.readout_s
    }

    /// When a row of an image opens and closes, s after the frame's time.
    pub(super) fn window(self, row: u32, height: u32) -> [f64; 2] {
        let middle = ((f64::from(row) + 0.5) / f64::from(height) - 0.5) * self.readout_s;
        [middle - self.exposure_s / 2.0, middle + self.exposure_s / 2.0]
    }
}

/// A time at which some rows of a frame are rendered.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Sample {
    /// The middle of the cell, s after the frame's time.
    pub(super) offset_s: f64,
    /// The beginning and the end of what it stands for.
    pub(super) cell: [f64; 2],
    /// The rows that are rendered.
    pub(super) rendered: Range<u32>,
    /// The rows that are exposed, with the part of their exposure that falls into the cell.
    pub(super) weights: Vec<(u32, f32)>,
}

/// Returns the samples of an image of a height in which points move by at most so many pixels during the whole frame; none if nothing
/// moves.
pub(super) fn samples(timing: Timing, height: u32, motion_px: f64) -> Vec<Sample> {
    if height == 0 || motion_px < STILL_PX || timing.span_s() <= 0.0 {
        return Vec::new();
    }
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "clamped to the rows of an image"
    )]
    let mut count = motion_px.ceil().clamp(2.0, f64::from(height).max(2.0)) as usize;
    loop {
        let samples = divided(timing, height, count);
        let rows: f64 = samples.iter().map(|sample| sample.rendered.len() as f64).sum();
        if count <= 2 || rows <= MAX_COST * f64::from(height) {
            return samples;
        }
        count = (count * 9 / 10).max(2);
    }
}

/// Divides the time of a frame into cells.
fn divided(timing: Timing, height: u32, count: usize) -> Vec<Sample> {
    let first_s = -timing.span_s() / 2.0;
    let step_s = timing.span_s() / count as f64;
    let samples = (0..count).filter_map(|index| {
        let cell = [index, index + 1].map(|edge| first_s + edge as f64 * step_s);
        let weights: Vec<(u32, f32)> = (0..height)
            .map(|row| (row, share(timing.window(row, height), cell)))
            .filter(|(_, weight)| *weight > 0.0)
            .collect();
        let (first, last) = (weights.first()?.0, weights.last()?.0);
        let start = first.saturating_sub(MARGIN) / PERIOD * PERIOD;
        Some(Sample {
            offset_s: f64::midpoint(cell[0], cell[1]),
            cell: exposed(cell, timing),
            rendered: start..(last + 1 + MARGIN).min(height),
            weights,
        })
    });
    samples.collect()
}

/// The part of a cell that a sample stands for: a row is not exposed for longer.
fn exposed(cell: [f64; 2], timing: Timing) -> [f64; 2] {
    let half_s = ((cell[1] - cell[0]) / 2.0).min(timing.exposure_s / 2.0);
    let middle_s = f64::midpoint(cell[0], cell[1]);
    [middle_s - half_s, middle_s + half_s]
}

/// The part of a window that lies in a cell; of a moment, whether it does.
fn share([open, close]: [f64; 2], [from, to]: [f64; 2]) -> f32 {
    if close <= open {
        return if (from..to).contains(&open) { 1.0 } else { 0.0 };
    }
    #[expect(clippy::cast_possible_truncation, reason = "images are single precision")]
    let share = ((close.min(to) - open.max(from)).max(0.0) / (close - open)) as f32;
    share
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn cost(samples: &[Sample], height: u32) -> f64 {
        samples
            .iter()
            .map(|sample| sample.rendered.len() as f64)
            .sum::<f64>()
            / f64::from(height)
    }

    #[test]
    fn samples_are_a_pixel_apart_where_that_is_affordable() {
        let global = Timing {
            exposure_s: 0.01,
            readout_s: 0.0,
        };
        assert_eq!(samples(global, 800, 4.2).len(), 5);
        assert_eq!(samples(global, 800, 300.0).len(), 7);
        assert!(samples(global, 800, 0.01).is_empty());
        let rolling = Timing {
            exposure_s: 0.0,
            readout_s: 0.02,
        };
        assert_eq!(samples(rolling, 800, 100.0).len(), 100);
        let none = Timing {
            exposure_s: 0.0,
            readout_s: 0.0,
        };
        assert!(samples(none, 800, 9.0).is_empty());
    }

    proptest! {
        #[test]
        fn rows_are_exposed_as_long_as_they_are_open(
            exposure_s in 0.0..0.05f64,
            readout_s in 0.0..0.1f64,
            height in 1u32..300,
            motion_px in 0.1..500.0f64,
        ) {
            let timing = Timing { exposure_s, readout_s };
            let samples = samples(timing, height, motion_px);
            prop_assert!(cost(&samples, height) <= MAX_COST.max(2.0) + 1e-9);
            let mut open = vec![(0.0f64, 0.0f64); height as usize];
            for sample in &samples {
                for (row, weight) in &sample.weights {
                    prop_assert!(sample.rendered.contains(row));
                    let (all, moment) = &mut open[*row as usize];
                    *all += f64::from(*weight);
                    *moment += f64::from(*weight) * sample.offset_s;
                }
            }
            let step_s = timing.span_s() / samples.len() as f64;
            for (row, (all, moment)) in (0..).zip(open) {
                prop_assert!((all - 1.0).abs() < 1e-4, "row {row}: {all}");
                let [from, to] = timing.window(row, height);
                prop_assert!((moment - (from + to) / 2.0).abs() < step_s);
            }
        }
    }
}

//! One pass of the matcher over a pair.
//!
//! Two scans run on two threads, one downward and one upward. Until they meet in the middle, each stores its sums; then
//! each adds its sums to the stored ones and completes those rows. The result does not depend on the order of
//! execution.

use oaktwin_base::interrupt;
use oaktwin_simd::Level;

use super::census::{Census, CensusInput};
use super::lanes::{Lane, Short};
use super::out::Out;
use super::plan::{PassPlan, Width};
use super::rvc4;
use super::scan::Scan;
use super::scan_input::ScanInput;

/// The buffers of a pass, reused for the next one.
#[derive(Clone, Debug, Default)]
pub(super) struct Workspace {
    census: [Census; 2],
    narrow: Scans<u8, u8, u8>,
    short: Scans<u8, u8, Short>,
    mixed: Scans<u8, u16, u16>,
    wide: Scans<u16, u16, u16>,
    rvc4: rvc4::Memory,
}

#[derive(Clone, Debug)]
struct Scans<P: Lane, H: Lane, S: Lane> {
    down: Scan<P, S>,
    up: Scan<P, S>,
    /// The stored sums of one scan for each pixel, candidates innermost.
    halves: Vec<H>,
}

impl<P: Lane, H: Lane, S: Lane> Default for Scans<P, H, S> {
    fn default() -> Self {
        Self {
            down: Scan::default(),
            up: Scan::default(),
            halves: Vec::new(),
        }
    }
}

/// Matches two images of the same size.
pub(super) fn run(
    level: Level,
    plan: &PassPlan,
    images: [&CensusInput<'_>; 2],
    memory: &mut Workspace,
    Out {
        disparity,
        confidence,
        lost,
    }: Out<'_>,
) {
    let [left, right] = &mut memory.census;
    rayon::join(
        || left.make(level, plan, images[0], false),
        || right.make(level, plan, images[1], true),
    );
    let view = ScanInput {
        level,
        plan,
        census: [left, right],
        width: images[0].width,
    };
    let out = Out {
        disparity: &mut *disparity,
        confidence: &mut *confidence,
        lost,
    };
    match (plan.width, plan.candidates) {
        (Width::Narrow, 64) => memory.narrow.run::<64>(view, out),
        (Width::Narrow, _) => memory.narrow.run::<96>(view, out),
        (Width::Short, 64) => memory.short.run::<64>(view, out),
        (Width::Short, _) => memory.short.run::<96>(view, out),
        (Width::Mixed, 64) => memory.mixed.run::<64>(view, out),
        (Width::Mixed, _) => memory.mixed.run::<96>(view, out),
        (Width::Wide, 64) => memory.wide.run::<64>(view, out),
        (Width::Wide, _) => memory.wide.run::<96>(view, out),
    }
    if let Some(steps) = &plan.rvc4 {
        steps.run(level, left, &mut memory.rvc4, disparity, confidence);
    }
}

impl<P: Lane, H: Lane, S: Lane> Scans<P, H, S> {
    fn run<const D: usize>(&mut self, view: ScanInput<'_>, out: Out<'_>) {
        let Out {
            disparity,
            confidence,
            lost,
        } = out;
        let Self { down, up, halves } = self;
        let width = view.width;
        let (height, length) = (disparity.len() / width, width * D);
        if halves.len() != height * length {
            halves.clear();
            halves.resize(height * length, H::default());
        }
        let middle = height / 2;
        let (above, below) = halves.split_at_mut(middle * length);
        rayon::join(
            || {
                down.begin(view);
                for (y, half) in above.chunks_exact_mut(length).enumerate() {
                    if interrupt::is_unwanted() {
                        return;
                    }
                    down.begin_row::<H, D>(view, y, false, half);
                }
            },
            || {
                up.begin(view);
                for (y, half) in below.chunks_exact_mut(length).enumerate().rev() {
                    if interrupt::is_unwanted() {
                        return;
                    }
                    up.begin_row::<H, D>(view, middle + y, true, half);
                }
            },
        );
        let (disparity_above, disparity_below) = disparity.split_at_mut(middle * width);
        let (confidence_above, confidence_below) = confidence.split_at_mut(middle * width);
        let (lost_above, lost_below) = lost.split_at_mut((middle * width).min(lost.len()));
        let (mut lost_above, mut lost_below) = (
            lost_above.chunks_exact_mut(width),
            lost_below.chunks_exact_mut(width),
        );
        rayon::join(
            || {
                let rows = below
                    .chunks_exact(length)
                    .zip(disparity_below.chunks_exact_mut(width))
                    .zip(confidence_below.chunks_exact_mut(width));
                for (y, ((half, disparity), confidence)) in rows.enumerate() {
                    if interrupt::is_unwanted() {
                        return;
                    }
                    let lost = lost_below.next().unwrap_or_default();
                    let out = Out {
                        disparity,
                        confidence,
                        lost,
                    };
                    down.finish_row::<H, D>(view, middle + y, false, half, out);
                }
            },
            || {
                let rows = above
                    .chunks_exact(length)
                    .zip(disparity_above.chunks_exact_mut(width))
                    .zip(confidence_above.chunks_exact_mut(width));
                for (y, ((half, disparity), confidence)) in rows.enumerate().rev() {
                    if interrupt::is_unwanted() {
                        return;
                    }
                    let lost = lost_above.next_back().unwrap_or_default();
                    let out = Out {
                        disparity,
                        confidence,
                        lost,
                    };
                    up.finish_row::<H, D>(view, y, true, half, out);
                }
            },
        );
    }
}

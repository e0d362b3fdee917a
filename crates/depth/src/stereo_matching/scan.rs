//! A scan over the rows of an image: downward from left to right, or upward from right to left.

use oaktwin_simd::{self as simd, Kernel, Level};

use super::cost::Blocks;
use super::lanes::Lane;
use super::out::Out;
use super::paths::{FROM_ROW, Penalties, ScanRow, Slots, Sums};
use super::plan;
use super::refine::{self, NONE, Refined};
use super::scan_input::ScanInput;
use super::select::{RightKeys, RowWinners, Select};

/// The sums of one scan for a row.
enum Half<'a, H> {
    /// The output for this scan's sums, which the other scan completes.
    Left(&'a mut [H]),
    /// The sums of the other scan.
    Found(&'a [H]),
}

/// The position and the memory of a scan.
#[derive(Clone, Debug)]
pub(super) struct Scan<P: Lane, S: Lane> {
    slots: [Slots<P>; FROM_ROW],
    /// The number of rows processed.
    number: usize,
    blocks: Blocks,
    costs: Vec<P>,
    /// The sums of all paths.
    sums: Vec<S>,
    penalties: [Vec<[P; 2]>; 1 + FROM_ROW],
    found: RowWinners,
    right: RightKeys<S::Key>,
    refined: Refined,
}

impl<P: Lane, S: Lane> Default for Scan<P, S> {
    fn default() -> Self {
        Self {
            slots: Default::default(),
            number: 0,
            blocks: Blocks::default(),
            costs: Vec::new(),
            sums: Vec::new(),
            penalties: Default::default(),
            found: RowWinners::default(),
            right: RightKeys::default(),
            refined: Refined::default(),
        }
    }
}

impl<P: Lane, S: Lane> Scan<P, S> {
    /// Resets the scan to before its first row.
    pub(super) fn begin(&mut self, view: ScanInput<'_>) {
        let candidates = view.plan.candidates;
        self.number = 0;
        for slots in &mut self.slots {
            slots.reset(view.width, candidates);
        }
        self.costs.resize(view.width * candidates, P::default());
        self.sums.resize(view.width * candidates, S::default());
        self.found.resize(view.width);
    }

    /// Writes the path costs of the next row to `half`.
    pub(super) fn begin_row<H: Lane, const D: usize>(
        &mut self,
        view: ScanInput<'_>,
        y: usize,
        is_up: bool,
        half: &mut [H],
    ) {
        self.make_costs(view, y, is_up);
        self.follow::<H, D>(view, is_up, Half::Left(half));
    }

    /// Adds the path costs of the next row to the other scan's, and finds disparity and confidence.
    pub(super) fn finish_row<H: Lane, const D: usize>(
        &mut self,
        view: ScanInput<'_>,
        y: usize,
        is_up: bool,
        half: &[H],
        out: Out<'_>,
    ) {
        self.make_costs(view, y, is_up);
        self.follow::<H, D>(view, is_up, Half::Found(half));
        self.find::<D>(view, out);
    }

    fn make_costs(&mut self, view: ScanInput<'_>, y: usize, is_up: bool) {
        let is_first = self.number == 0;
        self.blocks.row(view, y, [is_first, is_up], &mut self.costs);
        self.set_penalties(view, y, is_up);
    }

    fn follow<H: Lane, const D: usize>(&mut self, view: ScanInput<'_>, is_up: bool, half: Half<'_, H>) {
        match view.plan.paths[usize::from(is_up)] {
            1 => self.follow_paths::<H, D, 1>(view.level, is_up, half),
            2 => self.follow_paths::<H, D, 2>(view.level, is_up, half),
            _ => self.follow_paths::<H, D, 4>(view.level, is_up, half),
        }
        self.number += 1;
    }

    fn follow_paths<H: Lane, const D: usize, const PATHS: usize>(
        &mut self,
        level: Level,
        is_up: bool,
        half: Half<'_, H>,
    ) {
        let penalties = self.penalties.each_ref().map(|pairs| Penalties { pairs });
        let row = ScanRow::<P, H, S, D, PATHS> {
            costs: &self.costs,
            sums: match half {
                Half::Left(half) => Sums::Half(half),
                Half::Found(half) => Sums::Whole(half, &mut self.sums),
            },
            slots: &mut self.slots,
            number: self.number,
            penalties,
            is_mirrored: is_up,
        };
        simd::run_at(level, row);
    }

    /// Sets the penalties of each pixel, in the order of the scan.
    fn set_penalties(&mut self, view: ScanInput<'_>, y: usize, is_up: bool) {
        let table = match &view.plan.penalties {
            plan::Penalties::Fixed([along, from_row]) => {
                let pairs = [along, from_row, from_row, from_row];
                for (own, pair) in self.penalties.iter_mut().zip(pairs) {
                    own.clear();
                    own.push(pair.map(P::of));
                }
                return;
            }
            plan::Penalties::Adaptive(table) => table,
        };
        let before = match (self.number, is_up) {
            (0, _) => y,
            (_, true) => y + 1,
            (_, false) => y - 1,
        };
        let [left, _] = view.census;
        let (own, before) = (left.levels(y), left.levels(before));
        let last = view.width - 1;
        let of = |i: usize| if is_up { last - i } else { i };
        let level = |row: &[u8], i: usize| row.get(of(i.min(last))).copied().unwrap_or_default();
        for (path, pairs) in self.penalties.iter_mut().enumerate() {
            pairs.clear();
            pairs.extend((0..view.width).map(|i| {
                let from = match path {
                    0 => level(own, i.saturating_sub(1)),
                    1 => level(before, i),
                    2 => level(before, i.saturating_sub(1)),
                    _ => level(before, i + 1),
                };
                let difference = usize::from(level(own, i).abs_diff(from));
                table.get(difference).copied().unwrap_or_default().map(P::of)
            }));
        }
    }

    /// Finds the disparities and the confidence of a row from its sums.
    fn find<const D: usize>(&mut self, view: ScanInput<'_>, out: Out<'_>) {
        let plan = view.plan;
        let sums = &mut self.sums;
        if plan.division > 1 {
            let by = f32::from(plan.division);
            simd::run_at(view.level, Divide { sums, by });
        }
        let right = plan.looks_back.then(|| {
            self.right.reset(plan, view.width, S::LAST);
            &mut self.right
        });
        simd::run_at(
            view.level,
            Select::<S, D> {
                plan,
                sums: &self.sums,
                found: &mut self.found,
                right,
            },
        );
        if plan.looks_back {
            let right = &mut self.refined.right;
            right.resize(view.width, NONE);
            self.right.read(plan, view.width, |x, key| {
                let (_, candidate) = S::open(key);
                let found = plan.disparities.get(usize::from(candidate));
                if let Some(right) = right.get_mut(x) {
                    *right = if key == S::LAST {
                        NONE
                    } else {
                        found.copied().unwrap_or(NONE)
                    };
                }
            });
        }
        refine::row(view.level, plan, &self.found, &mut self.refined, out);
    }
}

/// Integer division of 16 bits by 8, for which single precision is exact enough.
struct Divide<'a, S> {
    sums: &'a mut [S],
    by: f32,
}

impl<S: Lane> Kernel for Divide<'_, S> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        for sum in self.sums {
            let quotient = simd::saturating_trunc(f32::from(sum.wide()) / self.by);
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "16 bits")]
            let quotient = quotient as u16;
            *sum = S::of(quotient);
        }
    }
}

//! Winner takes all: the candidate with the smallest sum for each pixel of the left and the right image.

use oaktwin_simd::Kernel;

use super::lanes::Lane;
use super::paths::{chunk, chunk_mut};
use super::plan::{MOST, PassPlan, Zone};

/// The winners of a row.
#[derive(Clone, Debug, Default)]
pub(super) struct RowWinners {
    /// The winning candidate.
    pub(super) best: Vec<u8>,
    /// The sums of the winner and of two candidates on each side; those beyond the range are undefined.
    pub(super) around: [Vec<u16>; 5],
    /// The smallest sum, except for the winner and its neighbours.
    pub(super) second: Vec<u16>,
}

impl RowWinners {
    pub(super) fn resize(&mut self, width: usize) {
        self.best.resize(width, 0);
        self.second.resize(width, 0);
        for around in &mut self.around {
            around.resize(width, 0);
        }
    }
}

/// The keys of a row of the right image, grouped by zone and phase of the zone's step, from right to left.
#[derive(Clone, Debug)]
pub(super) struct RightKeys<K> {
    keys: Vec<K>,
}

impl<K> Default for RightKeys<K> {
    fn default() -> Self {
        Self { keys: Vec::new() }
    }
}

/// The keys of a zone.
#[derive(Clone, Copy, Debug)]
struct ZoneKeys<'a> {
    zone: &'a Zone,
    /// The index of its first key.
    start: usize,
    /// The number of keys in a phase.
    phase: usize,
}

impl ZoneKeys<'_> {
    /// Returns the index of the first key of the pixel `place` places from the end of the right image.
    #[inline(always)]
    fn index(&self, place: usize) -> usize {
        // Steps are powers of two, and division takes long.
        let step = self.zone.step;
        self.start + (place & (step - 1)) * self.phase + (place >> step.trailing_zeros())
    }
}

/// Returns the places of the keys of each zone.
fn layout(zones: &[Zone], width: usize) -> impl Iterator<Item = ZoneKeys<'_>> {
    zones.iter().scan(0, move |first, zone| {
        let phase = (width + zone.first).div_ceil(zone.step) + zone.count;
        let start = *first;
        *first += phase * zone.step;
        Some(ZoneKeys { zone, start, phase })
    })
}

impl<K: Copy + Ord> RightKeys<K> {
    pub(super) fn reset(&mut self, plan: &PassPlan, width: usize, last: K) {
        let room = layout(&plan.zones, width).map(|own| own.start + own.phase * own.zone.step);
        let room = room.last().unwrap_or(0);
        self.keys.clear();
        self.keys.resize(room, last);
    }

    /// Passes the smallest key of each right pixel to `take`, from right to left.
    pub(super) fn read(&self, plan: &PassPlan, width: usize, mut take: impl FnMut(usize, K)) {
        if plan.zones.len() == 1 {
            for (place, &key) in self.keys.iter().take(width).enumerate() {
                take(width - 1 - place, key);
            }
            return;
        }
        let zones: Vec<ZoneKeys<'_>> = layout(&plan.zones, width).collect();
        for place in 0..width {
            let keys = zones
                .iter()
                .filter_map(|own| self.keys.get(own.index(place)).copied());
            if let Some(least) = keys.min() {
                take(width - 1 - place, least);
            }
        }
    }
}

/// A mask of the candidates around index [`MOST`]: the winner and its neighbours.
const BESIDE: [u8; 2 * MOST + 1] = {
    let mut mask = [0; 2 * MOST + 1];
    mask[MOST - 1] = 255;
    mask[MOST] = 255;
    mask[MOST + 1] = 255;
    mask
};

/// Finds the winners of a row.
pub(super) struct Select<'a, S: Lane, const D: usize> {
    pub(super) plan: &'a PassPlan,
    pub(super) sums: &'a [S],
    pub(super) found: &'a mut RowWinners,
    /// The keys of the right image, if its disparities are needed.
    pub(super) right: Option<&'a mut RightKeys<S::Key>>,
}

/// The maximum number of pixels per sweep over a row. Consecutively processed pixels are so far apart that they share
/// no pixel of the right image, so that no key is read right after it was written.
const APART: usize = 8;

impl<S: Lane, const D: usize> Kernel for Select<'_, S, D> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let width = self.sums.len() / D;
        let RowWinners { best, around, second } = self.found;
        if best.len() < width || second.len() < width || around.iter().any(|row| row.len() < width) {
            return;
        }
        let [a, b, c, d, e] = around;
        let mut right = self.right.map(|right| right.keys.as_mut_slice());
        let zones: Vec<ZoneKeys<'_>> = layout(&self.plan.zones, width).collect();
        let stride = width.div_ceil(APART).max(D + 1);
        for start in 0..stride {
            let mut x = start;
            while x < width {
                let Some(sums) = chunk::<S, D>(self.sums, x * D) else {
                    return;
                };
                let mut keys = [S::LAST; D];
                let mut least = S::LAST;
                for k in 0..D {
                    #[expect(clippy::cast_possible_truncation, reason = "at most 96")]
                    let key = sums[k].key(k as u8);
                    keys[k] = key;
                    least = least.min(key);
                }
                let (_, winner) = S::open(least);
                let mut other = S::MAX;
                let winner_at = usize::from(winner);
                let Some(beside) = chunk::<u8, D>(&BESIDE, MOST - winner_at.min(MOST)) else {
                    return;
                };
                for k in 0..D {
                    other = other.min(sums[k].masked(beside[k]));
                }
                let at = |k: usize| sums.get(k).copied().unwrap_or_default().wide();
                best[x] = winner;
                second[x] = other.wide();
                a[x] = at(winner_at.wrapping_sub(2));
                b[x] = at(winner_at.wrapping_sub(1));
                c[x] = at(winner_at);
                d[x] = at(winner_at + 1);
                e[x] = at(winner_at + 2);
                if let Some(right) = &mut right {
                    if self.plan.zones.len() == 1 {
                        let zone_first = self.plan.disparities[0];
                        let place = width - 1 - x + usize::from(zone_first);
                        if let Some(right) = chunk_mut::<S::Key, D>(right, place) {
                            for k in 0..D {
                                right[k] = right[k].min(keys[k]);
                            }
                        }
                    } else {
                        zoned(&zones, width - 1 - x, &keys, right);
                    }
                }
                x += stride;
            }
        }
    }
}

/// Updates the keys of the right image for several zones, at the pixel `place` places from its end.
#[inline(always)]
fn zoned<K: Copy + Ord>(zones: &[ZoneKeys<'_>], place: usize, keys: &[K], right: &mut [K]) {
    for own in zones {
        let (start, first) = (own.zone.start, own.index(place + own.zone.first));
        match own.zone.count {
            48 => update::<K, 48>(keys, start, right, first),
            32 => update::<K, 32>(keys, start, right, first),
            _ => update::<K, 16>(keys, start, right, first),
        }
    }
}

#[inline(always)]
fn update<K: Copy + Ord, const COUNT: usize>(keys: &[K], start: usize, right: &mut [K], first: usize) {
    if let (Some(keys), Some(right)) = (
        chunk::<K, COUNT>(keys, start),
        chunk_mut::<K, COUNT>(right, first),
    ) {
        for k in 0..COUNT {
            right[k] = right[k].min(keys[k]);
        }
    }
}

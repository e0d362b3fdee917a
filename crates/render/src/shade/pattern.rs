//! Where lamps and surroundings are sampled: at the same spots and in the same directions from every point, so that a point has the
//! same light in every image. Neighbouring strata that disagree are sampled more finely.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use oaktwin_camera::math::DVec3;

/// The strata in a row.
const COLUMNS: usize = 4;

/// The number of strata.
pub(super) const STRATA: usize = COLUMNS * COLUMNS;

/// The number of samples of a stratum; the first is taken always.
const OF_STRATUM: usize = 4;

/// The difference from a neighbouring stratum from which on all samples of a stratum are taken.
const DIFFERENT: f32 = 0.5;

/// A spot on a lamp, −1 to 1 across it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Spot {
    /// On a square lamp.
    pub(super) square: [f64; 2],
    /// On a round lamp; the map from the square preserves areas.
    pub(super) disk: [f64; 2],
}

/// The bits of the spots of a lamp that are certainly visible, and of those that may be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Spots {
    pub(super) certain: u64,
    pub(super) possible: u64,
}

impl Spots {
    pub(super) const UNKNOWN: Self = Self {
        certain: 0,
        possible: u64::MAX,
    };

    pub(super) const fn known(bits: u64) -> Self {
        Self {
            certain: bits,
            possible: bits,
        }
    }

    /// Whether a spot is visible, if that is known.
    pub(super) const fn is_seen(self, index: usize) -> Option<bool> {
        match ((self.certain >> index) & 1, (self.possible >> index) & 1) {
            (0, 1) => None,
            (bit, _) => Some(bit == 1),
        }
    }
}

/// The spots and directions, those of a stratum together.
#[derive(Debug)]
pub(super) struct Pattern {
    spots: Vec<Spot>,
    directions: Vec<DVec3>,
}

impl Pattern {
    /// Samples of four strata, one on each side.
    pub(super) const FEW: [usize; 4] = [OF_STRATUM, 7 * OF_STRATUM, 8 * OF_STRATUM, 14 * OF_STRATUM];

    /// The bits of these samples.
    pub(super) const FEW_BITS: u64 =
        1 << Self::FEW[0] | 1 << Self::FEW[1] | 1 << Self::FEW[2] | 1 << Self::FEW[3];

    pub(super) fn new() -> Self {
        let mut spots = Vec::new();
        let mut directions = Vec::new();
        for (column, row) in (0..STRATA).map(|stratum| (stratum % COLUMNS, stratum / COLUMNS)) {
            let mut of_stratum =
                [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[x, y]| spot(2 * column + x, 2 * row + y));
            // The first directions alternate between the quarters of their strata.
            of_stratum.rotate_left((column + 2 * row) % OF_STRATUM);
            directions.extend(of_stratum.map(|spot| above(spot.disk)));
            // The first spots of a lamp are near its rim, so that one that is partly hidden is hidden from one of them.
            let radius = |spot: &Spot| spot.disk[0].hypot(spot.disk[1]);
            of_stratum.sort_by(|a, b| radius(b).total_cmp(&radius(a)));
            spots.extend(of_stratum);
        }
        Self { spots, directions }
    }

    /// Returns the first sample of a stratum; their numbers repeat.
    pub(super) const fn first(stratum: u32) -> usize {
        stratum as usize % STRATA * OF_STRATUM
    }

    /// Returns a spot on a lamp.
    pub(super) fn spot(&self, index: usize) -> Spot {
        self.spots.get(index).copied().unwrap_or_default()
    }

    /// Returns a direction of the hemisphere around `normal`; the density of directions is the cosine of the angle between them.
    pub(super) fn direction(&self, index: usize, around: &Hemisphere) -> DVec3 {
        let local = self.directions.get(index).copied().unwrap_or(DVec3::Z);
        around.u * local.x + around.v * local.y + around.normal * local.z
    }
}

/// A hemisphere around a unit vector.
pub(super) struct Hemisphere {
    u: DVec3,
    v: DVec3,
    normal: DVec3,
}

impl Hemisphere {
    pub(super) fn new(normal: DVec3) -> Self {
        // The pair jumps where z changes its sign, which rounding errors must not decide for upright surfaces.
        let upright = normal.with_z(if normal.z.abs() < 1e-6 { 0.0 } else { normal.z });
        let (u, v) = upright.any_orthonormal_pair();
        Self { u, v, normal }
    }
}

/// Returns the share of the spots that is visible.
#[expect(clippy::cast_precision_loss, reason = "at most 64")]
pub(super) fn share_of(spots: u64) -> f32 {
    spots.count_ones() as f32 * (1.0 / 64.0)
}

/// The strata that differ from one of their neighbours.
fn edges(differs: impl Fn(usize, usize) -> bool) -> impl Fn(usize) -> bool {
    move |stratum| {
        let column = stratum % COLUMNS;
        (column > 0 && differs(stratum, stratum - 1))
            || (column + 1 < COLUMNS && differs(stratum, stratum + 1))
            || (stratum >= COLUMNS && differs(stratum, stratum - COLUMNS))
            || (stratum + COLUMNS < STRATA && differs(stratum, stratum + COLUMNS))
    }
}

/// Returns the bits of all visible spots. `test` returns the visible ones among the spots with the bits that it gets, which are not known. Spots of a stratum after the first are tested only if
/// the first differs from a neighbour's.
pub(super) fn mask(known: Spots, mut test: impl FnMut(u64) -> u64) -> u64 {
    /// The first spot of each stratum.
    const FIRST: u64 = u64::MAX / ((1 << OF_STRATUM) - 1);
    let unknown = known.possible & !known.certain;
    let mut seen = known.certain | test(unknown & FIRST);
    let first = seen & FIRST;
    let of = |stratum: usize| (first >> (stratum * OF_STRATUM)) & 1;
    let is_edge = edges(|a, b| of(a) != of(b));
    let mut wanted = 0;
    for stratum in 0..STRATA {
        let others = (((1 << OF_STRATUM) - 2) << (stratum * OF_STRATUM)) & unknown;
        if is_edge(stratum) {
            wanted |= others;
        } else if of(stratum) == 1 {
            seen |= others;
        }
    }
    seen | test(wanted)
}

/// Returns the mean of all samples, each a pair of values from 0 to 1; those of a stratum after the first are taken only if the first
/// differs from a neighbour's in one of the values.
pub(super) fn mean(part: usize, mut sample: impl FnMut(usize) -> [f32; 2]) -> [f32; 2] {
    let first: [[f32; 2]; STRATA] = std::array::from_fn(|stratum| sample(stratum * OF_STRATUM));
    let is_edge = edges(|a, b| (first[a][part] - first[b][part]).abs() > DIFFERENT);
    let mut sum = [0.0; 2];
    for (stratum, own) in first.into_iter().enumerate() {
        let mut of_stratum = own;
        if is_edge(stratum) {
            for index in 1..OF_STRATUM {
                let more = sample(stratum * OF_STRATUM + index);
                of_stratum = [of_stratum[0] + more[0], of_stratum[1] + more[1]];
            }
            of_stratum = of_stratum.map(|sum| sum * (1.0 / OF_STRATUM as f32));
        }
        sum = [sum[0] + of_stratum[0], sum[1] + of_stratum[1]];
    }
    sum.map(|sum| sum * (1.0 / STRATA as f32))
}

/// The spots of a quarter of the square from which those of a round lamp are mapped, in rows of four squares. They were found by a random
/// search that minimized the difference between the areas of segments of the disk and the shares of spots in them: 3.5 % at most.
const QUARTER: [[f64; 2]; 16] = [
    [0.032, 0.181],
    [0.296, 0.17],
    [0.54, 0.11],
    [0.809, 0.038],
    [0.089, 0.476],
    [0.285, 0.391],
    [0.61, 0.362],
    [0.85, 0.272],
    [0.189, 0.695],
    [0.402, 0.694],
    [0.612, 0.603],
    [0.895, 0.516],
    [0.193, 0.931],
    [0.578, 0.934],
    [0.754, 0.859],
    [0.848, 0.709],
];

/// Returns the spot of a square in a grid of twice as many columns as strata.
#[expect(clippy::cast_precision_loss, reason = "small numbers")]
fn spot(column: usize, row: usize) -> Spot {
    // The other quarters are the first, turned.
    let quarter =
        |column: usize, row: usize| QUARTER.get(row * COLUMNS + column).copied().unwrap_or_default();
    let last = COLUMNS - 1;
    let [a, b] = match (column.checked_sub(COLUMNS), row.checked_sub(COLUMNS)) {
        (Some(right), Some(above)) => quarter(right, above),
        (None, Some(above)) => {
            let [a, b] = quarter(above, last - column);
            [-b, a]
        }
        (None, None) => quarter(last - column, last - row).map(|at| -at),
        (Some(right), None) => {
            let [a, b] = quarter(last - row, right);
            [b, -a]
        }
    };
    // A sheared grid, so that the edge of a shadow passes the spots one after another.
    let count = (2 * COLUMNS) as f64;
    let [x, y] = [column, row].map(|at| at as f64);
    Spot {
        square: [
            (x + (y + 0.5) / count) / count * 2.0 - 1.0,
            (y + 1.0 - (x + 0.5) / count) / count * 2.0 - 1.0,
        ],
        disk: on_disk(a, b),
    }
}

/// Maps the square onto the disk: concentric squares become circles, and areas are preserved (Shirley and Chiu, "A Low Distortion Map
/// Between Disk and Square", 1997).
fn on_disk(a: f64, b: f64) -> [f64; 2] {
    let (radius, turn) = if a.abs() > b.abs() {
        (a, FRAC_PI_4 * b / a)
    } else if b == 0.0 {
        (0.0, 0.0)
    } else {
        (b, FRAC_PI_2 - FRAC_PI_4 * a / b)
    };
    let (sin, cos) = turn.sin_cos();
    [radius * cos, radius * sin]
}

/// Returns the unit vector above a point of the unit disk.
fn above([x, y]: [f64; 2]) -> DVec3 {
    DVec3::new(x, y, (1.0 - x * x - y * y).max(0.0).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The area of the unit disk on one side of a line at a distance from its centre, as a share.
    fn segment(distance: f64) -> f64 {
        let distance = distance.clamp(-1.0, 1.0);
        (distance.acos() - distance * (1.0 - distance * distance).sqrt()) / std::f64::consts::PI
    }

    #[test]
    fn a_straight_edge_hides_its_share_of_a_lamp() {
        let pattern = Pattern::new();
        for turn in 0..36 {
            let (sin, cos) = (f64::from(turn) * 0.175).sin_cos();
            let mut last = 1.1f32;
            for step in -25..=25 {
                let edge = f64::from(step) * 0.045;
                let [on_disk, on_square] = [true, false].map(|is_round| {
                    let is_seen = |index: usize| {
                        let spot = pattern.spot(index);
                        let [x, y] = if is_round { spot.disk } else { spot.square };
                        x * cos + y * sin > edge
                    };
                    let seen = mask(Spots::UNKNOWN, |wanted| {
                        let seen = (0..64).filter(|index| (wanted >> index) & 1 == 1 && is_seen(*index));
                        seen.fold(0, |bits, index| bits | 1 << index)
                    });
                    share_of(seen)
                });
                assert!(
                    (f64::from(on_disk) - segment(edge)).abs() < 0.035,
                    "{turn} {edge}: {on_disk} {}",
                    segment(edge)
                );
                assert!(on_disk <= last, "{turn} {edge}");
                last = on_disk;
                if turn == 0 {
                    let share = (0.5 - edge / 2.0).clamp(0.0, 1.0);
                    assert!((f64::from(on_square) - share).abs() < 0.02, "{edge}: {on_square}");
                }
            }
        }
    }

    #[test]
    fn directions_cover_the_hemisphere_by_the_cosine() {
        let pattern = Pattern::new();
        let normal = DVec3::new(0.48, -0.6, 0.64);
        let around = Hemisphere::new(normal);
        let count = STRATA * OF_STRATUM;
        for step in [1, OF_STRATUM] {
            let directions: Vec<DVec3> = (0..count)
                .step_by(step)
                .map(|index| pattern.direction(index, &around))
                .collect();
            assert!(
                directions
                    .iter()
                    .all(|d| (d.length() - 1.0).abs() < 1e-9 && d.dot(normal) > 0.0)
            );
            let sum = directions.iter().sum::<DVec3>() / directions.len() as f64;
            // The cosine-weighted mean of the cosine is 2/3.
            assert!((sum.dot(normal) - 2.0 / 3.0).abs() < 0.03, "{sum}");
            assert!((sum - normal * sum.dot(normal)).length() < 0.03, "{sum}");
        }
    }
}

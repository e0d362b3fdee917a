//! The deterministic sampling pattern of lamps and surroundings. The 16 places of a tile sample different parts of a lamp, so
//! that their mean samples all of it; each of 16 tiles samples other directions, so that their mean resolves even a small
//! window.

use std::f64::consts::TAU;

use oaktwin_camera::math::DVec3;

/// The number of places in a row of a tile, and of tiles in a row of the pattern.
pub(super) const PERIOD: u32 = 4;

/// The order of an ordered dither, in which neighbours differ most.
const ORDER: [u8; 16] = [0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5];

/// The number of rays that each place casts into its surroundings.
pub(super) const DIRECTIONS_PER_PLACE: usize = 1;

/// The number of directions of a tile.
const OF_TILE: usize = 16 * DIRECTIONS_PER_PLACE;

/// The number of directions of all tiles.
const DIRECTIONS: usize = 16 * OF_TILE;

/// The index of a place in its tile and of the tile in the pattern, each from 0 to 15.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct PatternCell {
    pub(super) of_place: usize,
    pub(super) of_tile: usize,
}

/// The directions of all cells.
#[derive(Debug)]
pub(super) struct Pattern {
    directions: Vec<DVec3>,
}

impl Pattern {
    pub(super) fn new() -> Self {
        #[expect(clippy::cast_precision_loss, reason = "a small count")]
        let direction = |i: usize| {
            let (tile, ring) = (i / OF_TILE, i % OF_TILE);
            // Equal areas of the disk below the hemisphere, for cosine weighting: a ring for each direction of a tile, in it a
            // thinner ring for each tile; the golden angle between directions, with steps in between for the tiles.
            let part = (ring as f64 + (tile as f64 + 0.5) / 16.0) / OF_TILE as f64;
            let turns = ring as f64 * 0.618_033_988_75 + (tile * 7 % 16) as f64 / 16.0;
            let (sin, cos) = (turns * TAU).sin_cos();
            let radius = part.sqrt();
            DVec3::new(radius * cos, radius * sin, (1.0 - part).sqrt())
        };
        Self {
            directions: (0..DIRECTIONS).map(direction).collect(),
        }
    }

    /// Returns the cell of a place.
    pub(super) fn cell(x: u32, y: u32) -> PatternCell {
        let in_square = |x: u32, y: u32| {
            let at = (y % PERIOD) * PERIOD + x % PERIOD;
            ORDER.get(at as usize).copied().map_or(0, usize::from)
        };
        PatternCell {
            of_place: in_square(x, y),
            of_tile: in_square(x / PERIOD, y / PERIOD),
        }
    }

    /// Returns the spot of a cell on a lamp, −1 to 1. The first four cells cover all rows and columns, so that a partly hidden
    /// lamp is hidden from at least one of them.
    pub(super) fn place(cell: usize) -> [f64; 2] {
        const FIRST: [usize; 4] = [1, 3, 0, 2];
        const LATER: [usize; 4] = [0, 2, 3, 1];
        let row = cell % 4;
        #[expect(clippy::cast_precision_loss, reason = "a small count")]
        [FIRST[row] ^ LATER[cell / 4 % 4], row].map(|i| (i as f64 + 0.5) / 2.0 - 1.0)
    }

    /// Returns the directions of a cell in the hemisphere around `normal`.
    pub(super) fn directions(&self, cell: PatternCell, normal: DVec3) -> [DVec3; DIRECTIONS_PER_PLACE] {
        // The pair jumps where z changes its sign, which rounding errors must not decide for upright surfaces.
        let upright = normal.with_z(if normal.z.abs() < 1e-6 { 0.0 } else { normal.z });
        let (u, v) = upright.any_orthonormal_pair();
        std::array::from_fn(|i| {
            // Only places on the black fields of a chessboard sample their surroundings; they have the first eight cells.
            let at = cell.of_tile * OF_TILE + cell.of_place * 2 % 16 + cell.of_place / 8 + i * 16;
            let local = self.directions.get(at).copied().unwrap_or(DVec3::Z);
            u * local.x + v * local.y + normal * local.z
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cells_cover_lamps_and_the_hemisphere() {
        let turns: std::collections::BTreeSet<_> = (0..16)
            .flat_map(|y| (0..16).map(move |x| Pattern::cell(x + 32, y + 16)))
            .collect();
        assert_eq!(turns.len(), 256);
        let places: Vec<_> = (0..16).map(Pattern::place).collect();
        let sum = places
            .iter()
            .fold([0.0; 2], |sum, p| [sum[0] + p[0], sum[1] + p[1]]);
        assert_eq!(sum, [0.0; 2]);
        let normal = DVec3::new(0.48, -0.6, 0.64);
        let pattern = Pattern::new();
        let of_tile = |of_tile| {
            (0..16)
                .flat_map(|of_place| pattern.directions(PatternCell { of_place, of_tile }, normal))
                .collect::<Vec<_>>()
        };
        let mut all = Vec::new();
        for tile in 0..16 {
            let directions = of_tile(tile);
            assert!(
                directions
                    .iter()
                    .all(|d| (d.length() - 1.0).abs() < 1e-9 && d.dot(normal) > 0.0)
            );
            // The cosine-weighted mean of the cosine is 2/3.
            let mean = directions.iter().map(|d| d.dot(normal)).sum::<f64>() / directions.len() as f64;
            assert!((mean - 2.0 / 3.0).abs() < 0.04, "{mean}");
            let drift = directions.iter().fold(DVec3::ZERO, |sum, d| sum + *d) / directions.len() as f64
                - normal * mean;
            assert!(drift.length() < 0.12, "{drift}");
            all.extend(directions);
        }
        // All directions are distinct.
        for (i, a) in all.iter().enumerate() {
            assert!(all[..i].iter().all(|b| (*a - *b).length() > 1e-3));
        }
    }
}

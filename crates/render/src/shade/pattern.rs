//! Which part of a lamp or of the sky a place of the image looks at: of 16 neighbours each looks at another one, and
//! their mean at all of them. Nothing is random.

use std::f64::consts::TAU;

use oaktwin_camera::math::DVec3;

/// Neighbours that share the work: a square of 4 × 4.
pub(super) const PERIOD: u32 = 4;

/// The order in which an ordered dither fills a square, so that near ones differ most.
const ORDER: [u8; 16] = [0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5];

/// How often each place looks into its surroundings.
pub(super) const LOOKS: usize = 2;

/// Directions for all neighbours together.
const DIRECTIONS: usize = 16 * LOOKS;

/// What each of the 16 looks at.
#[derive(Debug)]
pub(super) struct Pattern {
    directions: [DVec3; DIRECTIONS],
}

impl Pattern {
    pub(super) fn new() -> Self {
        #[expect(clippy::cast_precision_loss, reason = "a few")]
        let direction = |i: usize| {
            // Equal parts of the disk under the hemisphere: as a diffuse surface sees it.
            let radius = ((i as f64 + 0.5) / DIRECTIONS as f64).sqrt();
            let (sin, cos) = (i as f64 * TAU * 0.618_033_988_75).sin_cos();
            DVec3::new(radius * cos, radius * sin, (1.0 - radius * radius).sqrt())
        };
        Self {
            directions: std::array::from_fn(direction),
        }
    }

    /// Which of the 16 a place is.
    pub(super) fn turn(x: u32, y: u32) -> usize {
        let at = (y % PERIOD) * PERIOD + x % PERIOD;
        ORDER.get(at as usize).copied().map_or(0, usize::from)
    }

    /// Its place on a lamp, −1 to 1.
    pub(super) fn place(turn: usize) -> [f64; 2] {
        #[expect(clippy::cast_precision_loss, reason = "a few")]
        [turn % 4, turn / 4].map(|i| (i as f64 + 0.5) / 2.0 - 1.0)
    }

    /// Its directions into the hemisphere around `normal`.
    pub(super) fn looks(&self, turn: usize, normal: DVec3) -> [DVec3; LOOKS] {
        let (u, v) = normal.any_orthonormal_pair();
        std::array::from_fn(|i| {
            let local = self.directions[(turn + i * 16) % DIRECTIONS];
            u * local.x + v * local.y + normal * local.z
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn together_they_see_all() {
        let turns: std::collections::BTreeSet<usize> = (0..4)
            .flat_map(|y| (0..4).map(move |x| Pattern::turn(x + 8, y + 4)))
            .collect();
        assert_eq!(turns.len(), 16);
        let places: Vec<_> = (0..16).map(Pattern::place).collect();
        let sum = places
            .iter()
            .fold([0.0; 2], |sum, p| [sum[0] + p[0], sum[1] + p[1]]);
        assert_eq!(sum, [0.0; 2]);
        let normal = DVec3::new(0.48, -0.6, 0.64);
        let pattern = Pattern::new();
        let looks: Vec<_> = (0..16).flat_map(|turn| pattern.looks(turn, normal)).collect();
        assert!(
            looks
                .iter()
                .all(|d| (d.length() - 1.0).abs() < 1e-9 && d.dot(normal) > 0.0)
        );
        // The mean of the cosine by cosine is 2/3.
        let mean = looks.iter().map(|d| d.dot(normal)).sum::<f64>() / 32.0;
        assert!((mean - 2.0 / 3.0).abs() < 0.01, "{mean}");
        let drift = looks.iter().fold(DVec3::ZERO, |sum, d| sum + *d) / 32.0 - normal * mean;
        assert!(drift.length() < 0.06, "{drift}");
    }
}

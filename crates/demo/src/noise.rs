//! Smooth noise for textures, the same on every computer.

pub(super) use oaktwin_image::noise::white;

/// Smooth noise of 0 to 1 with a lattice of 1, which repeats after `period` in both directions.
pub(super) fn smooth(x: f32, y: f32, period: [i32; 2], kind: u32) -> f32 {
    let (left, top) = (x.floor(), y.floor());
    let ease = |t: f32| t * t * (3.0 - 2.0 * t);
    let (tx, ty) = (ease(x - left), ease(y - top));
    #[expect(clippy::cast_possible_truncation, reason = "a texture's lattice is small")]
    let (left, top) = (left as i32, top as i32);
    let at = |i: i32, j: i32| {
        let [columns, rows] = period;
        white((left + i).rem_euclid(columns), (top + j).rem_euclid(rows), kind)
    };
    let upper = at(0, 0) + (at(1, 0) - at(0, 0)) * tx;
    let lower = at(0, 1) + (at(1, 1) - at(0, 1)) * tx;
    upper + (lower - upper) * ty
}

/// Smooth noise of 0 to 1 at four scales, each half of the one before; `x` and `y` are in units of the coarsest
/// lattice.
pub(super) fn rough(x: f32, y: f32, period: [i32; 2], kind: u32) -> f32 {
    let (mut sum, mut scale, mut strength, mut period) = (0.0, 1.0, 0.5, period);
    for octave in 0..4 {
        sum += strength * smooth(x * scale, y * scale, period, kind.wrapping_add(octave));
        scale *= 2.0;
        strength *= 0.5;
        period = period.map(|p| p * 2);
    }
    sum / 0.9375
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn noise_repeats_and_stays_in_bounds() {
        let mut sum = 0.0;
        for i in 0..1000i16 {
            let (x, y) = (f32::from(i) * 0.037, f32::from(i % 37) * 0.11);
            let value = rough(x, y, [8, 4], 5);
            assert!((0.0..=1.0).contains(&value));
            assert!((value - rough(x + 8.0, y - 4.0, [8, 4], 5)).abs() < 1e-3);
            sum += value;
        }
        assert!((sum / 1000.0 - 0.5).abs() < 0.1);
        assert_eq!(white(3, -4, 1), white(3, -4, 1));
        assert_ne!(white(3, -4, 1), white(3, -4, 2));
    }
}

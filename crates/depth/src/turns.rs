//! Angles in turns: sine and arctangent as polynomials, from operations that every processor rounds alike.

/// 1.5·2²³: the sum with a number smaller than 2²² is rounded to the nearest integer, halves to even.
const ROUNDER: f32 = 12_582_912.0;

/// Returns sin(2π x) for |x| up to 2²¹, with an error below 3e-7.
///
/// The odd polynomial of a quarter turn with the smallest maximum error (3.3e-9 in exact arithmetic), by Lawson's iteration.
#[inline(always)]
pub(crate) fn sin_of_turns(x: f32) -> f32 {
    let fraction = fraction(x);
    let quarter = 0.25 - (fraction.abs() - 0.25).abs();
    let v = quarter.copysign(fraction);
    let w = v * v;
    let series = ((39.536_705 * w - 76.549_78) * w + 81.601_006) * w - 41.341_656;
    v * (series * w + std::f32::consts::TAU)
}

/// Returns the difference to the nearest integer, for |x| up to 2²¹.
#[inline(always)]
pub(crate) fn fraction(x: f32) -> f32 {
    x - ((x + ROUNDER) - ROUNDER)
}

/// Returns the angle of a vector in turns in [0, 1), with an error below 1.3e-7; 0 for the zero vector.
///
/// The odd polynomial of an eighth of a turn with the smallest maximum error (3.9e-8 in exact arithmetic), by Lawson's
/// iteration.
#[inline(always)]
pub(crate) fn angle_in_turns(x: f32, y: f32) -> f32 {
    let (along, across) = (x.abs(), y.abs());
    let steep = across > along;
    let (large, small) = if steep { (across, along) } else { (along, across) };
    // Avoids a division by 0: the smallest normal number vanishes beside any other.
    let ratio = small / (large + f32::MIN_POSITIVE);
    let w = ratio * ratio;
    let series = ((((0.001_084_129_2 * w - 0.005_348_273_6) * w + 0.012_672_496) * w - 0.021_061_515) * w
        + 0.031_525_116)
        * w
        - 0.053_026_237;
    let eighth = ratio * (series * w + 0.159_154_33);
    let quarter = if steep { 0.25 - eighth } else { eighth };
    let half = if x < 0.0 { 0.5 - quarter } else { quarter };
    let turns = if y < 0.0 { 1.0 - half } else { half };
    // Angles that round to a full turn become 0.
    if turns < 1.0 { turns } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sine_is_close_to_the_exact_value() {
        let mut largest = 0f64;
        for i in -400_000..=400_000 {
            let x = i as f32 / 4096.0;
            let exact = (f64::from(x) * std::f64::consts::TAU).sin();
            largest = largest.max((f64::from(sin_of_turns(x)) - exact).abs());
        }
        assert!(largest < 3e-7, "{largest}");
        assert_eq!(sin_of_turns(0.0), 0.0);
        assert!((sin_of_turns(0.25) - 1.0).abs() < 3e-7);
        assert!((sin_of_turns(-0.25) + 1.0).abs() < 3e-7);
    }

    #[test]
    fn angle_is_close_to_the_exact_value() {
        let mut largest = 0f64;
        for i in 0..400_000u32 {
            let exact = (f64::from(i) + 0.5) / 400_000.0;
            let length = f64::from(1 + i % 977) * 1e-3;
            let (sine, cosine) = (exact * std::f64::consts::TAU).sin_cos();
            #[expect(
                clippy::cast_possible_truncation,
                reason = "single precision is what it takes"
            )]
            let (x, y) = ((length * cosine) as f32, (length * sine) as f32);
            let found = f64::from(angle_in_turns(x, y));
            assert!((0.0..1.0).contains(&found));
            let off = (found - exact).abs();
            largest = largest.max(off.min(1.0 - off));
        }
        assert!(largest < 1.3e-7, "{largest:e}");
        let axes = [
            (0.0, 0.0, 0.0),
            (2.0, 0.0, 0.0),
            (0.0, 3.0, 0.25),
            (-1.0, 0.0, 0.5),
            (0.0, -1.0, 0.75),
        ];
        for (x, y, turns) in axes {
            assert_eq!(angle_in_turns(x, y), turns);
        }
        assert_eq!(angle_in_turns(1.0, -1e-12), 0.0);
    }
}

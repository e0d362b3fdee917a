//! Depth in whole millimetres, the numbers of `DepthAI`'s depth frames and ROS's `16UC1` images.

use crate::Image;

/// 2²³: from here on to twice as much, `float32` has just the whole numbers, in its lowest bits. Adding it rounds.
const ONE_A_STEP: f32 = 8_388_608.0;

/// Whole millimetres; 0 where there is no value.
///
/// * `metres · 1000` in `float32`, rounded to the nearest, halves to even, as OpenCV's `convertTo` does for ROS.
/// * 0 for infinity, NaN, and whatever is not positive: what `DepthAI` and ROS take for "nothing measured".
/// * 0 beyond 65.535 m too. Saturating there, as plain conversions do, would put a wall 65.5 m away that nobody can
///   tell from a measured one.
///
/// A depth under half a millimetre also becomes 0.
#[must_use]
pub fn from_metres(metres: &Image<f32>) -> Image<u16> {
    metres.map(|&metres| {
        let millimetres = metres * 1000.0;
        // False for a NaN. Without branches and casts from float, so that it is vectorised.
        let fits = (millimetres > 0.0) & (millimetres < 65535.5);
        let kept = if fits { millimetres } else { 0.0 };
        #[expect(clippy::cast_possible_truncation, reason = "the number is in the low 16 bits")]
        let whole = (kept + ONE_A_STEP).to_bits() as u16;
        whole
    })
}

/// Metres; 0 where there is no value.
#[must_use]
pub fn to_metres(millimetres: &Image<u16>) -> Image<f32> {
    millimetres.map(|&millimetres| f32::from(millimetres) / 1000.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn rounding_and_what_has_no_value() {
        let cases = [
            (0.0, 0),
            (-1.0, 0),
            (f32::INFINITY, 0),
            (f32::NEG_INFINITY, 0),
            (f32::NAN, 0),
            (0.000_49, 0),
            (0.000_51, 1),
            (1.0, 1000),
            (1.234_49, 1234),
            (1.234_51, 1235),
            (0.002_5, 2),
            (0.003_5, 4),
            (65.535, 65535),
            (65.536, 0),
            (1e30, 0),
        ];
        let image = Image::new(15, 1, cases.iter().map(|case| case.0).collect()).unwrap();
        let expected: Vec<u16> = cases.iter().map(|case| case.1).collect();
        assert_eq!(from_metres(&image).pixels(), expected);
    }

    proptest! {
        #[test]
        fn every_millimetre_comes_back(millimetres: u16) {
            let image = Image::filled(1, 1, millimetres);
            prop_assert_eq!(from_metres(&to_metres(&image)), image);
        }
    }
}

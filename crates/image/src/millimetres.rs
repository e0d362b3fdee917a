//! Depth in integer millimetres, as in `DepthAI`'s depth frames and ROS's `16UC1` images.

use crate::Image;

/// 2²³. From here to 2²⁴, `float32` has exactly the integers, in its lowest bits, so that adding it rounds.
const INTEGER_STEP: f32 = 8_388_608.0;

/// Converts metres to integer millimetres; 0 means no value.
///
/// * The value is `metres · 1000` in `float32`, rounded to nearest, ties to even, like OpenCV's `convertTo` for ROS.
/// * Infinity, NaN and values that are not positive become 0, "no measurement" in `DepthAI` and ROS.
/// * Values beyond 65.535 m become 0 too. Saturation would create a wall at 65.5 m that looks like a measurement.
///
/// A depth below half a millimetre also becomes 0.
#[must_use]
pub fn from_metres(metres: &Image<f32>) -> Image<u16> {
    metres.map(|&metres| {
        let millimetres = metres * 1000.0;
        // False for NaN. There are no branches and no casts from float, so that the loop is vectorised.
        let fits = (millimetres > 0.0) & (millimetres < 65535.5);
        let kept = if fits { millimetres } else { 0.0 };
        #[expect(clippy::cast_possible_truncation, reason = "the number is in the low 16 bits")]
        let whole = (kept + INTEGER_STEP).to_bits() as u16;
        whole
    })
}

/// Converts millimetres to metres; 0 means no value.
#[must_use]
pub fn to_metres(millimetres: &Image<u16>) -> Image<f32> {
    millimetres.map(|&millimetres| f32::from(millimetres) / 1000.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn rounds_and_drops_invalid_values() {
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
        fn all_values_round_trip(millimetres: u16) {
            let image = Image::filled(1, 1, millimetres);
            prop_assert_eq!(from_metres(&to_metres(&image)), image);
        }
    }
}

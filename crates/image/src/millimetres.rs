//! Depth in whole millimetres, the numbers of `DepthAI`'s depth frames and ROS's `16UC1` images.

use crate::Image;

/// Whole millimetres; 0 where there is no value.
///
/// * Rounded to the nearest, halves up, as ROS's `depth_image_proc` does (`metres · 1000 + 0.5`, cut off).
/// * 0 for infinity, NaN, and whatever is not positive: what `DepthAI` and ROS take for "nothing measured".
/// * 0 beyond 65.535 m too. Saturating there, as plain conversions do, would put a wall 65.5 m away that nobody can
///   tell from a measured one.
///
/// A depth under half a millimetre also becomes 0.
#[must_use]
pub fn from_metres(metres: &Image<f32>) -> Image<u16> {
    metres.map(|&metres| {
        let millimetres = metres * 1000.0 + 0.5;
        // False for a NaN. Written without branches, so that it is vectorised.
        let fits = (millimetres > 0.0) & (millimetres < 65536.0);
        let kept = if fits { millimetres } else { 0.0 };
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "0 to 65535.996"
        )]
        let whole = kept as i32 as u16;
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
            (65.535, 65535),
            (65.536, 0),
            (1e30, 0),
        ];
        let image = Image::new(13, 1, cases.iter().map(|case| case.0).collect()).unwrap();
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

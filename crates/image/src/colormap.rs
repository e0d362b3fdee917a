//! Colour maps: turbo for quantities, distinct colours for ids.

use std::sync::LazyLock;

/// Returns Anton Mikhailov's turbo colour map from 0 to 1 in 256 steps, sRGB.
///
/// It is computed from Ruofei Du's polynomial fit of degree 5 (Google, "Turbo, an improved rainbow colormap for visualization",
/// 2019), which differs slightly from the original, most at the dark blue end.
#[must_use]
pub fn turbo() -> &'static [[u8; 3]; 256] {
    &TURBO
}

/// The coefficients for red, green and blue, in ascending powers.
const POLYNOMIALS: [[f64; 6]; 3] = [
    [
        0.135_721_38,
        4.615_392_60,
        -42.660_322_58,
        132.131_082_34,
        -152.942_393_96,
        59.286_379_43,
    ],
    [
        0.091_402_61,
        2.194_188_39,
        4.842_966_58,
        -14.185_033_33,
        4.277_298_57,
        2.829_566_04,
    ],
    [
        0.106_673_30,
        12.641_946_08,
        -60.582_048_36,
        110.362_767_71,
        -89.903_109_12,
        27.348_249_73,
    ],
];

static TURBO: LazyLock<[[u8; 3]; 256]> = LazyLock::new(|| {
    std::array::from_fn(|i| {
        let x = i as f64 / 255.0;
        POLYNOMIALS.map(|coefficients| {
            let value = coefficients.iter().rev().fold(0.0, |sum, c| sum * x + c);
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 255")]
            let byte = (value.clamp(0.0, 1.0) * 255.0).round() as u8;
            byte
        })
    })
});

/// The number of hues of full value and 90 % saturation: all colours with a maximum channel of 255 and a minimum of 25.
const HUES: u32 = 6 * 230;

/// A prime near `HUES` divided by the golden ratio: all hues occur before one repeats, and successive hues differ much.
const HUE_STEP: u32 = 853;

/// The number of colours without 255 in any channel, except black.
const OTHERS: u32 = 255 * 255 * 255 - 1;

/// A number near `OTHERS` divided by the golden ratio, and coprime to it.
const OTHER_STEP: u32 = 10_247_853;

/// Returns a fixed colour for each index from 0, opaque and never black.
///
/// The first 1380 colours are vivid hues, which differ much for successive indices. The first 16 million are all different, so
/// that colours can be mapped back to indices.
#[must_use]
pub fn distinct(index: u32) -> [u8; 4] {
    #[expect(clippy::cast_possible_truncation, reason = "each is below 256")]
    let bytes = |channels: [u32; 3]| {
        let [r, g, b] = channels.map(|channel| channel as u8);
        [r, g, b, 255]
    };
    if index < HUES {
        let place = index * HUE_STEP % HUES;
        let (up, down) = (25 + place % 230, 255 - place % 230);
        return bytes(match place / 230 {
            0 => [255, up, 25],
            1 => [down, 255, 25],
            2 => [25, 255, up],
            3 => [25, down, 255],
            4 => [up, 25, 255],
            _ => [255, 25, down],
        });
    }
    let place = u64::from(index - HUES) * u64::from(OTHER_STEP) % u64::from(OTHERS);
    let place = u32::try_from(place).unwrap_or(0) + 1;
    bytes([place / (255 * 255), place / 255 % 255, place % 255])
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn turbo_is_near_the_published_table() {
        let turbo = turbo();
        // The published table's ends and middle are (48, 18, 59), (164, 252, 60), (122, 4, 3).
        for (i, published) in [(0, [48, 18, 59]), (128, [164, 252, 60]), (255, [122, 4, 3])] {
            let off = turbo[i].iter().zip(published).map(|(a, b)| a.abs_diff(b)).max();
            assert!(off <= Some(35), "{i}: {:?}", turbo[i]);
        }
    }

    #[test]
    fn colours_are_unique() {
        let colours: HashSet<[u8; 4]> = (0..200_000).map(distinct).collect();
        assert_eq!(colours.len(), 200_000);
        assert!(
            colours
                .iter()
                .all(|&[r, g, b, a]| (r, g, b) != (0, 0, 0) && a == 255)
        );
        assert_eq!(distinct(0), [255, 25, 25, 255]);
    }

    #[test]
    fn steps_are_coprime_to_their_ranges() {
        let gcd = |mut a: u32, mut b: u32| {
            while b > 0 {
                (a, b) = (b, a % b);
            }
            a
        };
        assert_eq!(gcd(HUES, HUE_STEP), 1);
        assert_eq!(gcd(OTHERS, OTHER_STEP), 1);
    }

    #[test]
    fn successive_colours_differ() {
        for i in 0..100 {
            let (a, b) = (distinct(i), distinct(i + 1));
            let apart: u32 = a.iter().zip(b).map(|(a, b)| u32::from(a.abs_diff(b))).sum();
            assert!(apart > 150, "{a:?} {b:?}");
        }
    }
}

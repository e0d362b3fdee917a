//! Extended disparity: merges the disparities of half-size and full-size images.

use oaktwin_image::Image;

use super::census::CensusInput;

/// Halves an image; each pixel is the mean of four, halves up. An odd last row or column is dropped.
pub(super) fn halve(image: &CensusInput<'_>) -> (usize, usize, Vec<i16>) {
    let (width, height) = (image.width / 2, image.height / 2);
    let mut out = Vec::with_capacity(width * height);
    let mut rows = image.levels.chunks_exact(image.width);
    while let (Some(first), Some(second)) = (rows.next(), rows.next()) {
        for (a, b) in first.chunks_exact(2).zip(second.chunks_exact(2)) {
            out.push((a.iter().sum::<i16>() + b.iter().sum::<i16>() + 2) >> 2);
        }
    }
    (width, height, out)
}

/// Merges the disparities of half-size images. Doubled, those beyond `beyond` steps, the range of the full-size images,
/// replace less confident and invalid ones; all others are less accurate than disparities of the full-size images and are
/// ignored. `shift` is the disparity shift in steps.
pub(super) fn merge(
    half: (&Image<u16>, &Image<u8>),
    shift: u32,
    beyond: u32,
    disparity: &mut Image<u16>,
    confidence: &mut Image<u8>,
) {
    let (half_width, half_height) = (half.0.width() as usize, half.0.height() as usize);
    let width = disparity.width() as usize;
    if half_width == 0 || half_height == 0 {
        return;
    }
    let rows = disparity
        .pixels_mut()
        .chunks_exact_mut(width)
        .zip(confidence.pixels_mut().chunks_exact_mut(width));
    for (y, (disparity, confidence)) in rows.enumerate() {
        let start = (y / 2).min(half_height - 1) * half_width;
        for (x, (own, own_confidence)) in disparity.iter_mut().zip(confidence).enumerate() {
            let at = start + (x / 2).min(half_width - 1);
            let (Some(&found), Some(&sure)) = (half.0.pixels().get(at), half.1.pixels().get(at)) else {
                return;
            };
            let doubled = 2 * u32::from(found) + shift;
            if found > 0 && doubled > beyond && (*own == 0 || sure > *own_confidence) {
                *own = u16::try_from(doubled).unwrap_or(u16::MAX);
                *own_confidence = sure;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Merges one half-size pixel with a full-size one.
    fn merged(half: [u16; 2], full: [u16; 2]) -> [u16; 2] {
        let one = |[disparity, confidence]: [u16; 2]| {
            let confidence = u8::try_from(confidence).unwrap();
            (Image::filled(1, 1, disparity), Image::filled(1, 1, confidence))
        };
        let (half, (mut disparity, mut confidence)) = (one(half), one(full));
        merge((&half.0, &half.1), 0, 95, &mut disparity, &mut confidence);
        [disparity.pixels()[0], confidence.pixels()[0].into()]
    }

    #[test]
    fn only_disparities_beyond_the_range_are_used_and_only_if_they_are_more_confident() {
        assert_eq!(merged([60, 90], [40, 80]), [120, 90]);
        assert_eq!(merged([60, 80], [40, 80]), [40, 80]);
        assert_eq!(merged([60, 10], [0, 80]), [120, 10]);
        assert_eq!(merged([47, 90], [40, 80]), [40, 80]);
        assert_eq!(merged([47, 90], [0, 80]), [0, 80]);
        assert_eq!(merged([0, 90], [0, 80]), [0, 80]);
    }
}

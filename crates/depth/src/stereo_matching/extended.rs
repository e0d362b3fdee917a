//! Extended disparity: merges the disparities of half-size images with those of full-size images.

use oaktwin_image::Image;

use super::census::Source;

/// Halves an image; each pixel is the mean of four, halves up. An odd last row or column is dropped.
pub(super) fn halve(image: &Source<'_>) -> (usize, usize, Vec<i16>) {
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

/// Merges the disparities of half-size images: they replace those of the full-size images beyond `beyond` steps and
/// where these are invalid. Disparities are doubled; `shift` is the disparity shift in steps.
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
            if found == 0 {
                continue;
            }
            let doubled = 2 * u32::from(found) + shift;
            if *own == 0 || doubled > beyond {
                *own = u16::try_from(doubled).unwrap_or(u16::MAX);
                *own_confidence = sure;
            }
        }
    }
}

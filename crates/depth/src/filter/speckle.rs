use super::Pixel;
use oaktwin_image::Image;

/// `SpeckleFilter`: drops small patches of pixels that are alike.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Speckle {
    /// `speckleRange`: a patch of up to so many pixels is dropped.
    pub speckle_range: u32,
    /// `differenceThreshold`: the largest step between two neighbours of a patch, in pixel values.
    pub difference_threshold: u32,
}

impl Default for Speckle {
    fn default() -> Self {
        Self {
            speckle_range: 50,
            difference_threshold: 2,
        }
    }
}

impl Speckle {
    pub(super) fn run<P: Pixel>(&self, image: &mut Image<P>) {
        let (width, zero) = (image.width() as usize, P::default());
        let pixels = image.pixels_mut();
        let mut seen = vec![false; pixels.len()];
        let mut patch = Vec::new();
        for start in 0..pixels.len() {
            if seen[start] || pixels[start] == zero {
                continue;
            }
            seen[start] = true;
            patch.clear();
            patch.push(start);
            let mut next = 0;
            while let Some(&at) = patch.get(next) {
                next += 1;
                let column = at % width;
                let neighbours = [
                    (column > 0).then(|| at - 1),
                    (column + 1 < width).then_some(at + 1),
                    at.checked_sub(width),
                    Some(at + width).filter(|&below| below < pixels.len()),
                ];
                for other in neighbours.into_iter().flatten() {
                    let step = pixels[other].for_speckles().abs_diff(pixels[at].for_speckles());
                    if !seen[other] && pixels[other] != zero && step <= self.difference_threshold {
                        seen[other] = true;
                        patch.push(other);
                    }
                }
            }
            if patch.len() as u64 <= u64::from(self.speckle_range) {
                for &at in &patch {
                    pixels[at] = zero;
                }
            }
        }
    }
}

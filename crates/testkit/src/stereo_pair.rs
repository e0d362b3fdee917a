//! Stereo pairs for benchmarks.

use oaktwin_camera::ImageSize;
use oaktwin_image::Image;

use crate::random::Random;

/// Returns a rectified pair of a slanted wall with boxes in front of it, with a texture of 2 px.
///
/// # Errors
/// An error if the size is zero or too large for an image.
pub fn textured_pair(size: ImageSize) -> Result<[Image<u8>; 2], String> {
    let mut random = Random::new(1);
    let (width, height) = (size.width as usize, size.height as usize);
    let wide = 2 * width;
    let fine: Vec<f64> = (0..wide * (height + 1))
        .map(|_| random.range(0.0, 255.0))
        .collect();
    let level = |x: f64, y: usize| {
        let (from, part) = (x.floor().max(0.0), x - x.floor());
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a column")]
        let column = (from as usize).min(wide - 2);
        let row = |y: usize| fine[y * wide + column] * (1.0 - part) + fine[y * wide + column + 1] * part;
        0.5 * (row(y) + row(y + 1))
    };
    let mut images = [Vec::new(), Vec::new()];
    for y in 0..height {
        for x in 0..width {
            #[expect(clippy::cast_precision_loss, reason = "pixels")]
            let (u, v) = (x as f64, y as f64);
            let mut seen = [(6.0 + 0.01 * v, 0.0); 2];
            for k in 0..7 {
                let k = f64::from(k);
                let (left, top, d) = (120.0 + 160.0 * k, 60.0 + 70.0 * k, 12.3 + 9.7 * k);
                for (image, moved) in seen.iter_mut().zip([0.0, d]) {
                    if u + moved >= left && u + moved < left + 130.0 && v >= top && v < top + 260.0 {
                        *image = (d, 500.0);
                    }
                }
            }
            let [(_, left), (d, right)] = seen;
            for (image, at) in images.iter_mut().zip([u + left, u + d + right]) {
                let noise = random.range(-2.0, 2.0);
                #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "8 bits")]
                image.push((level(at, y) + noise).clamp(0.0, 255.0) as u8);
            }
        }
    }
    let [left, right] = images.map(|pixels| Image::new(size.width, size.height, pixels));
    left.zip(right)
        .map(|(left, right)| [left, right])
        .ok_or_else(|| format!("no image has {} × {} pixels", size.width, size.height))
}

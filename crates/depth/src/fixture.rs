//! What the tests of several engines look at.

use oaktwin_image::Image;

use crate::DepthShot;
use crate::random::Stream;

/// The noise of a camera.
pub(crate) fn random() -> Stream {
    Stream::new(7, "camera")
}

/// A shot of `depth`, number `frame`.
pub(crate) fn shot(depth: &Image<f32>, frame: u64) -> DepthShot<'_> {
    let mut shot = DepthShot::new(depth.into());
    shot.frame = frame;
    shot
}

/// A room with things in it, the nearest `nearest` m away, slopes and holes: what a depth image of any size may hold. Here and
/// there are the `odd` values, 96 at most.
#[expect(clippy::cast_possible_truncation, reason = "small numbers of tests")]
pub(crate) fn room(width: u32, height: u32, nearest: f64, odd: &[f32]) -> Image<f32> {
    let mut pixels = Vec::new();
    for y in 0..height {
        for x in 0..width {
            let (u, v) = (f64::from(x) / f64::from(width), f64::from(y) / f64::from(height));
            let mut z = 4.0 + u;
            if v > 0.6 {
                z = z.min(0.9 / (v - 0.5));
            }
            for k in 0..12 {
                let k = f64::from(k);
                let (at, up) = ((k * 0.37 + 0.1).fract(), (k * 0.61 + 0.2).fract());
                if (u - at).abs() < 0.03 + 0.01 * (k % 5.0) && (v - up).abs() < 0.08 {
                    z = z.min(nearest + 0.3 * k);
                }
            }
            let odd = odd.get(((x + 3 * y) % 97) as usize);
            pixels.push(odd.copied().unwrap_or(z as f32));
        }
    }
    Image::new(width, height, pixels).unwrap()
}

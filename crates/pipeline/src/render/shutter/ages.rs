//! What a time-of-flight camera sees at each of its two frequencies, which it measures one after the other.

use oaktwin_camera::{Camera, PixelPoint, Usd};
use oaktwin_image::{Image, ZDepth};
use oaktwin_render::Backend;

use super::motion::Moments;
use crate::render::{PlacedCamera, RigError};

/// The depth of a camera at a time before the frame's, with that time, s.
pub(in crate::render) type Earlier = [(f64, ZDepth); 2];

/// Renders the depth of a camera at two times before the frame's, s.
pub(in crate::render) fn earlier(
    moments: &mut dyn Moments,
    index: usize,
    camera: &PlacedCamera,
    ages_s: [f64; 2],
    backend: Backend,
) -> Result<Earlier, RigError> {
    let mut at = |age_s: f64| {
        let (renderer, mount) = moments.at(-age_s, index)?;
        Ok::<_, RigError>((age_s, renderer.depth(&camera.view(&mount), backend)))
    };
    Ok([at(ages_s[0])?, at(ages_s[1])?])
}

/// Returns the mean radial velocity of what each pixel sees since earlier times, m/s; 0 where a time has no surface.
pub(in crate::render) fn velocities(camera: &Camera, depth: &ZDepth, earlier: &Earlier) -> [Image<f32>; 2] {
    earlier.each_ref().map(|(age_s, then)| {
        let mut velocities = Image::filled(depth.0.width(), depth.0.height(), 0.0);
        let width = depth.0.width().max(1);
        let both = depth.0.pixels().iter().zip(then.0.pixels());
        for ((index, velocity), (now, then)) in (0..).zip(velocities.pixels_mut()).zip(both) {
            let way = f64::from(*now) - f64::from(*then);
            let pixel =
                PixelPoint::<Usd>::new(f64::from(index % width) + 0.5, f64::from(index / width) + 0.5);
            if *age_s <= 0.0 || !way.is_finite() || way == 0.0 {
                continue;
            }
            if let Some(ray) = camera.unproject(pixel).filter(|ray| ray.z > 0.0) {
                #[expect(clippy::cast_possible_truncation, reason = "images are float32")]
                let mean = (way * ray.length() / ray.z / age_s) as f32;
                *velocity = mean;
            }
        }
        velocities
    })
}

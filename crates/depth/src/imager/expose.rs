//! Automatic exposure.

use oaktwin_camera::Intrinsics;
use oaktwin_image::ImageView;

use super::rows::Falloff;
use super::{Exposure, Imager};

/// The number of samples of an image along a row and along a column.
const GRID: u32 = 96;

impl Imager {
    /// The common exposure of images from cameras with these intrinsics: the fixed one, or the one at which the mean of their
    /// clamped values is the target. If the scene is too dark, it is the maximum exposure.
    #[must_use]
    pub fn expose(&self, images: &[(ImageView<'_, f32>, &Intrinsics)]) -> Exposure {
        let p = &self.parameters;
        let most = p.max_exposure_time * p.max_gain;
        let total = if p.auto_exposure {
            let samples: Vec<f64> = images
                .iter()
                .flat_map(|(image, intrinsics)| self.samples(*image, intrinsics))
                .collect();
            settle(&samples, p.exposure_target, most)
        } else {
            p.exposure
        };
        let time = total.min(p.max_exposure_time);
        Exposure {
            time,
            gain: total / time,
        }
    }

    fn samples(&self, image: ImageView<'_, f32>, intrinsics: &Intrinsics) -> Vec<f64> {
        let (rows, columns) = (grid(image.height()), grid(image.width()));
        let falloff = Falloff::new(intrinsics, self.parameters.vignetting);
        let mut found = Vec::with_capacity(rows.len() * columns.len());
        for y in rows {
            let start = y as usize * image.width() as usize;
            for &x in &columns {
                if let Some(&light) = image.pixels().get(start + x as usize) {
                    let light = if light > 0.0 { f64::from(light) } else { 0.0 };
                    found.push(light * f64::from(falloff.at(x, y)));
                }
            }
        }
        found
    }
}

/// Returns evenly spaced positions.
fn grid(count: u32) -> Vec<u32> {
    let samples = count.min(GRID);
    let place = |i: u32| u64::from(2 * i + 1) * u64::from(count) / u64::from(2 * samples);
    (0..samples)
        .map(|i| u32::try_from(place(i)).unwrap_or(0))
        .collect()
}

/// Finds the exposure at which the mean of the recorded values is the target, by bisection.
fn settle(samples: &[f64], target: f64, most: f64) -> f64 {
    #[expect(clippy::cast_precision_loss, reason = "a few thousand")]
    let wanted = target * samples.len() as f64;
    let sum = |exposure: f64| -> f64 { samples.iter().map(|light| (light * exposure).min(1.0)).sum() };
    if sum(most) <= wanted {
        return most;
    }
    let (mut low, mut high) = (0.0, most);
    for _ in 0..48 {
        let middle = f64::midpoint(low, high);
        if sum(middle) < wanted {
            low = middle;
        } else {
            high = middle;
        }
    }
    high
}

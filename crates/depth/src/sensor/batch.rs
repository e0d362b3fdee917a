use oaktwin_image::ImageView;
use rayon::prelude::*;

use super::{Engine, Sensor};
use crate::single_view::Wanted;
use crate::{BatchError, Shot};

impl Sensor {
    /// What it reports of a batch of images of one frame, as the environments of a simulator make them: `[count, height,
    /// width]` as `depth` and the pictures are, items numbered from `first_item`. Metres in and out, one image after the
    /// other; `out` has [`Chain::size`](crate::filter::Chain::size) rows and columns an image. Images have no past:
    /// filters that remember begin anew in each.
    ///
    /// # Errors
    /// `depth`, the pictures or `out` have another length than the shape says, or the engine matches pairs, which are not
    /// here; nothing is written then.
    pub fn sense_batch(
        &self,
        depth: &[f32],
        rgb: Option<&[[u8; 4]]>,
        shape: [usize; 3],
        frame: u64,
        first_item: u32,
        out: &mut [f32],
    ) -> Result<(), BatchError> {
        if rgb.is_none() && self.filters.is_empty() {
            return match &self.engine {
                Engine::SingleView(engine) => {
                    engine.sense_batch(depth, shape, frame, first_item, &self.random, out)
                }
                Engine::StereoNoise(engine) => {
                    engine.sense_batch(depth, shape, frame, first_item, &self.random, out)
                }
                Engine::TimeOfFlight(engine) => {
                    engine.sense_batch(depth, shape, frame, first_item, &self.random, out)
                }
                Engine::StereoMatching(_) => Err(no_pairs(shape)),
            };
        }
        if matches!(self.engine, Engine::StereoMatching(_)) {
            return Err(no_pairs(shape));
        }
        let [count, height, width] = shape;
        let fits = |what, shape: [usize; 3], length| {
            let pixels = shape.iter().try_fold(1usize, |all, side| all.checked_mul(*side));
            if pixels == Some(length) {
                Ok(())
            } else {
                Err(BatchError { what, shape, length })
            }
        };
        fits("depth", shape, depth.len())?;
        if let Some(rgb) = rgb {
            fits("picture", shape, rgb.len())?;
        }
        // An image with pixels is not longer than its array.
        let size = u32::try_from(width).ok().zip(u32::try_from(height).ok());
        let Some((columns, rows)) = size.filter(|_| !depth.is_empty()) else {
            return fits("result", [0; 3], out.len());
        };
        let (out_columns, out_rows) = self.filters.size(columns, rows);
        let out_shape = [count, out_rows as usize, out_columns as usize];
        fits("result", out_shape, out.len())?;
        let (pixels, out_pixels) = (height * width, (out_shape[1] * out_shape[2]).max(1));
        let fresh = {
            let mut fresh = self.clone();
            fresh.reset();
            fresh
        };
        depth
            .par_chunks_exact(pixels)
            .zip(out.par_chunks_exact_mut(out_pixels))
            .enumerate()
            .for_each_init(
                || fresh.clone(),
                |sensor, (i, (depth, out))| {
                    sensor.reset();
                    let Some(view) = ImageView::new(columns, rows, depth) else {
                        return;
                    };
                    let mut shot = Shot::new(view);
                    #[expect(clippy::cast_possible_truncation, reason = "items are numbered modulo 2³²")]
                    let number = i as u32;
                    (shot.frame, shot.item) = (frame, first_item.wrapping_add(number));
                    let picture = rgb.and_then(|rgb| rgb.get(i * pixels..(i + 1) * pixels));
                    let picture = picture.and_then(|rgb| ImageView::new(columns, rows, rgb));
                    // Of one size, as the batch is.
                    let shot = match picture {
                        Some(picture) => shot.with_rgb(picture).unwrap_or(shot),
                        None => shot,
                    };
                    let distance = sensor.capture(&shot, Wanted::default()).distance;
                    if distance.0.pixels().len() == out.len() {
                        out.copy_from_slice(distance.0.pixels());
                    }
                },
            );
        Ok(())
    }
}

/// A batch has no pairs to match.
fn no_pairs(shape: [usize; 3]) -> BatchError {
    BatchError {
        what: "stereo pairs",
        shape,
        length: 0,
    }
}

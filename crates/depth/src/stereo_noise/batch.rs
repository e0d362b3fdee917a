use oaktwin_image::ImageView;
use rayon::prelude::*;

use super::StereoNoise;
use super::sense::{Job, Scratch};
use crate::Shot;
use crate::random::Stream;

/// A batch whose images do not fit its shape.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "a batch of {count} images of {width}x{height} pixels has {expected} pixels, the {what} has {found}; give as many"
)]
pub struct BatchError {
    /// Which of both.
    pub what: &'static str,
    /// Images.
    pub count: u32,
    /// Rows of each.
    pub height: u32,
    /// Columns of each.
    pub width: u32,
    /// Pixels of all.
    pub expected: u64,
    /// Pixels that were given.
    pub found: u64,
}

impl StereoNoise {
    /// [`StereoNoise::sense`] of many images of one frame, as the environments of a simulator make them: image after
    /// image, row after row, metres in and out. Image i is item i of its frame ([`Shot::item`]).
    ///
    /// `shape` is (images, rows, columns). Each thread works on one image at a time.
    ///
    /// # Errors
    /// As many pixels as the shape has are not there, or not room for them. `out` is left as it was.
    pub fn sense_batch(
        &self,
        depth: &[f32],
        shape: (u32, u32, u32),
        frame: u64,
        random: &Stream,
        out: &mut [f32],
    ) -> Result<(), BatchError> {
        let (count, height, width) = shape;
        let expected = u128::from(count) * u128::from(height) * u128::from(width);
        for (what, found) in [("depth", depth.len()), ("output", out.len())] {
            if found as u128 != expected {
                return Err(BatchError {
                    what,
                    count,
                    height,
                    width,
                    expected: u64::try_from(expected).unwrap_or(u64::MAX),
                    found: found as u64,
                });
            }
        }
        let pixels = (width as usize * height as usize).max(1);
        let images = depth
            .par_chunks_exact(pixels)
            .zip(out.par_chunks_exact_mut(pixels));
        (0..count).into_par_iter().zip(images).for_each_init(
            Scratch::default,
            |scratch, (item, (depth, out))| {
                let Some(view) = ImageView::new(width, height, depth) else {
                    return;
                };
                let mut shot = Shot::new(view);
                (shot.frame, shot.item) = (frame, item);
                let job = Job::new(self, &shot, random);
                job.rows(scratch, 0, out, |fixed, out| self.table.look_up(fixed, out));
            },
        );
        Ok(())
    }
}

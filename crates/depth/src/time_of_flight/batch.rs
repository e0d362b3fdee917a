use oaktwin_image::ImageView;
use rayon::prelude::*;

use super::TimeOfFlight;
use super::sense::{Job, Scratch};
use crate::random::Stream;
use crate::{BatchError, Shot};

impl TimeOfFlight {
    /// What it reports of a batch of images of one frame, `[count, height, width]` as `depth` and `out` are: those of
    /// [`TimeOfFlight::sense`] of shots without pictures, items numbered from `first_item`. Metres in and out.
    ///
    /// # Errors
    /// `depth` or `out` has another length than the shape says.
    pub fn sense_batch(
        &self,
        depth: &[f32],
        shape: [usize; 3],
        frame: u64,
        first_item: u32,
        random: &Stream,
        out: &mut [f32],
    ) -> Result<(), BatchError> {
        let [count, height, width] = shape;
        let pixels = height.checked_mul(width);
        let all = pixels.and_then(|pixels| pixels.checked_mul(count));
        for (what, length) in [("depth", depth.len()), ("result", out.len())] {
            if all != Some(length) {
                return Err(BatchError { what, shape, length });
            }
        }
        let pixels = pixels.unwrap_or(0).max(1);
        let job = |item: usize, depth| {
            let view = ImageView::new(u32::try_from(width).ok()?, u32::try_from(height).ok()?, depth)?;
            let mut shot = Shot::new(view);
            #[expect(clippy::cast_possible_truncation, reason = "items are numbered modulo 2³²")]
            let number = item as u32;
            (shot.frame, shot.item) = (frame, first_item.wrapping_add(number));
            Some(Job::new(self, &shot, random))
        };
        if count < rayon::current_num_threads() {
            // Threads share each image.
            let images = depth.chunks_exact(pixels).zip(out.chunks_exact_mut(pixels));
            for (item, (depth, out)) in images.enumerate() {
                if let Some(job) = job(item, depth) {
                    job.distance(out);
                }
            }
        } else {
            let images = depth
                .par_chunks_exact(pixels)
                .zip(out.par_chunks_exact_mut(pixels));
            images
                .enumerate()
                .for_each_init(Scratch::default, |scratch, (item, (depth, out))| {
                    if let Some(job) = job(item, depth) {
                        let mut rows = out.chunks_exact_mut(width.max(1));
                        job.rows(scratch, 0, height, |row| {
                            row.metres(rows.next().unwrap_or_default());
                        });
                    }
                });
        }
        Ok(())
    }
}

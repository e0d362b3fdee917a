use super::TimeOfFlight;
use super::sense::{Job, Scratch};
use crate::BatchError;
use crate::batch::Batch;
use crate::random::Stream;

impl TimeOfFlight {
    /// Measures a batch `[count, height, width]` of depth images of one frame as [`TimeOfFlight::sense`] does without colour
    /// images; items count from `first_item`. Metres in and out.
    ///
    /// # Errors
    /// Returns an error if the length of `depth` or `out` does not match the shape.
    pub fn sense_batch(
        &self,
        depth: &[f32],
        shape: [usize; 3],
        frame: u64,
        first_item: u32,
        random: &Stream,
        out: &mut [f32],
    ) -> Result<(), BatchError> {
        let [_, height, width] = shape;
        Batch::new(depth, shape, frame, first_item)?.sense(
            out,
            |shot, out| Job::new(self, shot, random).distance(out),
            |scratch: &mut Scratch, shot, out| {
                let mut rows = out.chunks_exact_mut(width.max(1));
                Job::new(self, shot, random).rows(scratch, 0, height, |row| {
                    row.metres(rows.next().unwrap_or_default());
                });
            },
        )
    }
}

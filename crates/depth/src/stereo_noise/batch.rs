use super::StereoNoise;
use super::sense::{Job, Scratch};
use crate::BatchError;
use crate::batch::Batch;
use crate::random::Stream;

impl StereoNoise {
    /// Measures a batch `[count, height, width]` of depth images of one frame as [`StereoNoise::sense`] does without colour
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
        let finish = |fixed: &[u16], out: &mut [f32]| self.table.look_up(fixed, out);
        Batch::new(depth, shape, frame, first_item)?.sense(
            out,
            |shot, out| Job::new(self, shot, random).image(out, finish),
            |scratch: &mut Scratch, shot, out| Job::new(self, shot, random).rows(scratch, 0, out, finish),
        )
    }
}

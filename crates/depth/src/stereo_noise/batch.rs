use super::StereoNoise;
use super::sense::{Job, Scratch};
use crate::BatchError;
use crate::batch::Batch;
use crate::random::Stream;

impl StereoNoise {
    /// What it reports of a batch of images of one frame, `[count, height, width]` as `depth` and `out` are: those of
    /// [`StereoNoise::sense`] of shots without pictures, items numbered from `first_item`. Metres in and out.
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
        let finish = |fixed: &[u16], out: &mut [f32]| self.table.look_up(fixed, out);
        Batch::new(depth, shape, frame, first_item)?.sense(
            out,
            |shot, out| Job::new(self, shot, random).image(out, finish),
            |scratch: &mut Scratch, shot, out| Job::new(self, shot, random).rows(scratch, 0, out, finish),
        )
    }
}

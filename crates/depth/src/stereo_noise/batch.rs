use super::StereoNoise;
use super::sense::{Job, Scratch};
use crate::batch::Batch;
use crate::random::Stream;
use crate::{BatchEngine, BatchError};

impl BatchEngine for StereoNoise {
    fn sense_batch(
        &self,
        depth: &[f32],
        shape: [usize; 3],
        frame: u64,
        first_item: u32,
        random: &Stream,
        out: &mut [f32],
    ) -> Result<(), BatchError> {
        let finish = |fixed: &[u16], _: &[u8], out: &mut [f32]| self.table.look_up(fixed, out);
        Batch::new(depth, shape, frame, first_item)?.sense(
            out,
            |shot, out| Job::new(self, shot, random).image(out, finish),
            |scratch: &mut Scratch, shot, out| Job::new(self, shot, random).rows(scratch, 0, out, finish),
        )
    }
}

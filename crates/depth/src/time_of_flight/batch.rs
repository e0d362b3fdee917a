use super::TimeOfFlight;
use super::sense::{Job, Scratch};
use crate::batch::Batch;
use crate::random::Stream;
use crate::{BatchEngine, BatchError};

impl BatchEngine for TimeOfFlight {
    fn sense_batch(
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

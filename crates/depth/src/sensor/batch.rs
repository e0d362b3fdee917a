use rayon::prelude::*;

use super::{Engine, Sensor};
use crate::BatchError;
use crate::batch::{Batch, check_length};
use crate::single_view::Wanted;

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
        let batch = Batch::new(depth, shape, frame, first_item)?.with_rgb(rgb)?;
        let Some([columns, rows]) = batch.size() else {
            return check_length("result", [0; 3], out.len());
        };
        let (out_columns, out_rows) = self.filters.size(columns, rows);
        let out_shape = [shape[0], out_rows as usize, out_columns as usize];
        check_length("result", out_shape, out.len())?;
        let out_pixels = (out_shape[1] * out_shape[2]).max(1);
        let fresh = {
            let mut fresh = self.clone();
            fresh.reset();
            fresh
        };
        out.par_chunks_exact_mut(out_pixels).enumerate().for_each_init(
            || fresh.clone(),
            |sensor, (index, out)| {
                sensor.reset();
                let Some(shot) = batch.shot(index) else { return };
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

use rayon::prelude::*;

use super::Sensor;
use crate::batch::{Batch, check_length};
use crate::{BatchError, EngineInput};

impl Sensor {
    /// Whether the engine writes batches without colour images directly into their place.
    #[must_use]
    pub fn measures_batches(&self) -> bool {
        self.filters.is_empty() && self.drifted.is_none() && self.engine.batches().is_some()
    }

    /// Measures a batch `[count, height, width]` of depth images of one frame, for instance a simulator's environments,
    /// with or without their colour images; items count from `first_item`. Metres in and out, one image after the other;
    /// each image in `out` has the rows and columns of [`Chain::size`](crate::filter::Chain::size). Images of a batch
    /// have no past: filters that remember are reset before each.
    ///
    /// # Errors
    /// Returns an error, and writes nothing, if the length of `depth`, `rgb` or `out` does not match the shape, or if the
    /// engine requires stereo pairs.
    pub fn sense_batch(
        &self,
        depth: &[f32],
        rgb: Option<&[[u8; 4]]>,
        shape: [usize; 3],
        frame: u64,
        first_item: u32,
        out: &mut [f32],
    ) -> Result<(), BatchError> {
        if self.engine.kind().input == EngineInput::Pair {
            return Err(BatchError {
                what: "stereo pairs",
                shape,
                length: 0,
            });
        }
        let fast = self.engine.batches().filter(|_| self.measures_batches());
        if let Some(engine) = fast.filter(|_| rgb.is_none()) {
            return engine.sense_batch(depth, shape, frame, first_item, &self.random, out);
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
                let Ok(capture) = sensor.capture(shot, &[]) else {
                    return;
                };
                let distance = capture.distance;
                if distance.0.pixels().len() == out.len() {
                    out.copy_from_slice(distance.0.pixels());
                }
            },
        );
        Ok(())
    }
}

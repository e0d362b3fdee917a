use std::io::Write;

use oaktwin_dataset::{LayerData, Shot, WriteError, Writer};
use oaktwin_files::OutputFiles;
use oaktwin_image::npy;

/// Writes the distances, or the aligned ones, to a stream as one NPY array.
pub(super) struct StreamWriter<'a> {
    pub(super) stream: &'a mut (dyn Write + Send),
    pub(super) has_begun: bool,
}

impl Writer for StreamWriter<'_> {
    fn write(&mut self, shot: &Shot, _output: &mut OutputFiles) -> Result<(), WriteError> {
        let aligned = shot.layers.iter().find_map(|layer| match &layer.data {
            LayerData::Depth(metres) => Some(metres),
            _ => None,
        });
        let distance = shot.frame.depth_sensor_distance.as_ref().map(|z| &z.0);
        let Some(metres) = aligned.or(distance) else {
            return Ok(());
        };
        let mut header = Vec::new();
        if !std::mem::replace(&mut self.has_begun, true) {
            let shape = [metres.height() as usize, metres.width() as usize];
            let shape: Vec<usize> = shot.input.batch.into_iter().chain(shape).collect();
            header = npy::begin::<f32>(&shape);
        }
        self.stream
            .write_all(&header)
            .and_then(|()| npy::write(metres.pixels(), self.stream))
            .and_then(|()| self.stream.flush())
            .map_err(|error| WriteError::Other(Box::new(error)))
    }
}

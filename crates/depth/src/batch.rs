use oaktwin_image::ImageView;
use rayon::prelude::*;

use crate::{BatchError, Shot};

/// Images of one frame, one after the other in one array, as the environments of a simulator make them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Batch<'a> {
    depth: &'a [f32],
    rgb: Option<&'a [[u8; 4]]>,
    shape: [usize; 3],
    frame: u64,
    first_item: u32,
}

/// Whether an array has as many numbers as its shape says.
pub(crate) fn check_length(what: &'static str, shape: [usize; 3], length: usize) -> Result<(), BatchError> {
    let [count, height, width] = shape;
    let pixels = height.checked_mul(width);
    if pixels.and_then(|pixels| pixels.checked_mul(count)) == Some(length) {
        return Ok(());
    }
    Err(BatchError { what, shape, length })
}

impl<'a> Batch<'a> {
    /// Of exact depth, `[count, height, width]`, items numbered from `first_item`.
    pub(crate) fn new(
        depth: &'a [f32],
        shape: [usize; 3],
        frame: u64,
        first_item: u32,
    ) -> Result<Self, BatchError> {
        check_length("depth", shape, depth.len())?;
        Ok(Self {
            depth,
            rgb: None,
            shape,
            frame,
            first_item,
        })
    }

    /// With their pictures, of the same shape.
    pub(crate) fn with_rgb(self, rgb: Option<&'a [[u8; 4]]>) -> Result<Self, BatchError> {
        if let Some(rgb) = rgb {
            check_length("picture", self.shape, rgb.len())?;
        }
        Ok(Self { rgb, ..self })
    }

    /// Images, rows, columns.
    pub(crate) fn shape(&self) -> [usize; 3] {
        self.shape
    }

    /// Columns and rows of each; none where there are no pixels.
    pub(crate) fn size(&self) -> Option<[u32; 2]> {
        let [_, height, width] = self.shape;
        // An image with pixels is not longer than its array.
        let size = u32::try_from(width).ok().zip(u32::try_from(height).ok());
        size.filter(|_| !self.depth.is_empty()).map(Into::into)
    }

    /// Pixels of each.
    pub(crate) fn pixels(&self) -> usize {
        self.shape[1] * self.shape[2]
    }

    /// One of them.
    pub(crate) fn shot(&self, index: usize) -> Option<Shot<'a>> {
        let [columns, rows] = self.size()?;
        let place = index * self.pixels()..(index + 1) * self.pixels();
        let mut shot = Shot::new(ImageView::new(columns, rows, self.depth.get(place.clone())?)?);
        #[expect(clippy::cast_possible_truncation, reason = "items are numbered modulo 2³²")]
        let number = index as u32;
        (shot.frame, shot.item) = (self.frame, self.first_item.wrapping_add(number));
        match self.rgb {
            Some(rgb) => shot
                .with_rgb(ImageView::new(columns, rows, rgb.get(place)?)?)
                .ok(),
            None => Some(shot),
        }
    }

    /// Makes of each image one as large: by `on_all_threads` one after the other where there are fewer images than
    /// threads, else each by `on_one_thread` in the memory of its thread.
    pub(crate) fn sense<S: Default>(
        &self,
        out: &mut [f32],
        on_all_threads: impl Fn(&Shot<'a>, &mut [f32]),
        on_one_thread: impl Fn(&mut S, &Shot<'a>, &mut [f32]) + Sync,
    ) -> Result<(), BatchError> {
        check_length("result", self.shape, out.len())?;
        let pixels = self.pixels().max(1);
        if self.shape[0] < rayon::current_num_threads() {
            for (index, out) in out.chunks_exact_mut(pixels).enumerate() {
                if let Some(shot) = self.shot(index) {
                    on_all_threads(&shot, out);
                }
            }
        } else {
            let images = out.par_chunks_exact_mut(pixels).enumerate();
            images.for_each_init(S::default, |scratch, (index, out)| {
                if let Some(shot) = self.shot(index) {
                    on_one_thread(scratch, &shot, out);
                }
            });
        }
        Ok(())
    }
}

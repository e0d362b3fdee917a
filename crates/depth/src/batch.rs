use oaktwin_image::ImageView;
use rayon::prelude::*;

use crate::{BatchError, DepthShot};

/// Images of one frame in one array, for instance of a simulator's environments.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Batch<'a> {
    depth: &'a [f32],
    rgb: Option<&'a [[u8; 4]]>,
    shape: [usize; 3],
    frame: u64,
    first_item: u32,
}

/// Checks that the length of an array matches its shape.
pub(crate) fn check_length(what: &'static str, shape: [usize; 3], length: usize) -> Result<(), BatchError> {
    let [count, height, width] = shape;
    let pixels = height.checked_mul(width);
    if pixels.and_then(|pixels| pixels.checked_mul(count)) == Some(length) {
        return Ok(());
    }
    Err(BatchError { what, shape, length })
}

impl<'a> Batch<'a> {
    /// Creates a batch of exact depth, `[count, height, width]`; items count from `first_item`.
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

    /// Adds colour images of the same shape.
    pub(crate) fn with_rgb(self, rgb: Option<&'a [[u8; 4]]>) -> Result<Self, BatchError> {
        if let Some(rgb) = rgb {
            check_length("picture", self.shape, rgb.len())?;
        }
        Ok(Self { rgb, ..self })
    }

    /// The number of images, rows and columns.
    pub(crate) fn shape(&self) -> [usize; 3] {
        self.shape
    }

    /// The columns and rows of each image; `None` without pixels.
    pub(crate) fn size(&self) -> Option<[u32; 2]> {
        let [_, height, width] = self.shape;
        let size = u32::try_from(width).ok().zip(u32::try_from(height).ok());
        size.filter(|_| !self.depth.is_empty()).map(Into::into)
    }

    /// The pixels of each image.
    pub(crate) fn pixels(&self) -> usize {
        self.shape[1] * self.shape[2]
    }

    /// Returns one of the images.
    pub(crate) fn shot(&self, index: usize) -> Option<DepthShot<'a>> {
        let [columns, rows] = self.size()?;
        let place = index * self.pixels()..(index + 1) * self.pixels();
        let mut shot = DepthShot::new(ImageView::new(columns, rows, self.depth.get(place.clone())?)?);
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

    /// Processes each image into one of the same size: one after the other with `on_all_threads` if there are fewer images
    /// than threads, else each with `on_one_thread` in the memory of its thread.
    pub(crate) fn sense<S: Default>(
        &self,
        out: &mut [f32],
        on_all_threads: impl Fn(&DepthShot<'a>, &mut [f32]),
        on_one_thread: impl Fn(&mut S, &DepthShot<'a>, &mut [f32]) + Sync,
    ) -> Result<(), BatchError> {
        check_length("result", self.shape, out.len())?;
        let pixels = self.pixels().max(1);
        // A single image may be measured outside a pool.
        if self.shape[0] <= 1 || self.shape[0] < rayon::current_num_threads() {
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

//! The memory of temporal filters, for each item of a batch.

use std::sync::{Mutex, PoisonError};

use oaktwin::camera::ImageSize;
use oaktwin::depth::filter::Chain;
use oaktwin::image::ImageView;
use oaktwin::sensor::Shot;
use pyo3::prelude::*;
use rayon::prelude::*;

use super::units::Items;
use crate::error::{error, wrong};
use crate::images::part;
use crate::threads;

/// The filters of each item, with their memory, for images of one size.
#[derive(Debug, Default)]
pub(super) struct Memory(Mutex<(Option<ImageSize>, Vec<Chain>)>);

/// Some images of a batch, one after the other.
pub(super) struct Images<'a> {
    pub(super) metres: &'a [f32],
    pub(super) rgb: Option<&'a [[u8; 4]]>,
    pub(super) size: ImageSize,
    pub(super) frame: u64,
    /// The number of the first one in the batch, and how many there are.
    pub(super) first: usize,
    pub(super) count: usize,
}

impl Memory {
    /// Forgets the earlier images of some items, or of all.
    pub(super) fn reset(&self, items: Option<&[usize]>) {
        let mut memory = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        match items {
            None => memory.1.clear(),
            Some(items) => {
                for item in items {
                    if let Some(chain) = memory.1.get_mut(*item) {
                        chain.reset();
                    }
                }
            }
        }
    }

    /// Measures images, each as the next one of its item. Called with the interpreter released; a change of size clears the memory.
    pub(super) fn sense(&self, items: &Items, images: &Images<'_>, room: &mut [f32]) -> PyResult<()> {
        // Locked before entering the pool, so that the pool's threads never wait for the lock.
        let mut memory = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let (size, chains) = &mut *memory;
        if *size != Some(images.size) {
            chains.clear();
            *size = Some(images.size);
        }
        let end = images.first + images.count;
        if chains.len() < end
            && let Some((sensor, _)) = items.of(images.first)
        {
            let mut fresh = sensor.filters().clone();
            fresh.reset();
            chains.resize(end, fresh);
        }
        let chains = chains.get_mut(images.first..end).unwrap_or_default();
        let out_pixels = (room.len() / images.count.max(1)).max(1);
        threads::install(|| {
            let all = chains
                .par_iter_mut()
                .zip(room.par_chunks_mut(out_pixels))
                .enumerate();
            all.try_for_each(|(index, (chain, room))| one(items, images, index, chain, room))
        })?
    }
}

/// Measures one image with the memory of its item.
fn one(
    items: &Items,
    images: &Images<'_>,
    index: usize,
    chain: &mut Chain,
    room: &mut [f32],
) -> PyResult<()> {
    let ImageSize { width, height } = images.size;
    let pixels = width as usize * height as usize;
    let depth = ImageView::new(width, height, part(images.metres, index * pixels, pixels))
        .ok_or_else(|| wrong("depth", "is smaller than its shape", "give whole arrays"))?;
    let mut shot = Shot::new(depth);
    let rgb = images.rgb.map(|rgb| part(rgb, index * pixels, pixels));
    if let Some(rgb) = rgb.and_then(|rgb| ImageView::new(width, height, rgb)) {
        shot = shot.with_rgb(rgb).map_err(error)?;
    }
    let Some((sensor, item)) = items.of(images.first + index) else {
        return Ok(());
    };
    (shot.frame, shot.item) = (images.frame, item);
    let mut sensor = sensor.with_filters(std::mem::take(chain));
    let captured = sensor.capture(shot, &[]);
    *chain = sensor.into_filters();
    let distance = captured.map_err(error)?.distance;
    if distance.0.pixels().len() == room.len() {
        room.copy_from_slice(distance.0.pixels());
    }
    Ok(())
}

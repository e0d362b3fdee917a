//! The memory of temporal filters, for each item of a batch.

use std::sync::{Mutex, PoisonError};

use oaktwin::camera::ImageSize;
use oaktwin::depth::filter::Chain;
use oaktwin::image::annotation::Annotator;
use oaktwin::sensor::Capture;
use pyo3::prelude::*;
use rayon::prelude::*;

use super::items::{Images, Items};
use crate::error::{error, wrong};
use crate::threads;

/// The filters of each item, with their memory, for images of one size.
#[derive(Debug, Default)]
pub(super) struct Memory(Mutex<(Option<ImageSize>, Vec<Chain>)>);

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

    /// Measures images with further outputs, each as the next one of its item, and hands each capture over with its place. Called with the
    /// interpreter released; a change of size clears the memory.
    pub(super) fn capture<P: Send>(
        &self,
        items: &Items,
        images: &Images<'_>,
        layers: &[Annotator],
        places: Vec<P>,
        take: impl Fn(Capture, P) + Sync,
    ) -> PyResult<()> {
        // Locked before entering the pool, so that the pool's threads never wait for the lock.
        let mut memory = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let (size, chains) = &mut *memory;
        if *size != Some(images.shape.size) {
            chains.clear();
            *size = Some(images.shape.size);
        }
        let end = images.first + images.count;
        for item in chains.len()..end {
            if let Some((sensor, ..)) = items.of(item) {
                let mut fresh = sensor.filters().clone();
                fresh.reset();
                chains.push(fresh);
            }
        }
        let chains = chains.get_mut(images.first..end).unwrap_or_default();
        threads::install(|| {
            let all = chains.par_iter_mut().zip(places).enumerate();
            all.try_for_each(|(index, (chain, place))| {
                take(one(items, images, index, layers, chain)?, place);
                Ok(())
            })
        })?
    }
}

/// Measures one image with the memory of its item.
fn one(
    items: &Items,
    images: &Images<'_>,
    index: usize,
    layers: &[Annotator],
    chain: &mut Chain,
) -> PyResult<Capture> {
    let Some((sensor, item, frame)) = items.of(images.first + index) else {
        return Err(wrong("depth", "has more images than items", "give one for each"));
    };
    let shot = images.shot(index, item, frame)?;
    let mut sensor = sensor.with_filters(std::mem::take(chain));
    let captured = sensor.capture(shot, layers);
    *chain = sensor.into_filters();
    captured.map_err(error)
}

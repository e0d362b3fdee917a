//! Memory of images that is used again.

use std::sync::{Mutex, PoisonError};

use oaktwin_image::Image;

/// The maximum size of an image whose memory is kept, bytes.
const MAX_BYTES: usize = 64 << 20;

/// The maximum number of images whose memory is kept.
const MAX_KEPT: usize = 8;

/// Memory of images that were dropped. Fresh memory has to be mapped page by page, which takes longer than writing it.
#[derive(Debug)]
pub(crate) struct Spare<T>(Mutex<Vec<Vec<T>>>);

impl<T> Default for Spare<T> {
    fn default() -> Self {
        Self(Mutex::default())
    }
}

impl<T: Clone> Spare<T> {
    /// Creates an image with the same value everywhere, in memory of an earlier one if there is some.
    pub(crate) fn image(&self, width: u32, height: u32, value: T) -> Image<T> {
        let known = self.0.lock().unwrap_or_else(PoisonError::into_inner).pop();
        let filled = known.and_then(|mut pixels| {
            pixels.clear();
            pixels.resize(width as usize * height as usize, value.clone());
            Image::new(width, height, pixels)
        });
        filled.unwrap_or_else(|| Image::filled(width, height, value))
    }

    /// Keeps the memory of an image.
    pub(crate) fn keep(&self, image: Image<T>) {
        let pixels = image.into_pixels();
        let mut kept = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if pixels.capacity() * size_of::<T>() <= MAX_BYTES && kept.len() < MAX_KEPT {
            kept.push(pixels);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn memory_is_used_again_and_filled() {
        let spare = Spare::default();
        let first = spare.image(8, 4, 7u16);
        let memory = first.pixels().as_ptr();
        spare.keep(first);
        let second = spare.image(5, 3, 9);
        assert_eq!(second, Image::filled(5, 3, 9));
        assert_eq!(second.pixels().as_ptr(), memory);
        // The only spare memory is in use.
        assert_eq!(spare.image(2, 2, 1), Image::filled(2, 2, 1));
    }

    #[test]
    fn vast_images_are_not_kept() {
        let spare = Spare::default();
        let side = 1 << 14;
        spare.keep(Image::filled(side, side, 0u8));
        assert!(spare.0.lock().unwrap().is_empty());
    }
}

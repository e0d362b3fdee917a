//! Limits of image sizes and memory.

use std::path::Path;

use oaktwin_camera::ImageSize;
use oaktwin_files::FileError;
use oaktwin_files::memory;
use oaktwin_image::annotation::{AnnotationKind, Annotator};

/// The maximum number of pixels of an image.
pub const MAX_PIXELS: u64 = 1 << 31;

/// An invalid image size.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SizeError {
    /// The image has no pixels.
    #[error("{}; {}", self.what(), self.remedy())]
    Empty(ImageSize),
    /// The image has more than [`MAX_PIXELS`].
    #[error("{}; {}", self.what(), self.remedy())]
    TooLarge(ImageSize),
}

impl SizeError {
    /// What is wrong.
    #[must_use]
    pub fn what(&self) -> String {
        match self {
            Self::Empty(size) => format!("an image of {size} has no pixels"),
            Self::TooLarge(size) => format!("an image of {size} has more than 2^31 pixels"),
        }
    }

    /// What to do.
    #[must_use]
    pub fn remedy(&self) -> &'static str {
        match self {
            Self::Empty(_) => "give a larger resolution",
            Self::TooLarge(_) => "choose a smaller resolution",
        }
    }
}

/// Checks an image size.
///
/// # Errors
/// Returns an error if the image has no pixels or more than [`MAX_PIXELS`].
pub fn check_size(size: ImageSize) -> Result<(), SizeError> {
    match u64::from(size.width) * u64::from(size.height) {
        0 => Err(SizeError::Empty(size)),
        pixels if pixels > MAX_PIXELS => Err(SizeError::TooLarge(size)),
        _ => Ok(()),
    }
}

/// Returns the memory in bytes that a frame needs on its way to a file: visibility, annotations and encoded files, while the
/// previous frame is still being written.
#[must_use]
pub fn frame_bytes(size: ImageSize, annotators: &[Annotator]) -> u64 {
    let pixels = u64::from(size.width) * u64::from(size.height);
    12 * pixels + 4 * annotation_bytes(size, annotators)
}

/// Returns the memory in bytes that recording a frame needs: rays, the largest message and its compressed form.
#[must_use]
pub fn record_bytes(size: ImageSize) -> u64 {
    40 * u64::from(size.width) * u64::from(size.height)
}

/// Returns the memory in bytes of a frame's annotations.
#[must_use]
pub fn annotation_bytes(size: ImageSize, annotators: &[Annotator]) -> u64 {
    let kinds = annotators.iter().filter_map(|annotator| annotator.kind());
    let per_pixel: u64 = kinds.map(AnnotationKind::bytes_per_pixel).sum();
    u64::from(size.width) * u64::from(size.height) * per_pixel
}

/// Returns the memory in bytes that simulating a sensor on a sequence of depth images needs: measured, 24 bytes a pixel, which
/// include the images that wait, and a reserve.
pub(crate) fn sense_bytes(size: ImageSize) -> u64 {
    32 * u64::from(size.width) * u64::from(size.height)
}

/// Returns the memory in bytes that matching a pair needs: a cost for each pixel and disparity, and both images.
pub(crate) fn match_bytes(size: ImageSize) -> u64 {
    const DISPARITIES: u64 = 96;
    const IMAGES: u64 = 32;
    (DISPARITIES + IMAGES) * u64::from(size.width) * u64::from(size.height)
}

/// Checks that a file's images fit into memory.
pub(crate) fn check_memory(path: &Path, size: ImageSize, bytes: u64) -> Result<(), FileError> {
    memory::check(bytes).map_err(|shortage| {
        let message = format!("images of {size}: {}", shortage.what());
        FileError::new(path, message, shortage.remedy())
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn checks_sizes() {
        assert!(check_size(ImageSize::new(1 << 16, 1 << 15)).is_ok());
        assert!(check_size(ImageSize::new((1 << 16) + 1, 1 << 15)).is_err());
        assert!(check_size(ImageSize::new(u32::MAX, u32::MAX)).is_err());
        assert!(check_size(ImageSize::new(0, 5)).is_err());
        let bytes = frame_bytes(
            ImageSize::new(1 << 16, 1 << 15),
            &Annotator::all().collect::<Vec<_>>(),
        );
        assert_eq!(memory::size(bytes), "848.0 GiB");
    }
}

//! The sizes of images that the page may ask for.

use oaktwin::camera::ImageSize;
use oaktwin::image::annotation::Annotator;
use oaktwin::memory;
use oaktwin::render::{check_size, frame_bytes};

use crate::protocol::Failure;

/// The maximum number of pixels: more than any camera of the catalog has, and few enough for an answer in time.
const MAX_PIXELS: u64 = 1 << 25;

/// The maximum width and height: what browsers draw. Rows of millions of pixels would take three times the memory that is counted.
const MAX_SIDE: u32 = 1 << 14;

/// The annotators of every frame.
pub(crate) const TRUTH: [Annotator; 2] = [Annotator::Rgb, Annotator::DistanceToImagePlane];

/// The memory that a stereo pair and its matcher take for each pixel, bytes: two cameras with their light, their images and
/// the maps of their rectification, and the sums of the matcher.
const PAIR_BYTES: u64 = 300;

/// Returns the size of images, if one is chosen.
pub(crate) fn image_size(size: Option<[u32; 2]>) -> Result<Option<ImageSize>, Failure> {
    let Some([width, height]) = size else {
        return Ok(None);
    };
    let size = ImageSize::new(width, height);
    check_size(size).map_err(|error| Failure::of("size", &error))?;
    check_pixels(size)?;
    Ok(Some(size))
}

/// Rejects images that are too large for the page, whose size a calibration may determine.
pub(crate) fn check_pixels(size: ImageSize) -> Result<(), Failure> {
    let pixels = u64::from(size.width) * u64::from(size.height);
    if pixels <= MAX_PIXELS && size.width.max(size.height) <= MAX_SIDE {
        return Ok(());
    }
    let error = format!(
        "images of {size} are too large for the page; choose at most {MAX_PIXELS} pixels and {MAX_SIDE} in a row or column, or use the command line"
    );
    Err(Failure::of("size", &error))
}

/// Rejects images that need more memory than is available.
pub(crate) fn check_memory(size: ImageSize, has_pair: bool) -> Result<(), Failure> {
    let pixels = u64::from(size.width) * u64::from(size.height);
    let of_pair = if has_pair { PAIR_BYTES * pixels } else { 0 };
    memory::check(frame_bytes(size, &TRUTH) * 3 + of_pair).map_err(|shortage| {
        let error = format!("images of {size}: {}; choose a smaller size", shortage.what());
        Failure::of("size", &error)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use oaktwin::catalog::Catalog;

    #[test]
    fn every_camera_of_the_catalog_fits() {
        let catalog = Catalog::builtin();
        for device in catalog.devices() {
            for camera in &catalog.nominal(device).cameras {
                assert!(check_pixels(camera.intrinsics.size).is_ok(), "{}", device.name);
            }
        }
    }

    #[test]
    fn rejects_sizes_that_are_too_large() {
        for size in [
            [0, 1],
            [1 << 13, (1 << 12) + 1],
            [1 << 25, 1],
            [1, 1 << 15],
            [u32::MAX, u32::MAX],
        ] {
            let failure = image_size(Some(size)).unwrap_err();
            assert_eq!(failure.field.as_deref(), Some("size"), "{failure:?}");
        }
        assert!(image_size(Some([1 << 13, 1 << 12])).is_ok() && image_size(Some([1 << 14, 1])).is_ok());
        assert!(image_size(None).unwrap().is_none());
    }
}

//! Grey images of 8 or 10 bits from files.

use std::path::Path;

use oaktwin_depth::imager::Recorded;
use oaktwin_files::{self as files, FileError};
use oaktwin_image::npy::{self, Values};
use oaktwin_image::{Image, png, texture};

/// The maximum size of a file.
const MAX_BYTES: u64 = 1 << 30;

/// The maximum of 10 bits.
const TEN_BITS: u16 = 1023;

/// The image of a file.
enum Grey {
    Eight(Image<u8>),
    Sixteen(Image<u16>),
}

/// Reads a pair of images: PNG, JPEG or NPY. 16-bit values are 10-bit ones, or, if one of the pair is larger, their upper 10 bits;
/// colours become luma (Rec. 601, as in `OpenCV` and `DepthAI`).
///
/// # Errors
/// Returns an error if a file cannot be read or is not an image.
pub fn read_pair(left: &Path, right: &Path) -> Result<[Recorded; 2], FileError> {
    let pair = [read(left)?, read(right)?];
    let is_full = pair.iter().any(|grey| match grey {
        Grey::Eight(_) => false,
        Grey::Sixteen(image) => image.pixels().iter().any(|&number| number > TEN_BITS),
    });
    Ok(pair.map(|grey| match grey {
        Grey::Eight(image) => Recorded::Eight(image),
        Grey::Sixteen(image) if is_full => Recorded::Ten(image.map(|&number| number >> 6)),
        Grey::Sixteen(image) => Recorded::Ten(image),
    }))
}

fn read(path: &Path) -> Result<Grey, FileError> {
    let bytes = files::read(path, MAX_BYTES, "an image")?;
    let grey = if bytes.starts_with(b"\x93NUMPY") {
        array(path, &bytes)?
    } else if let Ok(image) = png::decode::<u8>(&bytes) {
        Grey::Eight(image)
    } else if let Ok(image) = png::decode::<u16>(&bytes) {
        Grey::Sixteen(image)
    } else {
        let extension = path.extension().map(|extension| extension.to_string_lossy());
        let image = texture::decode_srgb(&bytes, extension.as_deref());
        Grey::Eight(
            image
                .map_err(|error| error.in_file(path))?
                .map(|&[r, g, b, _]| luma([r, g, b])),
        )
    };
    let (width, height) = match &grey {
        Grey::Eight(image) => (image.width(), image.height()),
        Grey::Sixteen(image) => (image.width(), image.height()),
    };
    crate::limits::check_size(oaktwin_camera::ImageSize::new(width, height))
        .map_err(|error| FileError::new(path, error.what(), error.remedy()))?;
    Ok(grey)
}

/// `(H, W)`, `(H, W, 1)`, or colours `(H, W, 3)` and `(H, W, 4)`.
fn array(path: &Path, bytes: &[u8]) -> Result<Grey, FileError> {
    let array = npy::decode(bytes).map_err(|error| error.in_file(path))?;
    let wrong = |message: String| {
        FileError::new(
            path,
            message,
            "give uint8 or uint16 of (H, W), or uint8 of (H, W, 3)",
        )
    };
    let shape = &array.shape;
    let (height, width, channels) = match shape[..] {
        [height, width] => (height, width, 1),
        [height, width, channels @ (1 | 3 | 4)] => (height, width, channels),
        _ => return Err(wrong(format!("NPY: shape: unsupported array shape {shape:?}"))),
    };
    let no_image = || wrong(format!("NPY: shape: unsupported array shape {shape:?}"));
    let (Ok(width), Ok(height)) = (u32::try_from(width), u32::try_from(height)) else {
        return Err(no_image());
    };
    match (array.values, channels) {
        (Values::U8(values), 1) => Image::new(width, height, values).map(Grey::Eight),
        (Values::U16(values), 1) => Image::new(width, height, values).map(Grey::Sixteen),
        (Values::U8(values), channels) => {
            let colors = values.chunks_exact(channels);
            let grey = colors.map(|color| match *color {
                [r, g, b, ..] => luma([r, g, b]),
                _ => 0,
            });
            Image::new(width, height, grey.collect()).map(Grey::Eight)
        }
        _ => return Err(wrong("NPY: descr: unsupported dtype".to_owned())),
    }
    .ok_or_else(no_image)
}

/// Returns the luma of a colour (Rec. 601, as in `OpenCV` and `DepthAI`).
#[must_use]
#[expect(clippy::cast_possible_truncation, reason = "a mean of bytes")]
pub fn luma([r, g, b]: [u8; 3]) -> u8 {
    ((299 * u32::from(r) + 587 * u32::from(g) + 114 * u32::from(b) + 500) / 1000) as u8
}

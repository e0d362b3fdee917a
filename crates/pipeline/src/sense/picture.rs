//! The colour images of depth images: one file each, or an array.

use std::path::{Path, PathBuf};

use oaktwin_camera::ImageSize;
use oaktwin_files::{self as files, FileError};
use oaktwin_image::npy::{self, Values};
use oaktwin_image::{Image, texture};

/// The maximum size of a file.
const MAX_BYTES: u64 = 4 << 30;

/// The colour images of a depth file, in order.
pub(super) struct Pictures {
    files: Vec<PathBuf>,
    /// The images of an array.
    decoded: Vec<Image<[u8; 4]>>,
    next: usize,
}

impl Pictures {
    /// Opens the colour images of a depth file with this number of images.
    ///
    /// # Errors
    /// Returns an error if an array cannot be read or the numbers of images differ.
    pub(super) fn open(files: &[PathBuf], depth: &Path, images: usize) -> Result<Option<Self>, FileError> {
        let decoded = match files {
            [] => return Ok(None),
            [one] if is_numpy(one) => array(one)?,
            _ => Vec::new(),
        };
        let count = if decoded.is_empty() {
            files.len()
        } else {
            decoded.len()
        };
        if count != images {
            let message = format!(
                "{count} colour images for the {images} depth images of {}",
                depth.display()
            );
            let remedy = "give one colour image per depth image, or an array of all";
            return Err(FileError::new(&files[0], message, remedy));
        }
        Ok(Some(Self {
            files: files.to_vec(),
            decoded,
            next: 0,
        }))
    }

    /// Reads the next colour image.
    ///
    /// # Errors
    /// Returns an error if it cannot be read or its size differs from the depth's.
    pub(super) fn next(&mut self, depth: &Path, size: ImageSize) -> Result<Image<[u8; 4]>, FileError> {
        let at = self.next;
        self.next += 1;
        let path = self.files.get(at).unwrap_or(&self.files[0]).clone();
        let picture = match self.decoded.get_mut(at) {
            Some(picture) => std::mem::replace(picture, Image::filled(0, 0, [0; 4])),
            None => {
                let bytes = files::read(&path, MAX_BYTES, "a colour image")?;
                let extension = path.extension().map(|extension| extension.to_string_lossy());
                texture::decode_srgb(&bytes, extension.as_deref()).map_err(|error| error.in_file(&path))?
            }
        };
        if (picture.width(), picture.height()) != (size.width, size.height) {
            let message = format!(
                "is {}x{}, but the depth {} is {size}",
                picture.width(),
                picture.height(),
                depth.display()
            );
            return Err(FileError::new(&path, message, "give images of the same size"));
        }
        Ok(picture)
    }
}

fn is_numpy(path: &Path) -> bool {
    path.extension()
        .is_some_and(|extension| extension.eq_ignore_ascii_case("npy"))
}

/// The colour images of an array, `(H, W, C)` or `(N, H, W, C)` of `uint8` with three or four channels.
fn array(path: &Path) -> Result<Vec<Image<[u8; 4]>>, FileError> {
    let bytes = files::read(path, MAX_BYTES, "an array of colour images")?;
    let array = npy::decode(&bytes).map_err(|error| error.in_file(path))?;
    let wrong = |message: String| {
        FileError::new(
            path,
            message,
            "give uint8 of (H, W, 3), (H, W, 4), (N, H, W, 3) or (N, H, W, 4)",
        )
    };
    let [.., height, width, channels @ (3 | 4)] = array.shape[..] else {
        return Err(wrong(format!(
            "NPY: shape: unsupported array shape {:?}",
            array.shape
        )));
    };
    let Values::U8(values) = array.values else {
        return Err(wrong("NPY: descr: unsupported dtype".to_owned()));
    };
    let size = u32::try_from(width).ok().zip(u32::try_from(height).ok());
    let pixels = height * width;
    if pixels == 0 {
        return Err(wrong(format!(
            "NPY: shape: unsupported array shape {:?}",
            array.shape
        )));
    }
    let pictures = values.chunks_exact(pixels * channels).map(|picture| {
        let colors = picture.chunks_exact(channels).map(|pixel| match *pixel {
            [r, g, b] => [r, g, b, 255],
            [r, g, b, a] => [r, g, b, a],
            _ => [0; 4],
        });
        size.and_then(|(width, height)| Image::new(width, height, colors.collect()))
    });
    let pictures: Option<Vec<_>> = pictures.collect();
    pictures.ok_or_else(|| wrong(format!("NPY: shape: {:?} is too large", array.shape)))
}

//! Depth files, read image by image with the memory of one image.

use std::fs::File;
use std::io::{BufReader, Cursor, Read};
use std::path::{Path, PathBuf};

use crate::limits::check_size;
use oaktwin_base::diagnostic::{message, opt};
use oaktwin_camera::ImageSize;
use oaktwin_files::FileError;
use oaktwin_image::npy::{self, Layout, Number, Values};
use oaktwin_image::{CodecError, Image, exr, pfm, png, tiff};

/// The number of bytes that tell formats apart, and that every NPY file has.
const BEGINNING: u64 = 12;

/// The maximum size of files that are read as a whole.
const MAX_BYTES: u64 = 4 << 30;

/// A depth file with one image or a batch.
pub struct DepthImageReader {
    path: PathBuf,
    /// The number of images of a batch; `None` for a single image.
    pub batch: Option<usize>,
    /// The size of each image.
    pub size: ImageSize,
    data: Data,
}

impl std::fmt::Debug for DepthImageReader {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("DepthImageReader")
            .field("path", &self.path)
            .field("batch", &self.batch)
            .field("size", &self.size)
            .finish_non_exhaustive()
    }
}

enum Data {
    /// Decoded images.
    Images(std::vec::IntoIter<Image<f32>>),
    /// The remaining images of an array.
    Numbers {
        reader: Box<dyn Read + Send>,
        layout: Layout,
        left: usize,
        scale: f64,
    },
}

impl DepthImageReader {
    /// Opens a file. Integer pixels are multiplied by `scale` metres.
    ///
    /// # Errors
    /// Returns an error if the file cannot be read or is not a depth image.
    pub fn open(path: &Path, scale: f64) -> Result<Self, FileError> {
        let unreadable = |error: std::io::Error| {
            if error.kind() == std::io::ErrorKind::NotFound {
                FileError::new(path, "there is no such file", "check the path")
            } else {
                FileError::new(path, format!("cannot be read ({error})"), "check the path")
            }
        };
        let file = File::open(path).map_err(unreadable)?;
        let metadata = file.metadata().map_err(unreadable)?;
        let length = metadata.is_file().then_some(metadata.len());
        Self::read(
            path,
            Box::new(BufReader::with_capacity(1 << 16, file)),
            length,
            scale,
        )
    }

    /// Reads from a stream; `length` is its size in bytes, if known.
    ///
    /// # Errors
    /// Returns an error if the stream cannot be read or is not a depth image.
    pub fn read(
        path: &Path,
        mut reader: Box<dyn Read + Send>,
        length: Option<u64>,
        scale: f64,
    ) -> Result<Self, FileError> {
        let mut beginning = Vec::new();
        take(path, &mut reader, BEGINNING, &mut beginning)?;
        if beginning.starts_with(npy::MAGIC) {
            return Self::numpy(path, reader, beginning, length, scale);
        }
        let mut bytes = beginning;
        take(path, &mut reader, MAX_BYTES, &mut bytes)?;
        if bytes.len() as u64 > MAX_BYTES {
            let message = format!("is larger than {} GiB", MAX_BYTES >> 30);
            return Err(FileError::new(
                path,
                message,
                "give a NumPy array, which is read in parts",
            ));
        }
        let codec = |error: CodecError| error.in_file(path);
        if bytes.starts_with(b"PK\x03\x04") {
            let array = npy::only_array(&bytes).map_err(codec)?;
            let length = array.len() as u64;
            let (mut reader, mut beginning) = (Cursor::new(array), Vec::new());
            take(path, &mut reader, BEGINNING, &mut beginning)?;
            return Self::numpy(path, Box::new(reader), beginning, Some(length), scale);
        }
        if bytes.starts_with(b"II*\0") || bytes.starts_with(b"MM\0*") {
            return Self::tiff(path, tiff::decode(&bytes).map_err(codec)?, scale);
        }
        let image = if bytes.starts_with(b"\x89PNG") {
            let image = png::decode::<u16>(&bytes).map_err(|mut error| {
                if error.remedy == png::CONVERT {
                    error.remedy = "save depth as 16-bit grey without alpha".into();
                }
                codec(error)
            })?;
            image.map(|&unit| metres(unit, scale))
        } else if bytes.starts_with(&[0x76, 0x2F, 0x31, 0x01]) {
            exr::decode(&bytes).map_err(codec)?
        } else if bytes.starts_with(b"Pf") || bytes.starts_with(b"PF") {
            pfm::decode(&bytes).map_err(codec)?
        } else {
            let message = if bytes.is_empty() {
                "is empty"
            } else {
                "unknown depth image format"
            };
            return Err(FileError::new(
                path,
                message,
                "give an NPY, NPZ, PNG, TIFF, EXR or PFM file",
            ));
        };
        let size = ImageSize::new(image.width(), image.height());
        check(path, size)?;
        Ok(Self {
            path: path.to_owned(),
            batch: None,
            size,
            data: Data::Images(vec![image].into_iter()),
        })
    }

    /// Several pages are a batch.
    fn tiff(path: &Path, pages: Vec<tiff::Page>, scale: f64) -> Result<Self, FileError> {
        let count = pages.len();
        let first = (pages.first()).map_or(ImageSize::new(0, 0), |page| {
            ImageSize::new(page.width, page.height)
        });
        check(path, first)?;
        let mut images = Vec::with_capacity(count);
        for (at, page) in pages.into_iter().enumerate() {
            let wrong = |message: &str, remedy: &str| {
                FileError::new(path, format!("TIFF: page {at}: {message}"), remedy)
            };
            if ImageSize::new(page.width, page.height) != first {
                return Err(wrong(
                    "has another size than the first page",
                    "save pages of one size",
                ));
            }
            let pixels = in_metres(page.values, scale).ok_or_else(|| {
                wrong(
                    "unsupported pixels of 8 bits",
                    "save float32 metres or 16-bit integers",
                )
            })?;
            let image = Image::new(first.width, first.height, pixels);
            images.push(image.ok_or_else(|| wrong("is not a valid image", "save it again"))?);
        }
        Ok(Self {
            path: path.to_owned(),
            batch: (count > 1).then_some(count),
            size: first,
            data: Data::Images(images.into_iter()),
        })
    }

    fn numpy(
        path: &Path,
        mut reader: Box<dyn Read + Send>,
        mut beginning: Vec<u8>,
        length: Option<u64>,
        scale: f64,
    ) -> Result<Self, FileError> {
        let codec = |error: CodecError| error.in_file(path);
        let header = header_bytes(&beginning).min(Layout::MAX_DATA_OFFSET);
        let missing = header.saturating_sub(beginning.len()) as u64;
        take(path, &mut reader, missing, &mut beginning)?;
        let layout = Layout::parse(&beginning).map_err(codec)?;
        let wrong = |message: String, remedy| FileError::new(path, format!("NPY: shape: {message}"), remedy);
        let (batch, height, width) = match layout.shape[..] {
            [height, width] | [height, width, 1] => (None, height, width),
            [count, height, width] | [count, height, width, 1] => (Some(count), height, width),
            _ => {
                let message = format!("unsupported array shape {:?}", layout.shape);
                return Err(wrong(
                    message,
                    "give (H, W), (H, W, 1), (N, H, W) or (N, H, W, 1)",
                ));
            }
        };
        if batch == Some(0) {
            return Err(wrong(
                format!("{:?} is an empty batch", layout.shape),
                "give at least one image",
            ));
        }
        let axis = |length: usize| {
            u32::try_from(length)
                .map_err(|_| wrong(format!("{length} pixels on a side"), "cut it into tiles"))
        };
        let size = ImageSize::new(axis(width)?, axis(height)?);
        check(path, size)?;
        if matches!(layout.number.values(&[]), Values::U8(_)) {
            return Err(FileError::new(
                path,
                "NPY: descr: unsupported dtype uint8",
                message!["give float metres, or wider integers with ", opt("depth-scale")],
            ));
        }
        let given = length.map(|length| length.saturating_sub(layout.data_offset as u64));
        match (given, layout.data_bytes()) {
            (Some(given), expected) if expected.map(|n| n as u64) != Some(given) => {
                return Err(codec(layout.wrong_length(given)));
            }
            (None, None) => return Err(codec(layout.wrong_length(0))),
            _ => {}
        }
        let count = batch.unwrap_or(1);
        let data = if layout.is_fortran {
            Data::Images(fortran(path, &mut reader, beginning, &layout, size, scale)?.into_iter())
        } else {
            Data::Numbers {
                reader,
                layout,
                left: count,
                scale,
            }
        };
        Ok(Self {
            path: path.to_owned(),
            batch,
            size,
            data,
        })
    }

    /// Returns the next image in metres; `None` after the last.
    ///
    /// # Errors
    /// Returns an error if the stream ends early or cannot be decoded.
    pub fn next_image(&mut self) -> Result<Option<Image<f32>>, FileError> {
        match &mut self.data {
            Data::Images(images) => Ok(images.next()),
            Data::Numbers { left: 0, .. } => Ok(None),
            Data::Numbers {
                reader,
                layout,
                left,
                scale,
            } => {
                let pixels = self.size.width as usize * self.size.height as usize;
                let wanted = pixels * layout.number.bytes();
                let mut bytes = Vec::new();
                take(&self.path, reader, wanted as u64, &mut bytes)?;
                if bytes.len() != wanted {
                    let read = self.batch.unwrap_or(1) - *left;
                    let message = format!("NPY: data: ends in image {read}");
                    let remedy = "the file is truncated or damaged; copy it again";
                    return Err(FileError::new(&self.path, message, remedy));
                }
                *left -= 1;
                image(layout.number, &bytes, self.size, *scale)
                    .map(Some)
                    .ok_or_else(|| FileError::new(&self.path, "is not a valid image", "save it again"))
            }
        }
    }
}

/// The length of the header and the magic string, as the header states it.
fn header_bytes(beginning: &[u8]) -> usize {
    match *beginning {
        [_, _, _, _, _, _, 1, _, a, b, ..] => 10 + usize::from(u16::from_le_bytes([a, b])),
        [_, _, _, _, _, _, _, _, a, b, c, d, ..] => {
            usize::try_from(u32::from_le_bytes([a, b, c, d])).map_or(usize::MAX, |n| n.saturating_add(12))
        }
        _ => beginning.len(),
    }
}

/// All images of an array in Fortran order.
fn fortran(
    path: &Path,
    reader: &mut dyn Read,
    mut bytes: Vec<u8>,
    layout: &Layout,
    size: ImageSize,
    scale: f64,
) -> Result<Vec<Image<f32>>, FileError> {
    let missing =
        layout.data_bytes().unwrap_or_default() + layout.data_offset - bytes.len().min(layout.data_offset);
    take(path, reader, missing as u64, &mut bytes)?;
    let array = npy::decode(&bytes).map_err(|error| error.in_file(path))?;
    let pixels = size.width as usize * size.height as usize;
    let images = in_metres(array.values, scale).unwrap_or_default();
    let images = images.chunks_exact(pixels).map(<[f32]>::to_vec);
    let images: Option<Vec<_>> = images
        .map(|pixels| Image::new(size.width, size.height, pixels))
        .collect();
    images.ok_or_else(|| FileError::new(path, "is not a valid image", "save it again"))
}

fn image(number: Number, bytes: &[u8], size: ImageSize, scale: f64) -> Option<Image<f32>> {
    Image::new(size.width, size.height, in_metres(number.values(bytes), scale)?)
}

/// Converts pixels to metres; integers are in units of `scale`. `None` for pixels of 8 bits, which are too few for depth.
fn in_metres(values: Values, scale: f64) -> Option<Vec<f32>> {
    Some(match values {
        Values::F32(values) => values,
        Values::F64(values) => values.into_iter().map(single).collect(),
        Values::U16(values) => values.into_iter().map(|unit| metres(unit, scale)).collect(),
        // Negative numbers mean that there is no depth.
        Values::I32(values) => (values.into_iter())
            .map(|unit| metres(unit.max(0), scale))
            .collect(),
        #[expect(clippy::cast_precision_loss, reason = "depth is single precision")]
        Values::I64(values) => (values.into_iter())
            .map(|unit| metres(unit.max(0) as f64, scale))
            .collect(),
        Values::U8(_) => return None,
    })
}

#[expect(clippy::cast_possible_truncation, reason = "depth is single precision")]
fn metres(unit: impl Into<f64>, scale: f64) -> f32 {
    (unit.into() * scale) as f32
}

#[expect(clippy::cast_possible_truncation, reason = "depth is single precision")]
fn single(z: f64) -> f32 {
    z as f32
}

fn check(path: &Path, size: ImageSize) -> Result<(), FileError> {
    check_size(size).map_err(|error| {
        let text = error.to_string();
        let (message, remedy) = text.split_once("; ").unwrap_or((&text, "give another"));
        FileError::new(path, message, remedy)
    })
}

/// Appends up to `max` bytes; memory grows with the bytes that arrive, not with the announced length.
fn take(path: &Path, reader: &mut dyn Read, max: u64, bytes: &mut Vec<u8>) -> Result<(), FileError> {
    reader.take(max).read_to_end(bytes).map(|_| ()).map_err(|error| {
        let message = match error.kind() {
            std::io::ErrorKind::IsADirectory => "is a directory".to_owned(),
            _ => format!("cannot be read ({error})"),
        };
        FileError::new(path, message, "check the path")
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn integers_are_in_units_of_the_scale_and_negative_ones_are_missing() {
        let file = npy::encode(&[1, 3], &[1500_i32, -1, 70_000]).unwrap();
        let length = Some(file.len() as u64);
        let mut source =
            DepthImageReader::read(Path::new("a.npy"), Box::new(Cursor::new(file)), length, 0.001).unwrap();
        let image = source.next_image().unwrap().unwrap();
        assert_eq!(image.pixels(), [1.5, 0.0, 70.0]);
    }
}

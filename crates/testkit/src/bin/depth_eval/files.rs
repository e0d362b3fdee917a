//! Reads and writes images as NPY files.

use std::error::Error;
use std::fs;
use std::path::Path;

use oaktwin_image::{Image, npy};

/// Rows × columns of `float32`.
pub(crate) fn read_depth(path: &Path) -> Result<Image<f32>, Box<dyn Error>> {
    Ok(npy::decode(&fs::read(path)?)?.into_f32_image()?)
}

/// Rows × columns.
pub(crate) fn write<T: npy::NpyElement>(path: &Path, image: &Image<T>) -> Result<(), Box<dyn Error>> {
    let shape = [image.height() as usize, image.width() as usize];
    Ok(fs::write(path, npy::encode(&shape, image.pixels())?)?)
}

/// Rows × columns × channels.
pub(crate) fn write_channels<T: npy::NpyElement, const N: usize>(
    path: &Path,
    image: &Image<[T; N]>,
) -> Result<(), Box<dyn Error>> {
    let shape = [image.height() as usize, image.width() as usize, N];
    Ok(fs::write(
        path,
        npy::encode(&shape, image.pixels().as_flattened())?,
    )?)
}

/// Rows × columns × 4 of `uint8`.
pub(crate) fn read_u8x4(path: &Path) -> Result<Image<[u8; 4]>, Box<dyn Error>> {
    let array = npy::decode(&fs::read(path)?)?;
    match array.values {
        npy::Values::U8(values) => four(&array.shape, &values),
        _ => Err("the colour image must be uint8".into()),
    }
}

/// Rows × columns × 4 of `float32`.
pub(crate) fn read_f32x4(path: &Path) -> Result<Image<[f32; 4]>, Box<dyn Error>> {
    let array = npy::decode(&fs::read(path)?)?;
    match array.values {
        npy::Values::F32(values) => four(&array.shape, &values),
        _ => Err("the positions must be float32".into()),
    }
}

fn four<T: Copy>(shape: &[usize], values: &[T]) -> Result<Image<[T; 4]>, Box<dyn Error>> {
    let &[height, width, 4] = shape else {
        return Err(format!("invalid shape {shape:?}: rows × columns × 4 required").into());
    };
    let pixels = values.as_chunks::<4>().0.to_vec();
    let image = Image::new(u32::try_from(width)?, u32::try_from(height)?, pixels);
    image.ok_or_else(|| "too large".into())
}

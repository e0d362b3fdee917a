//! Images in NPY files.

use std::error::Error;
use std::fs;
use std::path::Path;

use oaktwin_image::{Image, npy};

/// Rows × columns of `float32`.
pub(crate) fn read_depth(path: &Path) -> Result<Image<f32>, Box<dyn Error>> {
    Ok(npy::decode(&fs::read(path)?)?.into_f32_image()?)
}

/// Rows × columns.
pub(crate) fn write<T: npy::Element>(path: &Path, image: &Image<T>) -> Result<(), Box<dyn Error>> {
    let shape = [image.height() as usize, image.width() as usize];
    Ok(fs::write(path, npy::encode(&shape, image.pixels())?)?)
}

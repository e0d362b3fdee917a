use std::error::Error;
use std::fs;
use std::path::PathBuf;

use oaktwin_depth::filter::{self, Chain, Filter, Pixel};
use oaktwin_image::{Image, npy};
use serde::Deserialize;
use serde_json::{Value, json};

/// Filters a sequence of frames.
#[derive(Deserialize)]
pub(crate) struct Request {
    /// `uint8` or `uint16`: frames × rows × columns.
    frames: PathBuf,
    /// The output file of the filtered frames.
    filtered: PathBuf,
    /// The filters as text.
    filters: Vec<String>,
}

impl Request {
    pub(crate) fn answer(&self) -> Result<Value, Box<dyn Error>> {
        let filters = self.filters.iter().map(|text| filter::parse(text));
        let filters = filters.collect::<Result<Vec<Filter>, _>>()?;
        let texts: Vec<String> = filters.iter().map(ToString::to_string).collect();
        let array = npy::decode(&fs::read(&self.frames)?)?;
        let encoded = match &array.values {
            npy::Values::U8(pixels) => run(&array.shape, pixels, filters)?,
            npy::Values::U16(pixels) => run(&array.shape, pixels, filters)?,
            _ => return Err("frames must be uint8 or uint16".into()),
        };
        fs::write(&self.filtered, encoded)?;
        Ok(json!({ "filters": texts }))
    }
}

fn run<P: Pixel + npy::NpyElement>(
    shape: &[usize],
    pixels: &[P],
    filters: Vec<Filter>,
) -> Result<Vec<u8>, Box<dyn Error>> {
    let &[frames, height, width] = shape else {
        return Err("invalid shape: frames × rows × columns required".into());
    };
    let (width, height) = (u32::try_from(width)?, u32::try_from(height)?);
    let mut chain = Chain::new(filters);
    let mut filtered = Vec::new();
    for frame in pixels.chunks((pixels.len() / frames.max(1)).max(1)) {
        let image = Image::new(width, height, frame.to_vec()).ok_or("invalid image size")?;
        filtered.extend(chain.run(image).into_pixels());
    }
    let (width, height) = chain.size(width, height);
    Ok(npy::encode(
        &[frames, height as usize, width as usize],
        &filtered,
    )?)
}

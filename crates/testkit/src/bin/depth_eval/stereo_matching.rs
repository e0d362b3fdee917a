use std::collections::BTreeMap;
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use oaktwin_camera::StereoGeometry;
use oaktwin_depth::preset::Platform;
use oaktwin_depth::stereo_matching::{Parameters, RectifiedPair, StereoMatching, inspect};
use oaktwin_image::{Image, ImageView, npy};
use serde_json::{Value, json};

use crate::files;

const STEREO: StereoGeometry = StereoGeometry {
    focal_length_px: 800.0,
    baseline_m: 0.075,
};

#[derive(serde::Deserialize)]
pub(crate) struct Request {
    /// `uint8` or `uint16`.
    left: PathBuf,
    right: PathBuf,
    /// The width of the images at the given focal length.
    width: u32,
    #[serde(default)]
    set: BTreeMap<String, String>,
    /// The output files.
    disparity: PathBuf,
    confidence: PathBuf,
}

impl Request {
    pub(crate) fn answer(&self) -> Result<Value, Box<dyn Error>> {
        let mut parameters = Parameters::new(Platform::Rvc2, STEREO, self.width);
        for (name, value) in &self.set {
            parameters.set(name, value)?;
        }
        let engine = StereoMatching::new(parameters)?;
        let [left, right] = [&self.left, &self.right].map(|path| decode(path));
        let (left, right) = (left?, right?);
        let pair = match (&left, &right) {
            (Levels::U8(left), Levels::U8(right)) => {
                RectifiedPair::new(ImageView::from(left), ImageView::from(right))?
            }
            (Levels::U16(left), Levels::U16(right)) => {
                RectifiedPair::new(ImageView::from(left), ImageView::from(right))?
            }
            _ => return Err("the images have different dtypes".into()),
        };
        let (matched, findings) = (engine.disparity(&pair), inspect(&pair, &parameters));
        files::write(&self.disparity, &matched.disparity)?;
        files::write(&self.confidence, &matched.confidence)?;
        let codes: Vec<&str> = findings.iter().map(|finding| finding.code).collect();
        Ok(json!({ "findings": codes }))
    }
}

#[derive(serde::Deserialize)]
pub(crate) struct ParametersRequest {
    /// `RVC2` or `RVC4`.
    platform: String,
}

impl ParametersRequest {
    pub(crate) fn answer(&self) -> Result<Value, Box<dyn Error>> {
        let platforms = [Platform::Rvc2, Platform::Rvc4];
        let platform = platforms
            .into_iter()
            .find(|known| known.name().eq_ignore_ascii_case(&self.platform));
        let parameters = Parameters::new(platform.ok_or("unknown platform")?, STEREO, 1280);
        let values = Parameters::names()
            .into_iter()
            .map(|name| Ok((name, parameters.get(name)?)));
        let values: BTreeMap<&str, String> = values.collect::<Result<_, Box<dyn Error>>>()?;
        Ok(json!({ "parameters": values }))
    }
}

enum Levels {
    U8(Image<u8>),
    U16(Image<u16>),
}

fn decode(path: &Path) -> Result<Levels, Box<dyn Error>> {
    let array = npy::decode(&fs::read(path)?)?;
    let &[height, width] = array.shape.as_slice() else {
        return Err("invalid shape: rows × columns required".into());
    };
    let (width, height) = (u32::try_from(width)?, u32::try_from(height)?);
    let levels = match array.values {
        npy::Values::U8(values) => Image::new(width, height, values).map(Levels::U8),
        npy::Values::U16(values) => Image::new(width, height, values).map(Levels::U16),
        _ => return Err("images must be uint8 or uint16".into()),
    };
    levels.ok_or_else(|| "too large".into())
}

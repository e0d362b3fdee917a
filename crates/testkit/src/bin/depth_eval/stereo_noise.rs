use oaktwin_depth::preset::Platform;
use std::error::Error;
use std::fs;
use std::path::PathBuf;

use oaktwin_camera::StereoGeometry;
use oaktwin_depth::random::Stream;
use oaktwin_depth::stereo_noise::{Parameters, StereoNoise};
use oaktwin_depth::{BatchEngine as _, DepthShot};
use oaktwin_image::npy;
use serde::Deserialize;
use serde_json::{Map, Value, json};

use crate::files;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Request {
    /// Rows × columns, or for a batch images × rows × columns.
    depth: PathBuf,
    /// The colour image, rows × columns × 4 of `uint8`.
    rgb: Option<PathBuf>,
    /// The output file of the disparity; not for a batch.
    disparity: Option<PathBuf>,
    /// The output file of the depth.
    distance: Option<PathBuf>,
    seed: u64,
    camera: String,
    frame: u64,
    #[serde(default)]
    item: u32,
    /// The matcher's focal length.
    focal_length_px: f64,
    baseline_m: f64,
    width_px: u32,
    /// The parameters by name.
    #[serde(default)]
    parameters: Map<String, Value>,
}

impl Request {
    pub(crate) fn answer(&self) -> Result<Value, Box<dyn Error>> {
        let sensor = self.sensor()?;
        let random = Stream::new(self.seed, &self.camera);
        let array = npy::decode(&fs::read(&self.depth)?)?;
        if let (&[count, height, width], npy::Values::F32(depth)) = (array.shape.as_slice(), &array.values) {
            let shape = [count, height, width];
            let mut out = vec![0.0f32; depth.len()];
            sensor.sense_batch(depth, shape, self.frame, self.item, &random, &mut out)?;
            let distance = self.distance.as_ref().ok_or("a batch requires `distance`")?;
            fs::write(distance, npy::encode(&array.shape, &out)?)?;
            return Ok(json!({}));
        }
        let depth = array.into_f32_image()?;
        let rgb = self.rgb.as_deref().map(files::read_u8x4).transpose()?;
        let mut shot = DepthShot::new((&depth).into());
        if let Some(rgb) = &rgb {
            shot = shot.with_rgb(rgb.into())?;
        }
        (shot.frame, shot.item) = (self.frame, self.item);
        if let Some(disparity) = &self.disparity {
            files::write(disparity, &sensor.disparity(&shot, &random))?;
        }
        if let Some(distance) = &self.distance {
            files::write(distance, &sensor.sense(&shot, &random).0)?;
        }
        Ok(json!({}))
    }

    fn sensor(&self) -> Result<StereoNoise, Box<dyn Error>> {
        let stereo = StereoGeometry {
            focal_length_px: self.focal_length_px,
            baseline_m: self.baseline_m,
        };
        let mut parameters = Parameters::new(Platform::Rvc2, stereo, self.width_px);
        for (name, value) in &self.parameters {
            match value {
                Value::String(value) => parameters.set(name, value)?,
                value => parameters.set(name, value.to_string())?,
            }
        }
        Ok(StereoNoise::new(parameters)?)
    }
}

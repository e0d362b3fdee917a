use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use oaktwin_depth::filter::DepthConfidence;
use oaktwin_depth::random::Stream;
use oaktwin_depth::time_of_flight::{Parameters, TimeOfFlight};
use oaktwin_depth::{BatchEngine as _, DepthShot};
use oaktwin_image::{Image, npy};
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
    /// The receding velocity along each ray in m/s, rows × columns of `float32`.
    velocity: Option<PathBuf>,
    /// The output file of the depth.
    distance: PathBuf,
    /// The output files of the other images; not for a batch.
    amplitude: Option<PathBuf>,
    confidence: Option<PathBuf>,
    seed: u64,
    camera: String,
    frame: u64,
    #[serde(default)]
    item: u32,
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
            let mut out = vec![0.0f32; depth.len()];
            let shape = [count, height, width];
            sensor.sense_batch(depth, shape, self.frame, self.item, &random, &mut out)?;
            fs::write(&self.distance, npy::encode(&array.shape, &out)?)?;
            return Ok(json!({}));
        }
        let depth = array.into_f32_image()?;
        let rgb = self.rgb.as_deref().map(files::read_u8x4).transpose()?;
        let velocity = self.velocity.as_deref().map(files::read_depth).transpose()?;
        let mut shot = DepthShot::new((&depth).into());
        if let Some(rgb) = &rgb {
            shot = shot.with_rgb(rgb.into())?;
        }
        if let Some(velocity) = &velocity {
            shot = shot.with_radial_velocity(velocity.into())?;
        }
        (shot.frame, shot.item) = (self.frame, self.item);
        let output = sensor.output(&shot, &random);
        files::write(&self.distance, &output.distance.0)?;
        if let Some(path) = &self.amplitude {
            files::write(path, &output.amplitude)?;
        }
        if let Some(path) = &self.confidence {
            files::write(path, &output.confidence)?;
        }
        Ok(json!({}))
    }

    fn sensor(&self) -> Result<TimeOfFlight, Box<dyn Error>> {
        let mut parameters = Parameters::new(457.0, 640);
        for (name, value) in &self.parameters {
            match value {
                Value::String(value) => parameters.set(name, value)?,
                value => parameters.set(name, value.to_string())?,
            }
        }
        Ok(TimeOfFlight::new(parameters)?)
    }
}

/// `DepthAI`'s filter of depth by amplitude.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Confidence {
    /// `uint16`, rows × columns, like the amplitude.
    depth: PathBuf,
    amplitude: PathBuf,
    threshold: f32,
    /// The output files.
    filtered: PathBuf,
    confidence: PathBuf,
}

impl Confidence {
    pub(crate) fn answer(&self) -> Result<Value, Box<dyn Error>> {
        let (mut depth, amplitude) = (read_u16(&self.depth)?, read_u16(&self.amplitude)?);
        let filter = DepthConfidence {
            threshold: self.threshold,
        };
        let confidence = filter.run(&mut depth, &amplitude);
        files::write(&self.filtered, &depth)?;
        files::write(&self.confidence, &confidence)?;
        Ok(json!({}))
    }
}

fn read_u16(path: &Path) -> Result<Image<u16>, Box<dyn Error>> {
    let array = npy::decode(&fs::read(path)?)?;
    let (&[height, width], npy::Values::U16(pixels)) = (array.shape.as_slice(), array.values) else {
        return Err("invalid image: rows × columns of uint16 required".into());
    };
    Image::new(u32::try_from(width)?, u32::try_from(height)?, pixels).ok_or_else(|| "too large".into())
}

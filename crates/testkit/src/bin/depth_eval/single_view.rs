use std::collections::BTreeMap;
use std::error::Error;
use std::path::{Path, PathBuf};

use oaktwin_depth::DepthShot;
use oaktwin_depth::random::Stream;
use oaktwin_depth::single_view::{Assumptions, Parameters, SingleView, Wanted};
use oaktwin_image::{Image, npy};
use serde::Deserialize;
use serde_json::{Value, json};

use crate::files;

#[derive(Deserialize)]
pub(crate) struct Request {
    depth: PathBuf,
    rgb: Option<PathBuf>,
    positions: Option<PathBuf>,
    /// The output files.
    out: Out,
    /// The parameters by the schema's attribute names; the defaults are Isaac Sim 5.1's.
    #[serde(default)]
    parameters: BTreeMap<String, String>,
    #[serde(default)]
    assumptions: BTreeMap<String, String>,
    seed: u64,
    camera: String,
    frame: u64,
    #[serde(default)]
    item: u32,
}

/// The files of the requested outputs.
#[derive(Deserialize)]
struct Out {
    distance: PathBuf,
    positions: Option<PathBuf>,
    colors: Option<PathBuf>,
    imager: Option<PathBuf>,
    view: Option<PathBuf>,
}

impl Request {
    pub(crate) fn answer(&self) -> Result<Value, Box<dyn Error>> {
        let (mut parameters, mut assumptions) = (Parameters::isaac_5_1(), Assumptions::default());
        for (name, value) in &self.parameters {
            parameters.set(name, value)?;
        }
        for (name, value) in &self.assumptions {
            assumptions.set(name, value)?;
        }
        let sensor = SingleView::new(parameters, assumptions)?;
        let depth = files::read_depth(&self.depth)?;
        let rgb = self.rgb.as_deref().map(files::read_u8x4).transpose()?;
        let positions = self.positions.as_deref().map(files::read_f32x4).transpose()?;
        let mut shot = DepthShot::new((&depth).into());
        if let Some(rgb) = &rgb {
            shot = shot.with_rgb(rgb.into())?;
        }
        if let Some(positions) = &positions {
            shot = shot.with_positions(positions.into())?;
        }
        (shot.frame, shot.item) = (self.frame, self.item);
        let wanted = Wanted {
            positions: self.out.positions.is_some(),
            colors: self.out.colors.is_some(),
            imager: self.out.imager.is_some(),
            view: self.out.view.is_some(),
            reasons: false,
            confidence: false,
        };
        let output = sensor.sense(&shot, &Stream::new(self.seed, &self.camera), wanted);
        files::write(&self.out.distance, &output.distance.0)?;
        let mut written = vec!["distance"];
        let mut done = |name, is_written: bool| written.extend(is_written.then_some(name));
        done(
            "positions",
            write4(self.out.positions.as_deref(), output.positions.as_ref())?,
        );
        done(
            "colors",
            write4(self.out.colors.as_deref(), output.colors.as_ref())?,
        );
        done("view", write4(self.out.view.as_deref(), output.view.as_ref())?);
        let imager = self.out.imager.as_deref().zip(output.imager.as_ref());
        if let Some((path, image)) = imager {
            files::write(path, image)?;
        }
        done("imager", imager.is_some());
        Ok(json!({ "written": written, "center_m": output.center_m() }))
    }
}

/// Writes an image if it exists and its file is requested.
fn write4<T: npy::NpyElement>(
    path: Option<&Path>,
    image: Option<&Image<[T; 4]>>,
) -> Result<bool, Box<dyn Error>> {
    let Some((path, image)) = path.zip(image) else {
        return Ok(false);
    };
    files::write_channels(path, image)?;
    Ok(true)
}

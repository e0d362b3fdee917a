//! What is reported of a camera.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use oaktwin::camera::Usd;
use oaktwin::render::PlacedCamera;
use oaktwin::sensor::Sensor;
use serde::Serialize;

#[derive(Debug, Serialize)]
pub(super) struct RenderedCameraReport<'a> {
    pub(super) path: &'a str,
    pub(super) folder: Option<PathBuf>,
    pub(super) resolution: [u32; 2],
    fx: f64,
    fy: f64,
    /// The principal point in OpenUSD's convention: the first pixel's centre is at 0.5.
    cx: f64,
    cy: f64,
    lens: &'static str,
    /// The depth sensor, if its outputs are rendered.
    #[serde(skip_serializing_if = "Option::is_none")]
    depth_sensor: Option<RenderedSensorReport>,
}

#[derive(Debug, Serialize)]
struct RenderedSensorReport {
    engine: String,
    /// The parameters by the names of `--param`.
    parameters: BTreeMap<&'static str, String>,
}

impl<'a> RenderedCameraReport<'a> {
    pub(super) fn new(
        camera: &'a PlacedCamera,
        sensor: Option<&Sensor>,
        output: Option<&Path>,
        is_flat: bool,
    ) -> Self {
        let intrinsics = camera.camera.intrinsics;
        let centre = intrinsics.principal_point::<Usd>();
        Self {
            path: &camera.path,
            folder: output.map(|output| {
                if is_flat {
                    output.to_owned()
                } else {
                    output.join(&camera.folder)
                }
            }),
            resolution: [intrinsics.size.width, intrinsics.size.height],
            fx: intrinsics.fx,
            fy: intrinsics.fy,
            cx: centre.x,
            cy: centre.y,
            lens: camera.camera.lens.names().schema,
            depth_sensor: sensor.map(RenderedSensorReport::new),
        }
    }
}

impl RenderedSensorReport {
    fn new(sensor: &Sensor) -> Self {
        Self {
            engine: sensor.engine().kind().name.to_string(),
            parameters: sensor.engine().parameters().into_iter().collect(),
        }
    }
}

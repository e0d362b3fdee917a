use serde::Serialize;

use oaktwin_base::parameter::nvidia::Attributes;
use oaktwin_base::parameter::{Kind, Table};
use oaktwin_camera::StereoGeometry;
use oaktwin_catalog::{DepthKind, Latency, MatchingMode, Role, Source, Sources, Twin, TwinDepthSensor};

/// One depth sensor: its attributes and derived ranges.
#[derive(Clone, Debug, Serialize)]
pub struct DepthReport {
    /// The prim of its virtual camera.
    pub prim: String,
    /// The principle of measurement.
    pub kind: DepthKind,
    /// The camera whose optics and pose it has.
    pub camera: Role,
    /// The attributes of its render product: names without `omni:rtx:post:depthSensor:`.
    pub attributes: Vec<AttributeReport>,
    /// The nearest depth of the standard disparity range, `f b / maxDisparityPixel`, m.
    pub min_z_m: f64,
    /// The same with extended disparity, m, if the device has it: twice the maximum disparity, 190 of 191 levels.
    pub extended_min_z_m: Option<f64>,
    /// The farthest depth that a whole pixel of disparity resolves, by the vendor's formula
    /// `b/2 · tan(90° − HFOV / W)`, m.
    pub max_z_m: f64,
    /// The vendor's recommended range, m.
    pub ideal_range_m: (f64, f64),
    /// Disparity and depth steps at some distances.
    pub at: Vec<AtDistance>,
    /// The latency in the default mode, over the device's connection, if sources state it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub latency: Option<Latency>,
    /// The source of the catalog's values.
    pub source: Source,
    /// The keys with another source.
    pub sources: Sources,
}

/// One attribute.
#[derive(Clone, Debug, Serialize)]
pub struct AttributeReport {
    /// The name in the parameter sheet.
    pub name: &'static str,
    /// The value.
    pub value: f64,
    /// What it means, with its unit.
    pub meaning: String,
}

/// Disparity and depth steps at one distance.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct AtDistance {
    /// The distance, m.
    pub z_m: f64,
    /// `f b / z`, px.
    pub disparity_px: f64,
    /// The depth step to the next smaller whole-pixel disparity, m; absent beyond one pixel.
    pub step_px_m: Option<f64>,
    /// The same for 1/32 px, the finest subpixel setting, m.
    pub step_subpixel_m: Option<f64>,
}

/// The distances of the depth steps.
const DISTANCES_M: [f64; 4] = [1.0, 4.0, 8.0, 12.0];

impl DepthReport {
    pub(super) fn new(twin: &Twin, sensor: &TwinDepthSensor) -> Self {
        let spec = &sensor.spec;
        let geometry = StereoGeometry {
            focal_length_px: sensor.focal_length_px,
            baseline_m: spec.baseline_mm * 1e-3,
        };
        let hfov = twin
            .depth_camera(sensor)
            .map_or(0.0, |camera| camera.intrinsics.hfov());
        Self {
            prim: spec.prim.clone(),
            kind: spec.kind,
            camera: spec.camera,
            attributes: attributes(sensor),
            min_z_m: geometry.depth(spec.max_disparity_px),
            extended_min_z_m: spec
                .extended_max_disparity_px
                .map(|_| geometry.depth(2.0 * spec.max_disparity_px)),
            max_z_m: geometry.baseline_m / 2.0 / (hfov / spec.sensor_size_px).tan(),
            ideal_range_m: spec.ideal_range_m,
            at: DISTANCES_M
                .iter()
                .map(|&z_m| AtDistance {
                    z_m,
                    disparity_px: geometry.disparity(z_m),
                    step_px_m: finite(geometry.depth_step(z_m, 1.0)),
                    step_subpixel_m: finite(geometry.depth_step(z_m, 1.0 / 32.0)),
                })
                .collect(),
            latency: latency(twin, sensor),
            source: spec.source,
            sources: spec.sources.clone(),
        }
    }
}

fn latency(twin: &Twin, sensor: &TwinDepthSensor) -> Option<Latency> {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a width in pixels"
    )]
    let width_px = sensor.spec.sensor_size_px as u32;
    twin.device
        .latency(sensor.spec.kind, MatchingMode::default(), width_px, None)
}

fn finite(value: f64) -> Option<f64> {
    value.is_finite().then_some(value)
}

fn attributes(sensor: &TwinDepthSensor) -> Vec<AttributeReport> {
    let values = sensor.attributes(false);
    let rows = Attributes::rows().filter(|row| matches!(row.about.kind, Kind::Number | Kind::Integer));
    rows.map(|row| {
        let about = &row.about;
        let in_unit = if about.unit.is_empty() { "" } else { ", " };
        AttributeReport {
            name: if about.alias.is_empty() {
                about.name
            } else {
                about.alias
            },
            value: (row.numbers)(&values)[0],
            meaning: format!("{}{in_unit}{}", about.summary(), about.unit),
        }
    })
    .collect()
}

//! Everything known about one device: the output of `oaktwin show`.

mod camera;
mod depth;

use serde::Serialize;

use oaktwin_base::diagnostic::Finding;
use oaktwin_camera::math::DVec3;
use oaktwin_catalog::{
    Accuracy, Body, Catalog, Evidence, Imu, Note, Origin, Role, Sensor, Source, Sources, Twin,
};
use oaktwin_usd::asset::LensChoice;

pub use camera::{CameraReport, OffsetsReport, PixelReport, UsdReport};
pub use depth::{AtDistance, AttributeReport, DepthReport};

/// Everything known about one device.
#[derive(Clone, Debug, Serialize)]
pub struct DeviceReport {
    /// The catalog id, which is the stem of the asset's file.
    pub id: String,
    /// The name.
    pub name: String,
    /// The prim below `/Root` in the asset.
    pub prim: String,
    /// The manufacturer.
    pub manufacturer: String,
    /// `RVC2` or `RVC4`; of other makers, the family.
    pub generation: String,
    /// The processor, if it is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub platform: Option<String>,
    /// The variant of lens and focus.
    pub variant: String,
    /// The origin of the camera parameters: `nominal`, or the calibration's file and product name.
    pub origin: String,
    /// The nominal baseline in mm, if the device has a stereo pair.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub nominal_baseline_mm: Option<f64>,
    /// The baseline of this twin in mm, if the device has a stereo pair.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub baseline_mm: Option<f64>,
    /// The body.
    pub body: Body,
    /// The inertial unit, if its pose is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub imu: Option<Imu>,
    /// The image sensors.
    pub sensors: Vec<Sensor>,
    /// The cameras.
    pub cameras: Vec<CameraReport>,
    /// The depth sensors.
    pub depth_sensors: Vec<DepthReport>,
    /// The published accuracy, one table per source.
    pub accuracy: Vec<Accuracy>,
    /// Other sources about a value.
    pub evidence: Vec<Evidence>,
    /// Notes about the numbers, including conflicts of sources.
    pub notes: Vec<Note>,
    /// The findings about a calibration.
    pub findings: Vec<Finding>,
    /// The source of the device's own values.
    pub source: Source,
    /// The keys with another source.
    pub sources: Sources,
}

impl DeviceReport {
    /// Creates the report of a twin with the lens of its asset; `findings` are about its calibration.
    #[must_use]
    pub fn new(catalog: &Catalog, twin: &Twin, lens: LensChoice, findings: Vec<Finding>) -> Self {
        let device = &twin.device;
        let mut sensors: Vec<Sensor> = Vec::new();
        for camera in &device.cameras {
            if let Some(sensor) = catalog.sensor(&camera.sensor)
                && !sensors.contains(sensor)
            {
                sensors.push(sensor.clone());
            }
        }
        Self {
            id: device.id.clone(),
            name: device.name.clone(),
            prim: device.prim.clone(),
            manufacturer: device.manufacturer.clone(),
            generation: device.generation.clone(),
            platform: device.platform.clone(),
            variant: device.variant.clone(),
            origin: match &twin.origin {
                Origin::Nominal => "nominal".to_owned(),
                Origin::Calibration {
                    product_name,
                    file_name,
                } => format!("{file_name} ({product_name})"),
            },
            nominal_baseline_mm: device.stereo_baseline_mm,
            baseline_mm: twin
                .baseline_m((Role::Left, Role::Right))
                .map(|metres| metres * 1e3),
            body: device.body.clone(),
            imu: imu(twin),
            cameras: twin
                .cameras
                .iter()
                .map(|camera| CameraReport::new(twin, camera, lens))
                .collect(),
            depth_sensors: twin
                .depth_sensors
                .iter()
                .map(|sensor| DepthReport::new(twin, sensor))
                .collect(),
            accuracy: device.accuracy.clone(),
            evidence: device.evidence.clone(),
            notes: device.notes.clone(),
            findings,
            source: device.source,
            sources: device.sources.clone(),
            sensors,
        }
    }
}

/// The inertial unit, with its pose from a calibration.
fn imu(twin: &Twin) -> Option<Imu> {
    let mut imu = twin.device.imu.clone()?;
    let body_from_imu = twin.body_from_imu?;
    let position_mm = body_from_imu.translation * 1e3;
    let rotation = body_from_imu.rotation.transpose().to_cols_array_2d();
    if position_mm.distance(DVec3::from(imu.position_mm)) > 1e-6 || rotation != imu.rotation {
        imu.position_mm = position_mm.to_array();
        imu.rotation = rotation;
        imu.board_file_rotation = None;
        for key in ["position_mm", "rotation"] {
            imu.sources.insert(key.to_owned(), Source::CalibrationExport);
        }
    }
    Some(imu)
}

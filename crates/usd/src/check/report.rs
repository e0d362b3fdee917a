use oaktwin_base::diagnostic::{Finding, Level};
use oaktwin_camera::{ImageSize, Intrinsics, Usd};
use serde::Serialize;

use super::depth::Parameters;
use super::scene::{CheckedCamera, CheckedDepthSensor, CheckedScene, Generation, ResolutionSource};
use crate::lens::Lens;
use crate::nvidia::{CAMERA_SCHEMA, PRODUCT_SCHEMA};
use crate::stage::StageMetadata;

/// The result of checking a file.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CheckReport {
    /// The file's path as given by the caller.
    pub file: String,
    /// The root layer's metadata.
    pub stage: StageMetadata,
    /// The cameras, in stage order.
    pub cameras: Vec<UsdCameraReport>,
    /// The depth sensors, in stage order.
    pub depth_sensors: Vec<UsdDepthReport>,
    /// The findings: errors, warnings, then notes, each sorted by place.
    pub findings: Vec<Finding>,
}

/// A camera as interpreted by Isaac Sim and by OpenUSD.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct UsdCameraReport {
    /// The path of the camera prim.
    pub path: String,
    /// The name of the model that it was checked against, if given or recognised.
    pub model: Option<String>,
    /// The image size that the intrinsics apply to.
    pub resolution: ImageSize,
    /// The source of that size.
    pub resolution_from: ResolutionSource,
    /// Isaac Sim's intrinsics: square pixels, centred. `None` if the attributes are invalid or the camera is not
    /// perspective.
    pub isaac: Option<PinholeReport>,
    /// OpenUSD's intrinsics: each axis by its aperture, with aperture offsets.
    pub openusd: Option<PinholeReport>,
    /// The lens-distortion schema, whose parameters Isaac Sim's renderer uses instead.
    pub lens: Option<LensReport>,
}

/// Pinhole intrinsics at the report's resolution.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct PinholeReport {
    /// The horizontal focal length, px.
    pub fx: f64,
    /// The vertical focal length, px.
    pub fy: f64,
    /// The principal point's x, px (the first pixel centre is at 0.5).
    pub cx: f64,
    /// The principal point's y, px (the first pixel centre is at 0.5).
    pub cy: f64,
    /// The horizontal field of view, degrees.
    pub hfov_deg: f64,
    /// The vertical field of view, degrees.
    pub vfov_deg: f64,
    /// The diagonal field of view, degrees.
    pub dfov_deg: f64,
}

/// A lens-distortion schema, with fallbacks for unauthored attributes.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LensReport {
    /// The schema, such as `OmniLensDistortionOpenCvPinholeAPI`.
    pub schema: String,
    /// The model token, such as `opencvPinhole`.
    pub model: String,
    /// The image size that the parameters apply to.
    pub image_size: Option<ImageSize>,
    /// fx, fy, cx and cy of the OpenCV models, px (the first pixel centre is at 0).
    pub intrinsics: Option<[f64; 4]>,
    /// The coefficients of the OpenCV models, in the schema's order.
    pub coefficients: Vec<f64>,
}

/// A depth sensor.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct UsdDepthReport {
    /// The path of the prim that carries its attributes.
    pub path: String,
    /// The schema.
    pub schema: &'static str,
    /// The paths of the cameras that its product targets, or of the camera that carries it.
    pub cameras: Vec<String>,
    /// The rendered image size.
    pub resolution: Option<ImageSize>,
    /// `baselineMM`. This and the following are authored values, or else the schema's defaults in Isaac Sim 5.1.
    pub baseline_mm: f64,
    /// `focalLengthPixel`.
    pub focal_length_px: f64,
    /// `sensorSizePixel`.
    pub sensor_size_px: f64,
    /// `maxDisparityPixel`.
    pub max_disparity_px: f64,
    /// `minDistance`, m.
    pub min_distance_m: f64,
    /// `maxDistance`, m.
    pub max_distance_m: f64,
    /// The distance at which disparity reaches `maxDisparityPixel`, in metres.
    pub nearest_by_disparity_m: f64,
}

impl CheckReport {
    /// Returns the most severe level among the findings.
    #[must_use]
    pub fn worst(&self) -> Option<Level> {
        self.findings.iter().map(|finding| finding.level).max()
    }
}

pub(super) fn report(scene: &CheckedScene<'_>, findings: Vec<Finding>) -> CheckReport {
    CheckReport {
        file: scene.stage.file.clone(),
        stage: scene.stage.metadata.clone(),
        cameras: scene.cameras.iter().map(camera_report).collect(),
        depth_sensors: scene
            .depth_sensors
            .iter()
            .map(|sensor| depth_report(scene, sensor))
            .collect(),
        findings,
    }
}

fn camera_report(camera: &CheckedCamera<'_>) -> UsdCameraReport {
    let optics = camera.camera.optics();
    let perspective = camera.camera.is_perspective();
    let view = |k: Intrinsics| {
        let sound = [k.fx, k.fy].iter().all(|f| f.is_finite() && *f > 0.0);
        let c = k.principal_point::<Usd>();
        let view = PinholeReport {
            fx: k.fx,
            fy: k.fy,
            cx: c.x,
            cy: c.y,
            hfov_deg: k.hfov().to_degrees(),
            vfov_deg: k.vfov().to_degrees(),
            dfov_deg: k.dfov().to_degrees(),
        };
        (perspective && sound && c.x.is_finite() && c.y.is_finite()).then_some(view)
    };
    UsdCameraReport {
        path: camera.path().to_owned(),
        model: camera.known.map(|known| known.twin.device.name.clone()),
        resolution: camera.resolution,
        resolution_from: camera.resolution_from.clone(),
        isaac: view(optics.isaac_intrinsics(camera.resolution)),
        openusd: view(optics.openusd_intrinsics(camera.resolution)),
        lens: camera.lens.as_ref().map(lens_report),
    }
}

fn lens_report(lens: &Lens) -> LensReport {
    LensReport {
        schema: lens.schema.to_owned(),
        model: lens.model.to_owned(),
        image_size: lens.image_size,
        intrinsics: lens.parameters,
        coefficients: lens.coefficients.clone(),
    }
}

fn depth_report(scene: &CheckedScene<'_>, sensor: &CheckedDepthSensor<'_>) -> UsdDepthReport {
    let parameters = Parameters::of(sensor);
    // The shortest decimal that identifies the float: 0.2 rather than 0.20000000298.
    let decimal = |name| {
        let value = parameters.get(name);
        super::num(value).parse().unwrap_or(value)
    };
    let cameras = match (sensor.generation, sensor.product) {
        (Generation::Product, Some(product)) => {
            product.cameras.iter().map(|target| target.path.clone()).collect()
        }
        _ => scene
            .camera(sensor)
            .map(|camera| camera.path().to_owned())
            .into_iter()
            .collect(),
    };
    UsdDepthReport {
        path: sensor.prim.path.clone(),
        schema: match sensor.generation {
            Generation::Product => PRODUCT_SCHEMA,
            Generation::Camera => CAMERA_SCHEMA,
        },
        cameras,
        resolution: sensor.product.and_then(crate::stage::RenderProduct::resolution),
        baseline_mm: decimal("baselineMM"),
        focal_length_px: decimal("focalLengthPixel"),
        sensor_size_px: decimal("sensorSizePixel"),
        max_disparity_px: decimal("maxDisparityPixel"),
        min_distance_m: decimal("minDistance"),
        max_distance_m: decimal("maxDistance"),
        nearest_by_disparity_m: parameters.nearest_by_disparity_m(),
    }
}

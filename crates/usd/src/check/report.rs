use oaktwin_camera::{ImageSize, Intrinsics, Usd};
use oaktwin_diagnostic::{Finding, Level};
use serde::Serialize;

use super::depth::Parameters;
use super::scene::{CheckedCamera, DepthSensor, Generation, Scene};
use super::schema::{CAMERA_SCHEMA, PRODUCT_SCHEMA};
use crate::lens::Lens;
use crate::stage::StageMetadata;

/// What `check` has to say about a file.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Report {
    /// The file as the caller named it.
    pub file: String,
    /// What its root layer says about the whole.
    pub stage: StageMetadata,
    /// Its cameras, in the order of the stage.
    pub cameras: Vec<CameraReport>,
    /// Its depth sensors, in the order of the stage.
    pub depth_sensors: Vec<DepthReport>,
    /// What was found: errors first, then warnings, then notes, each by place.
    pub findings: Vec<Finding>,
}

/// A camera as both sides see it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CameraReport {
    /// Its prim.
    pub path: String,
    /// The model it was checked against, if one was given or recognised.
    pub model: Option<String>,
    /// The image that the intrinsics hold for.
    pub resolution: ImageSize,
    /// Where that size comes from.
    pub resolution_from: ResolutionSource,
    /// As Isaac Sim's renderer takes focal length and apertures: square pixels, centred. Absent where they are not
    /// usable or the camera is not a perspective one.
    pub isaac: Option<View>,
    /// As OpenUSD projects: each axis by its aperture, moved by the offsets.
    pub openusd: Option<View>,
    /// Its lens-distortion schema, whose parameters Isaac Sim's renderer takes instead.
    pub lens: Option<LensReport>,
}

/// Where a camera's image size comes from.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum ResolutionSource {
    /// The render product of this path.
    Product(String),
    /// The catalog's entry.
    Catalog,
    /// The lens schema's `imageSize`.
    LensSchema,
    /// 1280 columns and as many rows as the apertures' ratio says.
    Apertures,
}

/// Pinhole intrinsics on the report's resolution.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct View {
    /// Horizontal focal length, px.
    pub fx: f64,
    /// Vertical focal length, px.
    pub fy: f64,
    /// The principal point from the left edge, px (the first pixel's centre is at 0.5).
    pub cx: f64,
    /// The principal point from the top edge, px (likewise).
    pub cy: f64,
    /// Horizontal field of view, degrees.
    pub hfov_deg: f64,
    /// Vertical field of view, degrees.
    pub vfov_deg: f64,
    /// Diagonal field of view, degrees.
    pub dfov_deg: f64,
}

/// A lens-distortion schema as authored, fallbacks filled in.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LensReport {
    /// `OmniLensDistortionOpenCvPinholeAPI`.
    pub schema: String,
    /// `opencvPinhole`.
    pub model: String,
    /// The size that the parameters hold for.
    pub image_size: Option<ImageSize>,
    /// fx, fy, cx, cy of the OpenCV models, px (the first pixel's centre is at 0).
    pub intrinsics: Option<[f64; 4]>,
    /// The OpenCV models' coefficients, in the schema's order.
    pub coefficients: Vec<f64>,
}

/// A depth sensor.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct DepthReport {
    /// The prim that carries its attributes.
    pub path: String,
    /// Whose schema it follows.
    pub schema: &'static str,
    /// The cameras that its product targets, or the camera that carries it.
    pub cameras: Vec<String>,
    /// What is rendered.
    pub resolution: Option<ImageSize>,
    /// `baselineMM`, as the following authored or else the schema's fallback of Isaac Sim 5.1.
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
    /// The distance at which disparity reaches `maxDisparityPixel`, m.
    pub nearest_by_disparity_m: f64,
}

impl Report {
    /// The worst level among the findings.
    #[must_use]
    pub fn worst(&self) -> Option<Level> {
        self.findings.iter().map(|finding| finding.level).max()
    }

    /// How many findings have this level.
    #[must_use]
    pub fn count(&self, level: Level) -> usize {
        self.findings
            .iter()
            .filter(|finding| finding.level == level)
            .count()
    }
}

pub(super) fn report(scene: &Scene<'_>, findings: Vec<Finding>) -> Report {
    Report {
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

fn camera_report(camera: &CheckedCamera<'_>) -> CameraReport {
    let optics = camera.camera.optics();
    let perspective = camera.camera.is_perspective();
    let view = |k: Intrinsics| {
        let sound = [k.fx, k.fy].iter().all(|f| f.is_finite() && *f > 0.0);
        let c = k.principal_point::<Usd>();
        let view = View {
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
    CameraReport {
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

fn depth_report(scene: &Scene<'_>, sensor: &DepthSensor<'_>) -> DepthReport {
    let parameters = Parameters::of(sensor);
    // As the file writes it: 0.2, not the double nearest to the float nearest to it.
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
    DepthReport {
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

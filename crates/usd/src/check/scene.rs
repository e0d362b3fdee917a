//! Links the parts of a stage: cameras with their products, lenses and catalog entries, and depth sensors with their
//! cameras.

use std::path::Path;

use oaktwin_camera::{ApertureOffsets, ImageSize, UsdOptics};
use oaktwin_catalog::{Twin, TwinCamera, TwinDepthSensor};
use serde::Serialize;

use crate::asset::PrimNames;
use crate::lens::Lens;
use crate::nvidia::{CAMERA_NAMESPACE, CAMERA_SCHEMA, PRODUCT_NAMESPACE, PRODUCT_SCHEMA};
use crate::stage::{Prim, RenderProduct, SceneCamera, Stage};

/// OpenUSD's fallback for `metersPerUnit`.
pub(super) const FALLBACK_METERS_PER_UNIT: f64 = 0.01;

pub(super) struct CheckedScene<'a> {
    pub stage: &'a Stage,
    pub cameras: Vec<CheckedCamera<'a>>,
    pub depth_sensors: Vec<CheckedDepthSensor<'a>>,
}

/// A camera with its lens, catalog entry and products.
pub(super) struct CheckedCamera<'a> {
    pub camera: &'a SceneCamera,
    pub lens: Option<Lens>,
    pub known: Option<Known<'a>>,
    /// The products that render it, with their resolutions.
    pub products: Vec<(&'a RenderProduct, ImageSize)>,
    pub resolution: ImageSize,
    pub resolution_from: ResolutionSource,
}

/// The catalog's entry of a camera prim.
#[derive(Clone, Copy)]
pub(super) struct Known<'a> {
    pub twin: &'a Twin,
    /// The camera that provides the optics.
    pub camera: &'a TwinCamera,
    /// The depth sensor, if the prim is its virtual camera.
    pub sensor: Option<&'a TwinDepthSensor>,
}

impl Known<'_> {
    /// Returns the nominal optical attributes.
    pub(super) fn optics(&self) -> UsdOptics {
        UsdOptics::from_intrinsics(
            &self.camera.intrinsics,
            self.camera.pixel_size_um,
            ApertureOffsets::Zero,
        )
    }
}

/// A prim with a depth sensor's attributes, and the sensor's camera.
pub(super) struct CheckedDepthSensor<'a> {
    pub prim: &'a Prim,
    pub generation: Generation,
    pub product: Option<&'a RenderProduct>,
    /// The camera's index in [`CheckedScene::cameras`].
    pub camera: Option<usize>,
    pub known: Option<&'a TwinDepthSensor>,
}

/// The schema of a depth sensor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Generation {
    /// Kit's schema, on the render product.
    Product,
    /// ovrtx's schema, on the camera.
    Camera,
}

/// The source of a camera's image size.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum ResolutionSource {
    /// The render product of this path.
    Product(String),
    /// The catalog.
    Catalog,
    /// The lens schema's `imageSize`.
    LensSchema,
    /// A width of 1280 px with the apertures' aspect ratio.
    Apertures,
}

impl Generation {
    pub(super) const fn namespace(self) -> &'static str {
        match self {
            Self::Product => PRODUCT_NAMESPACE,
            Self::Camera => CAMERA_NAMESPACE,
        }
    }
}

impl<'a> CheckedScene<'a> {
    pub(super) fn new(stage: &'a Stage, twins: &'a [Twin], model: Option<&'a Twin>) -> Self {
        let cameras: Vec<CheckedCamera> = stage
            .cameras
            .iter()
            .map(|camera| {
                let twin = model.or_else(|| recognise(stage, &camera.prim.path, twins));
                CheckedCamera::new(
                    stage,
                    camera,
                    twin.and_then(|twin| known(twin, camera.prim.name())),
                )
            })
            .collect();
        let position = |path: &str| cameras.iter().position(|camera| camera.camera.prim.path == path);
        let sensor_of = |camera: Option<usize>| cameras.get(camera?)?.known?.sensor;
        let mut depth_sensors = Vec::new();
        for product in &stage.products {
            let prim = &product.prim;
            if prim.has_api(PRODUCT_SCHEMA) || prim.in_namespace(PRODUCT_NAMESPACE).next().is_some() {
                let camera = match &product.cameras[..] {
                    [target] => position(&target.path),
                    _ => None,
                };
                depth_sensors.push(CheckedDepthSensor {
                    prim,
                    generation: Generation::Product,
                    product: Some(product),
                    camera,
                    known: sensor_of(camera),
                });
            }
        }
        for (index, camera) in stage.cameras.iter().enumerate() {
            let prim = &camera.prim;
            if prim.has_api(CAMERA_SCHEMA) || prim.in_namespace(CAMERA_NAMESPACE).next().is_some() {
                depth_sensors.push(CheckedDepthSensor {
                    prim,
                    generation: Generation::Camera,
                    product: cameras[index].products.first().map(|(product, _)| *product),
                    camera: Some(index),
                    known: sensor_of(Some(index)),
                });
            }
        }
        Self {
            stage,
            cameras,
            depth_sensors,
        }
    }

    pub(super) fn camera(&self, sensor: &CheckedDepthSensor<'_>) -> Option<&CheckedCamera<'a>> {
        self.cameras.get(sensor.camera?)
    }

    /// Returns the stage unit in metres.
    pub(super) fn meters_per_unit(&self) -> f64 {
        self.stage
            .metadata
            .meters_per_unit
            .unwrap_or(FALLBACK_METERS_PER_UNIT)
    }
}

impl<'a> CheckedCamera<'a> {
    fn new(stage: &'a Stage, camera: &'a SceneCamera, known: Option<Known<'a>>) -> Self {
        let lens = Lens::of(&camera.prim);
        let products: Vec<(&RenderProduct, ImageSize)> = stage
            .products
            .iter()
            .filter(|product| {
                product
                    .cameras
                    .iter()
                    .any(|target| target.path == camera.prim.path)
            })
            .filter_map(|product| Some((product, product.resolution()?)))
            .collect();
        let lens_size = lens.as_ref().and_then(|lens| lens.image_size);
        let (resolution, resolution_from) = if let Some((product, size)) = products.first() {
            (*size, ResolutionSource::Product(product.prim.path.clone()))
        } else if let Some(known) = known {
            (known.camera.intrinsics.size, ResolutionSource::Catalog)
        } else if let Some(size) = lens_size {
            (size, ResolutionSource::LensSchema)
        } else {
            (size_by_apertures(camera), ResolutionSource::Apertures)
        };
        Self {
            camera,
            lens,
            known,
            products,
            resolution,
            resolution_from,
        }
    }

    pub(super) fn path(&self) -> &str {
        &self.camera.prim.path
    }

    /// Returns the size of the camera's own image, independent of render products.
    pub(super) fn own_size(&self) -> Option<ImageSize> {
        let lens = self.lens.as_ref().and_then(|lens| lens.image_size);
        lens.or_else(|| Some(self.known?.camera.intrinsics.size))
    }

    /// Whether it has the values of one unit rather than of the model: a lens schema or an off-centre principal point.
    pub(super) fn is_calibrated(&self) -> bool {
        self.lens.is_some() || self.camera.aperture_offsets() != (0.0, 0.0)
    }
}

/// Returns an image size 1280 px wide with the apertures' aspect ratio.
fn size_by_apertures(camera: &SceneCamera) -> ImageSize {
    const WIDTH: u32 = 1280;
    let rows = f64::from(WIDTH) * camera.vertical_aperture() / camera.horizontal_aperture();
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "clamped; a NaN becomes 0, then 1"
    )]
    let height = (rows.round().clamp(1.0, 100_000.0) as u32).max(1);
    ImageSize::new(WIDTH, height)
}

/// Returns the device that a prim in the path, the file or the default prim is named after.
fn recognise<'a>(stage: &Stage, path: &str, twins: &'a [Twin]) -> Option<&'a Twin> {
    let by_path = twins
        .iter()
        .find(|twin| path.split('/').any(|part| part == twin.device.prim));
    by_path.or_else(|| {
        let stem = Path::new(&stage.file).file_stem()?.to_str()?;
        let named = |name: &str| name == stem || Some(name) == stage.metadata.default_prim.as_deref();
        twins
            .iter()
            .find(|twin| named(&twin.device.id) || named(&twin.device.prim))
    })
}

/// Returns the catalog entry of a camera prim, by the name in the sheet or in Isaac Sim's asset.
fn known<'a>(twin: &'a Twin, name: &str) -> Option<Known<'a>> {
    let is = |spec: &str| spec == name || PrimNames::Isaac.of(spec) == name;
    let camera = twin.cameras.iter().find(|camera| is(&camera.spec.prim));
    let sensor = twin.depth_sensors.iter().find(|sensor| is(&sensor.spec.prim));
    match (camera, sensor) {
        (Some(camera), _) => Some(Known {
            twin,
            camera,
            sensor: None,
        }),
        (None, Some(sensor)) => Some(Known {
            twin,
            camera: twin.camera(sensor.spec.camera)?,
            sensor: Some(sensor),
        }),
        (None, None) => None,
    }
}

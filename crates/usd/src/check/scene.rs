//! The stage with its parts joined: cameras with their products, lenses and catalog entries, depth sensors with
//! their cameras.

use std::path::Path;

use oaktwin_camera::{ApertureOffsets, ImageSize, UsdOptics};
use oaktwin_catalog::{Twin, TwinCamera, TwinDepthSensor};

use super::report::ResolutionSource;
use super::schema::{CAMERA_NAMESPACE, CAMERA_SCHEMA, PRODUCT_NAMESPACE, PRODUCT_SCHEMA};
use crate::asset::PrimNames;
use crate::lens::Lens;
use crate::stage::{Prim, RenderProduct, SceneCamera, Stage};

/// OpenUSD's fallback for `metersPerUnit`.
pub(super) const FALLBACK_METERS_PER_UNIT: f64 = 0.01;

pub(super) struct Scene<'a> {
    pub stage: &'a Stage,
    pub cameras: Vec<CheckedCamera<'a>>,
    pub depth_sensors: Vec<DepthSensor<'a>>,
}

/// A camera and all that is known about it.
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
    /// The camera whose optics it has.
    pub camera: &'a TwinCamera,
    /// The depth sensor, where the prim is its virtual camera.
    pub sensor: Option<&'a TwinDepthSensor>,
}

impl Known<'_> {
    /// What the camera's optical attributes nominally are.
    pub(super) fn optics(&self) -> UsdOptics {
        UsdOptics::from_intrinsics(
            &self.camera.intrinsics,
            self.camera.pixel_size_um,
            ApertureOffsets::Zero,
        )
    }
}

/// The prim that carries a depth sensor's attributes, and the camera it is about.
pub(super) struct DepthSensor<'a> {
    pub prim: &'a Prim,
    pub generation: Generation,
    pub product: Option<&'a RenderProduct>,
    /// Its place in [`Scene::cameras`].
    pub camera: Option<usize>,
    pub known: Option<&'a TwinDepthSensor>,
}

/// Whose schema a depth sensor follows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Generation {
    /// Kit's, on the render product.
    Product,
    /// ovrtx's, on the camera.
    Camera,
}

impl<'a> Scene<'a> {
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
                depth_sensors.push(DepthSensor {
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
                depth_sensors.push(DepthSensor {
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

    pub(super) fn camera(&self, sensor: &DepthSensor<'_>) -> Option<&CheckedCamera<'a>> {
        self.cameras.get(sensor.camera?)
    }

    /// Metres in a stage unit.
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

    /// The size of the camera's own image, whatever is rendered of it.
    pub(super) fn own_size(&self) -> Option<ImageSize> {
        let lens = self.lens.as_ref().and_then(|lens| lens.image_size);
        lens.or_else(|| Some(self.known?.camera.intrinsics.size))
    }

    /// Whether it has the numbers of one unit rather than the model's: a lens schema, or a moved principal point.
    pub(super) fn is_calibrated(&self) -> bool {
        self.lens.is_some() || self.camera.aperture_offsets() != (0.0, 0.0)
    }
}

/// 1280 columns, and as many rows as the apertures' ratio says.
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

/// The device that a path leads through, or that the file is named after.
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

/// The catalog's entry of a camera prim, by the sheet's name or by that of Isaac Sim's own asset.
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

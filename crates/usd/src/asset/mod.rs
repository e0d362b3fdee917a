//! The USD asset of an OAK camera, written from a [`Twin`].
//!
//! # Contents
//! ```text
//! /Root                                     Xform, default prim
//! └── oak_d_pro                             Xform; with a rigid body: mass, collider
//!     ├── Camera_pseudo_depth               Camera: optics and pose of the left one
//!     ├── Camera_rgb_imx378, …              Camera
//!     ├── Imu_Sensor                        IsaacImuSensor
//!     ├── visuals, Looks                    the body, its materials
//!     ├── collisions                        with a rigid body
//!     └── TemplateRenderProducts            Scope
//!         └── Camera_pseudo_depth_render_product   RenderProduct with the depth sensor's schema
//! ```
//! Names and values come from Luxonis' parameter sheet. The stage is Z up and in metres. The origin lies midway
//! between the left and right optical centres; x is forward, y left, z up.
//!
//! # Numbers
//! Optics are computed in `f64` and written as the nearest `f32`: `focalLength = 4.762592` where the sheet prints
//! 4.7626. Rounding to the sheet's four decimals would move fx by up to 0.03 px, and the field of view with it. Focal
//! lengths, apertures and offsets are in *millimetres*, as in the vendor's assets, although OpenUSD defines these
//! attributes in tenths of a stage unit: projection depends on ratios alone, and `fStop = 0` disables depth of field,
//! which does not.

mod base;
mod camera;
mod depth;
mod describe;
mod error;
mod files;
mod geometry;
mod guard;
mod imu;
mod lens;
mod names;
mod options;
mod overrides;
mod physics;
mod pose;

#[cfg(test)]
pub(crate) mod sample;
#[cfg(test)]
mod tests;

use oaktwin_base::diagnostic::Finding;
use oaktwin_catalog::{Origin, Twin};

pub use error::AssetError;
pub use files::{AssetFile, files};
pub use names::{PrimNames, render_product_name};
pub use oaktwin_catalog::LensChoice;
pub use options::{AssetOptions, AssetTarget, Format, IsaacVersion};
pub use overrides::{OverrideBase, overrides};

use crate::body;
use crate::text::{Dictionary, Layer, PrimSpec, SpecValue, UpAxis};
use crate::usdz;

/// The name of the default prim.
pub const ROOT: &str = "Root";
/// The name of the scope of render products.
pub const PRODUCTS: &str = "TemplateRenderProducts";
/// The name of the inertial sensor's prim.
pub const IMU: &str = "Imu_Sensor";

/// An asset, ready to be written.
#[derive(Clone, Debug, PartialEq)]
pub struct Asset {
    /// The file name without its extension, such as `oak_d_pro_poe`.
    pub stem: String,
    /// The layer.
    pub layer: Layer,
    /// Notes and warnings about the asset.
    pub findings: Vec<Finding>,
}

impl Asset {
    /// Returns the layer in OpenUSD's text format.
    #[must_use]
    pub fn text(&self) -> String {
        self.layer.text()
    }

    /// Returns the file's content. `.usda` and `.usd` hold the same text; `.usdz` packages it.
    ///
    /// # Errors
    /// Returns an error if a package cannot hold a file of that stem or more than 4 GiB of text.
    pub fn bytes(&self, format: Format) -> Result<Vec<u8>, AssetError> {
        let text = self.text().into_bytes();
        match format {
            Format::Usda | Format::Usd => Ok(text),
            Format::Usdz => Ok(usdz::pack(&[(&format!("{}.usda", self.stem), &text)])?),
        }
    }

    /// Returns the file name, such as `oak_d_pro_poe.usd`.
    #[must_use]
    pub fn file_name(&self, format: Format) -> String {
        format!("{}.{}", self.stem, format.extension())
    }
}

/// Creates the asset of a twin.
///
/// # Errors
/// Returns an error if the model does not support an option (fisheye lenses, extended disparity), if a depth sensor
/// refers to a camera that the twin lacks, if a prim name is invalid or occurs twice, or if a number is not finite.
pub fn asset(twin: &Twin, options: &AssetOptions) -> Result<Asset, AssetError> {
    options.check(twin)?;
    let device = &twin.device;
    let device_path = format!("/{ROOT}/{}", device.prim);
    let mut findings = lens::findings(twin, options);
    findings.extend(depth::findings(twin, options, &device_path));

    let body = (options.body || options.rigid_body).then(|| body::body(twin));

    let mut device_prim = PrimSpec::def("Xform", &device.prim).documented(describe::device(twin, options));
    for sensor in &twin.depth_sensors {
        device_prim
            .children
            .push(depth::virtual_camera(twin, sensor, options)?);
    }
    for camera in &twin.cameras {
        device_prim.children.push(camera::prim(twin, camera, options)?);
    }
    device_prim.children.extend(imu::prim(twin, options));
    if let Some(body) = body {
        if options.body {
            let scopes = geometry::scopes(body.parts, &body.materials, &device_path);
            device_prim.children.extend(scopes);
        }
        if options.rigid_body {
            physics::add_rigid_body(&mut device_prim, device, body.collider);
        }
    }
    if !twin.depth_sensors.is_empty() {
        device_prim
            .children
            .push(depth::products(twin, options, &device_path)?);
    }

    let assumed_names = twin
        .depth_sensors
        .first()
        .map_or_else(String::new, |sensor| depth::assumed_names(sensor, options));
    let mut root = PrimSpec::def("Xform", ROOT).documented(describe::root(twin));
    root.kind = Some("component".into());
    root.asset_info = Dictionary::from([
        ("name".into(), SpecValue::string(&device.id)),
        ("version".into(), SpecValue::string(env!("CARGO_PKG_VERSION"))),
    ]);
    root.children.push(device_prim);

    let layer = Layer {
        custom_layer_data: layer_data(twin, options),
        default_prim: Some(ROOT.into()),
        documentation: Some(describe::layer(twin, options, &assumed_names)),
        kilograms_per_unit: options.rigid_body.then_some(1.0),
        meters_per_unit: Some(1.0),
        up_axis: Some(UpAxis::Z),
        sub_layers: Vec::new(),
        prims: vec![root],
    };
    guard::check(&layer, &device.name)?;
    Ok(Asset {
        stem: device.id.clone(),
        layer,
        findings,
    })
}

/// Returns the layer data by which programs recognise these assets.
fn layer_data(twin: &Twin, options: &AssetOptions) -> Dictionary {
    let origin = match &twin.origin {
        Origin::Nominal => "nominal",
        Origin::Calibration { .. } => "calibration",
    };
    Dictionary::from([(
        "oaktwin".into(),
        SpecValue::Dictionary(Dictionary::from([
            ("isaac".into(), SpecValue::string(options.isaac.name())),
            ("model".into(), SpecValue::string(&twin.device.id)),
            ("origin".into(), SpecValue::string(origin)),
            ("target".into(), SpecValue::string(options.target.name())),
            ("version".into(), SpecValue::string(env!("CARGO_PKG_VERSION"))),
        ])),
    )])
}

/// Returns the nearest 32-bit number.
#[expect(
    clippy::cast_possible_truncation,
    reason = "rounding is intended; overflow becomes infinite, which guard::check rejects"
)]
fn f32_of(value: f64) -> f32 {
    value as f32
}

fn float(value: f64) -> SpecValue {
    SpecValue::Float(f32_of(value))
}

//! The USD asset of an OAK camera: from a [`Twin`] to a layer.
//!
//! # What an asset holds
//! ```text
//! /Root                                     Xform, default prim
//! └── oak_d_pro                             Xform; with a rigid body: mass, collider
//!     ├── Camera_pseudo_depth               Camera: the optics and place of the left one
//!     ├── Camera_rgb_imx378, …              Camera
//!     ├── Imu_Sensor                        IsaacImuSensor
//!     ├── visuals, Looks                    the body, its materials
//!     ├── collisions                        with a rigid body
//!     └── TemplateRenderProducts            Scope
//!         └── Camera_pseudo_depth_render_product   RenderProduct with the depth sensor's schema
//! ```
//! Names and values are those of Luxonis' parameter sheet. Z is up, a unit is a metre, and the origin lies midway
//! between the left and right optical centres, x forward, y left, z up.
//!
//! # Numbers
//! Optics are computed in `f64` and written as the nearest `f32`: `focalLength = 4.762592`, where the sheet prints
//! 4.7626. Rounding to the sheet's four digits first would move fx by up to 0.03 px and make the file disagree with
//! its own field of view. Focal lengths, apertures and offsets are numbers of *millimetres* in attributes that
//! OpenUSD defines as tenths of a stage unit, as in the vendor's assets: projection depends on ratios alone, and
//! `fStop = 0` switches off the depth of field that does not.

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

use oaktwin_catalog::{Origin, Twin};
use oaktwin_diagnostic::Finding;

pub use error::AssetError;
pub use files::{AssetFile, files};
pub use names::{PrimNames, render_product_name};
pub use oaktwin_catalog::LensChoice;
pub use options::{AssetOptions, Format, IsaacVersion, Target};
pub use overrides::{OverrideBase, overrides};

use crate::body;
use crate::text::{Dictionary, Layer, Prim, UpAxis, Value};
use crate::usdz;

/// The default prim's name.
pub const ROOT: &str = "Root";
/// The scope of the render products.
pub const PRODUCTS: &str = "TemplateRenderProducts";
/// The inertial sensor's prim.
pub const IMU: &str = "Imu_Sensor";

/// An asset, ready to be written.
#[derive(Clone, Debug, PartialEq)]
pub struct Asset {
    /// The file's name without its extension, `oak_d_pro_poe`.
    pub stem: String,
    /// The document.
    pub layer: Layer,
    /// What the user should know.
    pub findings: Vec<Finding>,
}

impl Asset {
    /// The layer in OpenUSD's text format.
    #[must_use]
    pub fn text(&self) -> String {
        self.layer.text()
    }

    /// The file's content. `.usda` and `.usd` hold the same text; `.usdz` packages it.
    ///
    /// # Errors
    /// A stem that no package can hold, or more than 4 GiB of text.
    pub fn bytes(&self, format: Format) -> Result<Vec<u8>, AssetError> {
        let text = self.text().into_bytes();
        match format {
            Format::Usda | Format::Usd => Ok(text),
            Format::Usdz => Ok(usdz::pack(&[(&format!("{}.usda", self.stem), &text)])?),
        }
    }

    /// The file's name, `oak_d_pro_poe.usd`.
    #[must_use]
    pub fn file_name(&self, format: Format) -> String {
        format!("{}.{}", self.stem, format.extension())
    }
}

/// The asset of a twin.
///
/// # Errors
/// An option that the model cannot have (fisheye lenses, extended disparity), a twin whose depth sensor names a
/// camera it lacks, names that are no prim names or occur twice, numbers that are not finite.
pub fn asset(twin: &Twin, options: &AssetOptions) -> Result<Asset, AssetError> {
    options.check(twin)?;
    let device = &twin.device;
    let device_path = format!("/{ROOT}/{}", device.prim);
    let mut findings = lens::findings(twin, options);
    findings.extend(depth::findings(twin, options, &device_path));

    let body = (options.body || options.rigid_body).then(|| body::body(twin));

    let mut device_prim = Prim::def("Xform", &device.prim).documented(describe::device(twin, options));
    for sensor in &twin.depth_sensors {
        device_prim
            .children
            .push(depth::virtual_camera(twin, sensor, options)?);
    }
    for camera in &twin.cameras {
        device_prim.children.push(camera::prim(twin, camera, options)?);
    }
    device_prim.children.push(imu::prim(twin, options));
    if let Some(body) = body {
        if options.body {
            let scopes = geometry::scopes(body.parts, &body.materials, &device_path);
            device_prim.children.extend(scopes);
        }
        if options.rigid_body {
            physics::add_rigid_body(&mut device_prim, device, body.collider);
        }
    }
    device_prim
        .children
        .push(depth::products(twin, options, &device_path)?);

    let mut root = Prim::def("Xform", ROOT).documented(describe::root(twin));
    root.kind = Some("component".into());
    root.asset_info = Dictionary::from([
        ("name".into(), Value::string(&device.id)),
        ("version".into(), Value::string(env!("CARGO_PKG_VERSION"))),
    ]);
    root.children.push(device_prim);

    let layer = Layer {
        custom_layer_data: layer_data(twin, options),
        default_prim: Some(ROOT.into()),
        documentation: Some(describe::layer(twin, options)),
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

/// What a program recognises our assets by.
fn layer_data(twin: &Twin, options: &AssetOptions) -> Dictionary {
    let origin = match &twin.origin {
        Origin::Nominal => "nominal",
        Origin::Calibration { .. } => "calibration",
    };
    Dictionary::from([(
        "oaktwin".into(),
        Value::Dictionary(Dictionary::from([
            ("isaac".into(), Value::string(options.isaac.name())),
            ("model".into(), Value::string(&twin.device.id)),
            ("origin".into(), Value::string(origin)),
            ("target".into(), Value::string(options.target.name())),
            ("version".into(), Value::string(env!("CARGO_PKG_VERSION"))),
        ])),
    )])
}

/// The nearest 32-bit number.
#[expect(
    clippy::cast_possible_truncation,
    reason = "rounding is meant; what overflows becomes infinite and is refused by guard::check"
)]
fn f32_of(value: f64) -> f32 {
    value as f32
}

/// A `float` value.
fn float(value: f64) -> Value {
    Value::Float(f32_of(value))
}

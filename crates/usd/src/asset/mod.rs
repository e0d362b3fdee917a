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
mod geometry;
mod guard;
mod imu;
mod lens;
mod names;
mod options;
mod overrides;
mod physics;
mod pose;
mod tilt;

#[cfg(test)]
pub(crate) mod sample;
#[cfg(test)]
mod tests;

use oaktwin_catalog::{Origin, Twin};
use oaktwin_diagnostic::Finding;

pub use error::AssetError;
pub use geometry::{BodyMaterial, BodyPart};
pub use names::{PrimNames, render_product_name};
pub use options::{AssetOptions, Format, IsaacVersion, LensChoice, Target};
pub use overrides::{OverrideBase, overrides};

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
    let parts = if options.body {
        geometry::body_parts(twin)
    } else {
        Vec::new()
    };
    asset_with_body(twin, options, &parts)
}

/// The asset of a twin with a body of these parts.
///
/// # Errors
/// As [`asset`], and a part whose normals fit neither its points nor its corners.
pub fn asset_with_body(twin: &Twin, options: &AssetOptions, body: &[BodyPart]) -> Result<Asset, AssetError> {
    options.check(twin)?;
    let device = &twin.device;
    let device_path = format!("/{ROOT}/{}", device.prim);
    let mut findings = lens::findings(twin, options);
    findings.extend(depth::findings(twin, options, &device_path));

    let mut camera_body = Prim::def("Xform", &device.prim).documented(describe::device(twin, options));
    for sensor in &twin.depth_sensors {
        camera_body
            .children
            .push(depth::virtual_camera(twin, sensor, options)?);
    }
    for camera in &twin.cameras {
        camera_body.children.push(camera::prim(twin, camera, options)?);
    }
    camera_body.children.push(imu::prim(twin, options));
    if !body.is_empty() {
        camera_body.children.extend(geometry::prims(body, &device_path)?);
    }
    if options.rigid_body {
        physics::add_rigid_body(&mut camera_body, device);
    }
    camera_body
        .children
        .push(depth::products(twin, options, &device_path)?);

    let mut root = Prim::def("Xform", ROOT).documented(describe::root(twin));
    root.kind = Some("component".into());
    root.asset_info = Dictionary::from([
        ("name".into(), Value::string(&device.id)),
        ("version".into(), Value::string(env!("CARGO_PKG_VERSION"))),
    ]);
    root.children.push(camera_body);

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

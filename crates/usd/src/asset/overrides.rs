use oaktwin_base::diagnostic::{Finding, Level};
use oaktwin_catalog::{Origin, Twin};

use super::{
    Asset, AssetError, AssetOptions, AssetTarget, PRODUCTS, PrimNames, ROOT, camera, depth, describe, float,
    guard, layer_data, lens, render_product_name,
};
use crate::text::{Layer, PrimSpec, UpAxis};

/// The asset that a layer of overrides builds on.
#[derive(Clone, Debug, PartialEq)]
pub struct OverrideBase<'a> {
    /// The asset's path as written in the layer: absolute or relative to the layer's folder.
    pub asset: &'a str,
    /// The naming of its prims.
    pub names: PrimNames,
    /// The name of its default prim.
    pub root: &'a str,
    /// The name of the prim that contains its cameras.
    pub device: &'a str,
    /// Its `metersPerUnit`, repeated because OpenUSD takes the stage's from the strongest layer, which is the overrides.
    pub meters_per_unit: f64,
    /// Its `upAxis`, repeated for the same reason.
    pub up_axis: UpAxis,
}

impl<'a> OverrideBase<'a> {
    /// Creates the description of an asset with the sheet's layout.
    #[must_use]
    pub fn new(asset: &'a str, twin: &'a Twin, names: PrimNames) -> Self {
        Self {
            asset,
            names,
            root: ROOT,
            device: &twin.device.prim,
            meters_per_unit: 1.0,
            up_axis: UpAxis::Z,
        }
    }
}

/// Creates a layer that gives an existing asset the numbers of one unit: focal lengths, aperture offsets, the lens
/// schema and `focalLengthPixel`. Camera poses are not overridden, since the base may use another origin or other axes;
/// nor are apertures and the depth sensor's noise, which belong to the model.
///
/// # Errors
/// Returns an error if the twin is nominal, and in the cases of [`asset`](super::asset).
pub fn overrides(twin: &Twin, options: &AssetOptions, base: &OverrideBase<'_>) -> Result<Asset, AssetError> {
    options.check(twin)?;
    let model = &twin.device.name;
    if twin.origin == Origin::Nominal {
        return Err(AssetError::NothingToOverride { model: model.clone() });
    }
    let mut device = PrimSpec::over(base.device);
    let mut products = PrimSpec::over(PRODUCTS);
    for sensor in &twin.depth_sensors {
        let name = base.names.of(&sensor.spec.prim);
        let source = &depth::source(twin, sensor)?;
        let mut prim = PrimSpec::over(name);
        add_optics(&mut prim, &camera::optics(twin, source, options));
        if let Some(lens) = lens::of_depth_camera(twin, source) {
            lens.author(&mut prim, model)?;
        }
        let focal_length = (
            depth::attribute_name(options, "focalLengthPixel"),
            float(sensor.focal_length_px),
        );
        match options.target {
            AssetTarget::Isaac => {
                let mut product = PrimSpec::over(render_product_name(name));
                product.set(focal_length.0, focal_length.1);
                products.children.push(product);
            }
            AssetTarget::Ovrtx => prim.set(focal_length.0, focal_length.1),
        }
        device.children.push(prim);
    }
    for twin_camera in &twin.cameras {
        let mut prim = PrimSpec::over(base.names.of(&twin_camera.spec.prim));
        add_optics(&mut prim, &camera::optics(twin, twin_camera, options));
        if let Some(lens) = lens::of_camera(twin, twin_camera, options) {
            lens.author(&mut prim, model)?;
        }
        device.children.push(prim);
    }
    if !products.children.is_empty() {
        device.children.push(products);
    }
    let layer = Layer {
        custom_layer_data: layer_data(twin, options),
        default_prim: Some(base.root.into()),
        documentation: Some(describe::overrides(twin, base.asset)),
        kilograms_per_unit: None,
        meters_per_unit: Some(base.meters_per_unit),
        up_axis: Some(base.up_axis),
        sub_layers: vec![base.asset.into()],
        prims: vec![PrimSpec::over(base.root).with_child(device)],
    };
    guard::check(&layer, model)?;
    let mut findings = lens::findings(twin, options);
    findings.push(Finding::new(
        "places-not-overridden",
        Level::Note,
        format!("/{}/{}", base.root, base.device),
        "the cameras keep the poses of the base asset, whose origin and axes may differ",
        "write a complete asset from the calibration to use its extrinsics",
    ));
    Ok(Asset {
        stem: format!("{}_calibrated", twin.device.id),
        layer,
        findings,
    })
}

fn add_optics(prim: &mut PrimSpec, optics: &oaktwin_camera::UsdOptics) {
    prim.set("focalLength", float(optics.focal_length_mm));
    camera::add_offsets(prim, optics);
}

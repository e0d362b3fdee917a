use oaktwin_base::diagnostic::{Finding, Level};
use oaktwin_base::parameter::nvidia::Attributes;
use oaktwin_base::parameter::{Kind, ParameterRow, Table};
use oaktwin_catalog::{Twin, TwinCamera, TwinDepthSensor};

use super::camera::{CameraTraits, base};
use super::{
    AssetError, AssetOptions, AssetTarget, IsaacVersion, PRODUCTS, describe, float, lens, render_product_name,
};
use crate::nvidia::{CAMERA_NAMESPACE, CAMERA_SCHEMA, OUTLIER_REMOVAL, PRODUCT_NAMESPACE, PRODUCT_SCHEMA};
use crate::text::{AttributeSpec, PrimSpec, SpecValue};

/// The scope of the render variables that products share.
const RENDER_VARS: &str = "RenderVars";
/// The depth sensor's inputs, then its outputs. Isaac Sim 6 and later read this list from the asset.
const VARIABLES: [&str; 7] = [
    "LdrColor",
    "DistanceToImagePlaneSD",
    "Camera3dPositionSD",
    "DepthSensorDistance",
    "DepthSensorImager",
    "DepthSensorPointCloudColor",
    "DepthSensorPointCloudPosition",
];
const OVRTX_VARIABLE: &str = "DepthSensorOutputVisualization";

/// Creates the virtual camera of a depth sensor: a pinhole with the optics and pose of its source camera.
pub(super) fn virtual_camera(
    twin: &Twin,
    sensor: &TwinDepthSensor,
    options: &AssetOptions,
) -> Result<PrimSpec, AssetError> {
    let camera = &source(twin, sensor)?;
    let traits = CameraTraits {
        name: &sensor.spec.prim,
        focus_distance: sensor.spec.focus_distance,
        clipping_range_m: sensor.spec.clipping_range_m,
        stereo_role: "mono",
    };
    let mut prim = base(twin, camera, &traits, options);
    prim.documentation = Some(describe::depth_camera(twin, sensor, camera));
    if options.target == AssetTarget::Ovrtx {
        prim.api_schemas.push(CAMERA_SCHEMA.into());
        for attribute in attributes(sensor, options) {
            prim.add(attribute);
        }
    }
    if let Some(lens) = lens::of_depth_camera(twin, camera) {
        lens.author(&mut prim, &twin.device.name)?;
    }
    Ok(prim)
}

/// Returns the rectified camera whose optics and pose a depth sensor uses.
pub(super) fn source(twin: &Twin, sensor: &TwinDepthSensor) -> Result<TwinCamera, AssetError> {
    twin.depth_camera(sensor)
        .ok_or_else(|| AssetError::MissingCamera {
            model: twin.device.name.clone(),
            sensor: sensor.spec.prim.clone(),
            role: format!("{:?}", sensor.spec.camera).to_lowercase(),
        })
}

/// Creates the scope of render products, one for each depth sensor.
pub(super) fn products(
    twin: &Twin,
    options: &AssetOptions,
    device_path: &str,
) -> Result<PrimSpec, AssetError> {
    let mut scope = PrimSpec::def("Scope", PRODUCTS).documented(describe::PRODUCTS);
    let variables = variables(options);
    for sensor in &twin.depth_sensors {
        let camera = source(twin, sensor)?;
        let mut product = PrimSpec::def("RenderProduct", render_product_name(&sensor.spec.prim))
            .documented(describe::product(sensor));
        product.relate("camera", vec![format!("{device_path}/{}", sensor.spec.prim)]);
        product.set_uniform("resolution", lens::int2(&camera.intrinsics, &twin.device.name)?);
        if options.target == AssetTarget::Isaac {
            product.api_schemas.push(PRODUCT_SCHEMA.into());
            for attribute in attributes(sensor, options) {
                product.add(attribute);
            }
        }
        if !variables.is_empty() {
            let paths = variables
                .iter()
                .map(|name| format!("{device_path}/{PRODUCTS}/{RENDER_VARS}/{name}"));
            product.relate("orderedVars", paths.collect());
        }
        scope.children.push(product);
    }
    if !variables.is_empty() {
        let mut vars = PrimSpec::def("Scope", RENDER_VARS);
        for name in variables {
            let mut var = PrimSpec::def("RenderVar", name);
            var.set_uniform("sourceName", SpecValue::string(name));
            vars.children.push(var);
        }
        scope.children.push(vars);
    }
    Ok(scope)
}

fn variables(options: &AssetOptions) -> Vec<&'static str> {
    match (options.target, options.isaac) {
        (AssetTarget::Isaac, IsaacVersion::V5_1) => Vec::new(),
        (AssetTarget::Isaac, IsaacVersion::V6) => VARIABLES.to_vec(),
        (AssetTarget::Ovrtx, _) => VARIABLES.into_iter().chain([OVRTX_VARIABLE]).collect(),
    }
}

/// Returns the full name of a depth attribute for the target.
pub(super) fn attribute_name(options: &AssetOptions, name: &str) -> String {
    let namespace = match options.target {
        AssetTarget::Isaac => PRODUCT_NAMESPACE,
        AssetTarget::Ovrtx => CAMERA_NAMESPACE,
    };
    format!("{namespace}{name}")
}

/// The parameter sheet's attributes that shape the output, sorted by name.
fn attributes(sensor: &TwinDepthSensor, options: &AssetOptions) -> Vec<AttributeSpec> {
    let values = sensor.attributes(options.extended_disparity);
    let shapes = |row: &&ParameterRow<Attributes>| matches!(row.about.kind, Kind::Number | Kind::Integer);
    let mut attributes: Vec<AttributeSpec> = Attributes::rows()
        .filter(shapes)
        .map(|row| {
            let name = row.about.name;
            let number = (row.numbers)(&values)[0];
            let attribute = |value| AttributeSpec::new(attribute_name(options, name), value);
            let range = values.outlier_removal_range_px;
            match (name, options.target, options.isaac) {
                // One name, two types: a range in pixels in 5.x, a switch in 6.x.
                (OUTLIER_REMOVAL, AssetTarget::Isaac, IsaacVersion::V5_1) => {
                    let range = i32::try_from(range).unwrap_or(i32::MAX);
                    attribute(SpecValue::Int(range)).documented(describe::OUTLIER_REMOVAL)
                }
                (OUTLIER_REMOVAL, ..) => {
                    attribute(SpecValue::Bool(range > 0)).documented(describe::OUTLIER_REMOVAL)
                }
                ("noiseMean", ..) => attribute(float(number)).documented(describe::NOISE_MEAN),
                _ => attribute(float(number)),
            }
        })
        .collect();
    attributes.sort_by(|a, b| a.name.cmp(&b.name));
    attributes
}

/// Returns a note for each depth sensor whose schema is experimental.
pub(super) fn findings(twin: &Twin, options: &AssetOptions, device_path: &str) -> Vec<Finding> {
    if options.target != AssetTarget::Ovrtx {
        return Vec::new();
    }
    twin.depth_sensors
        .iter()
        .map(|sensor| {
            Finding::new(
                "ovrtx-experimental",
                Level::Note,
                format!("{device_path}/{}", sensor.spec.prim),
                format!(
                    "experimental: NVIDIA publishes no list of the attributes of {CAMERA_SCHEMA}; assumed: {}",
                    assumed_names(sensor, options)
                ),
                "compare them with the schema of the installed ovrtx",
            )
        })
        .collect()
}

/// Returns the attribute names that an asset for ovrtx assumes, comma-separated.
pub(super) fn assumed_names(sensor: &TwinDepthSensor, options: &AssetOptions) -> String {
    let names: Vec<String> = attributes(sensor, options)
        .into_iter()
        .map(|attribute| attribute.name)
        .collect();
    names.join(", ")
}

//! The documentation strings of an asset: the sources of its numbers, its frames and units, its estimates.

use oaktwin_catalog::{DepthKind, Imu, Origin, Role, Source, Sources, Twin, TwinCamera, TwinDepthSensor};

use super::{AssetOptions, AssetTarget, lens};

pub(super) const NOISE_MEAN: &str = "The quantization step of the disparity in pixels, not a bias: 0 switches \
    quantization and its jitter off.";
pub(super) const OUTLIER_REMOVAL: &str = "The sheet's outlierRemovalRange: in Isaac Sim 5 an int, the range in \
    pixels; in Isaac Sim 6 a bool.";
pub(super) const PRODUCTS: &str = "Templates: Isaac Sim's depth sensor copies these attributes to the render product \
    that it makes.";

const SHEET: &str = "Luxonis' parameter sheet of the OAK assets for Isaac Sim";

/// Describes the layer. `assumed_names` lists the attributes that an asset for ovrtx assumes.
pub(super) fn layer(twin: &Twin, options: &AssetOptions, assumed_names: &str) -> String {
    let device = &twin.device;
    let mut text = format!(
        "{} {}: a digital twin written by oaktwin {}.\n\
         Numbers: {}.\n\
         Frames: z up, metres; x forward, y left, z up; the origin {}. Cameras look along their -z axis, y up.\n\
         Units: focalLength, apertures and aperture offsets are millimetres, as in the vendor's assets (OpenUSD \
         defines them as tenths of a stage unit). Projection depends on their ratios alone, and fStop 0 switches off \
         the depth of field that does not.",
        device.manufacturer,
        device.name,
        env!("CARGO_PKG_VERSION"),
        origin(twin),
        body_origin(twin),
    );
    let estimates = estimates(twin);
    if !estimates.is_empty() {
        text.push_str("\nEstimates, where no source states a number: ");
        text.push_str(&estimates.join(", "));
        text.push('.');
    }
    if options.target == AssetTarget::Ovrtx {
        text.push_str(
            "\nFor ovrtx, experimental: no list of the attributes of its depth sensor's schema is published. Assumed: ",
        );
        text.push_str(assumed_names);
        text.push('.');
    }
    text
}

/// Describes the default prim.
pub(super) fn root(twin: &Twin) -> String {
    let device = &twin.device;
    format!("{} {}, {}.", device.manufacturer, device.name, device.variant)
}

/// Describes the device prim.
pub(super) fn device(twin: &Twin, options: &AssetOptions) -> String {
    let [width, height, depth] = twin.device.body.dimensions_mm;
    let mut text = format!(
        "The camera's body: {width} x {height} x {depth} mm{}.",
        mark(is_estimate(
            &twin.device.body.source,
            &twin.device.body.sources,
            "dimensions_mm"
        ))
    );
    if options.rigid_body {
        text.push_str(&format!(
            " A rigid body of {} g{}; it collides as the box around it. Do not nest it below another rigid body.",
            twin.device.body.mass_g,
            mark(is_estimate(&twin.device.body.source, &twin.device.body.sources, "mass_g"))
        ));
    }
    text
}

/// Describes a camera of the device.
pub(super) fn camera(twin: &Twin, camera: &TwinCamera, options: &AssetOptions) -> String {
    let spec = &camera.spec;
    let mut text = format!(
        "{}, {} px of {} um. Numbers: {}.",
        spec.sensor,
        camera.intrinsics.size,
        camera.pixel_size_um,
        origin(twin)
    );
    if is_estimate(&spec.source, &spec.sources, "position_mm") && twin.origin == Origin::Nominal {
        text.push_str(" Its position is an estimate.");
    }
    if let Some(lens) = lens::of_camera(twin, camera, options) {
        text.push_str(&format!(
            " Lens: {}. Its cx and cy count from the centre of the first pixel, as OpenCV does; whether Isaac Sim's \
             renderer adds half a pixel is not known.",
            lens.description()
        ));
    }
    text
}

/// Describes the virtual camera of a depth sensor.
pub(super) fn depth_camera(twin: &Twin, sensor: &TwinDepthSensor, camera: &TwinCamera) -> String {
    let mut text = format!(
        "The virtual camera of the depth sensor ({}): optics and pose of {}.",
        kind_name(sensor.spec.kind),
        camera.spec.prim
    );
    if lens::of_depth_camera(twin, camera).is_some() {
        text.push_str(
            " Depth images are rectified: the pose and the intrinsics belong to the device's rectified image, and the lens \
             schema has no distortion.",
        );
    }
    text
}

/// Describes a render product.
pub(super) fn product(sensor: &TwinDepthSensor) -> String {
    format!("The {} depth sensor's parameters.", kind_name(sensor.spec.kind))
}

/// Describes the inertial sensor.
pub(super) fn imu(imu: &Imu, options: &AssetOptions) -> String {
    let place = is_estimate(&imu.source, &imu.sources, "position_mm")
        || is_estimate(&imu.source, &imu.sources, "rotation");
    let below = if options.rigid_body {
        ""
    } else {
        " Isaac Sim's inertial sensor needs a rigid body above it: mount the camera on one."
    };
    format!(
        "Inertial unit: {}.{}{below}",
        imu.model,
        if place { " Its pose is an estimate." } else { "" }
    )
}

/// Describes a layer of overrides.
pub(super) fn overrides(twin: &Twin, base: &str) -> String {
    format!(
        "{} {}: overrides on {base}, written by oaktwin {}.\nNumbers: {}.\nCamera poses, apertures and the depth \
         sensor's noise come from the base.",
        twin.device.manufacturer,
        twin.device.name,
        env!("CARGO_PKG_VERSION"),
        origin(twin)
    )
}

/// Describes the place of the body's origin.
fn body_origin(twin: &Twin) -> &'static str {
    if twin.device.stereo_baseline_mm.is_some() {
        "lies midway between the left and right optical centres"
    } else if twin.camera(Role::Tof).is_some() {
        "is the optical centre of the time-of-flight camera"
    } else {
        "is the optical centre of the camera"
    }
}

fn origin(twin: &Twin) -> String {
    match &twin.origin {
        Origin::Nominal if twin.device.source == Source::Document => format!("nominal, from {SHEET}"),
        Origin::Nominal => "nominal, from oaktwin's catalog, which states the source of each".to_owned(),
        Origin::Calibration {
            product_name,
            file_name,
        } => match (product_name.as_str(), file_name.as_str()) {
            ("", "") => "the calibration of one unit".into(),
            (name, "") | ("", name) => format!("the calibration of one unit ({name})"),
            (product, file) => format!("the calibration of one unit ({product}, {file})"),
        },
    }
}

/// Returns the quantities that no source states.
fn estimates(twin: &Twin) -> Vec<String> {
    let device = &twin.device;
    let body = |key| is_estimate(&device.body.source, &device.body.sources, key);
    let mut estimates = Vec::new();
    if body("dimensions_mm") {
        estimates.push("outer dimensions".into());
    }
    if body("front_mm") {
        estimates.push("position of the front face".into());
    }
    if body("mass_g") {
        estimates.push("mass".into());
    }
    if device.body.projector_mm.is_some() && body("projector_mm") {
        estimates.push("position of the projector".into());
    }
    if let Some(imu) = &device.imu {
        if is_estimate(&imu.source, &imu.sources, "position_mm") {
            estimates.push("position of the inertial unit".into());
        }
        if is_estimate(&imu.source, &imu.sources, "rotation") {
            estimates.push("axes of the inertial unit".into());
        }
    }
    if twin.origin == Origin::Nominal {
        for camera in &device.cameras {
            if is_estimate(&camera.source, &camera.sources, "position_mm") {
                estimates.push(format!("position of {}", camera.prim));
            }
        }
    }
    estimates
}

fn is_estimate(table: &Source, sources: &Sources, key: &str) -> bool {
    *sources.get(key).unwrap_or(table) == Source::Estimate
}

const fn mark(is_estimate: bool) -> &'static str {
    if is_estimate { " (estimate)" } else { "" }
}

/// Returns `stereo` or `time of flight`.
const fn kind_name(kind: DepthKind) -> &'static str {
    match kind {
        DepthKind::Stereo => "stereo",
        DepthKind::Tof => "time of flight",
    }
}

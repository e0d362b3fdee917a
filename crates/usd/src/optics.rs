//! What a camera prim sees: its attributes as intrinsics and a lens, for an image of a given size.

use oaktwin_camera::{
    Camera, ImageSize, Intrinsics, LensModel, OpenCvFisheye, OpenCvPinhole, PixelPoint, Usd,
};
use oaktwin_diagnostic::{Finding, Level};

use crate::lens::{self, Lens, MODEL};
use crate::nvidia::{CAMERA_SCHEMA, PRODUCT_SCHEMA};
use crate::stage::{RenderProduct, SceneCamera};

/// How wide the image of a camera is of which nothing says it: Isaac Sim's viewport.
pub const DEFAULT_WIDTH: u32 = 1280;

/// How apertures become intrinsics.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Projection {
    /// As Isaac Sim's renderer does: `fx = fy = W · focalLength / horizontalAperture`, centred; the vertical aperture
    /// and the aperture offsets are ignored (RTX through Isaac Sim 6.0).
    #[default]
    Isaac,
    /// As OpenUSD defines it: each axis by its own aperture, the window moved by the offsets.
    OpenUsd,
}

/// Why a camera prim has no intrinsics: `PRIM: what is wrong; what to do`.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{prim}: {what}; {remedy}")]
pub struct OpticsError {
    /// The camera.
    pub prim: String,
    /// What is wrong, the attribute named.
    pub what: String,
    /// What to do.
    pub remedy: &'static str,
}

impl OpticsError {
    fn new(camera: &SceneCamera, what: impl Into<String>, remedy: &'static str) -> Self {
        Self {
            prim: camera.prim.path.clone(),
            what: what.into(),
            remedy,
        }
    }
}

/// The size of a camera's image where neither a render product nor a person says it: [`DEFAULT_WIDTH`] wide and as
/// high as its apertures say, at least 1.
///
/// # Errors
/// An aperture is no positive number.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "the cast saturates, and images of that size are refused"
)]
pub fn default_size(camera: &SceneCamera) -> Result<ImageSize, OpticsError> {
    let horizontal = positive(camera, "horizontalAperture", camera.horizontal_aperture())?;
    let vertical = positive(camera, "verticalAperture", camera.vertical_aperture())?;
    let height = (f64::from(DEFAULT_WIDTH) * vertical / horizontal)
        .round()
        .max(1.0);
    Ok(ImageSize::new(DEFAULT_WIDTH, height as u32))
}

/// The intrinsics and the lens of a camera prim for an image of `size`, and what was left out.
///
/// A lens-distortion schema for OpenCV's pinhole or fisheye model, or the f-theta model, takes the place of focal
/// length and apertures, whatever the projection; its image shows in `size` what it shows in its own size, each axis
/// scaled by itself, and its cx, cy are in OpenCV's convention, as assets author them. Other lens models are findings,
/// and the camera is the pinhole of its apertures.
///
/// # Errors
/// A camera that is not perspective; a focal length, an aperture or a value of the lens schema that is no usable
/// number.
pub fn camera(
    camera: &SceneCamera,
    size: ImageSize,
    projection: Projection,
) -> Result<(Camera, Vec<Finding>), OpticsError> {
    if !camera.is_perspective() {
        let projection = camera.prim.text("projection").unwrap_or_default();
        return Err(OpticsError::new(
            camera,
            format!("projection is `{projection}`, and only perspective cameras have a pinhole"),
            "set it to `perspective`, or choose another camera",
        ));
    }
    let mut findings = Vec::new();
    if let Some(seen) = through_schema(camera, size, &mut findings)? {
        return Ok((seen, findings));
    }
    let intrinsics = by_apertures(camera, size, projection, &mut findings)?;
    Ok((Camera::new(intrinsics, LensModel::Pinhole), findings))
}

/// `clippingRange` in metres, near and far. `None`, with a finding, where it is no range in front of the camera.
#[must_use]
pub fn clipping_range_m(camera: &SceneCamera, meters_per_unit: f64) -> (Option<(f64, f64)>, Option<Finding>) {
    let (near, far) = camera.clipping_range();
    if near > 0.0 && near < far {
        return (Some((near * meters_per_unit, far * meters_per_unit)), None);
    }
    let finding = Finding::new(
        "clipping-range",
        Level::Warning,
        &camera.prim.path,
        format!(
            "clippingRange is ({near}, {far}), which is no range in front of the camera; a default is used"
        ),
        "author (near, far) with 0 < near < far",
    );
    (None, Some(finding))
}

/// Whether a render product is a depth sensor's template: it carries Kit's depth-sensor schema, or its camera ovrtx's.
#[must_use]
pub fn is_depth_product(product: &RenderProduct, camera: Option<&SceneCamera>) -> bool {
    product.prim.has_api(PRODUCT_SCHEMA) || camera.is_some_and(|camera| camera.prim.has_api(CAMERA_SCHEMA))
}

fn by_apertures(
    camera: &SceneCamera,
    size: ImageSize,
    projection: Projection,
    findings: &mut Vec<Finding>,
) -> Result<Intrinsics, OpticsError> {
    positive(camera, "focalLength", camera.focal_length())?;
    positive(camera, "horizontalAperture", camera.horizontal_aperture())?;
    let optics = camera.optics();
    let offsets = [
        ("horizontalApertureOffset", optics.horizontal_aperture_offset_mm),
        ("verticalApertureOffset", optics.vertical_aperture_offset_mm),
    ];
    let intrinsics = match projection {
        Projection::Isaac => {
            if offsets.iter().any(|(_, offset)| *offset != 0.0) {
                findings.push(Finding::new(
                    "aperture-offsets-ignored",
                    Level::Note,
                    &camera.prim.path,
                    "its aperture offsets are ignored, as Isaac Sim's renderer does",
                    "ask for OpenUSD's projection to have them honoured",
                ));
            }
            optics.isaac_intrinsics(size)
        }
        Projection::OpenUsd => {
            positive(camera, "verticalAperture", camera.vertical_aperture())?;
            for (name, offset) in offsets {
                if !offset.is_finite() {
                    let what = format!("{name} is {offset}");
                    return Err(OpticsError::new(camera, what, "author a finite number"));
                }
            }
            optics.openusd_intrinsics(size)
        }
    };
    let is_sound = |f: f64| f.is_finite() && f > 0.0;
    if is_sound(intrinsics.fx) && is_sound(intrinsics.fy) {
        return Ok(intrinsics);
    }
    let what = format!(
        "focalLength {} and apertures {} and {} give a focal length of {} px",
        optics.focal_length_mm, optics.horizontal_aperture_mm, optics.vertical_aperture_mm, intrinsics.fx
    );
    Err(OpticsError::new(camera, what, "author sensible ones"))
}

fn positive(camera: &SceneCamera, attribute: &str, value: f64) -> Result<f64, OpticsError> {
    if value.is_finite() && value > 0.0 {
        return Ok(value);
    }
    Err(OpticsError::new(
        camera,
        format!("{attribute} is {value}"),
        "author a positive number",
    ))
}

/// The camera that a lens schema describes; `None` where there is none, or none that can be rendered.
fn through_schema(
    camera: &SceneCamera,
    size: ImageSize,
    findings: &mut Vec<Finding>,
) -> Result<Option<Camera>, OpticsError> {
    let prim = &camera.prim;
    let mut odd = |code, message: String, remedy| {
        findings.push(Finding::new(code, Level::Warning, &prim.path, message, remedy));
    };
    let named = prim.text(MODEL);
    let Some(lens) = Lens::of(prim) else {
        if let Some(named) = named.filter(|named| !named.is_empty() && *named != "pinhole") {
            let message =
                format!("{MODEL} is `{named}`, but no such lens schema is applied: a pinhole is rendered");
            odd("lens-model", message, "add the schema to the prim's apiSchemas");
        }
        let legacy = prim.text("cameraProjectionType").unwrap_or("pinhole");
        if legacy != "pinhole" {
            let message = format!("cameraProjectionType `{legacy}` is deprecated: a pinhole is rendered");
            odd(
                "lens-unsupported",
                message,
                "describe the lens with a lens-distortion schema",
            );
        }
        return Ok(None);
    };
    if named != Some(lens.model) {
        let says = named.map_or_else(|| "not authored".to_owned(), |named| format!("`{named}`"));
        let message = format!("{MODEL} is {says}, but {} is applied, and rendered", lens.schema);
        odd("lens-model", message, "name the applied schema's model");
    }
    let unusable = |what: &dyn std::fmt::Display| {
        OpticsError::new(
            camera,
            format!("{}: {what}", lens.schema),
            "author finite values, positive focal lengths and the image size they hold for",
        )
    };
    let (seen, own_size) = match lens.model {
        "opencvPinhole" | "opencvFisheye" => {
            let intrinsics = lens
                .intrinsics()
                .ok_or_else(|| unusable(&"fx, fy, cx, cy or imageSize is no usable number"))?;
            let model = opencv_model(&lens).map_err(|error| unusable(&error))?;
            (Camera::new(stretched(&intrinsics, size), model), intrinsics.size)
        }
        "ftheta" => {
            let lens = lens::f_theta(prim).map_err(|error| unusable(&error))?;
            let own = lens.nominal_size;
            let centre = lens.optical_centre.xy();
            if own.width == 0
                || own.height == 0
                || !centre.is_finite()
                || lens.max_fov.is_nan()
                || lens.max_fov <= 0.0
            {
                return Err(unusable(
                    &"nominalWidth, nominalHeight, opticalCenter or maxFov is no usable number",
                ));
            }
            (Camera::from_ftheta(lens, size), own)
        }
        model => {
            let message = format!("the lens model `{model}` cannot be rendered: a pinhole is");
            odd(
                "lens-unsupported",
                message,
                "describe the lens with one of OpenCV's models or f-theta",
            );
            return Ok(None);
        }
    };
    if (own_size.aspect() / size.aspect() - 1.0).abs() > 1e-3 {
        let message = format!("its lens is described for {own_size}, and stretched to {size}");
        odd("lens-aspect", message, "render the lens's own aspect ratio");
    }
    Ok(Some(seen))
}

fn opencv_model(lens: &Lens) -> Result<LensModel, oaktwin_camera::LensError> {
    let k = &lens.coefficients;
    Ok(match lens.model {
        "opencvFisheye" => LensModel::OpenCvFisheye(OpenCvFisheye::from_slice(k)?),
        // A schema without distortion carries a principal point only.
        _ if k.iter().all(|k| *k == 0.0) => LensModel::Pinhole,
        _ => LensModel::OpenCvPinhole(OpenCvPinhole::from_slice(k)?),
    })
}

/// The same view in an image of another size: each axis scaled by itself, from the image's corner.
fn stretched(intrinsics: &Intrinsics, size: ImageSize) -> Intrinsics {
    let sx = f64::from(size.width) / f64::from(intrinsics.size.width);
    let sy = f64::from(size.height) / f64::from(intrinsics.size.height);
    let c = intrinsics.principal_point::<Usd>();
    let centre = PixelPoint::<Usd>::new(c.x * sx, c.y * sy);
    Intrinsics::new(size, intrinsics.fx * sx, intrinsics.fy * sy, centre)
}

#[cfg(test)]
mod tests;

//! Converts the attributes of a camera prim to intrinsics and a lens for a given image size.

use oaktwin_base::diagnostic::{Finding, Level};
use oaktwin_base::parameter::choice;
use oaktwin_camera::{
    Camera, ImageSize, Intrinsics, LensModel, OpenCvFisheye, OpenCvPinhole, PixelPoint, Usd,
};

use crate::lens::{self, Lens, MODEL};
use crate::nvidia::{CAMERA_SCHEMA, PRODUCT_SCHEMA};
use crate::stage::{Prim, RenderProduct, SceneCamera};

/// The default image width, the width of Isaac Sim's viewport.
pub const DEFAULT_WIDTH: u32 = 1280;

choice! {
    /// The conversion of apertures to intrinsics. Isaac Sim's (RTX through 6.0) is `fx = fy = W · focalLength /
    /// horizontalAperture`, centred.
    Projection {
        /// Isaac Sim's: square pixels by the horizontal aperture, without aperture offsets.
        Isaac = "isaac",
        /// OpenUSD's: each axis by its own aperture, with aperture offsets.
        OpenUsd = "openusd",
    }
}

/// The reason why a camera prim has no intrinsics: `PRIM: what is wrong; what to do`.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{prim}: {what}; {remedy}")]
pub struct OpticsError {
    /// The path of the camera prim.
    pub prim: String,
    /// The problem, with the name of the attribute.
    pub what: String,
    /// The remedy.
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

/// Returns the default image size of a camera: [`DEFAULT_WIDTH`] wide, with the aspect ratio of its apertures, and at
/// least 1 pixel high.
///
/// # Errors
/// Returns an error if an aperture is not a positive number.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "the cast saturates, and images of that size are rejected"
)]
pub fn default_size(camera: &SceneCamera) -> Result<ImageSize, OpticsError> {
    let horizontal = positive(camera, "horizontalAperture", camera.horizontal_aperture())?;
    let vertical = positive(camera, "verticalAperture", camera.vertical_aperture())?;
    let height = (f64::from(DEFAULT_WIDTH) * vertical / horizontal)
        .round()
        .max(1.0);
    Ok(ImageSize::new(DEFAULT_WIDTH, height as u32))
}

/// Returns the intrinsics and the lens of a camera prim for an image of `size`, and findings about unsupported
/// attributes.
///
/// A lens-distortion schema for OpenCV's pinhole or fisheye model or the f-theta model replaces focal length and
/// apertures, whatever the projection. Its image is scaled from its own size to `size`, each axis separately; its cx and
/// cy are in OpenCV's convention, as assets author them. For other lens models, a finding is reported and the camera is
/// the pinhole of its apertures.
///
/// # Errors
/// Returns an error if the camera is not perspective, or if a focal length, an aperture or a value of the lens schema is
/// invalid.
pub fn camera(
    camera: &SceneCamera,
    size: ImageSize,
    projection: Projection,
) -> Result<(Camera, Vec<Finding>), OpticsError> {
    if !camera.is_perspective() {
        let projection = camera.prim.text("projection").unwrap_or_default();
        return Err(OpticsError::new(
            camera,
            format!("projection `{projection}` is not supported"),
            "set it to `perspective`, or choose another camera",
        ));
    }
    let mut findings = Vec::new();
    if let Some(view) = through_schema(camera, size, &mut findings)? {
        return Ok((view, findings));
    }
    let intrinsics = by_apertures(camera, size, projection, &mut findings)?;
    Ok((Camera::new(intrinsics, LensModel::Pinhole), findings))
}

/// Returns `clippingRange` (near, far) in metres. `None`, with a finding, if it is not a range in front of the camera.
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
        format!("invalid clippingRange ({near}, {far}); using the default"),
        "author (near, far) with 0 < near < far",
    );
    (None, Some(finding))
}

/// Whether a render product is a depth sensor's template: Kit's schema is applied to it, or ovrtx's to its camera.
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
                    "aperture offsets are ignored, as in Isaac Sim's renderer",
                    "use OpenUSD's projection to apply them",
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
    Err(OpticsError::new(
        camera,
        what,
        "author a focal length and apertures that give a finite, positive one",
    ))
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

/// Returns the camera that a lens schema describes; `None` if there is no supported schema.
fn through_schema(
    camera: &SceneCamera,
    size: ImageSize,
    findings: &mut Vec<Finding>,
) -> Result<Option<Camera>, OpticsError> {
    let prim = &camera.prim;
    let Some(lens) = Lens::of(prim) else {
        findings.extend(unapplied_lens(prim));
        return Ok(None);
    };
    let mut warn = |code, message: String, remedy| {
        findings.push(Finding::new(code, Level::Warning, &prim.path, message, remedy));
    };
    let named = prim.text(MODEL);
    if named != Some(lens.model) {
        let value = named.map_or_else(|| "not authored".to_owned(), |named| format!("`{named}`"));
        let message = format!(
            "{MODEL} is {value}, but {} is applied; using the latter",
            lens.schema
        );
        warn("lens-model", message, "set it to the applied schema's model");
    }
    let unusable = |what: &dyn std::fmt::Display| {
        OpticsError::new(
            camera,
            format!("{}: {what}", lens.schema),
            "author finite values, positive focal lengths and the image size that they apply to",
        )
    };
    let (view, own_size) = match lens.model {
        "opencvPinhole" | "opencvFisheye" => {
            let intrinsics = lens
                .intrinsics()
                .ok_or_else(|| unusable(&"fx, fy, cx, cy or imageSize is invalid"))?;
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
                    &"nominalWidth, nominalHeight, opticalCenter or maxFov is invalid",
                ));
            }
            (Camera::from_ftheta(lens, size), own)
        }
        model => {
            let message = format!("lens model `{model}` is not supported; using a pinhole");
            warn(
                "lens-unsupported",
                message,
                "describe the lens with one of OpenCV's models or f-theta",
            );
            return Ok(None);
        }
    };
    if (own_size.aspect() / size.aspect() - 1.0).abs() > 1e-3 {
        let message = format!("the lens schema is for {own_size} and is stretched to {size}");
        warn("lens-aspect", message, "render at the schema's aspect ratio");
    }
    Ok(Some(view))
}

/// Reports lens attributes on a prim without a lens schema, which have no effect.
fn unapplied_lens(prim: &Prim) -> Vec<Finding> {
    let warning = |code, message, remedy| Finding::new(code, Level::Warning, &prim.path, message, remedy);
    let model = prim
        .text(MODEL)
        .filter(|model| !model.is_empty() && *model != "pinhole");
    let legacy = prim
        .text("cameraProjectionType")
        .filter(|projection| *projection != "pinhole");
    let model = model.map(|model| {
        warning(
            "lens-model",
            format!("{MODEL} is `{model}`, but its lens schema is not applied; using a pinhole"),
            "add the schema to the prim's apiSchemas",
        )
    });
    let legacy = legacy.map(|projection| {
        warning(
            "lens-unsupported",
            format!("cameraProjectionType `{projection}` is deprecated; using a pinhole"),
            "describe the lens with a lens-distortion schema",
        )
    });
    model.into_iter().chain(legacy).collect()
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

/// Returns the same view in an image of another size, each axis scaled separately from the image's corner.
fn stretched(intrinsics: &Intrinsics, size: ImageSize) -> Intrinsics {
    let sx = f64::from(size.width) / f64::from(intrinsics.size.width);
    let sy = f64::from(size.height) / f64::from(intrinsics.size.height);
    let c = intrinsics.principal_point::<Usd>();
    let centre = PixelPoint::<Usd>::new(c.x * sx, c.y * sy);
    Intrinsics::new(size, intrinsics.fx * sx, intrinsics.fy * sy, centre)
}

#[cfg(test)]
mod tests;

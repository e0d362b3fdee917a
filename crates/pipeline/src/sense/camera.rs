//! The camera of depth images.

use std::path::Path;

use serde_json::Value;

use super::options::ImageCamera;
use super::{FieldOfView, SenseError};
use oaktwin_base::diagnostic::{Finding, Level, Message, message, opt};
use oaktwin_camera::math::{DMat3, DMat4, DVec3};
use oaktwin_camera::{
    Axes, Camera, ImageSize, Intrinsics, LensModel, OpenCv, OpenCvFisheye, OpenCvPinhole, PixelPoint,
    RigidTransform, Usd,
};
use oaktwin_files::{self as files, FileError};

/// The maximum size of a `camera_params` file.
const MAX_BYTES: u64 = 1 << 20;

/// Returns the camera of depth images of a size. Its field of view is the given one, else the field of view of the sensor's `own` camera.
///
/// # Errors
/// Returns an error if the field of view is invalid.
pub fn image_camera(
    size: ImageSize,
    given: FieldOfView,
    own: Intrinsics,
) -> Result<(Camera, Vec<Finding>), SenseError> {
    let mut findings = Vec::new();
    let images = of_images(size, given, None, own, &mut findings)?;
    Ok((images.camera, findings))
}

/// The camera of images of a size: from options or `camera_params`, else with the field of view of the sensor's own camera.
pub(super) fn of_images(
    size: ImageSize,
    given: FieldOfView,
    params: Option<&Path>,
    own: Intrinsics,
    findings: &mut Vec<Finding>,
) -> Result<ImageCamera, SenseError> {
    let pinhole = |intrinsics| Camera::new(intrinsics, LensModel::Pinhole);
    let centre = PixelPoint::<Usd>::new(f64::from(size.width) / 2.0, f64::from(size.height) / 2.0);
    let known = |camera: Camera| ImageCamera {
        is_models: camera.lens == LensModel::Pinhole && is_same(&camera.intrinsics, &own),
        camera,
    };
    match (given, params) {
        (FieldOfView::Camera(camera), _) => {
            let own = camera.intrinsics.size;
            if own != size {
                return Err(SenseError::option(format!(
                    "camera: its images are {own} instead of {size}; give a camera of the images' size"
                )));
            }
            if camera.lens != LensModel::Pinhole {
                findings.push(bent(
                    "camera",
                    "rectify them, and give the camera without the lens".into(),
                ));
            }
            Ok(known(camera))
        }
        (FieldOfView::FocalLength(fx), _) => {
            if !(fx.is_finite() && fx > 0.0) {
                return Err(SenseError::option(message![
                    opt("fx"),
                    format!(": must be a finite number > 0 (got {fx}); give the focal length in pixels")
                ]));
            }
            let intrinsics = Intrinsics::new(size, fx, fx, centre);
            if !intrinsics.has_finite_rays() {
                let is =
                    format!(": {fx:e} px is too short for images of {size}; give the focal length in pixels");
                return Err(SenseError::option(message![opt("fx"), is]));
            }
            Ok(known(pinhole(intrinsics)))
        }
        (FieldOfView::Degrees(hfov), _) => {
            if !(hfov > 0.0 && hfov < 180.0) {
                return Err(SenseError::option(message![
                    opt("hfov"),
                    format!(": {hfov} is out of range; give degrees above 0 and below 180")
                ]));
            }
            Ok(known(pinhole(Intrinsics::from_hfov(size, hfov.to_radians()))))
        }
        (FieldOfView::Known, Some(params)) => {
            let camera = read_params(params, size)?;
            if camera.lens != LensModel::Pinhole {
                let place = params.display().to_string();
                findings.push(bent(
                    &place,
                    message!["add ", opt("resample"), " to rectify them"],
                ));
            }
            Ok(known(camera))
        }
        (FieldOfView::Known, None) if size == own.size => Ok(ImageCamera {
            camera: pinhole(own),
            is_models: true,
        }),
        (FieldOfView::Known, None) => {
            findings.push(assumed_field_of_view(size, own));
            Ok(ImageCamera {
                camera: pinhole(with_width(own, size)),
                is_models: false,
            })
        }
    }
}

/// Scales intrinsics by the width of images, whose height is cropped or extended symmetrically.
fn with_width(own: Intrinsics, size: ImageSize) -> Intrinsics {
    let scale = f64::from(size.width) / f64::from(own.size.width);
    let c = own.principal_point::<Usd>();
    let cy = f64::from(size.height) / 2.0 + (c.y - f64::from(own.size.height) / 2.0) * scale;
    let centre = PixelPoint::<Usd>::new(c.x * scale, cy);
    Intrinsics::new(size, own.fx * scale, own.fy * scale, centre)
}

/// A note about images of another size, whose field of view is not known.
fn assumed_field_of_view(size: ImageSize, own: Intrinsics) -> Finding {
    let message = format!(
        "not the model's image size of {}; assuming its horizontal field of view of {:.2}°",
        own.size,
        own.hfov().to_degrees()
    );
    let remedy = message![
        "set ",
        opt("fx"),
        " or ",
        opt("hfov"),
        " if it differs, or ",
        opt("resample"),
        " to get images of the model's size"
    ];
    Finding::new("own-size", Level::Note, size.to_string(), message, remedy)
}

/// A warning about images with lens distortion.
fn bent(place: &str, remedy: Message) -> Finding {
    Finding::new(
        "image-lens",
        Level::Warning,
        place,
        "the images have lens distortion, but a depth sensor's are rectified; used without rectification",
        remedy,
    )
}

fn is_same(a: &Intrinsics, b: &Intrinsics) -> bool {
    let near = |a: f64, b: f64| (a - b).abs() <= 1e-5 * b.abs();
    let (ca, cb) = (a.principal_point::<Usd>(), b.principal_point::<Usd>());
    a.size == b.size && near(a.fx, b.fx) && near(a.fy, b.fy) && near(ca.x, cb.x) && near(ca.y, cb.y)
}

/// The pose in metres and the metres per unit in Replicator's `camera_params`; `None` if they are missing or invalid.
pub(super) fn read_pose(path: &Path) -> Option<(RigidTransform, f64)> {
    let bytes = files::read(path, MAX_BYTES, "camera_params").ok()?;
    let params: Value = serde_json::from_slice(&bytes).ok()?;
    let list = params["cameraViewTransform"].as_array()?;
    let numbers: Vec<f64> = list.iter().filter_map(Value::as_f64).collect();
    let meters_per_unit = params["metersPerSceneUnit"]
        .as_f64()
        .filter(|scale| *scale > 0.0)?;
    // The four rows for points as rows are the columns for points as columns.
    let view = DMat4::from_cols_array(&numbers.try_into().ok()?);
    let usd_from_world =
        RigidTransform::new(DMat3::from_mat4(view), view.w_axis.truncate() * meters_per_unit);
    let opencv_from_usd = RigidTransform::new(Axes::OpenCv.rotation_from(Axes::Usd), DVec3::ZERO);
    let pose = (opencv_from_usd * usd_from_world).inverse();
    (pose.orthonormality_error() < 1e-3 && pose.translation.is_finite()).then_some((pose, meters_per_unit))
}

/// Replicator's `camera_params`.
pub(super) fn read_params(path: &Path, size: ImageSize) -> Result<Camera, FileError> {
    let wrong = |message: String| {
        FileError::new(
            path,
            message,
            message!["render the camera again, or set ", opt("fx")],
        )
    };
    let bytes = files::read(path, MAX_BYTES, "camera_params")?;
    let params: Value = serde_json::from_slice(&bytes).map_err(|error| wrong(error.to_string()))?;
    let numbers = |key: &str| -> Vec<f64> {
        let list = params[key].as_array().map(Vec::as_slice).unwrap_or_default();
        list.iter().filter_map(Value::as_f64).collect()
    };
    let number = |key: &str| params[key].as_f64();
    let resolution = numbers("renderProductResolution");
    if resolution != [f64::from(size.width), f64::from(size.height)] {
        return Err(wrong(format!(
            "renderProductResolution: {resolution:?} instead of the depth image's {size}"
        )));
    }
    let (width, height) = (f64::from(size.width), f64::from(size.height));
    let projection = numbers("cameraProjection");
    if projection.len() != 16 {
        return Err(wrong("cameraProjection: not 16 numbers".to_owned()));
    }
    let at = |i: usize| projection.get(i).copied().unwrap_or(f64::NAN);
    let pinhole = Intrinsics::new(
        size,
        at(0) * width / 2.0,
        at(5) * height / 2.0,
        PixelPoint::<Usd>::new((1.0 - at(8)) * width / 2.0, (1.0 + at(9)) * height / 2.0),
    );
    let model = params["cameraModel"].as_str().unwrap_or("pinhole");
    let camera = match model {
        "pinholeOpenCV" | "fisheyeOpenCV" => {
            let (Some(fx), Some(fy)) = (number("cameraOpenCVFx"), number("cameraOpenCVFy")) else {
                return Err(wrong("cameraOpenCVFx, cameraOpenCVFy: missing".to_owned()));
            };
            let [cx, cy] = numbers("cameraFisheyeOpticalCentre")[..] else {
                return Err(wrong("cameraFisheyeOpticalCentre: not two numbers".to_owned()));
            };
            let intrinsics = Intrinsics::new(size, fx, fy, PixelPoint::<OpenCv>::new(cx, cy));
            let k = |i: usize| numbers("cameraFisheyePolynomial").get(i).copied().unwrap_or(0.0);
            let lens = if model == "fisheyeOpenCV" {
                LensModel::OpenCvFisheye(OpenCvFisheye {
                    k: [k(0), k(1), k(2), k(3)],
                })
            } else {
                let (p, s) = (numbers("cameraFisheyeLensP"), numbers("cameraFisheyeLensS"));
                let of = |list: &[f64], i: usize| list.get(i).copied().unwrap_or(0.0);
                let mut coefficients = [0.0; 14];
                coefficients[..8].copy_from_slice(&[
                    k(0),
                    k(1),
                    of(&p, 0),
                    of(&p, 1),
                    k(2),
                    k(3),
                    k(4),
                    k(5),
                ]);
                for (i, place) in coefficients[8..12].iter_mut().enumerate() {
                    *place = of(&s, i);
                }
                LensModel::OpenCvPinhole(OpenCvPinhole::new(coefficients))
            };
            Camera::new(intrinsics, lens)
        }
        "pinhole" => Camera::new(pinhole, LensModel::Pinhole),
        other => {
            return Err(wrong(format!("cameraModel: {other} is not supported")));
        }
    };
    let k = camera.intrinsics;
    if [k.fx, k.fy].iter().all(|f| f.is_finite() && *f > 0.0) {
        Ok(camera)
    } else {
        Err(wrong(format!("the focal length must be > 0 (got {})", k.fx)))
    }
}

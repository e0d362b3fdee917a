//! ROS's `camera_info`: the YAML of `camera_info_manager`, and what `ros2 topic echo` prints.

use oaktwin_camera::math::DVec3;

use super::CalibrationImportOptions;
use super::field::Field;
use super::part::{Camera, Family, Parts, Rectified, intrinsics, lens, rotation, size, socket, stem};
use crate::CalibrationError;
use crate::raw::Value;

const MATRIX: [&str; 3] = ["camera_matrix", "k", "K"];
const DISTORTION: [&str; 3] = ["distortion_coefficients", "d", "D"];
const ROTATION: [&str; 3] = ["rectification_matrix", "r", "R"];
const PROJECTION: [&str; 3] = ["projection_matrix", "p", "P"];

pub(super) fn recognizes(root: &Field<'_>) -> bool {
    root.get("distortion_model").is_some() || root.any(&PROJECTION).is_some() && root.any(&MATRIX).is_some()
}

pub(super) fn read(
    root: &Field<'_>,
    options: &CalibrationImportOptions,
    parts: &mut Parts,
) -> Result<(), CalibrationError> {
    let name = match root.get("camera_name") {
        Some(name) => Some(name.text()?.to_owned()),
        None => None,
    };
    let names: Vec<String> = name.into_iter().chain([stem(root.file)]).collect();
    let socket = socket(root, &names, options)?;
    let size = size(
        root,
        [&["image_width", "width"], &["image_height", "height"]],
        options,
    )?;
    let matrix = root.require(&MATRIX)?;
    parts.cameras.push(Camera {
        file: root.file.to_owned(),
        place: root.path().to_owned(),
        names,
        socket,
        intrinsics: intrinsics(&matrix, size, matrix.exactly("a camera matrix")?)?,
        lens: distortion(root)?,
        rectified: rectified(root, options)?,
        is_of_pair_file: false,
    });
    Ok(())
}

fn distortion(root: &Field<'_>) -> Result<oaktwin_camera::LensModel, CalibrationError> {
    let model = root.require(&["distortion_model"])?;
    let name = model.text()?;
    let (family, counts): (_, &[usize]) = match name {
        "plumb_bob" => (Family::Pinhole, &[4, 5]),
        "rational_polynomial" => (Family::Pinhole, &[8, 12, 14]),
        "equidistant" | "fisheye" => (Family::Fisheye, &[4]),
        _ => {
            let what = format!("the model \"{name}\" has no counterpart in DepthAI");
            let remedy = "calibrate with plumb_bob, rational_polynomial or equidistant";
            return Err(model.error("distortion-model", what, remedy));
        }
    };
    lens(&root.require(&DISTORTION)?, family, name, counts)
}

/// Returns the rectification; `None` if the camera was calibrated alone.
fn rectified(
    root: &Field<'_>,
    options: &CalibrationImportOptions,
) -> Result<Option<Rectified>, CalibrationError> {
    let (Some(r), Some(p)) = (root.any(&ROTATION), root.any(&PROJECTION)) else {
        return Ok(None);
    };
    let is_zero = |field: &Field<'_>| matches!(field.numbers(), Ok(all) if all.iter().all(|x| *x == 0.0));
    if is_zero(&p) || matches!(&p.node.value, Value::Array(items) if items.is_empty()) {
        return Ok(None);
    }
    let rectified_from_camera = rotation(&r, r.exactly("a rectification matrix")?)?;
    let [fx, _, _, tx, _, fy, _, ty, ..] = p.exactly::<12>("a projection matrix")?;
    if fx <= 0.0 || fy <= 0.0 {
        let what = format!("focal lengths {fx} and {fy} px; both must be positive");
        return Err(p.error("focal-length", what, "calibrate the pair"));
    }
    Ok(Some(Rectified {
        rectified_from_camera,
        translation: options.unit.in_metres() * DVec3::new(tx / fx, ty / fy, 0.0),
    }))
}

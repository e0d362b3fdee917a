//! OpenCV's `FileStorage`: files of one camera, and the files of the `stereo_calib` sample.

use oaktwin_camera::math::DVec3;
use oaktwin_camera::{ImageSize, LensModel, RigidTransform};

use super::CalibrationImportOptions;
use super::field::Field;
use super::part::{Camera, Family, Link, Parts, intrinsics, lens, rotation, size, socket, stem};
use crate::CalibrationError;

const MATRIX: [&str; 5] = ["camera_matrix", "cameraMatrix", "Camera_Matrix", "K", "mtx"];
const DISTORTION: [&str; 6] = [
    "distortion_coefficients",
    "distCoeffs",
    "dist_coeffs",
    "Distortion_Coefficients",
    "D",
    "dist",
];
/// The cameras of a pair: the keys of matrix and coefficients, and the position.
const PAIR: [([&str; 3], [&str; 3], &str); 2] = [
    (
        ["M1", "cameraMatrix1", "K1"],
        ["D1", "distCoeffs1", "dist1"],
        "left",
    ),
    (
        ["M2", "cameraMatrix2", "K2"],
        ["D2", "distCoeffs2", "dist2"],
        "right",
    ),
];
const WIDTH: [&str; 3] = ["image_width", "width", "image_Width"];
const HEIGHT: [&str; 3] = ["image_height", "height", "image_Height"];

pub(super) fn recognizes(root: &Field<'_>) -> bool {
    let has_pair = PAIR.iter().any(|(matrix, ..)| root.any(matrix).is_some());
    has_pair || root.any(&MATRIX).is_some() || root.get("R").is_some() && root.get("T").is_some()
}

pub(super) fn read(
    root: &Field<'_>,
    options: &CalibrationImportOptions,
    parts: &mut Parts,
) -> Result<(), CalibrationError> {
    if root.any(&MATRIX).is_some() {
        let names = [stem(root.file)];
        let camera = camera(root, &MATRIX, &DISTORTION, &names, options)?;
        parts.cameras.push(camera);
    }
    for (matrix, distortion, position) in &PAIR {
        if root.any(matrix).is_some() {
            let names = pair_names(matrix, position);
            let camera = camera(root, matrix, distortion, &names, options)?;
            parts.cameras.push(Camera {
                is_of_pair_file: true,
                ..camera
            });
        }
    }
    // A pair's file may have a rotation without a translation only if it is another kind of file.
    if let (Some(r), Some(t)) = (root.get("R"), root.get("T")) {
        let rotation = rotation(&r, r.exactly("a rotation")?)?;
        let translation = options.unit.in_metres() * DVec3::from(t.exactly("a translation")?);
        let [left, right] = PAIR.map(|(matrix, _, position)| {
            let names = pair_names(&matrix, position);
            socket(&r, &names, options)
        });
        parts.links.push(Link {
            file: root.file.to_owned(),
            place: t.path().to_owned(),
            from: left?,
            to: right?,
            to_from_from: RigidTransform::new(rotation, translation),
        });
    }
    Ok(())
}

fn pair_names(matrix: &[&str], position: &str) -> Vec<String> {
    let first = matrix.first().copied();
    first.into_iter().chain([position]).map(str::to_owned).collect()
}

fn camera(
    root: &Field<'_>,
    matrix: &[&str],
    distortion: &[&str],
    names: &[String],
    options: &CalibrationImportOptions,
) -> Result<Camera, CalibrationError> {
    let matrix = root.require(matrix)?;
    let size = image_size(root, options)?;
    Ok(Camera {
        file: root.file.to_owned(),
        place: matrix.path().to_owned(),
        names: names.to_vec(),
        socket: socket(&matrix, names, options)?,
        intrinsics: intrinsics(&matrix, size, matrix.exactly("a camera matrix")?)?,
        lens: lens_of(root, &root.require(distortion)?, options)?,
        rectified: None,
        is_of_pair_file: false,
    })
}

/// Returns the size in two keys, or in one list such as `image_size: [1280, 800]`.
fn image_size(root: &Field<'_>, options: &CalibrationImportOptions) -> Result<ImageSize, CalibrationError> {
    if let Some(list) = root.any(&["image_size", "imageSize"])
        && let [width, height] = list.items()?.as_slice()
    {
        return Ok(ImageSize::new(width.side()?, height.side()?));
    }
    size(root, [&WIDTH, &HEIGHT], options)
}

fn lens_of(
    root: &Field<'_>,
    distortion: &Field<'_>,
    options: &CalibrationImportOptions,
) -> Result<LensModel, CalibrationError> {
    let is_fisheye = match root.any(&["fisheye_model", "fisheye"]) {
        Some(flag) => match &flag.node.value {
            crate::raw::Value::Bool(is_fisheye) => *is_fisheye,
            _ => flag.number()? != 0.0,
        },
        None => options.is_fisheye,
    };
    if is_fisheye {
        return lens(distortion, Family::Fisheye, "OpenCV's fisheye model", &[4]);
    }
    lens(
        distortion,
        Family::Pinhole,
        "OpenCV's pinhole model",
        &[4, 5, 8, 12, 14],
    )
}

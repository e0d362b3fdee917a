//! Kalibr's `camchain.yaml` and `camchain-imucam.yaml`.

use oaktwin_base::diagnostic::{Finding, Level};
use oaktwin_camera::math::DVec3;
use oaktwin_camera::{ImageSize, LensModel, RigidTransform};

use super::field::Field;
use super::part::{Camera, Family, Link, Parts, intrinsics, lens, rotation, socket};
use super::{CalibrationImportOptions, FileFinding, name};
use crate::raw::Value;
use crate::{CalibrationError, Socket};

pub(super) fn recognizes(root: &Field<'_>) -> bool {
    root.get("cam0").is_some()
}

/// Whether the file has the noise of an inertial unit, which is no part of a calibration.
pub(super) fn is_imu_noise(root: &Field<'_>) -> bool {
    [Some(root.clone()), root.get("imu0")]
        .into_iter()
        .flatten()
        .any(|imu| imu.get("gyroscope_noise_density").is_some())
}

pub(super) fn read(
    root: &Field<'_>,
    options: &CalibrationImportOptions,
    parts: &mut Parts,
) -> Result<(), CalibrationError> {
    let Value::Object(entries) = &root.node.value else {
        return Ok(());
    };
    let mut before: Option<Socket> = None;
    for i in 0..entries.len() {
        let Some(field) = root.get(&format!("cam{i}")) else {
            break;
        };
        let camera = camera(&field, i, options)?;
        let socket = camera.socket;
        parts.cameras.push(camera);
        if let Some(before) = before {
            link(&field, [before, socket], options, parts)?;
        }
        if let Some(pose) = field.get("T_cam_imu") {
            parts.imu.push((socket, transform(&pose, options)?));
        }
        before = Some(socket);
    }
    Ok(())
}

/// Adds the extrinsics between a camera and the one before it.
fn link(
    field: &Field<'_>,
    [before, socket]: [Socket; 2],
    options: &CalibrationImportOptions,
    parts: &mut Parts,
) -> Result<(), CalibrationError> {
    let Some(pose) = field.get("T_cn_cnm1") else {
        parts.findings.push(FileFinding {
            file: field.file.to_owned(),
            finding: Finding::new(
                "not-joined",
                Level::Warning,
                field.key_path("T_cn_cnm1"),
                format!("missing, so no extrinsics connect {before} and {socket}"),
                "calibrate the cameras together",
            ),
        });
        return Ok(());
    };
    parts.links.push(Link {
        file: field.file.to_owned(),
        place: pose.path().to_owned(),
        from: before,
        to: socket,
        to_from_from: transform(&pose, options)?,
    });
    Ok(())
}

fn camera(
    field: &Field<'_>,
    number: usize,
    options: &CalibrationImportOptions,
) -> Result<Camera, CalibrationError> {
    let model = field.require(&["camera_model"])?;
    if model.text()? != "pinhole" {
        let what = format!("the model \"{}\" has no counterpart in DepthAI", model.text()?);
        return Err(model.error(
            "camera-model",
            what,
            "calibrate with pinhole-radtan or pinhole-equi",
        ));
    }
    let mut names = vec![format!("cam{number}")];
    if let Some(topic) = field.get("rostopic") {
        let words = topic.text()?.split('/').filter(|word| !word.is_empty());
        names.extend(words.take(1).map(str::to_owned));
    }
    // Kalibr's own examples name left first, then right.
    let customary = [Socket::CAM_B, Socket::CAM_C, Socket::CAM_A];
    let socket = match (name::socket(&names, &options.cameras), customary.get(number)) {
        (Some(socket), _) | (None, Some(&socket)) => socket,
        (None, None) => socket(field, &names, options)?,
    };
    let resolution = field.require(&["resolution"])?;
    let size = match resolution.items()?.as_slice() {
        [width, height] => ImageSize::new(width.side()?, height.side()?),
        other => {
            let what = format!("{} numbers; a resolution has 2", other.len());
            return Err(resolution.error("image-size", what, "state width and height"));
        }
    };
    let of_intrinsics = field.require(&["intrinsics"])?;
    let [fx, fy, cx, cy] = of_intrinsics.exactly("a pinhole (fx, fy, cx, cy)")?;
    Ok(Camera {
        file: field.file.to_owned(),
        place: field.path().to_owned(),
        names,
        socket,
        intrinsics: intrinsics(&of_intrinsics, size, [fx, 0.0, cx, 0.0, fy, cy, 0.0, 0.0, 1.0])?,
        lens: distortion(field)?,
        rectified: None,
        is_of_pair_file: false,
    })
}

fn distortion(field: &Field<'_>) -> Result<LensModel, CalibrationError> {
    let model = field.require(&["distortion_model"])?;
    let (name, counts): (_, &[usize]) = (model.text()?, &[4]);
    let family = match name {
        "radtan" => Family::Pinhole,
        "equidistant" => Family::Fisheye,
        "none" => return Ok(LensModel::Pinhole),
        _ => {
            let what = format!("the model \"{name}\" has no counterpart in DepthAI");
            let remedy = "calibrate with pinhole-radtan or pinhole-equi";
            return Err(model.error("distortion-model", what, remedy));
        }
    };
    lens(&field.require(&["distortion_coeffs"])?, family, name, counts)
}

fn transform(
    field: &Field<'_>,
    options: &CalibrationImportOptions,
) -> Result<RigidTransform, CalibrationError> {
    let [a, b, c, x, d, e, f, y, g, h, i, z, ..] = field.exactly::<16>("a 4x4 matrix")?;
    let rotation = rotation(field, [a, b, c, d, e, f, g, h, i])?;
    let translation = options.unit.in_metres() * DVec3::new(x, y, z);
    Ok(RigidTransform::new(rotation, translation))
}

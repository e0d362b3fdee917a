use std::path::Path;

use oaktwin_base::diagnostic::{message, opt};
use oaktwin_camera::math::{DMat3, DVec3};
use oaktwin_camera::{ImageSize, Intrinsics, LensModel, OpenCvFisheye, OpenCvPinhole, RigidTransform};

use super::field::{Field, error};
use super::{CalibrationImportOptions, FileFinding, name};
use crate::{CalibrationError, Socket};

/// The orthonormality error that makes a rotation invalid, as in `DepthAI` files.
const INVALID_ROTATION: f64 = 1e-2;

/// What the files contain.
#[derive(Default)]
pub(super) struct Parts {
    pub(super) cameras: Vec<Camera>,
    pub(super) links: Vec<Link>,
    /// The pose of the inertial unit in cameras.
    pub(super) imu: Vec<(Socket, RigidTransform)>,
    pub(super) findings: Vec<FileFinding>,
}

pub(super) struct Camera {
    pub(super) file: String,
    pub(super) place: String,
    pub(super) names: Vec<String>,
    pub(super) socket: Socket,
    pub(super) intrinsics: Intrinsics,
    pub(super) lens: LensModel,
    /// The rectification in ROS's files.
    pub(super) rectified: Option<Rectified>,
    /// Whether the camera is repeated in a file of a stereo pair, where it may be scaled to the size of the other one.
    pub(super) is_of_pair_file: bool,
}

/// R and P of ROS's `camera_info`.
pub(super) struct Rectified {
    pub(super) rectified_from_camera: DMat3,
    /// The position of the camera's optical centre in the frame of the left one, which is also rectified, negated; m.
    pub(super) translation: DVec3,
}

/// The extrinsics between two cameras.
pub(super) struct Link {
    pub(super) file: String,
    pub(super) place: String,
    pub(super) from: Socket,
    pub(super) to: Socket,
    pub(super) to_from_from: RigidTransform,
}

/// The lens models of all formats.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Family {
    Pinhole,
    Fisheye,
}

/// Returns the socket of a camera with these names.
pub(super) fn socket(
    field: &Field<'_>,
    names: &[String],
    options: &CalibrationImportOptions,
) -> Result<Socket, CalibrationError> {
    name::socket(names, &options.cameras).ok_or_else(|| {
        let name = names.first().map_or("camera", String::as_str);
        field.error(
            "no-socket",
            format!("the name \"{name}\" does not state the position of the camera"),
            message![
                "state it with ",
                opt("camera").with(format!("{name}=left")),
                ", right, rgb or cam_d"
            ],
        )
    })
}

/// Returns the name of a file without folder and extension.
pub(super) fn stem(file: &str) -> String {
    let stem = Path::new(file).file_stem();
    stem.map_or_else(String::new, |stem| stem.to_string_lossy().into_owned())
}

/// Returns the image size in the keys, or the size of the options if they are missing.
pub(super) fn size(
    parent: &Field<'_>,
    [width, height]: [&[&str]; 2],
    options: &CalibrationImportOptions,
) -> Result<ImageSize, CalibrationError> {
    if let (Some(width), Some(height)) = (parent.any(width), parent.any(height)) {
        return Ok(ImageSize::new(width.side()?, height.side()?));
    }
    options.size.ok_or_else(|| {
        let place = parent.key_path(width.first().copied().unwrap_or_default());
        error(
            parent.file,
            &place,
            "image-size",
            "the size of the images is missing",
            message!["state it with ", opt("size").with("1280x800")],
        )
    })
}

/// Returns the intrinsics of OpenCV's camera matrix, row by row.
pub(super) fn intrinsics(
    field: &Field<'_>,
    size: ImageSize,
    k: [f64; 9],
) -> Result<Intrinsics, CalibrationError> {
    let [fx, skew, cx, zero, fy, cy, last @ ..] = k;
    if fx <= 0.0 || fy <= 0.0 {
        let what = format!("focal lengths {fx} and {fy} px; both must be positive");
        return Err(field.error("focal-length", what, "calibrate the camera"));
    }
    if skew != 0.0 || zero != 0.0 || last != [0.0, 0.0, 1.0] {
        let what = "not of the form [fx, 0, cx, 0, fy, cy, 0, 0, 1]";
        return Err(field.error("intrinsic-form", what, "calibrate without skew"));
    }
    Ok(Intrinsics::from_opencv_matrix(
        size,
        [[fx, 0.0, cx], [0.0, fy, cy], [0.0, 0.0, 1.0]],
    ))
}

/// Returns the lens with coefficients of a model that has one of these numbers of them.
pub(super) fn lens(
    field: &Field<'_>,
    family: Family,
    model: &str,
    counts: &[usize],
) -> Result<LensModel, CalibrationError> {
    let coefficients = field.numbers()?;
    if !counts.contains(&coefficients.len()) {
        let counts: Vec<String> = counts.iter().map(ToString::to_string).collect();
        let what = format!(
            "{} coefficients; {model} has {}",
            coefficients.len(),
            counts.join(" or ")
        );
        let remedy = "correct the model or the coefficients, or calibrate again";
        return Err(field.error("distortion-length", what, remedy));
    }
    let lens = match family {
        Family::Fisheye => OpenCvFisheye::from_slice(&coefficients).map(LensModel::OpenCvFisheye),
        Family::Pinhole if coefficients.iter().all(|c| *c == 0.0) => Ok(LensModel::Pinhole),
        Family::Pinhole => OpenCvPinhole::from_slice(&coefficients).map(LensModel::OpenCvPinhole),
    };
    lens.map_err(|error| field.error("distortion-length", error.to_string(), "calibrate again"))
}

/// Returns a rotation from its rows.
pub(super) fn rotation(field: &Field<'_>, rows: [f64; 9]) -> Result<DMat3, CalibrationError> {
    let rotation = DMat3::from_cols_array(&rows).transpose();
    let off = RigidTransform::new(rotation, DVec3::ZERO).orthonormality_error();
    if off > INVALID_ROTATION || off.is_nan() {
        let what = "not a rotation: its rows are not orthonormal";
        return Err(field.error("skewed-rotation", what, "calibrate again"));
    }
    Ok(rotation)
}

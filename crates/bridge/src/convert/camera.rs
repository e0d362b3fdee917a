use oaktwin::camera::{Camera, ImageSize, Intrinsics, LensModel, OpenCvFisheye, OpenCvPinhole};

use super::MessageError;
use crate::message::{CameraInfo, Header, RegionOfInterest};

/// Converts camera info to the camera of its raw image.
///
/// # Errors
/// Returns an error if the camera is uncalibrated, the info is about another image than the published one (binning, a
/// region), or its distortion model is unknown.
pub fn camera(info: &CameraInfo) -> Result<Camera, MessageError> {
    let size = ImageSize::new(info.width, info.height);
    if size.width == 0 || size.height == 0 {
        return Err(MessageError::new(
            "width, height",
            format!("an image of {size} has no pixels"),
            "publish the size of the depth image",
        ));
    }
    let [fx, skew, cx, _, fy, cy, ..] = info.k;
    let is_focal_length = |f: f64| f.is_finite() && f > 0.0;
    if !is_focal_length(fx) || !is_focal_length(fy) {
        return Err(MessageError::new(
            "k",
            format!("the focal lengths must be > 0 px (got {fx} and {fy})"),
            "publish the intrinsics of the depth image",
        ));
    }
    if !(cx.is_finite() && cy.is_finite() && skew == 0.0) {
        return Err(MessageError::new(
            "k",
            format!("the principal point ({cx}, {cy}) must be finite, and the skew 0 (got {skew})"),
            "publish the intrinsics of the depth image",
        ));
    }
    check_region(info, size)?;
    let k = [[fx, 0.0, cx], [0.0, fy, cy], [0.0, 0.0, 1.0]];
    let intrinsics = Intrinsics::from_opencv_matrix(size, k);
    if !intrinsics.has_finite_rays() {
        return Err(MessageError::new(
            "k",
            format!("{fx:e} px is too short for images of {size}"),
            "publish the intrinsics of the depth image",
        ));
    }
    Ok(Camera::new(intrinsics, lens(info)?))
}

fn check_region(info: &CameraInfo, size: ImageSize) -> Result<(), MessageError> {
    let RegionOfInterest {
        x_offset,
        y_offset,
        height,
        width,
        ..
    } = info.roi;
    let is_whole = [(0, 0), (size.width, size.height)].contains(&(width, height));
    if info.binning_x > 1 || info.binning_y > 1 || !is_whole || x_offset > 0 || y_offset > 0 {
        return Err(MessageError::new(
            "binning_x, binning_y, roi",
            "describe another image than the published one",
            "publish the camera info of the image itself, without binning and region",
        ));
    }
    Ok(())
}

fn lens(info: &CameraInfo) -> Result<LensModel, MessageError> {
    if info.d.iter().all(|coefficient| *coefficient == 0.0) {
        return Ok(LensModel::Pinhole);
    }
    let wrong = |what: String| MessageError::new("d", what, "publish the camera info of a rectified image");
    match info.distortion_model.as_str() {
        "plumb_bob" | "rational_polynomial" => OpenCvPinhole::from_slice(&info.d)
            .map(LensModel::OpenCvPinhole)
            .map_err(|error| wrong(error.to_string())),
        "equidistant" => OpenCvFisheye::from_slice(&info.d)
            .map(LensModel::OpenCvFisheye)
            .map_err(|error| wrong(error.to_string())),
        other => {
            let shown: String = other.chars().take(40).collect();
            Err(MessageError::new(
                "distortion_model",
                format!("'{shown}' is unknown"),
                "expected plumb_bob, rational_polynomial or equidistant",
            ))
        }
    }
}

/// Returns the camera info of an image without distortion.
#[must_use]
pub fn camera_info(header: Header, intrinsics: &Intrinsics) -> CameraInfo {
    let k = intrinsics.opencv_matrix();
    let mut p = [0.0; 12];
    for (row, numbers) in p.chunks_exact_mut(4).zip(&k) {
        row[..3].copy_from_slice(numbers);
    }
    let mut flat = [0.0; 9];
    flat.copy_from_slice(k.as_flattened());
    CameraInfo {
        header,
        height: intrinsics.size.height,
        width: intrinsics.size.width,
        distortion_model: "plumb_bob".to_owned(),
        d: vec![0.0; 5],
        k: flat,
        r: [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0],
        p,
        ..CameraInfo::default()
    }
}

//! The lens of an image, as formats describe it.

use oaktwin_camera::LensModel;

use crate::{DatasetError, FrameCamera, Shot, WriteError};

use super::common::missing;

/// A lens that a format may describe.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Lens {
    /// No distortion.
    Pinhole,
    /// OpenCV's radial and tangential terms: k1 to k6, and p1 and p2.
    Radial { k: [f64; 6], p: [f64; 2] },
    /// OpenCV's fisheye: k1 to k4.
    Fisheye([f64; 4]),
}

/// Returns the camera of a shot and its lens, of which the format describes this many radial terms.
pub(super) fn lens<'a>(
    format: &'static str,
    shot: &'a Shot,
    radial_terms: usize,
) -> Result<(&'a FrameCamera, Lens), WriteError> {
    let view = shot
        .view
        .as_ref()
        .ok_or_else(|| missing(format, "the camera of each frame"))?;
    let fault = |what| {
        let remedy = "choose the depth camera, whose images are rectified, or the format basic".into();
        Err(DatasetError::Missing { format, what, remedy }.into())
    };
    Ok((
        view,
        match &view.camera.lens {
            LensModel::Pinhole => Lens::Pinhole,
            LensModel::OpenCvFisheye(lens) => Lens::Fisheye(lens.k),
            LensModel::FTheta(_) => return fault("a lens of OpenCV's models"),
            LensModel::OpenCvPinhole(lens) => {
                let [k1, k2, p1, p2, k3, k4, k5, k6, rest @ ..] = *lens.coefficients();
                let k = [k1, k2, k3, k4, k5, k6];
                if rest.iter().any(|term| *term != 0.0) {
                    return fault("a lens without thin-prism terms and without a tilted sensor");
                }
                if k.iter().skip(radial_terms).any(|term| *term != 0.0) {
                    return fault("a lens with fewer radial terms");
                }
                Lens::Radial { k, p: [p1, p2] }
            }
        },
    ))
}

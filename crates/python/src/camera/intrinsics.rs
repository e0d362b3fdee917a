//! The intrinsics and the lens of a camera, from the arguments of Python.

use oaktwin::camera::{ImageSize, Intrinsics, LensFamily, LensModel};
use pyo3::prelude::*;

use crate::array::numbers;
use crate::choice::choose;
use crate::error::{error, wrong};

/// Reads a lens model and its coefficients.
pub(super) fn lens(name: &str, coefficients: &[f64]) -> PyResult<LensModel> {
    let families: Vec<_> = LensFamily::ALL
        .iter()
        .map(|family| (family.name, family))
        .collect();
    let family = choose("lens", name, &families)?;
    (family.from_coefficients)(coefficients).map_err(|found| error(format!("distortion: {found}")))
}

/// Reads a camera matrix, or a field of view: horizontal, or vertical.
pub(super) fn read(
    size: ImageSize,
    k: Option<&Bound<'_, PyAny>>,
    hfov_deg: Option<f64>,
    vfov_deg: Option<f64>,
) -> PyResult<Intrinsics> {
    let angle = |name: &str, degrees: f64| match degrees > 0.0 && degrees < 180.0 {
        true => Ok(degrees.to_radians()),
        false => Err(wrong(
            name,
            format_args!("{degrees} is out of range"),
            "pass degrees above 0 and below 180",
        )),
    };
    match (k, hfov_deg, vfov_deg) {
        (Some(k), None, None) => {
            let (shape, array) = numbers("K", k)?;
            let values = array.as_slice().map_err(error)?;
            let (rows, _) = values.as_chunks::<3>();
            let ([3, 3], [a, b, c]) = (&shape[..], rows) else {
                return Err(wrong(
                    "K",
                    format_args!("has shape {shape:?}"),
                    "pass a 3x3 camera matrix",
                ));
            };
            let made = Intrinsics::from_opencv_matrix(size, [*a, *b, *c]);
            let is_camera = values.iter().all(|number| number.is_finite())
                && made.fx > 0.0
                && made.fy > 0.0
                && a[1] == 0.0
                && b[0] == 0.0
                && *c == [0.0, 0.0, 1.0];
            if is_camera && !made.has_finite_rays() {
                let is = format!(
                    "has focal lengths of {:e} and {:e} px, too short for its principal point",
                    made.fx, made.fy
                );
                return Err(wrong("K", is, "pass focal lengths and principal point in pixels"));
            }
            if is_camera {
                Ok(made)
            } else {
                Err(wrong(
                    "K",
                    "is not a camera matrix",
                    "pass [[fx, 0, cx], [0, fy, cy], [0, 0, 1]], px",
                ))
            }
        }
        (None, Some(hfov), None) => Ok(Intrinsics::from_hfov(size, angle("hfov_deg", hfov)?)),
        (None, None, Some(vfov)) => {
            // Pixels are square.
            let aspect = f64::from(size.width) / f64::from(size.height);
            let half_width = (angle("vfov_deg", vfov)? / 2.0).tan() * aspect;
            Ok(Intrinsics::from_hfov(size, 2.0 * half_width.atan()))
        }
        _ => Err(wrong(
            "K, hfov_deg, vfov_deg",
            "exactly one is required",
            "pass one of them",
        )),
    }
}

use oaktwin::sense::FieldOfView;
use pyo3::prelude::*;

use crate::camera::Camera;
use crate::error::wrong;

/// The relative difference of equal focal lengths: the rounding of single precision.
const SAME: f64 = 1e-5;

/// Returns the field of view from the options. A camera takes precedence, and the other options must agree with it.
pub(super) fn field_of_view(
    fx: Option<f64>,
    hfov_deg: Option<f64>,
    camera: Option<&Camera>,
) -> PyResult<FieldOfView> {
    if fx.is_some() && hfov_deg.is_some() {
        return Err(wrong("fx, hfov_deg", "both say the same", "give one"));
    }
    let said = FieldOfView::given(fx, hfov_deg);
    let Some(camera) = camera.map(|camera| camera.camera) else {
        return Ok(said);
    };
    let own = camera.intrinsics;
    let (option, given, of_camera) = match said {
        FieldOfView::FocalLength(fx) => ("fx", fx, own.fx),
        FieldOfView::Degrees(hfov) => ("hfov_deg", hfov, own.hfov().to_degrees()),
        FieldOfView::Known | FieldOfView::Camera(_) => return Ok(FieldOfView::Camera(camera)),
    };
    // This form treats NaN as different.
    if (given - of_camera).abs() <= SAME * of_camera {
        return Ok(FieldOfView::Camera(camera));
    }
    let is = format!("it is {given}, and the camera's {of_camera:.4}");
    Err(wrong(option, is, "leave it out, or the camera"))
}

//! Pickles of cameras.

use oaktwin::camera::{self, ImageSize, Intrinsics, LensFamily, RigidTransform};
use oaktwin::render::{Clip, check_size};
use pyo3::prelude::*;

use super::{Camera, intrinsics};
use crate::error::{error, wrong};

/// The state of a camera in pickles: name, size, K, lens and coefficients, clipping range, and pose on its device.
pub(super) type CameraState = (
    String,
    (u32, u32),
    [[f64; 3]; 3],
    &'static str,
    Vec<f64>,
    (f64, f64),
    [[f64; 4]; 4],
);

/// Restores the camera of a pickle without loss.
#[pyfunction]
#[expect(clippy::needless_pass_by_value, reason = "what PyO3 hands over")]
pub(crate) fn _camera(
    name: String,
    size: (u32, u32),
    k: [[f64; 3]; 3],
    lens: &str,
    coefficients: Vec<f64>,
    clip: (f64, f64),
    body_from_camera: [[f64; 4]; 4],
) -> PyResult<Camera> {
    let size = ImageSize::new(size.0, size.1);
    check_size(size).map_err(error)?;
    let lens = intrinsics::lens(lens, &coefficients)?;
    Ok(Camera {
        name,
        camera: camera::Camera::new(Intrinsics::from_opencv_matrix(size, k), lens),
        clip: Clip {
            near_m: clip.0,
            far_m: clip.1,
        },
        body_from_camera: RigidTransform::from_rows(body_from_camera),
    })
}

impl Camera {
    pub(super) fn state(&self) -> PyResult<CameraState> {
        let lens = &self.camera.lens;
        if LensFamily::of(lens).is_none() {
            let what = format!("its {} lens cannot be pickled", lens.names().option);
            return Err(wrong(&self.name, what, "open its scene again instead"));
        }
        Ok((
            self.name.clone(),
            self.size(),
            self.camera.intrinsics.opencv_matrix(),
            self.lens(),
            lens.coefficients().to_vec(),
            self.clip(),
            self.body_from_camera.rows(),
        ))
    }
}

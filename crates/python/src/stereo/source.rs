use std::path::Path;

use oaktwin::camera::ImageSize;
use oaktwin::catalog::{Origin, Role};
use oaktwin::depth::preset::Platform;
use oaktwin::depth::rectify::{Method, RectifyOptions};
use oaktwin::sense::FieldOfView;
use oaktwin::sensor::{SensorOptions, stereo_cameras};
use oaktwin::stereo::{Matcher, PairOf, StereoError, check_calibration};
use oaktwin::usd::asset::LensChoice;
use pyo3::prelude::*;

use crate::choice::maybe_named;
use crate::device::Device;
use crate::error::{error, wrong};

/// The image size before the first pair, if no device defines it.
const FIRST_SIZE: ImageSize = ImageSize {
    width: 1280,
    height: 800,
};

/// The origin of the image pairs.
#[expect(clippy::large_enum_variant, reason = "a matcher has only one")]
pub(super) enum PairSource {
    Device {
        device: Py<Device>,
        /// The name of the depth sensor, if one was chosen, and the left and the right camera of its pair.
        sensor: Option<String>,
        cameras: (Role, Role),
        is_raw: bool,
        rectify: Option<Method>,
    },
    Rectified {
        field_of_view: FieldOfView,
        baseline_m: f64,
    },
}

impl PairSource {
    pub(super) fn device(
        device: &Bound<'_, Device>,
        sensor: Option<&str>,
        raw: Option<bool>,
        rectify: Option<&str>,
    ) -> PyResult<Self> {
        let own = device.get();
        let rectify = maybe_named("rectify", rectify)?;
        if let Origin::Calibration { file_name, .. } = &own.twin.origin {
            check_calibration(Path::new(file_name), &own.findings).map_err(error)?;
        }
        let raw_by_default = own.twin.origin != Origin::Nominal || own.lens == LensChoice::Fisheye;
        if raw == Some(false) && rectify.is_some() {
            let is = "raw=False means that the images are rectified already";
            return Err(wrong("rectify", is, "omit rectify or raw=False"));
        }
        Ok(Self::Device {
            device: device.clone().unbind(),
            sensor: sensor.map(str::to_owned),
            cameras: stereo_cameras(&own.twin, sensor).map_err(error)?,
            is_raw: raw.unwrap_or(raw_by_default || rectify.is_some()),
            rectify,
        })
    }

    pub(super) fn rectified(fx: Option<f64>, hfov_deg: Option<f64>, baseline: Option<f64>) -> PyResult<Self> {
        let field_of_view = match (fx, hfov_deg) {
            (Some(fx), None) => Some(FieldOfView::FocalLength(fx)),
            (None, Some(hfov)) => Some(FieldOfView::Degrees(hfov)),
            (None, None) => None,
            _ => {
                return Err(wrong(
                    "fx, hfov_deg",
                    "only one of them may be given",
                    "pass fx or hfov_deg",
                ));
            }
        };
        match (field_of_view, baseline) {
            (Some(field_of_view), Some(baseline_m)) => Ok(Self::Rectified {
                field_of_view,
                baseline_m,
            }),
            _ => Err(wrong(
                "device",
                "the camera of the images is unknown",
                "pass a device, or fx (or hfov_deg) and baseline of a rectified pair",
            )),
        }
    }

    /// The image size of the matcher before the first pair.
    pub(super) fn first_size(&self) -> ImageSize {
        match self {
            Self::Device { device, cameras, .. } => {
                let left = device.get().twin.camera(cameras.0);
                left.map_or(FIRST_SIZE, |left| left.intrinsics.size)
            }
            Self::Rectified { .. } => FIRST_SIZE,
        }
    }

    pub(super) fn matcher(
        &self,
        chosen: Option<Platform>,
        options: &SensorOptions,
        size: ImageSize,
    ) -> Result<Matcher, StereoError> {
        let pair_of = match self {
            Self::Device {
                device,
                cameras,
                is_raw,
                rectify,
                ..
            } => {
                let device = device.get();
                let own = chosen.or_else(|| device.twin.platform());
                PairOf::Twin {
                    twin: &device.twin,
                    cameras: *cameras,
                    lens: device.lens,
                    is_raw: *is_raw,
                    rectify: rectify.map(|method| RectifyOptions {
                        method,
                        ..RectifyOptions::of(own.unwrap_or(Platform::Rvc4))
                    }),
                    platform: chosen,
                }
            }
            Self::Rectified {
                field_of_view,
                baseline_m,
            } => PairOf::Rectified {
                field_of_view: *field_of_view,
                baseline_m: *baseline_m,
                platform: chosen.unwrap_or(Platform::Rvc2),
            },
        };
        Matcher::new(&pair_of, size, options)
    }
}

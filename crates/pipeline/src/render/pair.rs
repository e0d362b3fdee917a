//! The stereo pair of a depth sensor that matches one.

use super::camera::{DepthSensorSource, PlacedCamera};
use crate::pair::{PairCameras, PairError, PairOptions};
use oaktwin_camera::math::DMat3;
use oaktwin_camera::{Camera, LensModel, UsdOptics};
use oaktwin_catalog::{DepthKind, Twin};
use oaktwin_diagnostic::{Finding, Level};

/// Less than this nobody sees: a part of a pixel at the focal length of any of the cameras, and of a focal length, 1.
const SAME: f64 = 1e-6;

/// The stereo pair of a twin, for the engine that matches one. The camera of its stereo depth sensor becomes the rectified
/// left one, whose depth that engine reports, and so do all that is rendered for it and its `camera_params`. For a nominal
/// pinhole pair that is what it was; a finding says how far it is from there otherwise.
///
/// # Errors
/// A device without a pair, or an option that cannot be.
pub fn put_pair(
    twin: &Twin,
    cameras: &mut [PlacedCamera],
    options: &PairOptions,
) -> Result<(PairCameras, Vec<Finding>), PairError> {
    let pair = PairCameras::new(twin, options)?;
    let own = pair.rectify().geometry().left;
    let mount_from_camera = pair.body_from_rectified_left();
    let mut findings = Vec::new();
    let is_stereo = |prim: &str| {
        let mut sensors = twin.depth_sensors.iter();
        sensors.any(|sensor| sensor.spec.prim == prim && sensor.spec.kind == DepthKind::Stereo)
    };
    for camera in cameras {
        match &camera.depth_sensor {
            Some(DepthSensorSource::Twin(prim)) if is_stereo(prim) => {}
            _ => continue,
        }
        let before = (camera.camera.intrinsics, camera.mount_from_camera.rotation);
        let turned = (before.1.transpose() * mount_from_camera.rotation - DMat3::IDENTITY).to_cols_array();
        let turned = turned.iter().fold(0.0f64, |most, entry| most.max(entry.abs()));
        if turned > SAME || (own.fx / before.0.fx - 1.0).abs() > SAME {
            let message = format!(
                "it is the rectified left camera, whose depth is matched: turned by {:.2}°, focal length {:.2} px instead of {:.2}",
                turned.asin().to_degrees(),
                own.fx,
                before.0.fx
            );
            findings.push(Finding::new(
                "rectified-left",
                Level::Note,
                &camera.path,
                message,
                "",
            ));
        }
        let pixel_size_um =
            camera.attributes.optics.focal_length_mm * 1e3 / camera.camera.intrinsics.mean_focal_length();
        camera.camera = Camera::new(own, LensModel::Pinhole);
        camera.mount_from_camera = mount_from_camera;
        camera.attributes.optics = UsdOptics::from_intrinsics(&own, pixel_size_um, Default::default());
    }
    Ok((pair, findings))
}

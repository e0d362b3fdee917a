//! The stereo pair for stereo matching.

use super::camera::{DepthSensorSource, PlacedCamera};
use crate::pair::{PairCameras, PairError, PairOptions};
use oaktwin_base::diagnostic::{Finding, Level};
use oaktwin_camera::math::DMat3;
use oaktwin_camera::{Camera, LensModel, UsdOptics};
use oaktwin_catalog::{DepthKind, Twin};

/// The tolerance of rotations (rad) and focal lengths (relative), far below a pixel.
const SAME: f64 = 1e-6;

/// Returns the stereo pair of the depth sensors among the cameras, by default the left and right cameras of the twin. The camera
/// of such a depth sensor becomes the rectified left camera, whose depth
/// stereo matching reports, also for ground truth and `camera_params`. For a nominal pinhole pair that changes nothing; otherwise a
/// finding reports the difference.
///
/// # Errors
/// Returns an error if the device has no pair, the depth sensors have different pairs, or an option is invalid.
pub fn put_pair(
    twin: &Twin,
    cameras: &mut [PlacedCamera],
    options: &PairOptions,
) -> Result<(PairCameras, Vec<Finding>), PairError> {
    let mut sensors = Vec::new();
    for camera in &*cameras {
        if let Some(DepthSensorSource::Twin(prim)) = &camera.depth_sensor {
            sensors.extend(
                twin.depth_sensors
                    .iter()
                    .filter(|sensor| sensor.spec.prim == *prim),
            );
        }
    }
    let pairs = || {
        sensors
            .iter()
            .filter_map(|sensor| Some((sensor, sensor.spec.pair()?)))
    };
    let options = &PairOptions {
        cameras: pairs().next().map_or(options.cameras, |(_, pair)| pair),
        ..*options
    };
    if pairs().any(|(_, pair)| pair != options.cameras) {
        return Err(PairError::SeveralPairs {
            device: twin.device.name.clone(),
            sensors: pairs().map(|(sensor, _)| sensor.spec.prim.clone()).collect(),
        });
    }
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
                "replaced by the rectified left camera: rotated by {:.2}°, focal length {:.2} px instead of {:.2} px",
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

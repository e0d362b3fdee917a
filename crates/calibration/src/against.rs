use oaktwin_base::diagnostic::{Finding, Level, message, opt};
use oaktwin_camera::ImageSize;
use oaktwin_catalog::{Catalog, Role, Twin, TwinCamera};

use crate::check::{RESOLUTION, baseline_finding};
use crate::{Calibration, CameraCalibration, Socket};

/// The relative difference of a rescaled fx from the nominal one that causes a warning; lenses of real units differ by 6 %.
const SUSPICIOUS_FOCAL_LENGTH: f64 = 0.10;
/// The tolerance of an image's aspect ratio; 4056x3040 and 4:3 differ by 0.0007.
const SAME_ASPECT: f64 = 0.01;

/// Compares a unit's calibration with its model: name, baseline, image sizes and focal lengths. A difference of the baseline
/// above 10 % and an image larger than its sensor are [errors](Level::Error), which [`crate::force`] downgrades to warnings.
/// `nominal` is the model's [nominal twin](Catalog::nominal), and `catalog` contains its sensors.
#[must_use]
pub fn check_against(calibration: &Calibration, nominal: &Twin, catalog: &Catalog) -> Vec<Finding> {
    let mut findings = Vec::new();
    findings.extend(product(calibration, nominal, catalog));
    findings.extend(baseline(calibration, nominal));
    for camera in &nominal.cameras {
        let Some(found) = calibrated(calibration, camera) else {
            continue;
        };
        findings.extend(resolution(found, camera, catalog));
        findings.extend(focal_length(found, camera));
    }
    findings
}

/// Returns the calibration of a twin's camera.
pub(crate) fn calibrated<'a>(
    calibration: &'a Calibration,
    camera: &TwinCamera,
) -> Option<&'a CameraCalibration> {
    calibration.cameras.get(&socket_of(camera)?)
}

pub(crate) fn socket_of(camera: &TwinCamera) -> Option<Socket> {
    u8::try_from(camera.spec.socket()).ok().map(Socket)
}

/// Returns the sockets of a twin's stereo pair.
pub(crate) fn pair_of(nominal: &Twin) -> Option<(Socket, Socket)> {
    let socket = |role| nominal.camera(role).and_then(socket_of);
    Some((socket(Role::Left)?, socket(Role::Right)?))
}

fn product(calibration: &Calibration, nominal: &Twin, catalog: &Catalog) -> Option<Finding> {
    let product = &calibration.board.product_name;
    let device = &nominal.device;
    if product.is_empty() || catalog.device(product).is_ok_and(|own| own.id == device.id) {
        return None;
    }
    Some(Finding::new(
        "product-name",
        Level::Warning,
        "productName",
        format!("the file is for a \"{product}\", not for an {}", device.name),
        "check that the file belongs to this model",
    ))
}

fn baseline(calibration: &Calibration, nominal: &Twin) -> Option<Finding> {
    let (left, right) = pair_of(nominal)?;
    let found = calibration.baseline(left, right, false).ok()?;
    let expected = nominal.device.stereo_baseline_mm? * 1e-3;
    // If the design in the file agrees with the model, reading the file has reported the difference.
    if let Ok(spec) = calibration.baseline(left, right, true)
        && calibration.stereo_pair() == Some((left, right))
        && (spec / expected - 1.0).abs() < 1e-3
    {
        return None;
    }
    let who = format!("an {} has", nominal.device.name);
    baseline_finding(calibration.baseline_place(left, right), found, expected, &who)
}

fn resolution(found: &CameraCalibration, camera: &TwinCamera, catalog: &Catalog) -> Option<Finding> {
    let sensor = catalog.sensor(&camera.spec.sensor)?;
    let native = ImageSize::new(sensor.native_resolution.0, sensor.native_resolution.1);
    let (size, place) = (found.size(), format!("{}.width", found.place));
    if size.width > native.width || size.height > native.height {
        return Some(Finding::new(
            RESOLUTION,
            Level::Error,
            place,
            format!("{size} is larger than the {native} of the {}", sensor.id),
            message![
                "check that the file belongs to this model; ",
                opt("force"),
                " ignores the error"
            ],
        ));
    }
    let known = [
        native.aspect(),
        sensor.used_size().aspect(),
        16.0 / 9.0,
        4.0 / 3.0,
    ];
    if known
        .iter()
        .all(|aspect| (size.aspect() / aspect - 1.0).abs() > SAME_ASPECT)
    {
        return Some(Finding::new(
            RESOLUTION,
            Level::Warning,
            place,
            format!(
                "no mode of the {} ({native}) has the aspect ratio of {size}",
                sensor.id
            ),
            "images are scaled and cropped about the centre; calibrate at the sensor's own size",
        ));
    }
    None
}

fn focal_length(found: &CameraCalibration, camera: &TwinCamera) -> Option<Finding> {
    let size = camera.intrinsics.size;
    let (fx, nominal) = (found.intrinsics.resized(size, true).fx, camera.intrinsics.fx);
    let off = fx / nominal - 1.0;
    if off.abs() <= SUSPICIOUS_FOCAL_LENGTH {
        return None;
    }
    Some(Finding::new(
        "focal-length-off",
        Level::Warning,
        format!("{}.intrinsicMatrix", found.place),
        format!(
            "fx is {fx:.1} px at {size}, but nominally {nominal:.1} px for the {} camera ({:+.1} %)",
            camera.spec.prim,
            off * 100.0
        ),
        "check that the file belongs to this model",
    ))
}

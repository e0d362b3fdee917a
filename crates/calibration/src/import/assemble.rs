//! The document of all cameras and extrinsics.

use std::collections::BTreeMap;

use oaktwin_base::diagnostic::{Finding, Level, Message, message, opt};
use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::DVec3;
use oaktwin_catalog::{Twin, TwinCamera};

use super::field::error;
use super::part::{Camera, Link, Parts};
use super::{FileFinding, ImportedCalibration};
use crate::against::socket_of;
use crate::check::{BASELINE, RESOLUTION};
use crate::document::{self, Document};
use crate::{CalibrationError, Socket};

/// The baselines of stereo cameras, m: twice the range of the catalog's, 20 mm to 150 mm, and more for rigs. Another unit of length is
/// wrong by a factor of at least 10.
const PLAUSIBLE_BASELINE_M: std::ops::RangeInclusive<f64> = 0.008..=0.6;
/// The distance between two poses of the inertial unit that causes a warning, m.
const SUSPICIOUS_IMU_M: f64 = 1e-3;

pub(super) fn document(
    parts: Parts,
    nominal: Option<&Twin>,
) -> Result<ImportedCalibration, CalibrationError> {
    let Parts {
        cameras,
        links,
        imu,
        mut findings,
    } = parts;
    let first_file = cameras.first().map(|camera| camera.file.clone());
    let cameras = by_socket(cameras, &links)?;
    let mut by_camera: BTreeMap<Socket, Link> = BTreeMap::new();
    for link in links.into_iter().chain(rectified_pair(&cameras)?) {
        if let Some(other) = by_camera.get(&link.from) {
            let what = format!("{} has extrinsics here and in {}", link.from, other.file);
            return Err(error(
                &link.file,
                &link.place,
                "repeated-extrinsics",
                what,
                "give one of the files",
            ));
        }
        by_camera.insert(link.from, link);
    }
    let pair = pair(&cameras, &by_camera, nominal, &mut findings);
    for camera in cameras.values() {
        let is_joined = by_camera
            .values()
            .any(|link| [link.from, link.to].contains(&camera.socket));
        if cameras.len() > 1 && !is_joined {
            findings.push(at(
                &camera.file,
                "not-joined",
                Level::Warning,
                &camera.place,
                format!("the files have no extrinsics of {}", camera.socket),
                "calibrate it together with another camera",
            ));
        }
    }
    let document = Document {
        product: nominal.map_or_else(String::new, product),
        cameras: cameras
            .values()
            .map(|camera| (camera.socket, node(camera, &by_camera, nominal)))
            .collect(),
        stereo: pair.map_or_else(document::no_stereo, |right_from_left| {
            document::stereo(Socket::CAM_B, Socket::CAM_C, &right_from_left)
        }),
        imu: self::imu(&imu, &by_camera, &mut findings),
        use_spec_translation: nominal.is_some(),
    };
    Ok(ImportedCalibration {
        raw: document.into_raw(first_file.unwrap_or_default()),
        findings,
        cameras: cameras
            .into_values()
            .map(|camera| (camera.file, camera.place))
            .collect(),
    })
}

fn at(
    file: &str,
    code: &'static str,
    level: Level,
    place: &str,
    message: impl Into<Message>,
    remedy: impl Into<Message>,
) -> FileFinding {
    FileFinding {
        file: file.to_owned(),
        finding: Finding::new(code, level, place, message, remedy),
    }
}

fn product(nominal: &Twin) -> String {
    let device = &nominal.device;
    device.aliases.first().unwrap_or(&device.name).clone()
}

/// Returns one camera for each socket.
fn by_socket(cameras: Vec<Camera>, links: &[Link]) -> Result<BTreeMap<Socket, Camera>, CalibrationError> {
    let mut found: BTreeMap<Socket, Camera> = BTreeMap::new();
    for camera in cameras {
        match found.get(&camera.socket) {
            Some(other) if other.is_of_pair_file == camera.is_of_pair_file => {
                let what = format!(
                    "{} is here and in {} ({})",
                    camera.socket, other.file, other.place
                );
                return Err(error(
                    &camera.file,
                    &camera.place,
                    "repeated-socket",
                    what,
                    message!["omit one of them, or state their positions with ", opt("camera")],
                ));
            }
            Some(_) if camera.is_of_pair_file => {}
            _ => _ = found.insert(camera.socket, camera),
        }
    }
    for link in links {
        for end in [link.from, link.to] {
            if !found.contains_key(&end) {
                let what = format!("the extrinsics refer to {end}, but no file has its intrinsics");
                let remedy = "give the file with its camera matrix as well";
                return Err(error(&link.file, &link.place, "no-intrinsics", what, remedy));
            }
        }
    }
    Ok(found)
}

/// Returns the extrinsics of a pair with ROS's rectification: both rotations lead to the same axes, in which the right camera is beside
/// the left one.
fn rectified_pair(cameras: &BTreeMap<Socket, Camera>) -> Result<Option<Link>, CalibrationError> {
    let (Some(left), Some(right)) = (cameras.get(&Socket::CAM_B), cameras.get(&Socket::CAM_C)) else {
        return Ok(None);
    };
    let (Some(of_left), Some(of_right)) = (&left.rectified, &right.rectified) else {
        return Ok(None);
    };
    let translation = of_right.translation - of_left.translation;
    if translation == DVec3::ZERO {
        return Err(error(
            &right.file,
            "projection_matrix",
            "no-pair",
            "without a baseline (Tx is 0), so the pair was not calibrated together",
            "calibrate it as a stereo pair, or import one camera",
        ));
    }
    let right_from_rectified = of_right.rectified_from_camera.transpose();
    Ok(Some(Link {
        file: right.file.clone(),
        place: "projection_matrix".to_owned(),
        from: left.socket,
        to: right.socket,
        to_from_from: RigidTransform::new(
            right_from_rectified * of_left.rectified_from_camera,
            right_from_rectified * translation,
        ),
    }))
}

/// Returns `right_from_left` of a connected pair, and reports an implausible one.
fn pair(
    cameras: &BTreeMap<Socket, Camera>,
    links: &BTreeMap<Socket, Link>,
    nominal: Option<&Twin>,
    findings: &mut Vec<FileFinding>,
) -> Option<RigidTransform> {
    let (left, right) = (cameras.get(&Socket::CAM_B)?, cameras.get(&Socket::CAM_C)?);
    let direct = |from: Socket, to: Socket| links.get(&from).filter(|link| link.to == to);
    let (link, right_from_left) = match direct(left.socket, right.socket) {
        Some(link) => (link, link.to_from_from),
        None => {
            let link = direct(right.socket, left.socket)?;
            (link, link.to_from_from.inverse())
        }
    };
    let baseline_m = right_from_left.translation.length();
    // With a model, the baseline is compared with its design.
    if nominal.is_none() && !PLAUSIBLE_BASELINE_M.contains(&baseline_m) {
        findings.push(at(
            &link.file,
            BASELINE,
            Level::Error,
            &link.place,
            format!(
                "the baseline is {:.2} mm; stereo cameras have 8 mm to 600 mm",
                baseline_m * 1e3
            ),
            message![
                "check the unit of length, ",
                opt("unit"),
                "; ",
                opt("force"),
                " ignores the error"
            ],
        ));
    }
    let sizes = [left, right].map(|camera| camera.intrinsics.size);
    if sizes[0] != sizes[1] {
        findings.push(at(
            &right.file,
            RESOLUTION,
            Level::Error,
            &right.place,
            format!(
                "the images of left and right are of two sizes, {} and {}",
                sizes[0], sizes[1]
            ),
            message![
                "give two files of one calibration; ",
                opt("force"),
                " ignores the error"
            ],
        ));
    }
    Some(right_from_left)
}

fn node(camera: &Camera, links: &BTreeMap<Socket, Link>, nominal: Option<&Twin>) -> crate::raw::Node {
    let own = |socket| nominal.and_then(|twin| camera_of(twin, socket));
    let hfov_deg = own(camera.socket).map_or_else(
        || camera.intrinsics.hfov().to_degrees(),
        |own| own.spec.fisheye_hfov_deg.unwrap_or(own.spec.hfov_deg),
    );
    let extrinsics = match links.get(&camera.socket) {
        Some(link) => {
            let designed = match (own(link.to), own(link.from)) {
                (Some(to), Some(from)) => (to.body_from_camera.inverse() * from.body_from_camera).translation,
                _ => link.to_from_from.translation,
            };
            document::extrinsics(link.to, &link.to_from_from, designed)
        }
        None => document::no_extrinsics(),
    };
    document::camera(&camera.intrinsics, &camera.lens, hfov_deg, extrinsics)
}

fn camera_of(twin: &Twin, socket: Socket) -> Option<&TwinCamera> {
    twin.cameras
        .iter()
        .find(|camera| socket_of(camera) == Some(socket))
}

/// Returns the extrinsics of the inertial unit relative to the root of the chain. Poses in several cameras that disagree cause a
/// warning.
fn imu(
    poses: &[(Socket, RigidTransform)],
    links: &BTreeMap<Socket, Link>,
    findings: &mut Vec<FileFinding>,
) -> crate::raw::Node {
    let Some((socket, camera_from_imu)) = poses.last() else {
        return document::no_extrinsics();
    };
    for (from, from_from_imu) in poses {
        let Some(link) = links.get(from) else { continue };
        let Some((_, expected)) = poses.iter().find(|(socket, _)| *socket == link.to) else {
            continue;
        };
        let off_m = ((link.to_from_from * *from_from_imu).translation - expected.translation).length();
        if off_m > SUSPICIOUS_IMU_M {
            findings.push(at(
                &link.file,
                "imu-off",
                Level::Warning,
                "T_cam_imu",
                format!(
                    "the poses in {from} and {} differ by {:.1} mm from the extrinsics between them; the last one is used",
                    link.to,
                    off_m * 1e3
                ),
                "calibrate the inertial unit again",
            ));
        }
    }
    document::extrinsics(*socket, camera_from_imu, camera_from_imu.translation)
}

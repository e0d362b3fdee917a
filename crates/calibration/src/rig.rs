//! Stereo rigs that are in no catalog: two cameras with a common calibration.

use std::collections::BTreeMap;

use oaktwin_base::diagnostic::{Finding, Level, Message, message, opt};
use oaktwin_base::parameter::Platform;
use oaktwin_camera::math::DVec3;
use oaktwin_camera::{Axes, RigidTransform};
use oaktwin_catalog::{Body, BodyShape, Camera, Device, Origin, Role, Source, Sources, Twin, TwinCamera};

use crate::{Calibration, CalibrationError, CameraCalibration, Socket};

/// The pixel size of a rig's cameras, µm. A calibration does not contain it, and the images and depth of a pair do not depend on it.
const PIXEL_SIZE_UM: f64 = 3.0;

/// Creates the twin of a rig from its calibration alone: the two cameras of a pair and their poses. Its housing is unknown and has no
/// size, and it has no other camera and no depth sensor of the catalog.
///
/// The pair is `pair`, (left, right), otherwise the pair that the file names, otherwise the only two cameras.
///
/// # Errors
/// Returns an error if the file does not determine the pair, no extrinsics connect it, or the left camera is not to the left.
pub fn rig(
    calibration: &Calibration,
    pair: Option<(Socket, Socket)>,
    platform: Platform,
    file_name: &str,
) -> Result<(Twin, Vec<Finding>), CalibrationError> {
    let (left, right) = match pair {
        Some(pair) => pair,
        None => calibration.pair_of_rig()?,
    };
    let right_from_left = calibration.transform(left, right, false)?;
    check_order(calibration, (left, right), right_from_left.translation)?;
    let cameras = [(Role::Left, left), (Role::Right, right)];
    let cameras: Vec<TwinCamera> = cameras
        .into_iter()
        .map(|(role, socket)| Ok(twin_camera(role, calibration.camera(socket)?)))
        .collect::<Result<_, CalibrationError>>()?;
    let baseline_m = right_from_left.translation.length();
    let nominal = Twin {
        device: device(calibration, &cameras, baseline_m, platform),
        cameras,
        depth_sensors: Vec::new(),
        body_from_imu: None,
        design_baselines_m: BTreeMap::new(),
        origin: Origin::Nominal,
    };
    crate::twin(calibration, &nominal, file_name)
}

/// Rejects a camera beside itself, and a left camera to the right of the right one, which is at `right_from_left` in its frame.
fn check_order(
    calibration: &Calibration,
    (left, right): (Socket, Socket),
    right_from_left: DVec3,
) -> Result<(), CalibrationError> {
    let [x, y, z] = right_from_left.to_array();
    if left == right {
        let remedy = message!["name two cameras, such as ", opt("pair").with("CAM_B CAM_C")];
        let what = format!("left and right are both {left}");
        return Err(no_pair(calibration, "cameraData".to_owned(), what, remedy));
    }
    if x > y.abs().max(z.abs()) {
        let place = calibration.baseline_place(left, right);
        let what = format!(
            "{left}, the left camera, is {:.1} mm to the right of {right}",
            x * 1e3
        );
        let remedy = message!["swap them: ", opt("pair").with(format!("{right} {left}"))];
        return Err(no_pair(calibration, place, what, remedy));
    }
    Ok(())
}

fn no_pair(calibration: &Calibration, place: String, what: String, remedy: Message) -> CalibrationError {
    CalibrationError::Invalid {
        file: calibration.file_name.clone(),
        errors: vec![Finding::new("no-pair", Level::Error, place, what, remedy)],
    }
}

impl Calibration {
    /// Returns the sockets, (left, right), of the pair that the file names, or of its only two cameras.
    fn pair_of_rig(&self) -> Result<(Socket, Socket), CalibrationError> {
        if let Some(stereo) = self.stereo {
            return Ok((stereo.left, stereo.right));
        }
        let sockets: Vec<Socket> = self.cameras.keys().copied().collect();
        if let [a, b] = sockets[..] {
            let b_from_a = self.transform(a, b, false)?;
            return Ok(if b_from_a.translation.x < 0.0 {
                (a, b)
            } else {
                (b, a)
            });
        }
        let names: Vec<String> = sockets.iter().map(ToString::to_string).collect();
        let place = "stereoRectificationData".to_owned();
        let [first, second, ..] = sockets[..] else {
            let what = format!("{} is the only camera with intrinsics", names.join(", "));
            return Err(no_pair(self, place, what, "calibrate a stereo pair".into()));
        };
        // DepthAI's own names of these two are LEFT and RIGHT.
        let usual = (Socket::CAM_B, Socket::CAM_C);
        let has_usual = [usual.0, usual.1].iter().all(|socket| sockets.contains(socket));
        let (left, right) = if has_usual { usual } else { (first, second) };
        let what = format!("names no stereo pair among {}", names.join(", "));
        let remedy = message!["name it, such as ", opt("pair").with(format!("{left} {right}"))];
        Err(no_pair(self, place, what, remedy))
    }
}

fn twin_camera(role: Role, found: &CameraCalibration) -> TwinCamera {
    TwinCamera {
        spec: Camera {
            role,
            prim: format!("Camera_{role}"),
            sensor: "unknown".to_owned(),
            remark: None,
            socket: Some(found.socket.number()),
            hfov_deg: found.intrinsics.hfov().to_degrees(),
            fisheye_hfov_deg: None,
            position_mm: [0.0; 3],
            pitch_deg: 0.0,
            focus_distance: 0.0,
            f_stop: 0.0,
            projection: "perspective".to_owned(),
            stereo_role: role.to_string(),
            clipping_range_m: (0.01, 100.0),
            projection_type: "pinhole".to_owned(),
            max_fov_deg: None,
            legacy_distortion: None,
            source: Source::CalibrationExport,
            sources: Sources::new(),
        },
        is_monochrome: false,
        readout_s: 0.0,
        pixel_size_um: PIXEL_SIZE_UM,
        intrinsics: found.intrinsics,
        lens: found.lens,
        body_from_camera: RigidTransform::new(Axes::Ros.rotation_from(Axes::OpenCv), DVec3::ZERO),
    }
}

fn device(calibration: &Calibration, cameras: &[TwinCamera], baseline_m: f64, platform: Platform) -> Device {
    let board = &calibration.board;
    let name = [&board.product_name, &board.board_name]
        .into_iter()
        .find(|name| !name.is_empty())
        .map_or("stereo rig", String::as_str);
    Device {
        id: "rig".to_owned(),
        name: name.to_owned(),
        full_name: None,
        aliases: Vec::new(),
        boards: Vec::new(),
        stands_in_for: BTreeMap::new(),
        prim: "rig".to_owned(),
        manufacturer: "unknown".to_owned(),
        generation: platform.name().to_uppercase(),
        platform: None,
        processor: None,
        variant: "stereo rig".to_owned(),
        data_source: None,
        body: Body {
            shape: BodyShape::Plain,
            dimensions_mm: [0.0; 3],
            front_mm: [0.0; 3],
            mass_g: 0.0,
            projector_mm: None,
            source: Source::Estimate,
            sources: Sources::new(),
        },
        imu: None,
        projector: None,
        stereo_baseline_mm: Some(baseline_m * 1e3),
        cameras: cameras.iter().map(|camera| camera.spec.clone()).collect(),
        depth_sensors: Vec::new(),
        accuracy: Vec::new(),
        accuracy_headline: None,
        evidence: Vec::new(),
        notes: Vec::new(),
        source: Source::CalibrationExport,
        sources: Sources::new(),
    }
}

//! The parts of a `DepthAI` JSON of version 7.

use oaktwin_camera::math::DVec3;
use oaktwin_camera::{Intrinsics, LensModel, OpenCvLens, RigidTransform};

use crate::Socket;
use crate::raw::{Node, Raw, Value};
use crate::rectify::rectifying_rotations;

const CM_PER_M: f64 = 100.0;

/// A document without the identification of a board.
pub(crate) struct Document {
    pub(crate) product: String,
    /// Nodes made by [`camera`], in the order of sockets.
    pub(crate) cameras: Vec<(Socket, Node)>,
    /// Made by [`stereo`] or [`no_stereo`].
    pub(crate) stereo: Node,
    /// Made by [`extrinsics`] or [`no_extrinsics`].
    pub(crate) imu: Node,
    /// Whether `DepthAI` computes depth with the baseline of the design.
    pub(crate) use_spec_translation: bool,
}

impl Document {
    pub(crate) fn into_raw(self, name: String) -> Raw {
        let text = |text: &str| Node::from(text);
        let cameras = self.cameras.into_iter();
        let cameras: Vec<Node> = cameras
            .map(|(socket, camera)| vec![Node::from(i64::from(socket.number())), camera].into())
            .collect();
        let root = Node::from([
            ("batchName", text("")),
            ("batchTime", 0.into()),
            ("boardConf", text("")),
            ("boardCustom", text("")),
            ("boardName", text("")),
            ("boardOptions", 0.into()),
            ("boardRev", text("")),
            ("cameraData", cameras.into()),
            ("deviceName", text("")),
            ("hardwareConf", text("")),
            ("housingExtrinsics", no_extrinsics()),
            ("imuExtrinsics", self.imu),
            ("miscellaneousData", Value::Array(Vec::new()).into()),
            ("productName", text(&self.product)),
            ("stereoEnableDistortionCorrection", false.into()),
            ("stereoRectificationData", self.stereo),
            ("stereoUseSpecTranslation", self.use_spec_translation.into()),
            ("version", 7.into()),
            ("verticalCameraSocket", (-1).into()),
        ]);
        Raw { name, root }
    }
}

/// Returns a camera; `spec_hfov_deg` includes distortion.
pub(crate) fn camera(
    intrinsics: &Intrinsics,
    lens: &LensModel,
    spec_hfov_deg: f64,
    extrinsics: Node,
) -> Node {
    let (kind, coefficients) = match lens.as_opencv() {
        Some(OpenCvLens::Pinhole(coefficients)) => (0, coefficients.to_vec()),
        Some(OpenCvLens::Fisheye(k)) => (1, k.to_vec()),
        // Neither DepthAI nor any calibration or catalog has another lens.
        None => (0, vec![0.0; 14]),
    };
    let size = intrinsics.size;
    Node::from([
        ("cameraType", Node::from(kind)),
        ("distortionCoeff", coefficients.into()),
        ("extrinsics", extrinsics),
        ("height", i64::from(size.height).into()),
        ("intrinsicMatrix", matrix(intrinsics.opencv_matrix())),
        ("lensPosition", 0.into()),
        ("specHfovDeg", spec_hfov_deg.into()),
        ("width", i64::from(size.width).into()),
    ])
}

/// Returns a stereo pair, with the rectification by its extrinsics.
pub(crate) fn stereo(left: Socket, right: Socket, right_from_left: &RigidTransform) -> Node {
    let (r1, r2) = rectifying_rotations(right_from_left).unwrap_or_default();
    Node::from([
        ("leftCameraSocket", i64::from(left.number()).into()),
        ("rectifiedRotationLeft", matrix(r1.transpose().to_cols_array_2d())),
        (
            "rectifiedRotationRight",
            matrix(r2.transpose().to_cols_array_2d()),
        ),
        ("rightCameraSocket", i64::from(right.number()).into()),
    ])
}

/// Returns the stereo pair of a document without one.
pub(crate) fn no_stereo() -> Node {
    Value::Object(Vec::new()).into()
}

/// Returns extrinsics: the transform to a camera's frame, and the translation of the design, m.
pub(crate) fn extrinsics(to: Socket, transform: &RigidTransform, designed: DVec3) -> Node {
    // Rounding to 1e-10 cm, a picometre, hides rounding errors of the conversion from metres.
    let cm = |m: f64| tidy((m * CM_PER_M * 1e10).round() / 1e10);
    let translation = |t: DVec3| {
        Node::from([
            ("x", cm(t.x).into()),
            ("y", cm(t.y).into()),
            ("z", cm(t.z).into()),
        ])
    };
    Node::from([
        (
            "rotationMatrix",
            matrix(transform.rotation.transpose().to_cols_array_2d()),
        ),
        ("specTranslation", translation(designed)),
        ("toCameraSocket", i64::from(to.number()).into()),
        ("translation", translation(transform.translation)),
    ])
}

/// Returns empty extrinsics: zeros, and no socket.
pub(crate) fn no_extrinsics() -> Node {
    let zero = || Node::from([("x", 0.0.into()), ("y", 0.0.into()), ("z", 0.0.into())]);
    Node::from([
        ("rotationMatrix", matrix([[0.0; 3]; 3])),
        ("specTranslation", zero()),
        ("toCameraSocket", (-1).into()),
        ("translation", zero()),
    ])
}

fn matrix(rows: [[f64; 3]; 3]) -> Node {
    rows.map(|row| Node::from(row.map(tidy).to_vec())).to_vec().into()
}

/// Replaces −0 by 0.
fn tidy(x: f64) -> f64 {
    x + 0.0
}

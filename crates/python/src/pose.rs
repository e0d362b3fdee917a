//! Conversions between 4×4 NumPy matrices and rigid transforms.

use numpy::{PyArray1, PyArray2, PyArrayMethods};
use oaktwin::camera::math::{DMat3, DQuat, DVec3};
use oaktwin::camera::{Axes, RigidTransform};
use oaktwin::render;
use pyo3::prelude::*;

use crate::arguments::vector;
use crate::array::numbers;
use crate::choice::choose;
use crate::error::{error, wrong};

/// The tolerance of rotation matrices; single precision is well within it.
const TOLERANCE: f64 = 1e-4;

/// Returns a matrix as an array.
pub(crate) fn matrix<'py, const R: usize, const C: usize>(
    py: Python<'py>,
    rows: &[[f64; C]; R],
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    PyArray1::from_slice(py, rows.as_flattened()).reshape([R, C])
}

/// Returns a transform as an array.
pub(crate) fn rows<'py>(py: Python<'py>, transform: &RigidTransform) -> PyResult<Bound<'py, PyArray2<f64>>> {
    matrix(py, &transform.rows())
}

/// Whose pose a matrix is: the frame that it is the pose of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Of {
    Body,
    Camera,
    /// A camera's on its device.
    Mount,
}

impl Of {
    /// The class in Python.
    const fn class(self) -> &'static str {
        match self {
            Self::Body => "BodyPose",
            Self::Camera => "CameraPose",
            Self::Mount => "Mount",
        }
    }

    /// The frame that the class names.
    const fn frame(self) -> &'static str {
        match self {
            Self::Body => "body",
            Self::Camera | Self::Mount => "camera",
        }
    }

    /// Returns the pose as an array that names its frame.
    pub(crate) fn array<'py>(self, py: Python<'py>, pose: &RigidTransform) -> PyResult<Bound<'py, PyAny>> {
        let class = py.import("oaktwin._poses")?.getattr(self.class())?;
        rows(py, pose)?.call_method1("view", (class,))
    }

    /// Reads one pose, and rejects an array that names another frame.
    pub(crate) fn one(self, name: &str, object: &Bound<'_, PyAny>) -> PyResult<RigidTransform> {
        self.check(name, object)?;
        one_pose(name, object)
    }

    /// Reads one pose or several, likewise.
    pub(crate) fn several(
        self,
        name: &str,
        object: &Bound<'_, PyAny>,
    ) -> PyResult<(Vec<RigidTransform>, bool)> {
        self.check(name, object)?;
        poses(name, object)
    }

    fn check(self, name: &str, object: &Bound<'_, PyAny>) -> PyResult<()> {
        let Ok(frame) = object
            .getattr("frame")
            .and_then(|frame| frame.extract::<String>())
        else {
            return Ok(());
        };
        if frame == self.frame() {
            return Ok(());
        }
        let (is, remedy) = match self {
            Self::Body => (
                "not of a device's body",
                "pass scene.look_at(eye, target, device), or look_at(..., frame=\"body\")",
            ),
            Self::Camera | Self::Mount => (
                "not of a camera",
                "pass scene.look_at(eye, target), or world_from_body @ camera.body_from_camera",
            ),
        };
        Err(wrong(
            name,
            format_args!("is a pose of the frame \"{frame}\", {is}"),
            remedy,
        ))
    }
}

/// One pose (4, 4) or several (N, 4, 4), and whether it is a batch.
fn poses(name: &str, object: &Bound<'_, PyAny>) -> PyResult<(Vec<RigidTransform>, bool)> {
    let (shape, array) = numbers(name, object)?;
    let is_batch = match shape[..] {
        [4, 4] => false,
        [_, 4, 4] => true,
        _ => {
            let shape = format!("has shape {shape:?}");
            return Err(wrong(name, shape, "pass a matrix (4, 4), or a batch (N, 4, 4)"));
        }
    };
    let values = array.as_slice().map_err(error)?;
    let (matrices, _) = values.as_chunks::<16>();
    let poses = matrices.iter().map(|matrix| pose(name, matrix));
    Ok((poses.collect::<PyResult<_>>()?, is_batch))
}

pub(crate) fn one_pose(name: &str, object: &Bound<'_, PyAny>) -> PyResult<RigidTransform> {
    let (shape, array) = numbers(name, object)?;
    match (&shape[..], array.as_slice().map_err(error)?.as_chunks::<16>().0) {
        ([4, 4], [matrix]) => pose(name, matrix),
        ([count, 4, 4], _) if *count > 1 => Err(wrong(name, "contains several poses", "pass one 4x4 matrix")),
        _ => Err(wrong(
            name,
            format_args!("has shape {shape:?}"),
            "pass a matrix (4, 4)",
        )),
    }
}

/// Reads one pose, row by row.
pub(crate) fn pose(name: &str, matrix: &[f64; 16]) -> PyResult<RigidTransform> {
    if matrix.iter().any(|number| !number.is_finite()) {
        return Err(wrong(name, "has non-finite values", "pass a rigid transform"));
    }
    let (rows, _) = matrix.as_chunks::<4>();
    let [a, b, c, last] = rows else {
        return Err(wrong(name, "does not have four rows", "pass a 4x4 matrix"));
    };
    if last
        .iter()
        .zip([0.0, 0.0, 0.0, 1.0])
        .any(|(x, wanted)| (x - wanted).abs() > TOLERANCE)
    {
        let remedy = "pass a matrix for column vectors, with the translation in the last column (transpose a USD matrix)";
        return Err(wrong(
            name,
            format_args!("the last row must be [0, 0, 0, 1] (got {last:?})"),
            remedy,
        ));
    }
    let mut pose = RigidTransform::from_rows([*a, *b, *c, [0.0, 0.0, 0.0, 1.0]]);
    let off = pose.orthonormality_error();
    if off > TOLERANCE || pose.rotation.determinant() < 0.0 {
        let determinant = pose.rotation.determinant();
        let is = if determinant < 0.0 {
            format!("the 3x3 part is a reflection, not a rotation (determinant {determinant:.3})")
        } else {
            format!("the 3x3 part is not a rotation (error {off:.2}, determinant {determinant:.3})")
        };
        return Err(wrong(
            name,
            is,
            "pass an orthonormal matrix with determinant 1, without scale",
        ));
    }
    // Orthonormalizes matrices that were rounded to single precision.
    if off > 1e-12 {
        pose.rotation = DMat3::from_quat(DQuat::from_mat3(&pose.rotation).normalize());
    }
    Ok(pose)
}

/// Returns the pose at a position in the world that faces a target: a (4, 4) float64 matrix, world_from_camera, metres.
/// `Scene.look_at` knows the up axis of its world.
///
/// eye: the position (3 values), metres in the world.
/// target: the position to face (3 values), metres in the world.
/// up: the direction in the world (3 values) that points up in the image; any length.
/// frame: "camera" (default) for a camera's axes, OpenCV's (x right, y down, z forward), a `CameraPose`; "body" for a device's
///     (x forward, y left, z up), a `BodyPose`. The pose of a device's camera is `look_at(..., frame="body") @ camera.body_from_camera`.
///
/// Raises oaktwin.Error if eye and target are equal, or if the view direction is parallel to up.
#[pyfunction]
#[pyo3(signature = (eye, target, up = None, *, frame = "camera"))]
#[pyo3(text_signature = "(eye, target, up=(0.0, 0.0, 1.0), *, frame='camera')")]
pub(crate) fn look_at<'py>(
    py: Python<'py>,
    eye: &Bound<'py, PyAny>,
    target: &Bound<'py, PyAny>,
    up: Option<&Bound<'py, PyAny>>,
    frame: &str,
) -> PyResult<Bound<'py, PyAny>> {
    let of = choose("frame", frame, &[("camera", Of::Camera), ("body", Of::Body)])?;
    let up = up.map_or(Ok(DVec3::Z), |up| vector("up", up))?;
    facing(py, eye, target, up, of)
}

/// Returns the pose at a position that faces a target.
pub(crate) fn facing<'py>(
    py: Python<'py>,
    eye: &Bound<'py, PyAny>,
    target: &Bound<'py, PyAny>,
    up: DVec3,
    of: Of,
) -> PyResult<Bound<'py, PyAny>> {
    let axes = if of == Of::Body { Axes::Ros } else { Axes::OpenCv };
    let [eye, target] = [("eye", eye), ("target", target)].map(|(name, point)| vector(name, point));
    let world_from_body = render::look_at(eye?, target?, up).map_err(error)?;
    let body_from_frame = RigidTransform::new(Axes::Ros.rotation_from(axes), DVec3::ZERO);
    of.array(py, &(world_from_body * body_from_frame))
}

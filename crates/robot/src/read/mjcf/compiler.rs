//! How the numbers of the file are meant: `<compiler>`.

use std::path::{Path, PathBuf};

use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::{DMat3, DQuat, DVec3};

use super::super::document::{Element, Vectors, XmlError};
use super::super::turn;

/// The settings of `<compiler>`.
#[derive(Debug)]
pub(super) struct Compiler {
    /// Radians per unit of an angle.
    pub(super) angle: f64,
    euler: Vec<(DVec3, bool)>,
    /// The folder of meshes.
    pub(super) meshes: PathBuf,
    strips_paths: bool,
    limits_ranges: bool,
}

impl Compiler {
    pub(super) fn new(root: &Element, folder: &Path) -> Result<Self, XmlError> {
        let mut compiler = Self {
            angle: 1f64.to_radians(),
            euler: sequence("xyz").unwrap_or_default(),
            meshes: folder.to_owned(),
            strips_paths: false,
            limits_ranges: true,
        };
        for element in root.all("compiler") {
            match element.get("angle") {
                Some("degree") => compiler.angle = 1f64.to_radians(),
                Some("radian") => compiler.angle = 1.0,
                Some(other) => {
                    return Err(
                        element.wrong(format!("angle: unknown unit '{other}'"), "give radian or degree")
                    );
                }
                None => {}
            }
            if let Some(text) = element.get("eulerseq") {
                compiler.euler = sequence(text).ok_or_else(|| {
                    let what = format!("eulerseq: '{text}' is not three of x, y, z, X, Y and Z");
                    element.wrong(what, "give xyz, for example")
                })?;
            }
            if element.get("coordinate").is_some_and(|kind| kind != "local") {
                return Err(element.wrong(
                    "global coordinates are not supported, nor in MuJoCo since 2.3.3",
                    "save the file with an older MuJoCo",
                ));
            }
            if let Some(meshes) = element.get("meshdir").or(element.get("assetdir")) {
                compiler.meshes = folder.join(meshes);
            }
            compiler.strips_paths |= element.get("strippath") == Some("true");
            if let Some(limits) = element.get("autolimits") {
                compiler.limits_ranges = limits == "true";
            }
        }
        Ok(compiler)
    }

    /// Returns the path of a mesh.
    pub(super) fn mesh(&self, name: &str) -> PathBuf {
        match Path::new(name).file_name().filter(|_| self.strips_paths) {
            Some(name) => self.meshes.join(name),
            None => self.meshes.join(name),
        }
    }

    /// Returns the range of a joint that has limits, in the file's unit.
    pub(super) fn limits(&self, joint: &Element) -> Result<Option<[f64; 2]>, XmlError> {
        let range = joint.exactly::<2>("range")?;
        let is_limited = match joint.get("limited").unwrap_or("auto") {
            "auto" => range.is_some() && self.limits_ranges,
            other => other == "true",
        };
        match range.filter(|_| is_limited) {
            Some([low, high]) if low > high => {
                let what = format!("range: {low} is above {high}");
                Err(joint.wrong(what, "give the smaller one first"))
            }
            limits => Ok(limits),
        }
    }

    /// Returns the pose of an element in its parent.
    pub(super) fn pose(&self, element: &Element) -> Result<RigidTransform, XmlError> {
        let position = element.vector("pos")?.unwrap_or(DVec3::ZERO);
        Ok(RigidTransform::new(self.rotation(element)?, position))
    }

    fn rotation(&self, element: &Element) -> Result<DMat3, XmlError> {
        let no_direction =
            |name: &str| element.wrong(format!("{name} has no direction"), "give other numbers");
        if let Some(quat) = element.exactly::<4>("quat")? {
            return rotation(quat).ok_or_else(|| no_direction("quat"));
        }
        if let Some([x, y, z, angle]) = element.exactly::<4>("axisangle")? {
            let axis = DVec3::new(x, y, z).try_normalize();
            let axis = axis.ok_or_else(|| no_direction("axisangle"))?;
            return Ok(turn::about(axis, angle * self.angle));
        }
        if let Some(angles) = element.exactly::<3>("euler")? {
            let turns = self.euler.iter().zip(angles);
            return Ok(
                turns.fold(DMat3::IDENTITY, |rotation, (&(axis, is_fixed), angle)| {
                    let turn = turn::about(axis, angle * self.angle);
                    if is_fixed {
                        turn * rotation
                    } else {
                        rotation * turn
                    }
                }),
            );
        }
        if let Some([a, b, c, d, e, f]) = element.exactly::<6>("xyaxes")? {
            let wrong = || no_direction("xyaxes");
            let x = DVec3::new(a, b, c).try_normalize().ok_or_else(wrong)?;
            let y = DVec3::new(d, e, f).reject_from_normalized(x);
            let y = y.try_normalize().ok_or_else(wrong)?;
            return Ok(DMat3::from_cols(x, y, x.cross(y)));
        }
        match element.vector("zaxis")? {
            Some(axis) if axis.length() > 0.0 => Ok(turn::z_to(axis)),
            Some(_) => Err(no_direction("zaxis")),
            None => Ok(DMat3::IDENTITY),
        }
    }
}

/// Returns the rotation of a quaternion `w x y z` of any length but 0.
pub(super) fn rotation([w, x, y, z]: [f64; 4]) -> Option<DMat3> {
    let quaternion = DQuat::from_xyzw(x, y, z, w);
    let length = quaternion.length();
    (length > 0.0 && length.is_finite()).then(|| DMat3::from_quat(quaternion.normalize()))
}

/// The axes of Euler angles; those in capitals stay fixed.
fn sequence(text: &str) -> Option<Vec<(DVec3, bool)>> {
    let axes: Option<Vec<(DVec3, bool)>> = text
        .chars()
        .map(|letter| {
            let axis = match letter.to_ascii_lowercase() {
                'x' => DVec3::X,
                'y' => DVec3::Y,
                'z' => DVec3::Z,
                _ => return None,
            };
            Some((axis, letter.is_ascii_uppercase()))
        })
        .collect();
    axes.filter(|axes| axes.len() == 3)
}

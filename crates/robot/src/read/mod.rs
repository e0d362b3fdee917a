//! Reads the robots of users from URDF and MJCF, and puts them into scenes.

mod document;
mod error;
mod locate;
mod mjcf;
mod placed;
mod positions;
mod robot;
mod turn;
mod urdf;

use std::ffi::OsStr;
use std::path::{Path, PathBuf};

use document::Element;
pub use error::RobotFileError;
pub use placed::PlacedRobot;
pub use positions::JointPositions;
pub use robot::{Joint, JointKind, Link, LinkVisual, Mimic, Robot, Shape};

impl Robot {
    /// Opens a URDF file, or an MJCF file as `MuJoCo` saves it or as people write it. Packages that `package://` names are looked for in
    /// `package_folders`, and around the file.
    ///
    /// # Errors
    /// Returns an error if the file cannot be read or contradicts itself. What is not supported is a finding.
    pub fn open(path: &Path, package_folders: &[PathBuf]) -> Result<Self, RobotFileError> {
        let extension = path.extension().and_then(OsStr::to_str).unwrap_or_default();
        if matches!(extension, "usd" | "usda" | "usdc" | "usdz") {
            return Err(RobotFileError::new(
                path,
                "file".to_owned(),
                "a robot in USD is an animated stage, not a file of joints".to_owned(),
                "give it as the scene, and mount the OAK on its prim: --mount /World/Robot/hand".to_owned(),
            ));
        }
        let root = Element::open(path)?;
        match root.tag.as_str() {
            "robot" => urdf::read(&root, package_folders),
            "mujoco" => mjcf::read(root),
            tag => Err(root.wrong(
                format!("a robot begins with <robot> or <mujoco>, not with <{tag}>"),
                "give a URDF or an MJCF file",
            )),
        }
    }
}

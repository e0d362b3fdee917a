//! Reads the robots of users from URDF, MJCF and USD, and puts them into scenes.

mod document;
mod error;
mod locate;
mod mjcf;
mod placed;
mod positions;
mod robot;
mod size;
mod turn;
mod urdf;
mod usd;

use std::ffi::OsStr;
use std::path::{Path, PathBuf};

pub use error::RobotFileError;
pub use placed::PlacedRobot;
pub use positions::JointPositions;
pub use robot::{Joint, JointKind, Link, LinkVisual, Mimic, Robot, Shape};

impl Robot {
    /// Opens a URDF file, an MJCF file as `MuJoCo` saves it or as people write it, or a USD stage with joints of `UsdPhysics`. Packages that `package://` names are looked for in
    /// `package_folders`, and around the file.
    ///
    /// # Errors
    /// Returns an error if the file cannot be read or contradicts itself. What is not supported is a finding.
    pub fn open(path: &Path, package_folders: &[PathBuf]) -> Result<Self, RobotFileError> {
        let extension = path.extension().and_then(OsStr::to_str).unwrap_or_default();
        if ["usd", "usda", "usdc", "usdz"].contains(&extension.to_ascii_lowercase().as_str()) {
            return usd::read(path)?.with_checked_sizes(path);
        }
        let root = document::open(path)?;
        let robot = match root.tag.as_str() {
            "robot" => urdf::read(&root, package_folders)?,
            "mujoco" => mjcf::read(root)?,
            tag => Err(root.wrong(
                format!("a robot begins with <robot> or <mujoco>, not with <{tag}>"),
                "give a URDF, MJCF or USD file",
            ))?,
        };
        robot.with_checked_sizes(path)
    }
}

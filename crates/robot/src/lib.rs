//! Descriptions of an OAK for robots and simulators (URDF, SDF, MJCF, a Webots PROTO and a Blender script), and robots that carry one.
//!
//! A [`Description`] is what all formats share: the housing with its mass, and a frame for each camera, depth sensor and the
//! inertial unit. A format is one module that turns it into files.
//!
//! A [`Robot`] is read from a URDF or MJCF file. As a [`PlacedRobot`], its shapes are instances of a scene, which joint positions move.

mod blender;
mod description;
mod error;
mod frame;
mod mesh;
mod mjcf;
mod mount;
mod read;
mod sdf;
mod urdf;
mod webots;
mod xml;

use std::path::{Path, PathBuf};

use oaktwin_base::diagnostic::{Finding, Level};
use oaktwin_base::parameter::choice;
use oaktwin_catalog::{Catalog, Twin};
use oaktwin_files::{self as files, FileError};

pub use description::{CameraFrame, DepthFrame, Description, Housing, ImuFrame, Visual};
pub use error::RobotError;
pub use frame::DeviceFrame;
pub use mesh::HousingMesh;
pub use mount::{Attachment, Mount};
pub use read::{
    Joint, JointKind, JointPositions, Link, LinkVisual, Mimic, PlacedRobot, Robot, RobotFileError, Shape,
};

choice! {
    /// A format of robots and simulators.
    Format {
        /// URDF, plain and as a xacro macro, with the frames of the vendor's ROS package.
        Urdf = "urdf",
        /// `SDFormat` 1.9 for Gazebo.
        Sdf = "sdf",
        /// `SDFormat` 1.9 for Drake.
        Drake = "drake",
        /// MJCF for `MuJoCo` 3.6 and newer, and for Drake.
        Mjcf = "mjcf",
        /// A PROTO for Webots R2023b.
        Webots = "webots",
        /// A Python script for Blender.
        Blender = "blender",
    }
}

/// Files and their findings.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RobotFiles {
    /// The paths relative to the output folder, with `/`, and the contents.
    pub files: Vec<(String, Vec<u8>)>,
    /// The information that the format cannot represent.
    pub findings: Vec<Finding>,
}

impl RobotFiles {
    /// Writes the files into a folder, which is created, and returns their paths.
    ///
    /// # Errors
    /// Returns an error if a file cannot be written.
    pub fn write(&self, folder: &Path) -> Result<Vec<PathBuf>, FileError> {
        let mut written = Vec::new();
        for (name, bytes) in &self.files {
            let path = folder.join(name);
            files::make_folder(path.parent().unwrap_or(folder))?;
            files::write(&path, bytes)?;
            written.push(path);
        }
        Ok(written)
    }

    /// Creates an export with the visible meshes, which all formats share.
    fn with_visuals(of: &Description) -> Self {
        let visuals = of.housing.visuals.iter();
        Self {
            files: visuals
                .map(|visual| (format!("meshes/{}", of.visual_file(visual)), visual.mesh.to_obj()))
                .collect(),
            findings: Vec::new(),
        }
    }

    /// Adds the collider's mesh.
    fn with_collider(mut self, of: &Description) -> Self {
        let path = format!("meshes/{}", of.collider_file());
        self.files.push((path, of.housing.collider.to_obj()));
        self
    }

    /// Reports a link that the format cannot name, with what to do instead.
    fn without_parent(&mut self, of: &Description, format: &str, remedy: &'static str) {
        if let Some(parent) = &of.parent {
            self.findings.push(Finding::new(
                "parent-ignored",
                Level::Warning,
                "parent",
                format!(
                    "{format} cannot name {parent}, a link of another file; the pose is the whole model's"
                ),
                remedy,
            ));
        }
    }

    fn text(&mut self, path: impl Into<String>, text: String) {
        self.files.push((path.into(), text.into_bytes()));
    }
}

/// Describes a twin in a format. The catalog provides the noise of the inertial parts.
///
/// # Errors
/// Returns an error if a name is not valid in the format.
pub fn export(
    catalog: &Catalog,
    twin: &Twin,
    attachment: &Attachment,
    format: Format,
) -> Result<RobotFiles, RobotError> {
    let description = Description::new(catalog, twin, attachment)?;
    let mut export = match format {
        Format::Urdf => urdf::export(&description),
        Format::Sdf => sdf::export(&description, sdf::Reader::Gazebo),
        Format::Drake => sdf::export(&description, sdf::Reader::Drake),
        Format::Mjcf => mjcf::export(&description),
        Format::Webots => webots::export(&description),
        Format::Blender => blender::export(&description),
    };
    export.findings.splice(0..0, description.findings);
    Ok(export)
}

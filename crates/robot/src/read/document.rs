//! Robots' files as trees of elements.

use std::path::Path;

use oaktwin_camera::math::DVec3;
pub(super) use oaktwin_files::xml::{Element, XmlError};

/// The maximum size of a file in bytes; meshes are in files of their own.
const MAX_BYTES: u64 = 16 << 20;

/// Reads the outermost element of a file.
pub(super) fn open(path: &Path) -> Result<Element, XmlError> {
    Element::open(path, MAX_BYTES, "a robot", "give a complete URDF or MJCF file")
}

/// Attributes with three numbers.
pub(super) trait Vectors {
    fn vector(&self, name: &str) -> Result<Option<DVec3>, XmlError>;
}

impl Vectors for Element {
    fn vector(&self, name: &str) -> Result<Option<DVec3>, XmlError> {
        Ok(self.exactly::<3>(name)?.map(DVec3::from))
    }
}

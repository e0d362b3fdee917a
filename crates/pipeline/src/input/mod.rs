//! Depth images on disk: files of one image or many, numbered sequences, folders in Replicator's layout.

pub mod name;
pub mod replicator;
pub mod source;

/// The kind of depth in an image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InputKind {
    /// Along the optical axis: `distance_to_image_plane`.
    Z,
    /// From the optical centre: `distance_to_camera`.
    Range,
}

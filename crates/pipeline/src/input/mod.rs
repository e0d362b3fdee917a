//! Depth images on disk: files of one image or many, numbered sequences, folders in Replicator's layout.

pub mod name;
pub mod replicator;
pub mod source;

oaktwin_parameter::choice! {
    /// The kind of depth in an image.
    InputKind {
        /// Along the optical axis: `distance_to_image_plane`.
        Z = "z",
        /// From the optical centre: `distance_to_camera`.
        Range = "range",
    }
}

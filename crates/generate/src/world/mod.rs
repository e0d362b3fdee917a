//! What can be placed, and where: base scenes, objects and their hulls.

mod asset;
mod base;
mod hull;
mod object_files;
mod parts;
mod triangles;

pub(crate) use asset::Asset;
pub(crate) use base::{Base, fall};
pub(crate) use hull::{Hull, pose_from_parry, pose_to_parry, to_parry};
pub(crate) use object_files::{ObjectFiles, files_of, is_image};
pub(crate) use triangles::Triangles;

//! Tests of the importers with small generated files.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss
)]

mod bad;
mod compressed;
mod dae;
mod gltf;
mod gltf_animations;
mod gltf_builder;
mod gltf_extensions;
mod gltf_skins;
mod large_coordinates;
mod obj;
mod opacity;
mod options;
mod ply;
mod stl;
mod support;

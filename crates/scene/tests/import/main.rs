//! The importers, on small files that the tests write themselves.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss
)]

mod bad;
mod gltf;
mod obj;
mod options;
mod ply;
mod stl;
mod support;

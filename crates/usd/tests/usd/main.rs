//! The tests of this crate, in one program.

mod bad_input;
mod blend_shapes;
mod check_fixtures;
mod limits;
mod opacity;
mod own_assets;
mod scene;

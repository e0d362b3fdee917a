//! The tests of this crate, in one program.

mod common;
mod compare;
#[cfg(feature = "schema")]
mod schema;
mod sheet;
mod sheet_depth;
mod sheet_file;
mod user_catalog;

//! The tests of this crate, in one program.

mod depthai_golden;
mod exports;
mod fixtures;
mod models;

//! The tests of this crate, in one program.

mod bad_imports;
mod depthai_golden;
mod design;
mod exports;
mod fixtures;
mod imports;
mod models;
mod rigs;

//! The tests of this crate, in one program.

mod confidence;
mod depthai_golden;
mod reasons;
mod support;
mod vendor_curves;

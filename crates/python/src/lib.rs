//! The native half of the Python package `oaktwin`: NumPy arrays in and out, exceptions for errors, no mathematics.
//!
//! The interpreter is released while images are processed, and signals are checked between images.
//! Invalid input raises an exception, never a panic. Docstrings are for Python's users; the stubs (`_oaktwin.pyi` and those it imports) have the types.

#![expect(
    clippy::doc_markdown,
    reason = "docstrings are for Python and not in Markdown"
)]

mod accuracy;
mod align;
mod arguments;
mod array;
mod asset;
mod camera;
mod choice;
mod device;
mod engine;
mod error;
mod export;
mod filter;
mod finding;
mod fit;
mod frames;
mod generate;
mod grey;
mod images;
mod imu;
mod json;
mod layers;
mod memory;
mod mesh;
mod models;
mod pair;
mod parameters;
mod pose;
mod progress;
mod projection;
mod recording;
mod rectification;
mod rig;
mod robot;
mod scene;
mod sensor;
mod settings;
mod shot;
mod stereo;
mod threads;
mod worlds;

use std::ffi::OsString;

use pyo3::prelude::*;

/// The native half of oaktwin; use the package `oaktwin`.
#[pymodule(gil_used = true)]
mod _oaktwin {
    use pyo3::prelude::*;

    #[pymodule_export]
    use super::align::align;
    #[pymodule_export]
    use super::camera::{_camera, Camera};
    #[pymodule_export]
    use super::device::{_device, Device};
    #[pymodule_export]
    use super::error::{Error, FindingWarning};
    #[pymodule_export]
    use super::filter::Filter;
    #[pymodule_export]
    use super::finding::{_finding, Finding};
    #[pymodule_export]
    use super::generate::Recipe;
    #[pymodule_export]
    use super::images::_read_from;
    #[pymodule_export]
    use super::imu::simulate_imu;
    #[pymodule_export]
    use super::main;
    #[pymodule_export]
    use super::memory::set_memory_limit;
    #[pymodule_export]
    use super::mesh::Mesh;
    #[pymodule_export]
    use super::models::models;
    #[pymodule_export]
    use super::pose::look_at;
    #[pymodule_export]
    use super::recording::Recording;
    #[pymodule_export]
    use super::rectification::Rectification;
    #[pymodule_export]
    use super::rig::Rig;
    #[pymodule_export]
    use super::scene::Scene;
    #[pymodule_export]
    use super::scene::annotators::annotators;
    #[pymodule_export]
    use super::scene::coverage::coverage;
    #[pymodule_export]
    use super::sensor::{_drift, DepthSensor, SensorBatch};
    #[pymodule_export]
    use super::stereo::StereoMatcher;
    #[pymodule_export]
    use super::worlds::Worlds;
    #[pymodule_export]
    use crate::accuracy::accuracy;
    #[pymodule_export]
    use crate::fit::{fit, fit_latency};
    #[pymodule_export]
    use crate::parameters::{parameters, presets};
    #[pymodule_export]
    #[expect(non_upper_case_globals, reason = "the name in Python")]
    const __version__: &str = env!("CARGO_PKG_VERSION");

    /// Makes instances callable. A method named `__call__` would have neither a signature nor a docstring in Python.
    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        oaktwin::panics::hide_contained();
        for class in ["DepthSensor", "Filter", "SensorBatch", "StereoMatcher"] {
            let class = module.getattr(class)?;
            class.setattr("__call__", class.getattr("_call")?)?;
        }
        Ok(())
    }
}

/// Runs the program `oaktwin` in this process and returns its exit code.
///
/// arguments: the command line without the program's name.
#[pyo3::pyfunction]
fn main(py: Python<'_>, arguments: Vec<OsString>) -> u8 {
    py.detach(|| oaktwin_cli::main([OsString::from("oaktwin")].into_iter().chain(arguments)))
}

//! Evaluation of depth sensors, simulated and real.
//!
//! * [`accuracy`] measures a twin's depth accuracy by the vendor's method;
//! * [`coverage`] measures which part of a surface sensors at candidate poses see;
//! * [`fit`] estimates a sensor's error parameters from recordings of a flat target;
//! * [`latency`] estimates a camera's latency from a recording of a moving edge;
//! * [`measure`] holds the statistics that they use, and [`figure`] draws their results.

pub mod accuracy;
pub mod coverage;
pub mod figure;
pub mod fit;
pub mod latency;
mod list;
pub mod measure;
mod table;

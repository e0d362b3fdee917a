//! Evaluation of depth sensors, simulated and real.
//!
//! * [`accuracy`] measures a twin as the vendor measures its cameras;
//! * [`fit`] estimates a sensor's error parameters from recordings of a flat target;
//! * [`measure`] holds the statistics that both use, and [`figure`] draws their results.

pub mod accuracy;
pub mod figure;
pub mod fit;
pub mod measure;
mod table;

//! What the contest and its engines say to each other: one JSON request a line on the engine's standard input, one
//! JSON answer a line on its standard output, `{"error": …}` where there is none. `tests/oracles/bench_render.py`
//! speaks it too.

use std::path::PathBuf;

use serde::{Deserialize, Serialize};

#[derive(Debug, Deserialize, Serialize)]
#[serde(tag = "op", rename_all = "snake_case")]
pub(crate) enum Request {
    /// Read the triangles, build, render a first frame in every mode.
    Load {
        /// float32 (n, 3), little-endian, without a header.
        positions: PathBuf,
        /// uint32 (m, 3), little-endian, without a header.
        triangles: PathBuf,
        view: ViewJson,
        threads: usize,
    },
    /// Render some frames.
    Frames {
        mode: String,
        threads: usize,
        count: usize,
    },
    /// Write a frame as float32, little-endian, without a header.
    Depth { mode: String, path: PathBuf },
}

/// A pinhole with its principal point in the middle of the image. The ray through pixel (x, y) is
/// `rotation · ((x + 0.5 − width / 2) / focal, (y + 0.5 − height / 2) / focal, 1)`, so that its parameter is depth.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub(crate) struct ViewJson {
    pub(crate) width: u32,
    pub(crate) height: u32,
    /// px
    pub(crate) focal: f64,
    /// Rows of `world_from_camera`; the camera's axes are OpenCV's.
    pub(crate) rotation: [[f64; 3]; 3],
    pub(crate) translation: [f64; 3],
    pub(crate) near: f64,
}

/// The answer to `Load`.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub(crate) struct Loaded {
    /// Ways to render that are timed apart: `""` where there is one.
    pub(crate) modes: Vec<String>,
    /// From triangles in memory to the first pixel.
    pub(crate) build_s: f64,
    /// By how much the process has grown since before it read the triangles.
    pub(crate) resident_bytes: u64,
    /// The same at its largest.
    pub(crate) peak_bytes: u64,
}

/// The answer to `Frames`.
#[derive(Clone, Debug, Default, Deserialize, Serialize)]
pub(crate) struct Frames {
    /// Of each frame.
    pub(crate) wall_s: Vec<f64>,
    /// Of all threads together, of each frame.
    pub(crate) cpu_s: Vec<f64>,
}

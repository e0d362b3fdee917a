//! The protocol between the benchmark and its engines: one JSON request per line on the engine's standard input, one
//! JSON answer per line on its standard output, `{"error": …}` if it failed. `tests/oracles/bench_render.py`
//! implements it, too.

use std::path::PathBuf;

use serde::{Deserialize, Serialize};

#[derive(Debug, Deserialize, Serialize)]
#[serde(tag = "op", rename_all = "snake_case")]
pub(crate) enum Request {
    /// Read the triangles, build, and render a first frame in every mode.
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

/// A pinhole with its principal point at the image centre. The ray through pixel (x, y) is
/// `rotation · ((x + 0.5 − width / 2) / focal, (y + 0.5 − height / 2) / focal, 1)`, so that its parameter is depth.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub(crate) struct ViewJson {
    pub(crate) width: u32,
    pub(crate) height: u32,
    /// The focal length in pixels.
    pub(crate) focal: f64,
    /// Rows of `world_from_camera`; the camera's axes are OpenCV's.
    pub(crate) rotation: [[f64; 3]; 3],
    pub(crate) translation: [f64; 3],
    pub(crate) near: f64,
}

/// The answer to `Load`.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub(crate) struct Loaded {
    /// The separately timed rendering modes: `[""]` if there is only one.
    pub(crate) modes: Vec<String>,
    /// The time from triangles in memory to the first pixel.
    pub(crate) build_s: f64,
    /// The growth of the process's memory since before it read the triangles.
    pub(crate) resident_bytes: u64,
    /// The peak growth.
    pub(crate) peak_bytes: u64,
}

/// The answer to `Frames`.
#[derive(Clone, Debug, Default, Deserialize, Serialize)]
pub(crate) struct Frames {
    /// The wall time of each frame.
    pub(crate) wall_s: Vec<f64>,
    /// The processor time of all threads for each frame.
    pub(crate) cpu_s: Vec<f64>,
}

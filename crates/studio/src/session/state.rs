//! The state of a session, as its archive contains it.

use serde::{Deserialize, Serialize};
use serde_json::value::RawValue;

/// The content of `session.json`.
#[derive(Debug, Serialize, Deserialize)]
pub(super) struct State {
    #[serde(rename = "oaktwinSession")]
    pub(super) version: u64,
    /// The version of the program that wrote it.
    pub(super) program: String,
    pub(super) document: Box<RawValue>,
    pub(super) display: Box<RawValue>,
    pub(super) scene: SceneEntry,
    pub(super) calibrations: Vec<Entry>,
    pub(super) trajectory: Option<Entry>,
    #[serde(default)]
    pub(super) motion: Option<Entry>,
}

#[derive(Debug, Serialize, Deserialize)]
pub(super) struct SceneEntry {
    pub(super) id: String,
    pub(super) name: String,
    pub(super) triangles: usize,
    pub(super) up: Option<String>,
    pub(super) scale: Option<f64>,
    /// The place in the archive; none of a scene that the command line named, which may refer to other files.
    pub(super) file: Option<String>,
    /// A robot that was dropped into the scene. A robot of the command line belongs to its scene.
    #[serde(default)]
    pub(super) robot: Option<Entry>,
    /// The reflectances in the infrared, as they are in the id of the scene.
    #[serde(default)]
    pub(super) infrared: Option<String>,
    /// The positions of the robot's joints, as they are in the id of the scene.
    #[serde(default)]
    pub(super) posture: Option<String>,
}

/// A dropped file.
#[derive(Debug, Serialize, Deserialize)]
pub(super) struct Entry {
    pub(super) id: String,
    pub(super) name: String,
    pub(super) file: String,
}

impl Entry {
    /// Puts a file into a folder of the archive.
    pub(super) fn put(
        files: &mut Vec<(String, Vec<u8>)>,
        folder: &str,
        (id, name): (&str, &str),
        bytes: &[u8],
    ) -> Self {
        let file = format!("{folder}/{name}");
        files.push((file.clone(), bytes.to_vec()));
        let (id, name) = (id.to_owned(), name.to_owned());
        Self { id, name, file }
    }
}

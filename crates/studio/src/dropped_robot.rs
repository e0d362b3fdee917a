//! Robots that are dropped onto the page.

use std::sync::Arc;

use oaktwin::render::{OpenOptions, SceneFile};
use tempfile::TempDir;

use crate::protocol::{Failure, SceneInfo};
use crate::robot::{DroppedFile, RobotFile};
use crate::scene::{LoadedScene, at_any_time, in_any_state, infrared};
use crate::studio::Studio;
use crate::upload;

/// The maximum length of a dropped robot, bytes.
pub(crate) const MAX_BYTES: usize = 16 << 20;

/// Whether XML has an attribute `file` or `filename`. What a page drops must not make the server read other files.
fn names_files(text: &str) -> bool {
    text.split("file").skip(1).any(|rest| {
        let rest = rest.strip_prefix("name").unwrap_or(rest);
        rest.trim_start().starts_with('=')
    })
}

/// Puts a dropped robot into a scene, and returns what the page knows about the new scene.
pub(crate) fn dropped(studio: &Studio, scene: &str, name: &str, bytes: &[u8]) -> Result<SceneInfo, Failure> {
    let base = studio.scenes.as_opened(in_any_state(scene))?;
    let received = Received::new(studio, name, bytes)?;
    let id = received.id_in(&base);
    if studio.scenes.dropped(&id).is_none() {
        studio.scenes.add(received.put_into(&base)?);
    }
    let id = match infrared::split(at_any_time(scene)) {
        Some((_, reflectances)) => infrared::reflecting(&id, reflectances),
        None => id,
    };
    Ok(studio.scenes.as_opened(&id)?.info.clone())
}

/// A robot's file that was received.
pub(crate) struct Received<'a> {
    name: &'a str,
    bytes: &'a [u8],
    /// The part of the id of a scene that depends on the file.
    id: String,
    file: RobotFile,
    /// Deletes the file when it has been read.
    _folder: TempDir,
}

impl<'a> Received<'a> {
    pub(crate) fn new(studio: &Studio, name: &'a str, bytes: &'a [u8]) -> Result<Self, Failure> {
        let is_stage = SceneFile::is_stage(name.as_ref());
        if is_stage || names_files(&String::from_utf8_lossy(bytes)) {
            let error = format!(
                "{name}: {}, which a dropped robot may not; open it with oaktwin studio SCENE --robot {name}",
                if is_stage {
                    "is a stage"
                } else {
                    "names other files"
                }
            );
            return Err(Failure::of("robot", &error));
        }
        let folder = upload::folder(&studio.uploads)?;
        let path = folder.path().join(name);
        std::fs::write(&path, bytes).map_err(|error| {
            Failure::from(format!("the dropped file cannot be kept: {error}; drop it again"))
        })?;
        Ok(Self {
            name,
            bytes,
            id: upload::content_id(name, &OpenOptions::default(), &path)?,
            file: RobotFile {
                packages: Vec::new(),
                world_from_base: None,
                arguments: vec!["--robot".to_owned(), name.to_owned()],
                path,
            },
            _folder: folder,
        })
    }

    /// Returns the id of a scene with the robot in it.
    pub(crate) fn id_in(&self, base: &LoadedScene) -> String {
        format!("{}-{}", self.id, base.info.id)
    }

    /// Returns a scene with the robot in it.
    pub(crate) fn put_into(&self, base: &LoadedScene) -> Result<LoadedScene, Failure> {
        let mut made = base.with_robot(&self.file, &self.id_in(base), self.name)?;
        made.check_triangles()?;
        if let Some(robot) = &mut made.robot {
            robot.dropped = Some(Arc::new(DroppedFile {
                name: self.name.to_owned(),
                bytes: self.bytes.to_vec(),
                base: base.info.id.clone(),
            }));
        }
        Ok(made)
    }
}

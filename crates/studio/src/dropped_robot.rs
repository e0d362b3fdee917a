//! Robots that are dropped onto the page.

use oaktwin::render::OpenOptions;

use crate::protocol::{Failure, SceneInfo};
use crate::robot::{RobotFile, split};
use crate::studio::Studio;
use crate::upload;

/// Whether XML has an attribute `file` or `filename`. What a page drops must not make the server read other files.
fn names_files(text: &str) -> bool {
    text.split("file").skip(1).any(|rest| {
        let rest = rest.strip_prefix("name").unwrap_or(rest);
        rest.trim_start().starts_with('=')
    })
}

/// Returns the id of a scene in any posture, at any time.
fn in_any_state(id: &str) -> &str {
    let id = split(id).map_or(id, |(own, _)| own);
    id.rsplit_once('@').map_or(id, |(own, _)| own)
}

/// Puts a dropped robot into a scene, and returns what the page knows about the new scene.
pub(crate) fn dropped(studio: &Studio, scene: &str, name: &str, bytes: &[u8]) -> Result<SceneInfo, Failure> {
    if names_files(&String::from_utf8_lossy(bytes)) {
        let error = format!(
            "{name}: names other files, which a dropped one may not; open it with oaktwin studio SCENE --robot {name}"
        );
        return Err(Failure::of("robot", &error));
    }
    let base = studio.scenes.as_opened(in_any_state(scene))?;
    let folder = upload::folder(&studio.uploads)?;
    let path = folder.path().join(name);
    std::fs::write(&path, bytes)
        .map_err(|error| Failure::from(format!("the dropped file cannot be kept: {error}; drop it again")))?;
    let file = RobotFile {
        packages: Vec::new(),
        world_from_base: None,
        arguments: vec!["--robot".to_owned(), name.to_owned()],
        path,
    };
    let id = upload::content_id(name, &OpenOptions::default(), &file.path)?;
    let id = format!("{id}-{}", base.info.id);
    if let Some(known) = studio.scenes.dropped(&id) {
        return Ok(known.info.clone());
    }
    let made = base.with_robot(&file, &id, name)?;
    made.check_triangles()?;
    Ok(studio.scenes.add(made).info.clone())
}

//! The scenes that the page can show, by their ids.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

use super::infrared::{self, Reflecting};
use super::recent::{Recent, keep, used};
use super::{LoadedScene, MAX_TRIANGLES};
use crate::protocol::Failure;
use crate::{robot, upload};

/// The number of dropped scenes that are kept, besides the command line's, and of their triangles.
const KEPT: usize = 24;
const KEPT_TRIANGLES: usize = 2 * MAX_TRIANGLES;
/// The number of bytes of their files, which stay on the disk for animations and sessions.
const KEPT_BYTES: u64 = 4 * upload::MAX_BYTES;

/// Returns the id of a scene in any posture and at any time, with its reflectances.
pub(crate) fn at_any_time(id: &str) -> &str {
    let id = robot::split(id).map_or(id, |(own, _)| own);
    id.rsplit_once('@').map_or(id, |(own, _)| own)
}

/// Returns the id of a scene in any posture, at any time, with any reflectances.
pub(crate) fn in_any_state(id: &str) -> &str {
    let id = at_any_time(id);
    infrared::split(id).map_or(id, |(own, _)| own)
}

/// Scenes in postures of their robots.
#[derive(Debug, Default)]
struct Postures(Recent);

impl Postures {
    /// The number of copies of scenes that are kept.
    const KEPT: usize = 6;

    /// Returns a scene in a posture: a copy that nobody uses any more is moved, which is faster than another copy.
    fn get(&mut self, id: &str, scene: &LoadedScene, posture: &str) -> Result<Arc<LoadedScene>, Failure> {
        if let Some(found) = used(&mut self.0, id) {
            return Ok(found);
        }
        let Some(robot) = &scene.robot else {
            let error = format!(
                "the scene {} has no robot; open the page without its link",
                scene.info.name
            );
            return Err(Failure::of("scene", &error));
        };
        let positions = robot.parse(posture)?;
        let is_free = |one: &Arc<LoadedScene>| {
            robot::split(&one.info.id).is_some_and(|(own, _)| own == scene.info.id)
                && Arc::strong_count(one) == 1
        };
        let spare = self.0.iter().position(is_free);
        let spare = spare.and_then(|place| self.0.remove(place));
        let mut moved = match spare.map(Arc::try_unwrap) {
            Some(Ok(spare)) => spare,
            Some(Err(_)) | None => scene.copied(),
        };
        moved.pose(id, positions);
        Ok(keep(&mut self.0, moved, Self::KEPT))
    }
}

/// The scenes by id.
#[derive(Debug)]
pub(crate) struct Scenes {
    first: Arc<LoadedScene>,
    dropped: Mutex<Recent>,
    postures: Mutex<Postures>,
    pub(crate) reflecting: Reflecting,
}

impl Scenes {
    pub(crate) fn new(first: LoadedScene) -> Self {
        Self {
            first: Arc::new(first),
            dropped: Mutex::default(),
            postures: Mutex::default(),
            reflecting: Reflecting::default(),
        }
    }

    /// The scene that is shown first.
    pub(crate) fn first(&self) -> &LoadedScene {
        &self.first
    }

    /// Returns a scene, by its id; at a time code, by `ID@CODE`, or in a posture of its robot, by `ID~POSITIONS`.
    pub(crate) fn get(&self, id: &str) -> Result<Arc<LoadedScene>, Failure> {
        let at_time = id.rsplit_once('@').filter(|_| robot::split(id).is_none());
        let Some((base, code)) = at_time else {
            return self.still(id);
        };
        match code.parse::<f64>() {
            Ok(time) if time.is_finite() => self.as_opened(base)?.at(time),
            _ => {
                let error = format!("'{code}' is no time code; load the page again");
                Err(Failure::of("time", &error))
            }
        }
    }

    /// Returns a scene as it was opened, or in a posture of its robot.
    pub(crate) fn still(&self, id: &str) -> Result<Arc<LoadedScene>, Failure> {
        let Some((own, posture)) = robot::split(id) else {
            return self.as_opened(id);
        };
        let scene = self.as_opened(own)?;
        let mut postures = self.postures.lock().unwrap_or_else(PoisonError::into_inner);
        postures.get(id, &scene, posture)
    }

    /// Returns a scene as it was opened; with other reflectances in the infrared, by `ID;NAME=REFLECTANCE`.
    pub(crate) fn as_opened(&self, id: &str) -> Result<Arc<LoadedScene>, Failure> {
        match infrared::split(id) {
            Some((own, reflectances)) => self.reflecting.get(id, &*self.as_read(own)?, reflectances),
            None => self.as_read(id),
        }
    }

    /// Returns a scene as its file has it.
    fn as_read(&self, id: &str) -> Result<Arc<LoadedScene>, Failure> {
        if self.first.info.id == id {
            return Ok(Arc::clone(&self.first));
        }
        self.dropped(id).ok_or_else(|| {
            Failure::of(
                "scene",
                &format!("no scene '{id}'; drop the file onto the page again"),
            )
        })
    }

    /// Returns a dropped scene that is kept.
    pub(crate) fn dropped(&self, id: &str) -> Option<Arc<LoadedScene>> {
        let mut dropped = self.dropped.lock().unwrap_or_else(PoisonError::into_inner);
        used(&mut dropped, id)
    }

    /// Keeps a dropped scene and forgets those that nobody has used for longest.
    pub(crate) fn add(&self, scene: LoadedScene) -> Arc<LoadedScene> {
        let scene = Arc::new(scene);
        let mut dropped = self.dropped.lock().unwrap_or_else(PoisonError::into_inner);
        dropped.retain(|known| known.info.id != scene.info.id);
        dropped.push_back(Arc::clone(&scene));
        let triangles = |kept: &Recent| -> usize { kept.iter().map(|scene| scene.info.triangles).sum() };
        // A scene and the same with a robot share a file.
        let bytes = |kept: &Recent| -> u64 {
            let files = kept.iter().filter_map(|scene| scene.kept.as_ref());
            let files: BTreeMap<_, _> = files.map(|file| (Arc::as_ptr(file), file.bytes)).collect();
            files.values().sum()
        };
        let are_too_many =
            |kept: &Recent| kept.len() > KEPT || triangles(kept) > KEPT_TRIANGLES || bytes(kept) > KEPT_BYTES;
        while dropped.len() > 1 && are_too_many(&dropped) {
            dropped.pop_front();
        }
        scene
    }
}

//! Scenes that are kept while they are used.

use std::collections::VecDeque;
use std::sync::Arc;

use super::LoadedScene;

/// Scenes by id. The one that was used last is the last.
pub(super) type Recent = VecDeque<Arc<LoadedScene>>;

/// Returns a scene, which becomes the last.
pub(super) fn used(scenes: &mut Recent, id: &str) -> Option<Arc<LoadedScene>> {
    let place = scenes.iter().position(|scene| scene.info.id == id)?;
    let scene = scenes.remove(place)?;
    scenes.push_back(Arc::clone(&scene));
    Some(scene)
}

/// Keeps a scene, and forgets the one that nobody has used for longest if there are more than `count`.
pub(super) fn keep(scenes: &mut Recent, scene: LoadedScene, count: usize) -> Arc<LoadedScene> {
    let scene = Arc::new(scene);
    scenes.push_back(Arc::clone(&scene));
    if scenes.len() > count {
        scenes.pop_front();
    }
    scene
}

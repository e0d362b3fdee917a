//! The textures of a scene, decoded on first use.

use std::sync::OnceLock;

use oaktwin_base::diagnostic::Finding;
use oaktwin_scene::{ColorSpace, Scene, Texture};

use super::pyramid::Pyramid;
use crate::texture_file::{self, PLAIN};

/// A decoded texture.
#[derive(Debug)]
pub(super) struct Loaded {
    /// `None` if the texture cannot be shown.
    pyramid: Option<Pyramid>,
    /// The reason why it cannot be shown.
    pub(super) finding: Option<Finding>,
}

/// The textures of a scene.
#[derive(Debug)]
pub(super) struct Textures {
    loaded: Vec<OnceLock<Loaded>>,
}

impl Textures {
    pub(super) fn new(scene: &Scene) -> Self {
        Self {
            loaded: scene.textures.iter().map(|_| OnceLock::new()).collect(),
        }
    }

    /// Makes room for textures that were added to the scene.
    pub(super) fn add(&mut self, scene: &Scene) {
        self.loaded.resize_with(scene.textures.len(), OnceLock::new);
    }

    /// Returns a texture, decoding it on first use; `None` if the scene has no such texture.
    pub(super) fn get(&self, scene: &Scene, index: u32) -> Option<&Loaded> {
        let slot = self.loaded.get(index as usize)?;
        let texture = scene.textures.get(index as usize)?;
        if slot.get().is_none() {
            // Decoding waits for other threads of the pool, which must not wait for this texture meanwhile: two may decode it at once.
            let _ = slot.set(Loaded::new(texture));
        }
        slot.get()
    }

    /// Returns a texture that is already decoded.
    pub(super) fn ready(&self, index: u32) -> Option<&Pyramid> {
        self.loaded.get(index as usize)?.get()?.pyramid.as_ref()
    }
}

impl Loaded {
    fn new(texture: &Texture) -> Self {
        match pyramid(texture) {
            Ok(pyramid) => Self {
                pyramid: Some(pyramid),
                finding: None,
            },
            Err(finding) => Self {
                pyramid: None,
                finding: Some(finding),
            },
        }
    }
}

fn pyramid(texture: &Texture) -> Result<Pyramid, Finding> {
    let is_srgb = texture.color_space != ColorSpace::Raw;
    let (image, is_high_range) = texture_file::decoded(texture, PLAIN)?;
    Ok(Pyramid::new(image, is_high_range || is_srgb))
}

#[cfg(test)]
mod tests {
    use super::*;

    use std::sync::Arc;

    use oaktwin_image::Image;
    use oaktwin_scene::TextureSource;
    use rayon::prelude::*;

    #[test]
    fn threads_of_the_pool_and_others_decode_a_texture_at_once() {
        let image = Image::new(512, 512, vec![[90, 120, 30, 255]; 512 * 512]).unwrap();
        let texture = Texture {
            source: TextureSource::Pixels(Arc::new(image)),
            color_space: ColorSpace::Auto,
        };
        let scene = Scene {
            textures: vec![texture],
            ..Scene::default()
        };
        for _ in 0..20 {
            let textures = Textures::new(&scene);
            let is_shown = || textures.get(&scene, 0).is_some_and(|one| one.finding.is_none());
            std::thread::scope(|scope| {
                scope.spawn(|| assert!(is_shown()));
                scope.spawn(|| assert!((0..64).into_par_iter().all(|_| is_shown())));
            });
        }
    }
}

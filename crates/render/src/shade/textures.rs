//! The textures of a scene, decoded on first use.

use std::sync::OnceLock;

use oaktwin_diagnostic::{Finding, Level};
use oaktwin_files as files;
use oaktwin_image::{Image, texture};
use oaktwin_scene::{ColorSpace, Scene, TextureSource};

use super::pyramid::Pyramid;

/// The maximum size of an image file.
const MAX_BYTES: u64 = 1 << 30;

/// The reason why a texture cannot be shown.
#[derive(Clone, Debug)]
pub(super) struct Missing {
    place: String,
    message: String,
    remedy: String,
}

impl Missing {
    pub(super) fn finding(&self) -> Finding {
        Finding::new(
            "texture-missing",
            Level::Warning,
            self.place.clone(),
            self.message.clone(),
            self.remedy.clone(),
        )
    }
}

/// The textures of a scene.
#[derive(Debug)]
pub(super) struct Textures {
    pyramids: Vec<OnceLock<Result<Pyramid, Missing>>>,
}

impl Textures {
    pub(super) fn new(scene: &Scene) -> Self {
        Self {
            pyramids: scene.textures.iter().map(|_| OnceLock::new()).collect(),
        }
    }

    /// Returns a texture, decoding it on first use; `None` if the scene has no such texture.
    pub(super) fn get(&self, scene: &Scene, index: u32) -> Option<&Result<Pyramid, Missing>> {
        let slot = self.pyramids.get(index as usize)?;
        let texture = scene.textures.get(index as usize)?;
        Some(slot.get_or_init(|| {
            let (image, is_high_range) = decoded(&texture.source)?;
            // Images of high dynamic range have been converted to sRGB.
            Ok(Pyramid::new(
                image,
                is_high_range || texture.color_space != ColorSpace::Raw,
            ))
        }))
    }

    /// Returns a texture that is already decoded.
    pub(super) fn ready(&self, index: u32) -> Option<&Pyramid> {
        self.pyramids.get(index as usize)?.get()?.as_ref().ok()
    }
}

/// Decodes the texture of a dome into linear light.
pub(super) fn linear(source: &TextureSource) -> Result<Image<[f32; 3]>, Missing> {
    if let TextureSource::Pixels(image) = source {
        let linear = oaktwin_image::srgb::linear_from_srgb();
        return Ok(image.map(|&[r, g, b, _]| [r, g, b].map(|value| linear[usize::from(value)])));
    }
    let (name, bytes) = bytes(source)?;
    texture::decode_linear(&bytes, extension(&name)).map_err(|error| broken(name, &error.to_string()))
}

/// Decodes an image into sRGB and returns whether it is of high dynamic range.
fn decoded(source: &TextureSource) -> Result<(Image<[u8; 4]>, bool), Missing> {
    if let TextureSource::Pixels(image) = source {
        return Ok((Image::clone(image), false));
    }
    let (name, bytes) = bytes(source)?;
    let is_high_range = bytes.starts_with(&[0x76, 0x2F, 0x31, 0x01]) || bytes.starts_with(b"#?");
    match texture::decode_srgb(&bytes, extension(&name)) {
        Ok(image) => Ok((image, is_high_range)),
        Err(error) => Err(broken(name, &error.to_string())),
    }
}

fn bytes(source: &TextureSource) -> Result<(String, Vec<u8>), Missing> {
    match source {
        TextureSource::Pixels(_) => Ok((String::new(), Vec::new())),
        TextureSource::Encoded { name, bytes } => Ok((name.clone(), bytes.to_vec())),
        TextureSource::File(path) => {
            let name = path.display().to_string();
            match files::read_regular(path, MAX_BYTES) {
                Ok(bytes) => Ok((name, bytes)),
                Err(error) => Err(Missing {
                    place: name,
                    message: format!("the texture cannot be read ({error}); a plain colour is used instead"),
                    remedy: "put the file there, or correct the path to it".to_owned(),
                }),
            }
        }
    }
}

fn extension(name: &str) -> Option<&str> {
    name.rsplit_once('.').map(|(_, extension)| extension)
}

/// The message of a codec includes the remedy.
fn broken(place: String, message: &str) -> Missing {
    Missing {
        place,
        message: format!("a plain colour is used instead of the texture: {message}"),
        remedy: String::new(),
    }
}

//! The textures of a scene, decoded on first use.

use std::sync::OnceLock;

use oaktwin_base::diagnostic::{Finding, Level, Message};
use oaktwin_files as files;
use oaktwin_image::{CodecError, Image, texture};
use oaktwin_scene::{ColorSpace, Scene, Texture, TextureSource};

use super::pyramid::Pyramid;

/// The maximum size of an image file.
const MAX_BYTES: u64 = 1 << 30;

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
        Some(slot.get_or_init(|| Loaded::new(texture)))
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

/// Decodes the texture of a dome into linear light.
pub(super) fn linear(source: &TextureSource) -> Result<Image<[f32; 3]>, Finding> {
    if let TextureSource::Pixels(image) = source {
        return Ok(texture::to_linear(image));
    }
    let (name, bytes) = bytes(source)?;
    texture::decode_linear(&bytes, extension(&name)).map_err(|error| broken(name, error))
}

fn pyramid(texture: &Texture) -> Result<Pyramid, Finding> {
    let is_srgb = texture.color_space != ColorSpace::Raw;
    if let TextureSource::Pixels(image) = &texture.source {
        return Ok(Pyramid::new(Image::clone(image), is_srgb));
    }
    let (name, bytes) = bytes(&texture.source)?;
    // Images of high dynamic range are converted to sRGB.
    let is_high_range = bytes.starts_with(&[0x76, 0x2F, 0x31, 0x01]) || bytes.starts_with(b"#?");
    let image = texture::decode_srgb(&bytes, extension(&name)).map_err(|error| broken(name, error))?;
    Ok(Pyramid::new(image, is_high_range || is_srgb))
}

fn bytes(source: &TextureSource) -> Result<(String, Vec<u8>), Finding> {
    match source {
        TextureSource::Pixels(_) => Ok((String::new(), Vec::new())),
        TextureSource::Encoded { name, bytes } => Ok((name.clone(), bytes.to_vec())),
        TextureSource::File(path) => {
            let name = path.display().to_string();
            match files::read_regular(path, MAX_BYTES) {
                Ok(bytes) => Ok((name, bytes)),
                Err(error) => Err(missing(
                    name,
                    format!("the texture cannot be read ({error}); a plain colour is used instead"),
                    "put the file there, or correct the path to it",
                )),
            }
        }
    }
}

fn extension(name: &str) -> Option<&str> {
    name.rsplit_once('.').map(|(_, extension)| extension)
}

fn broken(place: String, error: CodecError) -> Finding {
    let CodecError {
        format,
        place: at,
        problem,
        remedy,
    } = error;
    let message = format!("a plain colour is used instead of the texture: {format}: {at}: {problem}");
    missing(place, message, remedy)
}

fn missing(place: String, message: String, remedy: impl Into<Message>) -> Finding {
    Finding::new("texture-missing", Level::Warning, place, message, remedy)
}

//! The textures of a scene, decoded on first use.

use std::sync::OnceLock;

use oaktwin_base::diagnostic::{Finding, Level};
use oaktwin_files as files;
use oaktwin_image::texture::{self, Average, Fitted, Reduction};
use oaktwin_image::{CodecError, Image};
use oaktwin_scene::{ColorSpace, Scene, Texture, TextureSource};

use super::pyramid::Pyramid;

/// The maximum size of an image file.
const MAX_BYTES: u64 = 1 << 30;

/// A decoded texture.
#[derive(Debug)]
pub(super) struct Loaded {
    /// `None` if the texture cannot be shown.
    pyramid: Option<Pyramid>,
    /// The reason why it cannot be shown, or not in full size.
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
            Ok((pyramid, finding)) => Self {
                pyramid: Some(pyramid),
                finding,
            },
            Err(finding) => Self {
                pyramid: None,
                finding: Some(finding),
            },
        }
    }
}

/// Decodes the texture of a dome into linear light. Returns a finding if it is reduced.
pub(super) fn linear(source: &TextureSource) -> Result<(Image<[f32; 3]>, Option<Finding>), Finding> {
    if let TextureSource::Pixels(image) = source {
        return Ok((texture::to_linear(image), None));
    }
    let (name, bytes) = bytes(source)?;
    match texture::fit_linear(&bytes, extension(&name)) {
        Ok(fitted) => Ok(with_finding(name, fitted)),
        Err(error) => Err(broken(name, &error)),
    }
}

/// Decodes a texture. Returns a finding if it is reduced.
fn pyramid(texture: &Texture) -> Result<(Pyramid, Option<Finding>), Finding> {
    let average = match texture.color_space {
        ColorSpace::Raw => Average::Raw,
        _ => Average::Srgb,
    };
    if let TextureSource::Pixels(image) = &texture.source {
        return Ok((Pyramid::new(Image::clone(image), average == Average::Srgb), None));
    }
    let (name, bytes) = bytes(&texture.source)?;
    // Images of high dynamic range are converted to sRGB.
    let is_high_range = bytes.starts_with(&[0x76, 0x2F, 0x31, 0x01]) || bytes.starts_with(b"#?");
    match texture::fit_srgb(&bytes, extension(&name), average) {
        Ok(fitted) => {
            let (image, finding) = with_finding(name, fitted);
            let pyramid = Pyramid::new(image, is_high_range || average == Average::Srgb);
            Ok((pyramid, finding))
        }
        Err(error) => Err(broken(name, &error)),
    }
}

/// Returns the image, and a finding if it is reduced.
fn with_finding<P>(place: String, fitted: Fitted<P>) -> (Image<P>, Option<Finding>) {
    let image = fitted.image;
    let finding = fitted.reduction.map(|Reduction { full_size, shortage }| {
        let message = format!(
            "the texture is reduced from {} × {} to {} × {} pixels: {}",
            full_size.0,
            full_size.1,
            image.width(),
            image.height(),
            shortage.what()
        );
        Finding::new(
            "texture-reduced",
            Level::Warning,
            place,
            message,
            shortage.remedy(),
        )
    });
    (image, finding)
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

fn broken(place: String, error: &CodecError) -> Finding {
    // The message of a codec includes the remedy.
    missing(
        place,
        format!("a plain colour is used instead of the texture: {error}"),
        "",
    )
}

fn missing(place: String, message: String, remedy: &str) -> Finding {
    Finding::new("texture-missing", Level::Warning, place, message, remedy)
}

//! Decodes the images of textures.

use oaktwin_base::diagnostic::{Finding, Level, Message};
use oaktwin_files as files;
use oaktwin_image::{CodecError, Image, texture};
use oaktwin_scene::{Texture, TextureSource};

/// What findings say of the colour of a surface.
pub(crate) const PLAIN: &str = "a plain colour is used instead";

/// The maximum size of an image file.
const MAX_BYTES: u64 = 1 << 30;

/// Decodes a texture to sRGB or data, with opacity.
///
/// # Errors
/// Returns the finding that it cannot be read.
pub fn texture_pixels(texture: &Texture) -> Result<Image<[u8; 4]>, Finding> {
    decoded(texture, PLAIN).map(|(image, _)| image)
}

/// Decodes the texture of a dome into linear light.
pub(crate) fn linear(source: &TextureSource) -> Result<Image<[f32; 3]>, Finding> {
    if let TextureSource::Pixels(image) = source {
        return Ok(texture::to_linear(image));
    }
    let (name, bytes) = bytes(source, PLAIN)?;
    texture::decode_linear(&bytes, extension(&name)).map_err(|error| broken(name, error, PLAIN))
}

/// Decodes a texture to sRGB, or data, with opacity. Returns the image, and whether it has a high dynamic range and was converted to sRGB.
///
/// The finding about a texture that cannot be read ends with `instead`, which says how the surface is shown without it.
pub(crate) fn decoded(texture: &Texture, instead: &str) -> Result<(Image<[u8; 4]>, bool), Finding> {
    if let TextureSource::Pixels(image) = &texture.source {
        return Ok((Image::clone(image), false));
    }
    let (name, bytes) = bytes(&texture.source, instead)?;
    let is_high_range = bytes.starts_with(&[0x76, 0x2F, 0x31, 0x01]) || bytes.starts_with(b"#?");
    match texture::decode_srgb(&bytes, extension(&name)) {
        Ok(image) => Ok((image, is_high_range)),
        Err(error) => Err(broken(name, error, instead)),
    }
}

fn bytes(source: &TextureSource, instead: &str) -> Result<(String, Vec<u8>), Finding> {
    match source {
        TextureSource::Pixels(_) => Ok((String::new(), Vec::new())),
        TextureSource::Encoded { name, bytes } => Ok((name.clone(), bytes.to_vec())),
        TextureSource::File(path) => {
            let name = path.display().to_string();
            match files::read_regular(path, MAX_BYTES) {
                Ok(bytes) => Ok((name, bytes)),
                Err(error) => Err(missing(
                    name,
                    format!("the texture cannot be read ({error}); {instead}"),
                    "put the file there, or correct the path to it",
                )),
            }
        }
    }
}

fn extension(name: &str) -> Option<&str> {
    name.rsplit_once('.').map(|(_, extension)| extension)
}

fn broken(place: String, error: CodecError, instead: &str) -> Finding {
    let CodecError {
        format,
        place: at,
        problem,
        remedy,
    } = error;
    let message = format!("the texture cannot be read ({format}: {at}: {problem}); {instead}");
    missing(place, message, remedy)
}

fn missing(place: String, message: String, remedy: impl Into<Message>) -> Finding {
    Finding::new("texture-missing", Level::Warning, place, message, remedy)
}

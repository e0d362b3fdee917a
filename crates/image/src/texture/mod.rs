//! Textures in common formats: PNG, JPEG and `OpenEXR`; with the feature `textures` also BMP, TGA, WebP and Radiance HDR, and
//! with the feature `basis` KTX2 (Basis Universal).
//!
//! Embedded colour profiles and orientations are not applied, as in USD and glTF.

#[cfg(feature = "basis")]
mod basis;
mod jpeg;
#[cfg(feature = "textures")]
mod other;
mod png;
mod png_chunks;

use oaktwin_base::diagnostic::{message, opt};
use oaktwin_files::memory;

use crate::srgb::{linear_from_srgb, srgb_from_linear};
use crate::{CodecError, Image, exr, limits};

/// A decoded image in its own colour space.
enum Decoded {
    /// sRGB with alpha.
    Srgb(Image<[u8; 4]>),
    /// Linear colours.
    Linear(Image<[f32; 3]>),
}

/// The format of a texture.
enum Format {
    Png,
    Jpeg,
    Exr,
    /// KTX2 and Basis Universal's own container.
    Basis,
    /// BMP, TGA, WebP, HDR, or none.
    Other,
}

impl Format {
    fn of(bytes: &[u8]) -> Self {
        const SIGNATURES: [(&[u8], Format); 5] = [
            (b"\x89PNG\r\n\x1a\n", Format::Png),
            (&[0xFF, 0xD8, 0xFF], Format::Jpeg),
            (&[0x76, 0x2F, 0x31, 0x01], Format::Exr),
            (b"\xabKTX 20\xbb\r\n\x1a\n", Format::Basis),
            (b"sB", Format::Basis),
        ];
        SIGNATURES
            .into_iter()
            .find(|(signature, _)| bytes.starts_with(signature))
            .map_or(Self::Other, |(_, format)| format)
    }
}

/// Decodes a texture to sRGB with alpha (255 if the file has none). High dynamic range is clipped at 1.
///
/// `extension` is the file's, without the dot. It is used only if the bytes do not identify the format (TGA).
///
/// # Errors
/// Returns an error if the format is not supported, the file is damaged, the image has 2³¹ pixels or more, or needs more memory
/// than there is.
pub fn decode_srgb(bytes: &[u8], extension: Option<&str>) -> Result<Image<[u8; 4]>, CodecError> {
    Ok(match decode(bytes, extension)? {
        Decoded::Srgb(image) => image,
        Decoded::Linear(image) => to_srgb(&image),
    })
}

fn to_srgb(image: &Image<[f32; 3]>) -> Image<[u8; 4]> {
    image.map(|rgb| {
        let [r, g, b] = rgb.map(srgb_from_linear);
        [r, g, b, 255]
    })
}

/// Decodes a texture to linear colours, for example of a dome light. Images of 8 bits are assumed to be sRGB.
///
/// # Errors
/// Returns the same errors as [`decode_srgb`].
pub fn decode_linear(bytes: &[u8], extension: Option<&str>) -> Result<Image<[f32; 3]>, CodecError> {
    Ok(match decode(bytes, extension)? {
        Decoded::Srgb(image) => to_linear(&image),
        Decoded::Linear(image) => image,
    })
}

/// Converts sRGB colours to linear ones, without alpha.
#[must_use]
pub fn to_linear(image: &Image<[u8; 4]>) -> Image<[f32; 3]> {
    let linear = linear_from_srgb();
    image.map(|&[r, g, b, _]| [r, g, b].map(|value| linear[usize::from(value)]))
}

fn decode(bytes: &[u8], extension: Option<&str>) -> Result<Decoded, CodecError> {
    match Format::of(bytes) {
        Format::Png => png::decode(bytes).map(Decoded::Srgb),
        Format::Jpeg => jpeg::decode(bytes).map(Decoded::Srgb),
        Format::Exr => exr::decode_rgb(bytes).map(Decoded::Linear),
        #[cfg(feature = "basis")]
        Format::Basis => basis::decode(bytes).map(Decoded::Srgb),
        #[cfg(not(feature = "basis"))]
        Format::Basis => Err(not_built_in("KTX2", "compressed-gltf")),
        #[cfg(feature = "textures")]
        Format::Other => other::decode(bytes, extension),
        #[cfg(not(feature = "textures"))]
        Format::Other => Err(unsupported(bytes, extension)),
    }
}

/// Returns the error for a format that this build cannot read.
#[cfg(not(feature = "textures"))]
fn unsupported(bytes: &[u8], extension: Option<&str>) -> CodecError {
    let is_tga = || extension.is_some_and(|extension| extension.eq_ignore_ascii_case("tga"));
    match bytes {
        [b'B', b'M', ..] => not_built_in("BMP", "textures"),
        [b'R', b'I', b'F', b'F', _, _, _, _, b'W', b'E', b'B', b'P', ..] => not_built_in("WebP", "textures"),
        [b'#', b'?', ..] => not_built_in("HDR", "textures"),
        _ if is_tga() => not_built_in("TGA", "textures"),
        _ => unknown(),
    }
}

#[cfg_attr(
    all(feature = "textures", feature = "basis"),
    expect(dead_code, reason = "everything is built in")
)]
fn not_built_in(format: &'static str, feature: &str) -> CodecError {
    let remedy = message![
        "convert it to PNG, JPEG or EXR, or build oaktwin with ",
        opt("features").with(feature)
    ];
    CodecError::new(format, "byte 0", "this build cannot read the format", remedy)
}

fn unknown() -> CodecError {
    let remedy = "convert it to PNG, JPEG, BMP, TGA, WebP, KTX2, HDR or EXR";
    CodecError::new("image", "byte 0", "unsupported format", remedy)
}

/// Rejects an image that its file cannot contain, or that does not fit into the memory, before it is decoded to `per_pixel`
/// bytes.
fn check(
    format: &'static str,
    (width, height): (u32, u32),
    per_pixel: u64,
    length: usize,
) -> Result<(), CodecError> {
    let size = (u64::from(width), u64::from(height));
    limits::check_claim(format, size, per_pixel, length)?;
    memory::check(limits::needed(size, per_pixel))
        .map_err(|shortage| CodecError::shortage(format, size, shortage))
}

fn broken(format: &'static str, place: &'static str, problem: &dyn std::fmt::Display) -> CodecError {
    let remedy = "the file is truncated or damaged; save it again";
    CodecError::new(format, place, problem.to_string(), remedy)
}

#[cfg(test)]
mod tests;

//! Textures in common formats: JPEG, PNG, BMP, TGA, WebP, KTX2 (Basis Universal), Radiance HDR and `OpenEXR`.
//!
//! Embedded colour profiles and orientations are not applied, as in USD and glTF.

use std::io::Cursor;

use ::image::{DynamicImage, ImageDecoder, ImageFormat, ImageReader, Limits};

use oaktwin_memory::{self as memory, Shortage};

pub use crate::reduced::Average;
use crate::srgb::{linear_from_srgb, srgb_from_linear};
use crate::{CodecError, Image, basis, exr, limits, png_chunks, reduced};

/// A decoded image in its own colour space.
enum Decoded {
    /// sRGB with alpha.
    Srgb(Image<[u8; 4]>),
    /// Linear colours.
    Linear(Image<[f32; 3]>),
}

/// A texture that fits into the memory.
#[derive(Clone, Debug)]
pub struct Fitted<P> {
    /// The pixels.
    pub image: Image<P>,
    /// The reduction, unless the image has the size in its file.
    pub reduction: Option<Reduction>,
}

/// The reason why an image is smaller than in its file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reduction {
    /// The width and height in the file.
    pub full_size: (u32, u32),
    /// The memory for the full size.
    pub shortage: Shortage,
}

/// The bytes per pixel of a reduced image and its mipmaps, or of its linear colours.
const SRGB_BYTES: u64 = 8;
const LINEAR_BYTES: u64 = 20;

/// Decodes a texture like [`decode_srgb`]. A PNG, JPEG or `OpenEXR` image that does not fit into the memory is reduced by a power
/// of two while it is read.
///
/// # Errors
/// Returns the same errors as [`decode_srgb`].
pub fn fit_srgb(
    bytes: &[u8],
    extension: Option<&str>,
    average: Average,
) -> Result<Fitted<[u8; 4]>, CodecError> {
    if is_exr(bytes) {
        // What is brighter than white is clipped before it is averaged, as in the mipmaps of full images.
        if let Some(reduced) = reduced::decode_exr(bytes, SRGB_BYTES, 1.0)? {
            let Fitted { image, reduction } = reduced.into();
            let image = to_srgb(&image);
            return Ok(Fitted { image, reduction });
        }
    } else if let Some(reduced) = reduced::decode(bytes, SRGB_BYTES, average)? {
        return Ok(reduced.into());
    }
    let image = decode_srgb(bytes, extension)?;
    let reduction = None;
    Ok(Fitted { image, reduction })
}

/// Decodes a texture like [`decode_linear`]. A PNG, JPEG or `OpenEXR` image that does not fit into the memory is reduced by a
/// power of two while it is read.
///
/// # Errors
/// Returns the same errors as [`decode_srgb`].
pub fn fit_linear(bytes: &[u8], extension: Option<&str>) -> Result<Fitted<[f32; 3]>, CodecError> {
    if is_exr(bytes) {
        if let Some(reduced) = reduced::decode_exr(bytes, LINEAR_BYTES, f32::INFINITY)? {
            return Ok(reduced.into());
        }
    } else if let Some(reduced) = reduced::decode(bytes, LINEAR_BYTES, Average::Srgb)? {
        let Fitted { image, reduction } = reduced.into();
        let image = to_linear(&image);
        return Ok(Fitted { image, reduction });
    }
    let image = decode_linear(bytes, extension)?;
    let reduction = None;
    Ok(Fitted { image, reduction })
}

impl<P> From<reduced::Reduced<P>> for Fitted<P> {
    fn from(reduced: reduced::Reduced<P>) -> Self {
        Self {
            image: reduced.image,
            reduction: Some(Reduction {
                full_size: reduced.full_size,
                shortage: reduced.shortage,
            }),
        }
    }
}

/// Decodes a texture to sRGB with alpha (255 if the file has none). High dynamic range is clipped at 1.
///
/// `extension` is the file's, without the dot. It is used only if the bytes do not identify the format (TGA).
///
/// # Errors
/// Returns an error if the format is not supported, the file is damaged, or the image has 2³¹ pixels or more.
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

fn is_exr(bytes: &[u8]) -> bool {
    bytes.starts_with(&[0x76, 0x2F, 0x31, 0x01])
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
    if is_exr(bytes) {
        return exr::decode_rgb(bytes).map(Decoded::Linear);
    }
    if basis::is_basis(bytes) {
        return basis::decode(bytes).map(Decoded::Srgb);
    }
    let format = ::image::guess_format(bytes)
        .ok()
        .or_else(|| ImageFormat::from_extension(extension?))
        .filter(ImageFormat::reading_enabled)
        .ok_or_else(|| {
            CodecError::new(
                "image",
                "byte 0",
                "unsupported format",
                "convert it to PNG, JPEG, BMP, TGA, WebP, KTX2, HDR or EXR",
            )
        })?;
    let name = match format {
        ImageFormat::Png => "PNG",
        ImageFormat::Jpeg => "JPEG",
        ImageFormat::Bmp => "BMP",
        ImageFormat::Tga => "TGA",
        ImageFormat::WebP => "WebP",
        ImageFormat::Hdr => "HDR",
        _ => "image",
    };
    let broken = |place: &'static str, error: &dyn std::fmt::Display| {
        CodecError::new(
            name,
            place,
            error.to_string(),
            "the file is truncated or damaged; save it again",
        )
    };
    let bytes = if format == ImageFormat::Png {
        &png_chunks::without_unused(bytes)
    } else {
        bytes
    };
    let mut reader = ImageReader::with_format(Cursor::new(bytes), format);
    let mut limits = Limits::default();
    limits.max_alloc = Some(limits::allowed_bytes(bytes.len()));
    reader.limits(limits);
    let decoder = reader.into_decoder().map_err(|error| broken("header", &error))?;
    let (width, height) = decoder.dimensions();
    let per_pixel = u64::from(decoder.color_type().bytes_per_pixel());
    let size = (u64::from(width), u64::from(height));
    limits::check_claim(name, size, per_pixel, bytes.len())?;
    memory::check(limits::needed(size, per_pixel))
        .map_err(|shortage| CodecError::shortage(name, size, shortage))?;
    let image = DynamicImage::from_decoder(decoder).map_err(|error| broken("pixels", &error))?;
    let incomplete = || broken("pixels", &"incomplete");
    Ok(match image {
        DynamicImage::ImageRgb32F(_) | DynamicImage::ImageRgba32F(_) => {
            let pixels = image.into_rgb32f().into_raw().as_chunks().0.to_vec();
            Decoded::Linear(Image::new(width, height, pixels).ok_or_else(incomplete)?)
        }
        image => {
            let pixels = match &image {
                DynamicImage::ImageRgb8(image) => {
                    let (pixels, _) = image.as_raw().as_chunks();
                    pixels.iter().map(|&[r, g, b]| [r, g, b, u8::MAX]).collect()
                }
                _ => image.into_rgba8().into_raw().as_chunks().0.to_vec(),
            };
            Decoded::Srgb(Image::new(width, height, pixels).ok_or_else(incomplete)?)
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use ::image::{Rgb32FImage, RgbImage};
    use proptest::prelude::*;

    fn picture(format: ImageFormat) -> Vec<u8> {
        let mut out = Cursor::new(Vec::new());
        if format == ImageFormat::Hdr {
            let image = Rgb32FImage::from_fn(16, 8, |x, y| ::image::Rgb([x as f32, y as f32, 0.5]));
            image.write_to(&mut out, format).unwrap();
        } else {
            let byte = |value: u32| u8::try_from(value).unwrap();
            let image = RgbImage::from_fn(16, 8, |x, y| {
                ::image::Rgb([byte(x * 16), byte(y * 32), byte(255 - x)])
            });
            image.write_to(&mut out, format).unwrap();
        }
        out.into_inner()
    }

    #[test]
    fn reads_all_formats() {
        for format in [
            ImageFormat::Png,
            ImageFormat::Bmp,
            ImageFormat::Tga,
            ImageFormat::WebP,
        ] {
            let image = decode_srgb(&picture(format), Some("tga")).unwrap();
            assert_eq!((image.width(), image.height()), (16, 8), "{format:?}");
            assert_eq!(image.get(3, 2), Some(&[48, 64, 252, 255]), "{format:?}");
        }
        let jpeg = decode_srgb(&picture(ImageFormat::Jpeg), None).unwrap();
        let close = jpeg.get(3, 2).unwrap().iter().zip([48, 64, 252u8]);
        assert!(close.clone().all(|(a, b)| a.abs_diff(b) < 24), "{close:?}");
        let hdr = picture(ImageFormat::Hdr);
        assert_eq!(
            decode_linear(&hdr, None).unwrap().get(3, 2),
            Some(&[3.0, 2.0, 0.5])
        );
        assert_eq!(
            decode_srgb(&hdr, None).unwrap().get(3, 2),
            Some(&[255, 255, 188, 255])
        );
    }

    #[test]
    fn converts_8_bits_from_srgb() {
        let png = crate::png::encode(&Image::filled(1, 1, [255u8, 0, 188])).unwrap();
        let [r, g, b] = decode_linear(&png, None).unwrap().pixels()[0];
        assert_eq!((r, g), (1.0, 0.0));
        assert!((b - 0.5).abs() < 5e-3);
    }

    #[test]
    fn errors_state_a_remedy() {
        let says = |bytes: &[u8], extension| decode_srgb(bytes, extension).unwrap_err().to_string();
        assert_eq!(
            says(b"GIF89a", None),
            "image: byte 0: unsupported format; convert it to PNG, JPEG, BMP, TGA, WebP, KTX2, HDR or EXR"
        );
        assert!(says(b"", Some("tga")).starts_with("TGA: header: "));
        assert!(says(&picture(ImageFormat::Jpeg)[..60], None).starts_with("JPEG: "));
        // 60 000 × 60 000 pixels in a header of 18 bytes, and no more.
        let mut tga = vec![0u8; 18];
        tga[2] = 2;
        tga[12..16].copy_from_slice(&[0x60, 0xEA, 0x60, 0xEA]);
        tga[16] = 24;
        assert!(says(&tga, Some("tga")).contains("60000 × 60000 pixels, 2^31 or more"));
        tga[12..16].copy_from_slice(&[0x60, 0x6A, 0x60, 0x6A]);
        assert!(says(&tga, Some("tga")).contains("cannot be in 18 bytes"));
    }

    proptest! {
        #[test]
        fn never_panics_on_damaged_files(
            which in 0usize..6, at: prop::sample::Index, value: u8, cut: prop::sample::Index,
        ) {
            use ImageFormat::{Bmp, Hdr, Jpeg, Png, Tga, WebP};
            let mut file = picture([Png, Jpeg, Bmp, Tga, WebP, Hdr][which]);
            let at = at.index(file.len());
            file[at] = value;
            let _ = decode_srgb(&file, Some("tga"));
            file.truncate(cut.index(file.len()));
            let _ = decode_linear(&file, Some("tga"));
        }
    }
}

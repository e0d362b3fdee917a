use std::io::Cursor;

use ::image::{DynamicImage, ImageDecoder, ImageFormat, ImageReader, Limits};

use super::{Decoded, broken, check, unknown};
use crate::{CodecError, Image, limits};

/// Decodes BMP, TGA, WebP and Radiance HDR.
pub(super) fn decode(bytes: &[u8], extension: Option<&str>) -> Result<Decoded, CodecError> {
    let format = ::image::guess_format(bytes)
        .ok()
        .or_else(|| ImageFormat::from_extension(extension?))
        .ok_or_else(unknown)?;
    let name = match format {
        ImageFormat::Bmp => "BMP",
        ImageFormat::Tga => "TGA",
        ImageFormat::WebP => "WebP",
        ImageFormat::Hdr => "HDR",
        // Only if the extension names a format that the bytes are not.
        ImageFormat::Png => return Err(broken("PNG", "header", &"not a PNG file")),
        ImageFormat::Jpeg => return Err(broken("JPEG", "header", &"not a JPEG file")),
        _ => return Err(unknown()),
    };
    let mut reader = ImageReader::with_format(Cursor::new(bytes), format);
    let mut limits = Limits::default();
    limits.max_alloc = Some(limits::allowed_bytes(bytes.len()));
    reader.limits(limits);
    let decoder = reader
        .into_decoder()
        .map_err(|error| broken(name, "header", &error))?;
    let (width, height) = decoder.dimensions();
    let per_pixel = u64::from(decoder.color_type().bytes_per_pixel());
    check(name, (width, height), per_pixel, bytes.len())?;
    let image = DynamicImage::from_decoder(decoder).map_err(|error| broken(name, "pixels", &error))?;
    let incomplete = || broken(name, "pixels", &"incomplete");
    Ok(match image {
        DynamicImage::ImageRgb32F(_) | DynamicImage::ImageRgba32F(_) => {
            let pixels = image.into_rgb32f().into_raw().as_chunks().0.to_vec();
            Decoded::Linear(Image::new(width, height, pixels).ok_or_else(incomplete)?)
        }
        image => {
            let pixels = image.into_rgba8().into_raw().as_chunks().0.to_vec();
            Decoded::Srgb(Image::new(width, height, pixels).ok_or_else(incomplete)?)
        }
    })
}

use oaktwin::image::{CodecError, Image, millimetres, png};

use crate::message::{CompressedImage, Header};

/// What subscribers of compressed depth look for: images of millimetres, in PNG.
const FORMAT: &str = "16UC1; compressedDepth png";
/// The bytes before the PNG: the kind of quantization and its two parameters, which millimetres do not need.
const QUANTIZATION: [u8; 12] = [0; 12];

/// Converts measured depth in metres to a message as `compressed_depth_image_transport` expects it: whole millimetres without loss,
/// 0 where nothing was measured.
///
/// # Errors
/// Returns an error if the image has no pixels.
pub fn compressed_depth(header: Header, metres: &Image<f32>) -> Result<CompressedImage, CodecError> {
    let mut data = QUANTIZATION.to_vec();
    data.extend(png::encode(&millimetres::from_metres(metres))?);
    Ok(CompressedImage {
        header,
        format: FORMAT.to_owned(),
        data,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn millimetres_survive_the_compression() {
        let metres = Image::new(3, 1, vec![0.0, 1.2344, 65.0]).unwrap();
        let message = compressed_depth(Header::default(), &metres).unwrap();
        let (quantization, image) = message.data.split_at(12);
        assert_eq!(quantization, [0; 12]);
        assert_eq!(message.format, "16UC1; compressedDepth png");
        let decoded: Image<u16> = png::decode(image).unwrap();
        assert_eq!(decoded.pixels(), [0, 1234, 65_000]);
    }
}

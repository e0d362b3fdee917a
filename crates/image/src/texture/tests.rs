use super::*;
use std::io::Cursor;

use ::image::{DynamicImage, ImageFormat, Rgb32FImage, RgbImage};
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

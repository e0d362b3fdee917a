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

/// Noise of a colour type, as 16 bits per sample.
fn noise() -> DynamicImage {
    let mut state = 7u32;
    let mut sample = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        u16::try_from(state >> 16).unwrap()
    };
    DynamicImage::ImageRgba16(::image::ImageBuffer::from_fn(13, 7, |_, _| {
        ::image::Rgba([sample(), sample(), sample(), sample()])
    }))
}

fn encoded(image: &DynamicImage, format: ImageFormat) -> Vec<u8> {
    let mut out = Cursor::new(Vec::new());
    image.write_to(&mut out, format).unwrap();
    out.into_inner()
}

/// Compares with another reader, which scales samples of 16 bits in the same way.
fn is_as_read_by_another(file: &[u8], what: &str) {
    let theirs = ::image::load_from_memory(file).unwrap().into_rgba8();
    let ours = decode_srgb(file, None).unwrap();
    assert_eq!((ours.width(), ours.height()), theirs.dimensions(), "{what}");
    assert_eq!(ours.pixels().as_flattened(), theirs.as_raw().as_slice(), "{what}");
}

#[test]
fn png_and_jpeg_of_every_colour_type_are_as_another_reader_sees_them() {
    let noise = noise();
    for (what, image) in [
        ("grey", DynamicImage::ImageLuma8(noise.to_luma8())),
        (
            "grey and alpha",
            DynamicImage::ImageLumaA8(noise.to_luma_alpha8()),
        ),
        ("RGB", DynamicImage::ImageRgb8(noise.to_rgb8())),
        ("RGBA", DynamicImage::ImageRgba8(noise.to_rgba8())),
        ("grey of 16 bits", DynamicImage::ImageLuma16(noise.to_luma16())),
        (
            "grey and alpha of 16 bits",
            DynamicImage::ImageLumaA16(noise.to_luma_alpha16()),
        ),
        ("RGB of 16 bits", DynamicImage::ImageRgb16(noise.to_rgb16())),
        ("RGBA of 16 bits", noise.clone()),
    ] {
        is_as_read_by_another(&encoded(&image, ImageFormat::Png), what);
        if what == "grey" || what == "RGB" {
            is_as_read_by_another(&encoded(&image, ImageFormat::Jpeg), what);
        }
    }
}

#[test]
fn png_with_a_palette_and_few_bits_is_as_another_reader_sees_it() {
    for depth in [
        ::png::BitDepth::One,
        ::png::BitDepth::Two,
        ::png::BitDepth::Four,
        ::png::BitDepth::Eight,
    ] {
        for color in [::png::ColorType::Indexed, ::png::ColorType::Grayscale] {
            let mut file = Vec::new();
            let mut encoder = ::png::Encoder::new(&mut file, 9, 3);
            encoder.set_color(color);
            encoder.set_depth(depth);
            if color == ::png::ColorType::Indexed {
                let colors = 1usize << (depth as u8);
                encoder.set_palette(
                    (0..colors * 3)
                        .map(|i| u8::try_from(i * 37 % 256).unwrap())
                        .collect::<Vec<_>>(),
                );
                encoder.set_trns(vec![10u8, 200]);
            }
            let row = (9 * depth as usize).div_ceil(8);
            let samples: Vec<u8> = (0..3 * row)
                .map(|i| u8::try_from(i * 91 % 256).unwrap())
                .collect();
            encoder
                .write_header()
                .unwrap()
                .write_image_data(&samples)
                .unwrap();
            is_as_read_by_another(&file, &format!("{color:?} of {depth:?} bits"));
        }
    }
}

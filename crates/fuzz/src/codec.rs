//! Image files.

use oaktwin_image::npy::{self, Values};
use oaktwin_image::{Image, exr, pfm, png, texture};

use crate::random::Random;

pub(crate) fn npy(bytes: &[u8]) {
    let Ok(array) = npy::decode(bytes) else { return };
    let count: usize = array.shape.iter().product();
    let (length, file) = match &array.values {
        Values::U8(values) => (values.len(), npy::encode(&array.shape, values)),
        Values::U16(values) => (values.len(), npy::encode(&array.shape, values)),
        Values::I32(values) => (values.len(), npy::encode(&array.shape, values)),
        Values::I64(values) => (values.len(), npy::encode(&array.shape, values)),
        Values::F32(values) => (values.len(), npy::encode(&array.shape, values)),
        Values::F64(values) => (values.len(), npy::encode(&array.shape, values)),
    };
    assert_eq!(length, count, "{:?}", array.shape);
    let file = file.unwrap_or_else(|error| panic!("{error}"));
    let again = npy::decode(&file).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(again.shape, array.shape);
    assert!(same(&again.values, &array.values), "the values do not round-trip");
    if let Ok(image) = array.into_f32_image() {
        fits(&image);
    }
}

/// Whether values are equal, bit by bit.
fn same(a: &Values, b: &Values) -> bool {
    match (a, b) {
        (Values::F32(a), Values::F32(b)) => a.iter().map(|x| x.to_bits()).eq(b.iter().map(|x| x.to_bits())),
        (Values::F64(a), Values::F64(b)) => a.iter().map(|x| x.to_bits()).eq(b.iter().map(|x| x.to_bits())),
        (a, b) => a == b,
    }
}

pub(crate) fn npy_seeds() -> Vec<Vec<u8>> {
    let float: Vec<f32> = (0u8..24).map(f32::from).collect();
    let double: Vec<f64> = (0u8..24).map(f64::from).collect();
    let bytes: Vec<u8> = (0..24).collect();
    let shorts: Vec<u16> = (0..24).collect();
    let mut fortran = npy::encode(&[4, 6], &float).unwrap_or_default();
    if let Some(at) = fortran.windows(5).position(|word| word == b"False") {
        fortran[at..at + 5].copy_from_slice(b"True ");
    }
    let mut all: Vec<Vec<u8>> = [
        npy::encode(&[4, 6], &float),
        npy::encode(&[4, 6, 1], &double),
        npy::encode(&[2, 3, 4], &bytes),
        npy::encode(&[2, 2, 2, 3], &shorts),
        npy::encode(&[0, 6], &float[..0]),
    ]
    .into_iter()
    .flatten()
    .collect();
    all.push(fortran);
    all
}

/// The first byte selects the format, and whether the rest is a file or pixels to encode.
pub(crate) fn depth_image(bytes: &[u8]) {
    let Some((&first, rest)) = bytes.split_first() else {
        return;
    };
    if first & 1 == 1 {
        let mut random = Random::new(rest);
        // Small, since encoding takes most of the time.
        let (width, height) = (1 + random.up_to(18), 1 + random.up_to(17));
        let image = random.image(width, height, Random::depth);
        let file = match first >> 1 & 1 {
            0 => pfm::encode(&image),
            _ => exr::encode(&image).unwrap_or_else(|error| panic!("{error}")),
        };
        let again = match first >> 1 & 1 {
            0 => pfm::decode(&file),
            _ => exr::decode(&file),
        };
        assert_same(&again.unwrap_or_else(|error| panic!("{error}")), &image);
        return;
    }
    match first >> 1 & 3 {
        0 => {
            if let Ok(image) = png::decode::<u16>(rest) {
                let again = png::encode(&image).and_then(|file| png::decode::<u16>(&file));
                assert_eq!(again.unwrap_or_else(|error| panic!("{error}")), image);
            }
        }
        1 => {
            let _ = png::decode::<u8>(rest).map(|image| fits(&image));
            let _ = png::decode::<[u8; 3]>(rest).map(|image| fits(&image));
            let _ = png::decode::<[u8; 4]>(rest).map(|image| fits(&image));
        }
        2 => {
            if let Ok(image) = exr::decode(rest) {
                fits(&image);
            }
        }
        _ => {
            if let Ok(image) = pfm::decode(rest) {
                fits(&image);
                let again = pfm::decode(&pfm::encode(&image));
                assert_same(&again.unwrap_or_else(|error| panic!("{error}")), &image);
            }
        }
    }
}

fn fits<T>(image: &Image<T>) {
    assert_eq!(
        image.pixels().len(),
        image.width() as usize * image.height() as usize
    );
}

fn assert_same(a: &Image<f32>, b: &Image<f32>) {
    assert_eq!((a.width(), a.height()), (b.width(), b.height()));
    let bits = |image: &Image<f32>| image.pixels().iter().map(|x| x.to_bits()).collect::<Vec<_>>();
    assert!(bits(a) == bits(b), "the pixels do not round-trip");
}

pub(crate) fn depth_image_seeds() -> Vec<Vec<u8>> {
    let mut float = Image::filled(9, 7, 1.5f32);
    float.pixels_mut()[0] = f32::INFINITY;
    let grey =
        Image::new(5, 4, (0..20u16).map(|at| at * 997).collect()).unwrap_or_else(|| Image::filled(1, 1, 0));
    let files = [
        (0, png::encode(&grey)),
        (2, png::encode(&grey.map(|_| 7u8))),
        (2, png::encode(&grey.map(|_| [7u8, 3, 1]))),
        (2, png::encode(&grey.map(|_| [7u8, 3, 1, 200]))),
        (4, exr::encode(&float)),
        (6, Ok(pfm::encode(&float))),
        (1, Ok(vec![9, 9, 40, 50, 60, 70, 0, 1, 2])),
        (3, Ok(vec![9, 9, 40, 50, 60, 70, 0, 1, 2])),
    ];
    files
        .into_iter()
        .filter_map(|(first, file)| Some([&[first][..], &file.ok()?].concat()))
        .collect()
}

pub(crate) fn texture(bytes: &[u8]) {
    let srgb = texture::decode_srgb(bytes, Some("tga"));
    let linear = texture::decode_linear(bytes, Some("tga"));
    match (srgb, linear) {
        (Ok(srgb), Ok(linear)) => {
            assert_eq!((srgb.width(), srgb.height()), (linear.width(), linear.height()));
            fits(&srgb);
            fits(&linear);
        }
        (Err(_), Err(_)) => {}
        (srgb, linear) => panic!("sRGB: {:?}, linear: {:?}", srgb.err(), linear.err()),
    }
}

pub(crate) fn texture_seeds() -> Vec<Vec<u8>> {
    let colors = Image::filled(8, 4, [200u8, 100, 50]);
    let mut all: Vec<Vec<u8>> = [png::encode(&colors), exr::encode(&Image::filled(3, 3, 0.5))]
        .into_iter()
        .flatten()
        .collect();
    // Two pixels of a TGA, a BMP and a Radiance HDR.
    all.push(vec![
        0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 1, 0, 24, 0, 1, 2, 3, 4, 5, 6,
    ]);
    let mut bmp = b"BM\x3e\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0\x02\0\0\0\x01\0\0\0\x01\0\x18\0".to_vec();
    bmp.resize(54, 0);
    bmp.extend([1, 2, 3, 4, 5, 6, 0, 0]);
    all.push(bmp);
    all.push(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n\x80\x80\x80\x80\x10\x20\x30\x81".to_vec());
    all
}

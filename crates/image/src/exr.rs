//! `OpenEXR`: depth as one channel of `float32`, lossless, including infinity and NaN.
//!
//! The written channel is `Y`, the luminance of a greyscale image, which OpenCV writes and reads and all viewers display.
//! `OpenEXR`'s name for depth is `Z` (its technical introduction), but OpenCV silently returns zeros for files with only that
//! channel (its issue 22592).

use std::io::Cursor;

use ::exr::prelude::{
    AnyChannel, AnyChannels, Blocks, Compression, Encoding, FlatSamples, Image as ExrImage, Layer,
    LayerAttributes, LineOrder, MetaData, ReadChannels, ReadLayers, Vec2, WritableImage, read,
};
use oaktwin_base::panics;

use crate::{CodecError, Image, limits};

pub(crate) const FORMAT: &str = "OpenEXR";

/// The name of the written channel.
pub const CHANNEL: &str = "Y";

/// Encodes an image as one channel named [`CHANNEL`].
///
/// # Errors
/// Returns an error if the image has no pixels, which the format does not support.
pub fn encode(image: &Image<f32>) -> Result<Vec<u8>, CodecError> {
    let size = Vec2(image.width() as usize, image.height() as usize);
    let samples = FlatSamples::F32(image.pixels().to_vec());
    let layer = Layer::new(
        size,
        LayerAttributes::default(),
        Encoding {
            compression: Compression::ZIP1,
            blocks: Blocks::ScanLines,
            line_order: LineOrder::Increasing,
        },
        AnyChannels::sort([AnyChannel::new(CHANNEL, samples)].into_iter().collect()),
    );
    let mut out = Cursor::new(Vec::with_capacity(size_of_val(image.pixels()) / 2));
    if image.pixels().is_empty() {
        return Err(CodecError::new(
            FORMAT,
            "image",
            format!("{} × {} pixels", image.width(), image.height()),
            "pass an image with pixels",
        ));
    }
    ExrImage::from_layer(layer)
        .write()
        .non_parallel()
        .to_buffered(&mut out)
        .map_err(|error| CodecError::new(FORMAT, "image", error.to_string(), "write another format"))?;
    Ok(out.into_inner())
}

/// The names of depth channels in lower case, by priority: `OpenEXR`'s `Z`, Blender's `V` (and its layer `Depth`), names of
/// annotators, luminance, and the first of three equal channels.
const DEPTH_NAMES: [&str; 7] = [
    "z",
    "v",
    "depth",
    "distance_to_image_plane",
    "distance_to_camera",
    "y",
    "r",
];

/// Decodes the depth in a file: its channel `Z`, otherwise `V`, `depth`, `distance_to_image_plane`, `distance_to_camera` or `Y`,
/// in any layer (`View Layer.Depth.Z`) and ignoring case; otherwise `R`, if `G` and `B` equal it; otherwise its only channel.
///
/// # Errors
/// Returns an error if the bytes are not an `OpenEXR` file of scan lines or tiles, or if it has several channels of other names.
pub fn decode(bytes: &[u8]) -> Result<Image<f32>, CodecError> {
    let mut channels = channels(bytes)?;
    let is_named = |given: &str, name: &str| {
        let last = given.rsplit('.').next().unwrap_or(given);
        last.eq_ignore_ascii_case(name)
    };
    let find = |name: &str| channels.names.iter().position(|given| is_named(given, name));
    let index = DEPTH_NAMES
        .iter()
        .find_map(|name| find(name))
        .or((channels.names.len() == 1).then_some(0))
        .ok_or_else(|| {
            CodecError::new(
                FORMAT,
                "channels",
                format!("none of {} is a depth", channels.names.join(", ")),
                "name the channel Z",
            )
        })?;
    let others = [find("g"), find("b")];
    if is_named(&channels.names[index], "r") {
        for other in others.into_iter().flatten() {
            let same = |(a, b): (f32, f32)| a.to_bits() == b.to_bits();
            let (red, other) = (&channels.samples[index], &channels.samples[other]);
            if !red.values_as_f32().zip(other.values_as_f32()).all(same) {
                return Err(CodecError::new(
                    FORMAT,
                    "channels",
                    "R, G and B differ, so this is a colour image, not depth",
                    "save the depth in a channel named Z",
                ));
            }
        }
    }
    let pixels = match channels.samples.swap_remove(index) {
        FlatSamples::F32(values) => values,
        other => other.values_as_f32().collect(),
    };
    Image::new(channels.width, channels.height, pixels).ok_or_else(incomplete)
}

/// Decodes the linear colours in a file: its channels R, G and B, or Y for all three.
pub(crate) fn decode_rgb(bytes: &[u8]) -> Result<Image<[f32; 3]>, CodecError> {
    let channels = channels(bytes)?;
    let indices = color_channels(&channels.names)?;
    let [r, g, b] = indices.map(|index| channels.samples[index].values_as_f32());
    let pixels = r.zip(g).zip(b).map(|((r, g), b)| [r, g, b]).collect();
    Image::new(channels.width, channels.height, pixels).ok_or_else(incomplete)
}

/// Returns the indices of the channels of red, green and blue.
pub(crate) fn color_channels(names: &[String]) -> Result<[usize; 3], CodecError> {
    let of = |name: &str| names.iter().position(|given| given == name);
    match (of("R"), of("G"), of("B"), of("Y")) {
        (Some(r), Some(g), Some(b), _) => Ok([r, g, b]),
        (_, _, _, Some(y)) => Ok([y; 3]),
        _ => Err(CodecError::new(
            FORMAT,
            "channels",
            format!("no R, G and B among {}", names.join(", ")),
            "save an image of R, G and B",
        )),
    }
}

/// The first layer of a file.
struct Channels {
    width: u32,
    height: u32,
    names: Vec<String>,
    samples: Vec<FlatSamples>,
}

pub(crate) fn incomplete() -> CodecError {
    broken("incomplete".into())
}

pub(crate) fn broken(problem: String) -> CodecError {
    CodecError::new(
        FORMAT,
        "pixels",
        problem,
        "the file is truncated or damaged; save it again",
    )
}

fn channels(bytes: &[u8]) -> Result<Channels, CodecError> {
    // A damaged file can fail the reader's assertions. Only the error survives the unwinding.
    panics::contain(|| read_channels(bytes)).unwrap_or_else(|_| Err(broken("the decoder failed".into())))
}

fn read_channels(bytes: &[u8]) -> Result<Channels, CodecError> {
    let meta = MetaData::read_from_buffered(Cursor::new(bytes), false)
        .map_err(|error| CodecError::new(FORMAT, "header", error.to_string(), "pass an OpenEXR file"))?;
    for header in &meta.headers {
        let size = (header.layer_size.0 as u64, header.layer_size.1 as u64);
        // A sample becomes at most four bytes.
        let channels = header.channels.list.len() as u64;
        limits::check(FORMAT, size, channels * 4, bytes.len())?;
    }
    let image = read()
        .no_deep_data()
        .largest_resolution_level()
        .all_channels()
        .first_valid_layer()
        .all_attributes()
        .non_parallel()
        .from_buffered(Cursor::new(bytes))
        .map_err(|error| broken(error.to_string()))?;
    let layer = image.layer_data;
    let size = |n: usize| u32::try_from(n).map_err(|_| broken(format!("{n} pixels on a side")));
    let (width, height) = (size(layer.size.0)?, size(layer.size.1)?);
    let (names, samples) = layer
        .channel_data
        .list
        .into_iter()
        .map(|channel| (channel.name.to_string(), channel.sample_data))
        .unzip();
    Ok(Channels {
        width,
        height,
        names,
        samples,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn writes_a_luminance_channel() {
        let file = encode(&Image::new(2, 1, vec![1.5f32, f32::INFINITY]).unwrap()).unwrap();
        assert_eq!(file[..4], [0x76, 0x2F, 0x31, 0x01]);
        let channels = channels(&file).unwrap();
        assert_eq!(channels.names, ["Y"]);
        assert!(matches!(&channels.samples[0], FlatSamples::F32(values) if values == &[1.5, f32::INFINITY]));
        assert_eq!(decode_rgb(&file).unwrap().get(0, 0), Some(&[1.5; 3]));
    }

    #[test]
    fn reads_colours() {
        let mut file = Cursor::new(Vec::new());
        let pixels = |position: Vec2<usize>| (position.0 as f32, 0.5f32, 2.0f32);
        let channels = ::exr::prelude::SpecificChannels::rgb(pixels);
        ExrImage::from_channels((2, 1), channels)
            .write()
            .non_parallel()
            .to_buffered(&mut file)
            .unwrap();
        let image = decode_rgb(file.get_ref()).unwrap();
        assert_eq!(image.pixels(), [[0.0, 0.5, 2.0], [1.0, 0.5, 2.0]]);
        let error = decode(file.get_ref()).unwrap_err().to_string();
        assert!(error.contains("R, G and B differ"), "{error}");
    }

    #[test]
    fn finds_depth_by_name_in_any_layer() {
        for (names, expected) in [
            (["A", "Z"], 2.0),
            (["Depth", "mask"], 1.0),
            (["Y", "View Layer.Depth.Z"], 2.0),
            (["distance_to_camera", "A"], 1.0),
        ] {
            let mut file = Cursor::new(Vec::new());
            let channels = ::exr::prelude::SpecificChannels::build()
                .with_channel(names[0])
                .with_channel(names[1])
                .with_pixel_fn(|_| (::exr::prelude::f16::from_f32(1.0), 2f32));
            ExrImage::from_channels((1, 1), channels)
                .write()
                .non_parallel()
                .to_buffered(&mut file)
                .unwrap();
            assert_eq!(decode(file.get_ref()).unwrap().pixels(), [expected], "{names:?}");
        }
    }

    #[test]
    fn reads_equal_channels_as_depth() {
        let mut file = Cursor::new(Vec::new());
        let pixels = |position: Vec2<usize>| {
            let z = 1.5 + position.0 as f32;
            (z, z, z)
        };
        ExrImage::from_channels((2, 1), ::exr::prelude::SpecificChannels::rgb(pixels))
            .write()
            .non_parallel()
            .to_buffered(&mut file)
            .unwrap();
        assert_eq!(decode(file.get_ref()).unwrap().pixels(), [1.5, 2.5]);
    }

    #[test]
    fn rejects_unknown_channels() {
        let mut file = Cursor::new(Vec::new());
        let channels = ::exr::prelude::SpecificChannels::build()
            .with_channel("U")
            .with_channel("W")
            .with_pixel_fn(|_| (1f32, 2f32));
        ExrImage::from_channels((1, 1), channels)
            .write()
            .non_parallel()
            .to_buffered(&mut file)
            .unwrap();
        assert_eq!(
            decode(file.get_ref()).unwrap_err().to_string(),
            "OpenEXR: channels: none of U, W is a depth; name the channel Z"
        );
        assert_eq!(
            decode_rgb(file.get_ref()).unwrap_err().to_string(),
            "OpenEXR: channels: no R, G and B among U, W; save an image of R, G and B"
        );
    }

    #[test]
    fn errors_state_a_remedy() {
        assert!(
            encode(&Image::filled(0, 2, 0.0))
                .unwrap_err()
                .to_string()
                .contains("0 × 2")
        );
        let error = decode(b"not one").unwrap_err().to_string();
        assert!(error.starts_with("OpenEXR: header: "), "{error}");
        assert!(error.ends_with("; pass an OpenEXR file"), "{error}");
    }

    proptest! {
        #[test]
        fn round_trip_is_lossless(width in 1u32..40, height in 1u32..40, seed: u32) {
            let bits: Vec<u32> = (0..width * height).map(|i| (i + 1).wrapping_mul(seed | 1)).collect();
            let image = Image::new(width, height, bits.iter().map(|&b| f32::from_bits(b)).collect()).unwrap();
            let back = decode(&encode(&image).unwrap()).unwrap();
            prop_assert_eq!((back.width(), back.height()), (width, height));
            prop_assert_eq!(back.pixels().iter().map(|v| v.to_bits()).collect::<Vec<_>>(), bits);
        }

        #[test]
        fn never_panics_on_damaged_files(at: prop::sample::Index, value: u8, cut: prop::sample::Index) {
            let mut file = encode(&Image::filled(20, 20, 1.0)).unwrap();
            let at = at.index(file.len());
            file[at] = value;
            let _ = decode(&file);
            file.truncate(cut.index(file.len()));
            let _ = decode(&file);
        }
    }
}

//! `OpenEXR`: block by block, in whatever order the file has them.

use std::io::Cursor;
use std::panic::{AssertUnwindSafe, catch_unwind};

use ::exr::block::lines::LineRef;
use ::exr::block::reader::{ChunksReader, Reader};
use ::exr::meta::header::Header;
use ::exr::prelude::{SampleType, f16};
use oaktwin_files::memory;

use super::areas::{self, Areas};
use super::{Reduced, divisor};
use crate::exr::{FORMAT, broken, color_channels, incomplete};
use crate::{CodecError, Image, limits};

/// Reads linear colours if their full size does not fit into the memory: at the largest size, divided by a power of two, that
/// does. `None` if it fits, and for files that the decoder of full images rejects.
///
/// `per_pixel` is the number of bytes that a pixel of the result needs in total. Values above `max` count as `max`.
///
/// # Errors
/// Returns an error if the file is damaged, or one of its blocks does not fit.
pub(crate) fn decode(
    bytes: &[u8],
    per_pixel: u64,
    max: f32,
) -> Result<Option<Reduced<[f32; 3]>>, CodecError> {
    // A damaged file can fail the reader's assertions. Only the error survives the unwinding.
    catch_unwind(AssertUnwindSafe(|| read(bytes, per_pixel, max)))
        .unwrap_or_else(|_| Err(broken("the decoder failed".into())))
}

fn read(bytes: &[u8], per_pixel: u64, max: f32) -> Result<Option<Reduced<[f32; 3]>>, CodecError> {
    let Ok(reader) = Reader::read_from_buffered(Cursor::new(bytes), false) else {
        return Ok(None);
    };
    let is_flat = |header: &Header| !header.deep;
    let Some(layer) = reader.headers().iter().position(is_flat) else {
        return Ok(None);
    };
    let header = reader.headers()[layer].clone();
    let size = (header.layer_size.0 as u64, header.layer_size.1 as u64);
    let bytes_per_pixel = header.channels.list.len() as u64 * 4;
    limits::check_claim(FORMAT, size, bytes_per_pixel, bytes.len())?;
    let Err(shortage) = memory::check(size.0 * size.1 * 2 * bytes_per_pixel) else {
        return Ok(None);
    };
    // A block is read, decompressed and put in order.
    let block = (header.max_block_byte_size() as u64).saturating_mul(4);
    let per_pixel = per_pixel + areas::BYTES_PER_PIXEL;
    let other = block.saturating_add(size.0 * (areas::BYTES_PER_COLUMN + 4));
    let divisor =
        divisor(size, per_pixel, |_| other).ok_or_else(|| CodecError::shortage(FORMAT, size, shortage))?;
    let means = means(reader, layer, &header, divisor, max)?;
    let full_size = side(size.0).zip(side(size.1)).ok_or_else(incomplete)?;
    Ok(Some(Reduced {
        image: means,
        full_size,
        shortage,
    }))
}

fn side(length: u64) -> Option<u32> {
    u32::try_from(length).ok()
}

fn means(
    reader: Reader<Cursor<&[u8]>>,
    layer: usize,
    header: &Header,
    divisor: u32,
    max: f32,
) -> Result<Image<[f32; 3]>, CodecError> {
    let names: Vec<String> = header.channels.list.iter().map(|c| c.name.to_string()).collect();
    let colors = color_channels(&names)?;
    let failed = |error: ::exr::error::Error| broken(error.to_string());
    let size = (side(header.layer_size.0 as u64)).zip(side(header.layer_size.1 as u64));
    let mut areas = Areas::new(size.ok_or_else(incomplete)?, divisor);
    let mut samples = Vec::new();
    let chunks = reader
        .filter_chunks(false, |_, tile, block| {
            block.layer == layer && tile.is_largest_resolution_level()
        })
        .map_err(failed)?;
    let mut blocks = chunks.sequential_decompressor(false);
    while let Some(block) = blocks.decompress_next_block() {
        let block = block.map_err(failed)?;
        for line in block.lines(&header.channels) {
            let channel = line.location.channel;
            if !colors.contains(&channel) {
                continue;
            }
            samples.clear();
            read_line(&line, header.channels.list[channel].sample_type, &mut samples).map_err(failed)?;
            let (Ok(x), Ok(y)) = (
                u32::try_from(line.location.position.0),
                u32::try_from(line.location.position.1),
            ) else {
                return Err(incomplete());
            };
            let pixels = (x..).zip(&samples).map(|(x, sample)| {
                let value = if *sample > max { max } else { *sample };
                let of = |color: usize| if color == channel { value } else { 0.0 };
                let [r, g, b] = colors.map(of);
                (x, [r, g, b, 0.0])
            });
            areas.add(y, pixels);
        }
    }
    let means = areas.finish().ok_or_else(incomplete)?;
    Ok(means.map(|&[r, g, b, _]| [r, g, b]))
}

#[expect(clippy::cast_precision_loss, reason = "as the reader of full images does")]
fn read_line(line: &LineRef<'_>, kind: SampleType, to: &mut Vec<f32>) -> Result<(), ::exr::error::Error> {
    match kind {
        SampleType::F16 => {
            for sample in line.read_samples::<f16>() {
                to.push(sample?.to_f32());
            }
        }
        SampleType::F32 => {
            for sample in line.read_samples::<f32>() {
                to.push(sample?);
            }
        }
        SampleType::U32 => {
            for sample in line.read_samples::<u32>() {
                to.push(sample? as f32);
            }
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reduced::shares;
    use ::exr::prelude::{
        Blocks, Compression, Encoding, Image as ExrImage, Layer, LayerAttributes, LineOrder,
        SpecificChannels, Vec2, WritableImage,
    };

    fn value((x, y): (u32, u32)) -> [f32; 3] {
        let mixed = (x * 7 + y * 13) % 11;
        [mixed as f32 * 0.25, (x + y) as f32, 3.0]
    }

    fn file(
        size: (usize, usize),
        blocks: Blocks,
        line_order: LineOrder,
        compression: Compression,
    ) -> Vec<u8> {
        let channels = SpecificChannels::rgb(|Vec2(x, y)| {
            let [r, g, b] = value((u32::try_from(x).unwrap(), u32::try_from(y).unwrap()));
            (r, f16::from_f32(g), b)
        });
        let encoding = Encoding {
            compression,
            blocks,
            line_order,
        };
        let layer = Layer::new(size, LayerAttributes::default(), encoding, channels);
        let mut out = Cursor::new(Vec::new());
        ExrImage::from_layer(layer)
            .write()
            .non_parallel()
            .to_buffered(&mut out)
            .unwrap();
        out.into_inner()
    }

    fn reduced(file: &[u8], divisor: u32, max: f32) -> Image<[f32; 3]> {
        let reader = Reader::read_from_buffered(Cursor::new(file), false).unwrap();
        let header = reader.headers()[0].clone();
        means(reader, 0, &header, divisor, max).unwrap()
    }

    /// The means, summed in another order.
    #[expect(clippy::cast_possible_truncation, reason = "rounds once, at the end")]
    fn expected(full: (u32, u32), divisor: u32, max: f32) -> Image<[f32; 3]> {
        let size = (full.0.div_ceil(divisor), full.1.div_ceil(divisor));
        let mut sums = vec![[0.0f64; 3]; (size.0 * size.1) as usize];
        for (x, y) in (0..full.0).flat_map(|x| (0..full.1).map(move |y| (x, y))) {
            for (row, down) in shares(y, full.1, size.1) {
                for (column, across) in shares(x, full.0, size.0) {
                    if down * across > 0.0 {
                        let sum = &mut sums[(row * size.0 + column) as usize];
                        for (sum, value) in sum.iter_mut().zip(value((x, y))) {
                            *sum += f64::from(value.min(max)) * f64::from(down) * f64::from(across);
                        }
                    }
                }
            }
        }
        let pixels = sums.iter().map(|sum| sum.map(|sum| sum as f32)).collect();
        Image::new(size.0, size.1, pixels).unwrap()
    }

    #[test]
    fn pixels_are_the_means_of_their_areas() {
        let tiles = Blocks::Tiles(Vec2(8, 16));
        for (size, blocks, order, compression) in [
            (
                (32, 16),
                Blocks::ScanLines,
                LineOrder::Increasing,
                Compression::ZIP16,
            ),
            (
                (31, 50),
                Blocks::ScanLines,
                LineOrder::Decreasing,
                Compression::RLE,
            ),
            ((37, 21), tiles, LineOrder::Unspecified, Compression::ZIP1),
            (
                (5, 1),
                Blocks::ScanLines,
                LineOrder::Increasing,
                Compression::Uncompressed,
            ),
        ] {
            let file = file(size, blocks, order, compression);
            let full = (u32::try_from(size.0).unwrap(), u32::try_from(size.1).unwrap());
            for (divisor, max) in [(2, f32::INFINITY), (4, 1.0), (8, f32::INFINITY)] {
                let (ours, truth) = (reduced(&file, divisor, max), expected(full, divisor, max));
                assert_eq!((ours.width(), ours.height()), (truth.width(), truth.height()));
                for (ours, truth) in ours.pixels().iter().zip(truth.pixels()) {
                    for (ours, truth) in ours.iter().zip(truth) {
                        assert!(
                            (ours - truth).abs() <= 1e-5 * truth.abs(),
                            "{size:?}: {ours} {truth}"
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn images_that_fit_and_damaged_ones_are_left_to_the_other_decoder() {
        let file = file(
            (8, 8),
            Blocks::ScanLines,
            LineOrder::Increasing,
            Compression::ZIP1,
        );
        assert!(decode(&file, 8, 1.0).unwrap().is_none());
        assert!(decode(&file[..20], 8, 1.0).unwrap().is_none());
    }

    #[test]
    fn truncated_images_are_rejected() {
        let file = file(
            (64, 64),
            Blocks::ScanLines,
            LineOrder::Increasing,
            Compression::Uncompressed,
        );
        let reader = Reader::read_from_buffered(Cursor::new(&file[..file.len() / 2]), false).unwrap();
        let header = reader.headers()[0].clone();
        assert!(means(reader, 0, &header, 2, 1.0).is_err());
    }
}

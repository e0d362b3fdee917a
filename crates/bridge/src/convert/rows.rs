use super::MessageError;
use crate::message::Image;

/// Returns the pixels of each row, without the bytes between rows. The data of a message is as long as its size and its step
/// announce, so what is allocated for an image is bounded by the bytes that arrived.
fn rows(message: &Image, bytes_per_pixel: u32) -> Result<impl Iterator<Item = &[u8]>, MessageError> {
    let Image {
        width, height, step, ..
    } = *message;
    if width == 0 || height == 0 {
        return Err(MessageError::new(
            "width, height",
            format!("an image of {width}x{height} has no pixels"),
            "publish images with pixels",
        ));
    }
    let row = u64::from(width) * u64::from(bytes_per_pixel);
    if u64::from(step) < row {
        return Err(MessageError::new(
            "step",
            format!(
                "{step} bytes for rows of {row} ({width} pixels, {})",
                message.encoding
            ),
            "set step to the number of bytes from one row to the next",
        ));
    }
    // The bytes after the last row are optional.
    let needed = u64::from(step) * u64::from(height - 1) + row;
    let found = message.data.len() as u64;
    if found < needed {
        return Err(MessageError::new(
            "data",
            format!("{found} bytes instead of {needed} for {width}x{height} with a step of {step}"),
            "publish whole images",
        ));
    }
    // Both fit, because that many bytes are in memory.
    let (row, step) = (usize::try_from(row).unwrap_or(0), step as usize);
    let rows = message.data.chunks(step).take(height as usize);
    Ok(rows.filter_map(move |bytes| bytes.get(..row)))
}

/// Converts the pixels of a message, which have `N` bytes each.
#[expect(clippy::cast_possible_truncation, reason = "a pixel has a few bytes")]
pub(super) fn pixels<T, const N: usize>(
    message: &Image,
    convert: impl Fn([u8; N]) -> T,
) -> Result<Vec<T>, MessageError> {
    let rows = rows(message, N as u32)?;
    let mut pixels = Vec::with_capacity(message.data.len() / N);
    for row in rows {
        pixels.extend(row.as_chunks().0.iter().map(|bytes| convert(*bytes)));
    }
    Ok(pixels)
}

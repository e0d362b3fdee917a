//! Parses image sizes.

use oaktwin::camera::ImageSize;
use oaktwin::render;

use crate::context::Result;

/// Parses the value of an optional size option, such as `1280x800`.
pub(crate) fn parse(option: &str, text: Option<&str>) -> Result<Option<ImageSize>> {
    let Some(text) = text else {
        return Ok(None);
    };
    let parts = text.split_once(['x', 'X', '×']);
    let number = |text: &str| text.trim().parse::<u32>().ok();
    let size = parts.and_then(|(width, height)| Some(ImageSize::new(number(width)?, number(height)?)));
    let size =
        size.ok_or_else(|| format!("{option} {text}: invalid size; use WIDTHxHEIGHT, such as 1280x800"))?;
    render::check_size(size).map_err(|error| format!("{option}: {error}"))?;
    Ok(Some(size))
}

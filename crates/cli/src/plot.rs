//! Writes figures to files.

use std::path::Path;

use oaktwin::figure::{self, Figure};
use oaktwin::files;
use oaktwin::image::png;

use crate::context::Result;

/// A figure file.
pub(crate) struct Plot<'a> {
    pub(crate) file: &'a Path,
    is_svg: bool,
}

impl<'a> Plot<'a> {
    /// Creates a plot in the format of the file's extension.
    pub(crate) fn new(file: &'a Path) -> Result<Self> {
        let extension = file.extension().unwrap_or_default().to_ascii_lowercase();
        let is_svg = extension == "svg";
        if !is_svg && extension != "png" {
            return Err(format!(
                "{}: is neither SVG nor PNG; name it FILE.svg or FILE.png",
                file.display()
            )
            .into());
        }
        Ok(Self { file, is_svg })
    }

    /// Writes figures below each other.
    pub(crate) fn draw(&self, figures: &[Figure]) -> Result<()> {
        let bytes = if self.is_svg {
            figure::svg(figures)?.into_bytes()
        } else {
            png::encode(&figure::image(figures)?)?
        };
        Ok(files::write(self.file, &bytes)?)
    }
}

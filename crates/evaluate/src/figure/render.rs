//! Figures as files: one below the other, as SVG or as an image.

use std::sync::OnceLock;

use oaktwin_image::Image;
use plotters::prelude::{BitMapBackend, IntoDrawingArea, SVGBackend};
use plotters::style::{FontStyle, register_font};

use super::{Figure, FigureError, chart};

/// The size of a figure, px.
const WIDTH: u32 = 960;
const HEIGHT: u32 = 560;
/// Pixels of an image per pixel of the SVG.
const IMAGE_SCALE: u32 = 2;
/// Samples per pixel of an image and axis.
const SAMPLES: u32 = 3;
/// Units per pixel of an SVG, because the plotting library places marks only at whole units.
const SVG_SCALE: u32 = 8;
/// The program that shows an SVG chooses the font; Debian's, for instance, is 18 % wider than ours.
const SVG_TEXT_PERCENT: u32 = 120;

/// Draws figures one below the other as an SVG document, 960 × 560 px each.
///
/// # Errors
/// Returns an error if the plotting library fails.
pub fn svg(figures: &[Figure]) -> Result<String, FigureError> {
    register()?;
    let size = size(figures, SVG_SCALE);
    let mut svg = String::new();
    let area = SVGBackend::with_string(&mut svg, size).into_drawing_area();
    chart::draw(&area, figures, SVG_SCALE, SVG_TEXT_PERCENT)?;
    drop(area);
    // The size in pixels, and the units of the marks as the view box.
    let [units, pixels] = [SVG_SCALE, 1].map(|scale| {
        let (width, height) = self::size(figures, scale);
        format!("<svg width=\"{width}\" height=\"{height}\"")
    });
    Ok(svg.replacen(&units, &pixels, 1))
}

/// Draws figures one below the other as an image at twice the size of the SVG.
///
/// # Errors
/// Returns an error if the plotting library fails.
pub fn image(figures: &[Figure]) -> Result<Image<[u8; 3]>, FigureError> {
    register()?;
    let (width, height) = size(figures, IMAGE_SCALE * SAMPLES);
    let mut samples = vec![255; width as usize * height as usize * 3];
    let area = BitMapBackend::with_buffer(&mut samples, (width, height)).into_drawing_area();
    chart::draw(&area, figures, IMAGE_SCALE * SAMPLES, 100)?;
    drop(area);
    let (width, height) = size(figures, IMAGE_SCALE);
    let pixels = averages(&samples, width as usize);
    Image::new(width, height, pixels).ok_or_else(|| FigureError("its size is wrong".to_owned()))
}

/// Returns the means of squares of samples, row by row.
fn averages(samples: &[u8], width: usize) -> Vec<[u8; 3]> {
    let side = SAMPLES as usize;
    let row = width * side * 3;
    let mean = |rows: &[u8], x: usize, channel: usize| {
        let sum: usize = (0..side * side)
            .map(|i| usize::from(rows[(i / side) * row + (x * side + i % side) * 3 + channel]))
            .sum();
        #[expect(clippy::cast_possible_truncation, reason = "a mean of bytes is a byte")]
        let mean = ((sum + side * side / 2) / (side * side)) as u8;
        mean
    };
    samples
        .chunks_exact(row * side)
        .flat_map(|rows| (0..width).map(move |x| [0, 1, 2].map(|channel| mean(rows, x, channel))))
        .collect()
}

fn size(figures: &[Figure], scale: u32) -> (u32, u32) {
    let count = u32::try_from(figures.len().max(1)).unwrap_or(1);
    (WIDTH * scale, HEIGHT * count * scale)
}

/// Registers the font, which ships with the program: figures do not depend on what is installed.
fn register() -> Result<(), FigureError> {
    static FONT: OnceLock<bool> = OnceLock::new();
    let is_registered =
        *FONT.get_or_init(|| register_font("sans-serif", FontStyle::Normal, notosans::REGULAR_TTF).is_ok());
    is_registered
        .then_some(())
        .ok_or_else(|| FigureError("its font is invalid".to_owned()))
}

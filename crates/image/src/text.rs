//! Text in images, in Noto Sans.

use std::sync::LazyLock;

use ab_glyph::{Font, FontRef, OutlinedGlyph, PxScale, ScaleFont, point};

use crate::Image;

#[expect(clippy::expect_used, reason = "the font is part of the program")]
static FONT: LazyLock<FontRef<'static>> =
    LazyLock::new(|| FontRef::try_from_slice(notosans::REGULAR_TTF).expect("the font is valid"));

/// The size and colour of text.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TextStyle {
    /// The height of a capital letter in pixels.
    pub height: f32,
    /// The colour in sRGB.
    pub color: [u8; 3],
}

/// Returns the width of a line of text in pixels.
#[must_use]
pub fn width(text: &str, height: f32) -> f32 {
    layout(text, height).1
}

/// Draws a line of text whose capital letters have their upper left corner at (`x`, `y`) in pixels, and crops it to the
/// image. Characters that the font lacks become boxes.
pub fn draw(image: &mut Image<[u8; 3]>, text: &str, (x, y): (f32, f32), style: TextStyle) {
    let (glyphs, _) = layout(text, style.height);
    for (glyph, left) in glyphs {
        draw_glyph(image, &glyph, (x + left, y + style.height), style.color);
    }
}

/// Returns the glyphs of a line of text that have an outline, each with its distance from the start in pixels, and the
/// width of the line.
fn layout(text: &str, height: f32) -> (Vec<(OutlinedGlyph, f32)>, f32) {
    let font = FONT.as_scaled(scale(height));
    let mut glyphs = Vec::new();
    let mut left = 0.0;
    let mut previous = None;
    for id in text.chars().map(|c| font.glyph_id(c)) {
        left += previous.map_or(0.0, |previous| font.kern(previous, id));
        let glyph = id.with_scale_and_position(font.scale(), point(0.0, 0.0));
        if let Some(outlined) = font.outline_glyph(glyph) {
            glyphs.push((outlined, left));
        }
        left += font.h_advance(id);
        previous = Some(id);
    }
    (glyphs, left)
}

/// Returns the scale at which capital letters have a height in pixels.
fn scale(height: f32) -> PxScale {
    let capital = FONT
        .outline(FONT.glyph_id('H'))
        .map_or(1.0, |outline| outline.bounds.height().abs());
    PxScale::from(height * FONT.height_unscaled() / capital)
}

/// Blends a glyph whose baseline starts at (`x`, `y`) into an image.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "positions saturate; colours are between 0 and 255"
)]
fn draw_glyph(image: &mut Image<[u8; 3]>, glyph: &OutlinedGlyph, (x, y): (f32, f32), color: [u8; 3]) {
    let corner = glyph.px_bounds().min;
    let (left, top) = ((x + corner.x).round() as i64, (y + corner.y).round() as i64);
    let [columns, rows] = [image.width(), image.height()];
    glyph.draw(|column, row, coverage| {
        let place = (
            u32::try_from(left.saturating_add(column.into())),
            u32::try_from(top.saturating_add(row.into())),
        );
        let (Ok(column), Ok(row)) = place else { return };
        if column >= columns || row >= rows {
            return;
        }
        let pixel = &mut image.pixels_mut()[row as usize * columns as usize + column as usize];
        for (channel, ink) in pixel.iter_mut().zip(color) {
            let (paper, ink) = (f32::from(*channel), f32::from(ink));
            *channel = (paper + (ink - paper) * coverage.clamp(0.0, 1.0)).round() as u8;
        }
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    const STYLE: TextStyle = TextStyle {
        height: 12.0,
        color: [255; 3],
    };

    #[test]
    fn text_has_its_width_and_height() {
        let mut image = Image::filled(200, 24, [0; 3]);
        draw(&mut image, "Hamburg 0.5 m", (10.0, 6.0), STYLE);
        let is_inked = |x: u32, y: u32| image.get(x, y).unwrap()[0] > 60;
        let columns: Vec<u32> = (0..200).filter(|&x| (0..24).any(|y| is_inked(x, y))).collect();
        let (first, last) = (columns[0], *columns.last().unwrap());
        assert!((10..=12).contains(&first), "{first}");
        let end = 10.0 + width("Hamburg 0.5 m", 12.0);
        assert!((last as f32 - end).abs() < 3.0, "{last} {end}");
        assert_eq!(width("", 12.0), 0.0);
        // The first letter is a capital.
        let rows: Vec<u32> = (0..24).filter(|&y| (10..18).any(|x| is_inked(x, y))).collect();
        assert_eq!((rows[0], *rows.last().unwrap()), (6, 17));
    }

    #[test]
    fn text_is_cropped_to_the_image() {
        let mut image = Image::filled(8, 8, [9; 3]);
        for at in [(-1e9, 0.0), (1e9, 0.0), (0.0, -1e9), (0.0, 1e9), (-1e30, 1e30)] {
            draw(&mut image, "m", at, STYLE);
        }
        assert_eq!(image, Image::filled(8, 8, [9; 3]));
        draw(&mut image, "m", (-4.0, -4.0), STYLE);
        assert_ne!(image, Image::filled(8, 8, [9; 3]));
        draw(&mut Image::filled(0, 0, [0; 3]), "m", (0.0, 0.0), STYLE);
    }
}
